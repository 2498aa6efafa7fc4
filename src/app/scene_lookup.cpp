#include "app/scene_lookup.h"

#include "app/console.h"
#include "render/memory_need.h"
#include "scene/warnings.h"
#include "text/spelling.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace raywalk {

namespace fs = std::filesystem;

std::string data_dir() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path() / RAYWALK_INSTALL_DATA_DIR;
  if (!program.empty() && fs::is_directory(installed / "scenes", ignored)) return installed.lexically_normal().string();
  return RAYWALK_DATA_DIR;
}

std::string text_dir() {
  const std::string data = data_dir();
  return data == RAYWALK_DATA_DIR ? data + "/src/text" : data + "/text";
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(fs::path(data_dir()) / "scenes", error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".toml") names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string scene_path(const std::string& scene) {
  std::error_code ignored;
  // A folder of the name hides no scene.
  if (fs::path(scene).has_parent_path() || (fs::exists(scene, ignored) && !fs::is_directory(scene, ignored)))
    return scene;
  const fs::path file = has_scene_ending(scene) ? scene : scene + ".toml";
  const fs::path shipped = fs::path(data_dir()) / "scenes" / file;
  return fs::exists(shipped, ignored) ? shipped.string() : scene;
}

std::optional<Error> why_no_room(const Scene& scene, const std::string& path, Precision precision) {
  RenderSettings settings;
  settings.size = ImageSize{1, 1};
  settings.precision = precision;
  return why_too_large(memory_needed(scene, settings), path);
}

Result<SceneDocument> load_scene(const std::string& scene, SceneWarnings warnings) {
  const std::string path = scene_path(scene);
  auto document = read_scene(path);
  if (document) {
    // Enough for the cheapest use; those that need more memory check again.
    if (const auto large = why_no_room(document->scene, path, Precision::float_)) return tl::unexpected(*large);
    if (warnings == SceneWarnings::said) warn(collected(document->warnings));
    return document;
  }
  return tl::unexpected(with_names(document.error(), scene));
}

Error with_names(Error error, const std::string& scene, const std::vector<std::string>& commands) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(scene_path(scene), ignored))) return error;
  const std::vector<std::string> names = shipped_scenes();
  std::vector<std::string_view> known(names.begin(), names.end());
  known.insert(known.end(), commands.begin(), commands.end());
  const std::string meant = nearest_word(fs::path(scene).stem().string(), known);
  if (std::find(commands.begin(), commands.end(), meant) != commands.end()) {
    error.hint = "did you mean raywalk " + meant + "?";
  } else if (!meant.empty()) {
    error.hint = "did you mean \"" + meant + "\", which comes with Raywalk?";
  } else if (!names.empty() && !scene.empty() && scene != "-" && !fs::path(scene).has_parent_path()) {
    error.hint = "give the path of a scene file, or the name of a scene that comes with Raywalk: " +
                 one_of({names.begin(), names.end()});
  }
  return error;
}

}  // namespace raywalk
