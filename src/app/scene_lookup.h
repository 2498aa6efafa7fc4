#pragma once

#include "io/scene_file.h"
#include "trace/kernel.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// The folder of `scenes` and `lessons`: beside an installed program, else in the source tree.
[[nodiscard]] std::string data_dir();

/// The folder of the language files (text/languages.h).
[[nodiscard]] std::string text_dir();

/// The names of the scenes in data_dir()/scenes, sorted: "classic".
[[nodiscard]] std::vector<std::string> shipped_scenes();

/// The path of a SCENE argument: a path, or else the name of a shipped scene.
[[nodiscard]] std::string scene_path(const std::string& scene);

enum class SceneWarnings { said, kept };

/// Reads the scene, and prints its warnings on standard error unless they are kept, one line per kind. If there is no
/// such file, the hint lists the available ones.
[[nodiscard]] Result<SceneDocument> load_scene(const std::string& scene, SceneWarnings warnings = SceneWarnings::said);

/// The error of reading a SCENE, with the names that may have been meant as a hint if there is no such file.
/// `commands`: words that may stand in its place.
[[nodiscard]] Error with_names(Error error, const std::string& scene, const std::vector<std::string>& commands = {});

/// Why there is not enough memory to trace the scene; nothing if there is.
[[nodiscard]] std::optional<Error> why_no_room(const Scene& scene, const std::string& path, Precision precision);

}  // namespace raywalk
