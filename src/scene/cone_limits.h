#pragma once

#include "scene/scene.h"

#include <string>

namespace raywalk {

/// Why cones cannot be followed through a scene, naming the object: "Egg is transformed". Empty where they can.
[[nodiscard]] std::string why_no_cones(const Scene& scene);

/// The object that has this reason; empty: there is none.
[[nodiscard]] std::string object_against_cones(const Scene& scene);

}  // namespace raywalk
