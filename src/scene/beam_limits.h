#pragma once

#include "scene/scene.h"

#include <string>

namespace raywalk {

/// Why the picture of a scene cannot be made of beams, naming the object: "Ball moves". Empty where it can.
[[nodiscard]] std::string why_no_space_beams(const Scene& scene);

}  // namespace raywalk
