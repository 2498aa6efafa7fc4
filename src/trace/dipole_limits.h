#pragma once
// Where light inside of bodies cannot be left to the dipole, or not well (trace/dipole.h).

#include "scene/scene.h"

#include <string>
#include <vector>

namespace raywalk {

/// Of a scene that asks for it, a sentence each, by the names of the objects.
[[nodiscard]] std::vector<std::string> dipole_losses(const Scene& scene);

}  // namespace raywalk
