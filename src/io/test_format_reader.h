#pragma once
// The scene language of introductory ray tracing courses (UC Berkeley CS184, UC San Diego CSE167; R. Ramamoorthi).
//
// What makes its pictures different from those of our own scenes stands in keys that any scene may use: triangles and
// spheres do not turn their normal towards the ray (material.normal = "fixed"), the light of the eye's surroundings is
// added as it is (material.ambient, with the scene's ambient at 1), `maxdepth n` allows n mirror bounces (limits.depth
// = n + 1), and a PNG is clamped and cut off to 8 bits without a curve (image.encoding = "truncated").
//
// Where the format leaves a choice: lights are placed by the current matrix, as published; `attenuation` holds for the
// point lights after it; secondary rays need no offset here, for a ray knows which surface it departs from.

#include "io/scene_file.h"

namespace raywalk {

/// `file_name` is for messages.
[[nodiscard]] Result<SceneDocument> parse_test_format(std::string_view text, const std::string& file_name);

}  // namespace raywalk
