#pragma once
// The scene language of introductory ray tracing courses (UC Berkeley CS184, UC San Diego CSE167; R. Ramamoorthi).
//
// The differences from our own scenes are expressed by keys that any scene may use: normals of triangles and spheres
// are not turned towards the ray (material.normal = "fixed"), ambient light is added unscaled (material.ambient, with
// the scene's ambient at 1), `maxdepth n` allows n mirror bounces (limits.depth = n + 1), and a PNG is clamped and
// truncated to 8 bits without a curve (image.encoding = "truncated").
//
// Where the format leaves a choice: lights are placed by the current matrix, as published; `attenuation` applies to the
// point lights after it; secondary rays need no offset, because a ray knows its source primitive.

#include "io/scene_file.h"

namespace raywalk {

/// `file_name` is for messages.
[[nodiscard]] Result<SceneDocument> parse_test_format(std::string_view text, const std::string& file_name);

}  // namespace raywalk
