#pragma once
// What photon mapping leaves out of a scene (trace/photon_lights.h).

#include "scene/scene.h"

#include <string>
#include <vector>

namespace raywalk {

/// Of a scene that it renders, a sentence each, by the names of the objects.
[[nodiscard]] std::vector<std::string> photon_losses(const Scene& scene);

}  // namespace raywalk
