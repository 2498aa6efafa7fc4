#include "view/opening.h"

#include "io/scene_file.h"
#include "view/link/link.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

/// The name of the lesson that this folder holds; empty if it is none that the window lists.
std::string lesson_of(const State& state, const std::string& folder) {
  const fs::path plain = fs::path(folder + "/").lexically_normal().parent_path();
  const std::string name = plain.filename().string();
  std::error_code failed;
  if (state.lessons.folder.empty() || !fs::exists(plain / "lesson.toml", failed)) return {};
  return fs::equivalent(plain, fs::path(state.lessons.folder) / name, failed) ? name : std::string();
}

/// The scenes and meshes that lie in a folder itself, in alphabetical order.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code failed;
  fs::directory_iterator entry(folder, failed);
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    std::error_code unknown;
    const std::string path = entry->path().string();
    if (has_scene_ending(path) && entry->is_regular_file(unknown)) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool means_link(std::string_view named) {
  return is_link(named) || named.starts_with("raywalk:") || named.starts_with("https://") ||
         named.starts_with("http://");
}

std::vector<Action> opening_of(const State& state, const std::string& named) {
  std::error_code unknown;
  if (means_link(named) && !fs::exists(named, unknown)) return {action::OpenLink{named}};
  if (const std::string lesson = lesson_of(state, named); !lesson.empty())
    return {action::CancelPrompt{}, action::OpenLesson{lesson}};
  return {action::Open{named}};
}

std::vector<Action> opening_among(const State& state, const std::vector<std::string>& paths) {
  if (paths.empty()) return {};
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code unknown;
    if (!fs::is_directory(path, unknown)) {
      files.push_back(path);
      continue;
    }
    if (!lesson_of(state, path).empty()) return opening_of(state, path);
    for (std::string& file : files_in(path)) files.push_back(std::move(file));
  }
  const auto is_scene = [](const std::string& path) {
    return has_scene_ending(path) && scene_format_of(path) == SceneFormat::toml;
  };
  auto chosen = std::find_if(files.begin(), files.end(), is_scene);
  if (chosen == files.end()) chosen = std::find_if(files.begin(), files.end(), has_scene_ending);
  return opening_of(state, chosen == files.end() ? paths.front() : *chosen);
}

}  // namespace raywalk
