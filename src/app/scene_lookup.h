#pragma once

#include "io/scene_file.h"
#include "trace/kernel.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// The folder that holds `scenes` and `lessons`: beside an installed program, else in the source tree.
[[nodiscard]] std::string data_dir();

/// The folder that holds the files of the languages (io/languages.h).
[[nodiscard]] std::string text_dir();

/// The names of the scenes in data_dir()/scenes, sorted: "classic".
[[nodiscard]] std::vector<std::string> shipped_scenes();

/// The file that a SCENE of the command line means: a path, or else the name of a shipped scene.
[[nodiscard]] std::string scene_path(const std::string& scene);

enum class SceneWarnings { said, kept };

/// Reads the scene, and says its warnings on standard error unless they are kept, one line for all of a kind. Where
/// there is no such file the hint names what there is.
[[nodiscard]] Result<SceneDocument> load_scene(const std::string& scene, SceneWarnings warnings = SceneWarnings::said);

/// Why there is no memory to trace the scene in; nothing where there is.
[[nodiscard]] std::optional<Error> why_no_room(const Scene& scene, const std::string& path, Precision precision);

}  // namespace raywalk
