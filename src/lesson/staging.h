#pragma once
// The scene of a step: read from a file, with the changes of the lesson.

#include "io/scene_file.h"
#include "lesson/value.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Reads a scene of the lesson's folder, or else a shipped one, by its name with or without ".toml".
[[nodiscard]] Result<SceneDocument> stage_scene(const std::string& name, const std::string& lesson_folder,
                                                const std::string& scenes_folder);

/// `document` with changed values. `changes` is TOML: tables named as in a scene file ("limits.depth = 2"), or by the
/// name of an object or a light ("'Solid Sphere'.material.reflection = 0"). `removed`: names of objects and lights. The
/// text of the result has no comments. Errors name `document`'s file.
[[nodiscard]] Result<SceneDocument> changed_scene(const SceneDocument& document, std::string_view changes,
                                                  const std::vector<std::string>& removed,
                                                  const std::string& file_name);

/// The value at a path in a scene's text: "limits.depth", "Solid Sphere.radius". Nothing if absent; a list of two
/// numbers is a point in the plan.
[[nodiscard]] Outcome scene_value(std::string_view text, std::string_view path);

}  // namespace raywalk
