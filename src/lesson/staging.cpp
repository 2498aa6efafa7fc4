#include "lesson/staging.h"

#include "io/textures.h"
#include "io/toml_table.h"
#include "text/spelling.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> lists{"object", "light"};

/// The table of the object or light of this name; null for none.
toml::table* named(toml::table& scene, std::string_view name) {
  for (const std::string_view list : lists) {
    toml::array* const array = scene[list].as_array();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
      if (toml::table* table = array->get(i)->as_table();
          table != nullptr && (*table)["name"].value_or(std::string_view()) == name)
        return table;
  }
  return nullptr;
}

std::vector<std::string> names_of(const toml::table& scene) {
  std::vector<std::string> names;
  for (const std::string_view list : lists) {
    const toml::array* const array = scene[list].as_array();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
      if (const toml::table* table = array->get(i)->as_table())
        names.push_back((*table)["name"].value_or(std::string()));
  }
  return names;
}

void merge(toml::table& into, const toml::table& from) {
  for (const auto& [key, value] : from) {
    toml::table* const inner = into[key.str()].as_table();
    if (inner != nullptr && value.is_table())
      merge(*inner, *value.as_table());
    else
      into.insert_or_assign(key.str(), value);
  }
}

bool is_of_scene(std::string_view key) {
  constexpr std::array<std::string_view, 8> keys{"camera",     "screen", "image",   "limits",
                                                 "background", "sky",    "ambient", "render"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Outcome value_of(const toml::node& node) {
  if (node.is_number()) return node.value_or(0.0);
  if (node.is_string()) return node.value_or(std::string());
  if (node.is_boolean()) return node.value_or(false);
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->size() < 2 || array->size() > 3) return tl::unexpected(std::string("is no value"));
  const auto part = [&](std::size_t i) { return i < array->size() ? array->get(i)->value_or(0.0) : 0.0; };
  return Vec3d(part(0), part(1), part(2));
}

}  // namespace

Result<SceneDocument> stage_scene(const std::string& name, const std::string& lesson_folder,
                                  const std::string& scenes_folder) {
  const std::string file = has_scene_ending(name) ? name : name + ".toml";
  std::error_code ignored;
  const fs::path own = fs::path(lesson_folder) / file, shipped = fs::path(scenes_folder) / file;
  const bool is_own = fs::exists(own, ignored);
  if (!is_own && !fs::exists(shipped, ignored)) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(scenes_folder, ignored))
      names.push_back(entry.path().stem().string());
    const std::string meant = nearest_word(name, {names.begin(), names.end()});
    return tl::unexpected(Error{own.string(), 0, 0,
                                "there is no scene \"" + name + "\", neither here nor among those that ship",
                                meant.empty() ? "write the scene beside lesson.toml, or name one of " + scenes_folder
                                              : "did you mean " + meant + "?"});
  }
  const std::string path = (is_own ? own : shipped).string();
  return read_scene(path);
}

Result<SceneDocument> changed_scene(const SceneDocument& document, std::string_view changes,
                                    const std::vector<std::string>& removed, const std::string& file_name) {
  toml::parse_result scene = toml::parse(document.text);
  const toml::parse_result wanted = toml::parse(changes);
  if (!scene || !wanted)
    return tl::unexpected(Error{file_name, 0, 0, "the scene cannot be changed: it is no TOML", ""});
  const std::vector<std::string> names = names_of(scene.table());
  std::vector<std::string_view> known{names.begin(), names.end()};
  const auto unknown = [&](std::string_view name) {
    const std::string meant = nearest_word(name, known);
    return tl::unexpected(Error{file_name, 0, 0,
                                "there is no \"" + std::string(name) + "\" in the scene (expected " + one_of(known) +
                                    ", or a table such as limits)",
                                meant.empty() ? "names stand in the scene's file" : "did you mean " + meant + "?"});
  };
  for (const auto& [key, value] : wanted.table()) {
    toml::table* const inner = named(scene.table(), key.str());
    if (inner != nullptr && value.is_table()) {
      merge(*inner, *value.as_table());
    } else if (is_of_scene(key.str())) {
      toml::table one;
      one.insert(key.str(), value);
      merge(scene.table(), one);
    } else {
      return unknown(key.str());
    }
  }
  for (const std::string& name : removed) {
    if (named(scene.table(), name) == nullptr) return unknown(name);
    for (const std::string_view list : lists) {
      toml::array* const array = scene.table()[list].as_array();
      for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
        const toml::table* const table = array->get(i)->as_table();
        if (table == nullptr || (*table)["name"].value_or(std::string_view()) != name) continue;
        array->erase(array->cbegin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
      if (array != nullptr && array->empty()) scene.table().erase(list);
    }
  }
  std::string text = text_of(scene.table());
  // Names of meshes and images are relative to the scene's own file.
  const std::string& path = document.path.empty() ? file_name : document.path;
  auto changed = parse_scene(text, path);
  Result<void> loaded;
  if (changed) loaded = load_textures(changed->scene, path.substr(0, path.find_last_of('/') + 1));
  if (!changed || !loaded) {
    // The place is in the changed text, which the author cannot see.
    Error error = changed ? loaded.error() : changed.error();
    error.line = error.column = 0;
    return tl::unexpected(error);
  }
  changed->text = std::move(text);
  changed->path = document.path;
  changed->files = document.files;
  return changed;
}

Outcome scene_value(std::string_view text, std::string_view path) {
  toml::parse_result scene = toml::parse(text);
  if (!scene) return tl::unexpected(std::string("the scene has no text of its own format"));
  // Names may hold spaces, but no dots.
  const std::size_t dot = path.find('.');
  toml::table* const inner = named(scene.table(), path.substr(0, dot));
  const bool of_name = inner != nullptr && dot != std::string_view::npos;
  const auto node = of_name ? toml::at_path(*inner, path.substr(dot + 1)) : toml::at_path(scene.table(), path);
  if (!node) return Nothing{};
  auto value = value_of(*node.node());
  if (!value) return tl::unexpected("scene(\"" + std::string(path) + "\") " + value.error());
  return value;
}

}  // namespace raywalk
