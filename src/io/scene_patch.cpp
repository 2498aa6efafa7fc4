#include "io/scene_patch.h"

#include "io/scene_references.h"
#include "io/scene_values.h"
#include "io/textures.h"
#include "text/file_ledger.h"
#include "text/toml_text.h"

#include <fmt/format.h>
#include <zlib.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <new>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

using detail::Value;
using Kind = Value::Kind;
using Json = nlohmann::ordered_json;  // a scene's objects have an order

/// Stands where a name would, for the names in their order.
constexpr std::string_view in_order = "";
/// Deeper than any scene; readers and copies of JSON recurse.
constexpr int max_nesting = 32;
/// What anybody may ask for of the time and the memory of who opens a patch: more than any scene that is made by hand.
constexpr std::size_t max_named = 1000;
constexpr double max_entries = 1e5, max_pixels = 1 << 22;

// --- What differs ----------------------------------------------------------------------------------------------------

Json parsed(std::string_view text) { return Json::parse(text, nullptr, false); }

std::optional<std::string> name_of(const Value& element) {
  const Value* name = element.find("name");
  if (name == nullptr || name->kind != Kind::scalar) return std::nullopt;
  const Json json = parsed(name->text);
  return json.is_string() ? std::optional(json.get<std::string>()) : std::nullopt;
}

Json json_of(const Value& value) {
  switch (value.kind) {
    case Kind::scalar:
    case Kind::list:
      return parsed(detail::inline_text(value));  // numbers, words and lists of them are written in TOML as in JSON
    case Kind::table: {
      Json object = Json::object();
      for (const Value& child : value.children)
        if (!child.is_default) object[child.key] = json_of(child);
      return object;
    }
    case Kind::tables:
      break;
  }
  Json array = Json::array();
  for (const Value& child : value.children) array.push_back(json_of(child));
  return array;
}

/// The names of a list's elements; nothing if they have none.
std::optional<std::vector<std::string>> names_in(const Value& tables) {
  std::vector<std::string> names;
  for (const Value& element : tables.children) {
    auto name = name_of(element);
    if (!name || name->empty() || std::find(names.begin(), names.end(), *name) != names.end()) return std::nullopt;
    names.push_back(std::move(*name));
  }
  return names;
}

std::size_t place_in(const std::vector<std::string>& names, std::string_view name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

Json changes(const Value& from, const Value& to);

Json changes_of_named(const Value& from, const Value& to, const std::vector<std::string>& old_names,
                      const std::vector<std::string>& names) {
  Json result = Json::object();
  std::vector<std::string> order;
  for (const std::string& name : old_names) {
    if (place_in(names, name) == names.size())
      result[name] = nullptr;
    else
      order.push_back(name);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t old = place_in(old_names, names[i]);
    if (old < old_names.size()) {
      if (from.children[old] != to.children[i]) result[names[i]] = changes(from.children[old], to.children[i]);
      continue;
    }
    order.push_back(names[i]);
    Json& added = result[names[i]] = json_of(to.children[i]);
    added.erase("name");
  }
  if (order != names) result[std::string(in_order)] = names;
  return result;
}

/// Of two values that differ.
Json changes(const Value& from, const Value& to) {
  if (from.kind == Kind::tables && to.kind == Kind::tables) {
    const auto old_names = names_in(from), names = names_in(to);
    return old_names && names ? changes_of_named(from, to, *old_names, *names) : json_of(to);
  }
  if (from.kind != Kind::table || to.kind != Kind::table) return json_of(to);
  Json result = Json::object();
  for (const Value& child : to.children) {
    const Value* old = from.find(child.key);
    if (old != nullptr && (*old != child || old->must_now_be_stated(child)))
      result[child.key] = changes(*old, child);
    else if (old == nullptr && !child.is_default)
      result[child.key] = json_of(child);
  }
  for (const Value& child : from.children)
    if (to.find(child.key) == nullptr) result[child.key] = nullptr;
  return result;
}

// --- Applying it -----------------------------------------------------------------------------------------------------

bool is_key(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// The value that JSON states; nothing if no key of a scene can be so.
std::optional<Value> value_of(const Json& json) {
  Value value;
  if (json.is_string()) {
    value.text = toml_text::quoted(json.get_ref<const std::string&>());
  } else if (json.is_boolean()) {
    value.text = json.get<bool>() ? "true" : "false";
  } else if (json.is_number_float()) {
    value.text = toml_text::number(json.get<double>());
  } else if (json.is_number()) {
    value.text = json.dump();
  } else if (json.is_object() || json.is_array()) {
    const bool holds_tables = !json.empty() && json.is_array() && json.front().is_object();
    value.kind = json.is_object() ? Kind::table : holds_tables ? Kind::tables : Kind::list;
    for (const auto& [key, each] : json.items()) {
      std::optional<Value> child = value_of(each);
      if (!child || (holds_tables && child->kind != Kind::table)) return std::nullopt;
      if (!holds_tables && !json.is_object() && child->kind != Kind::scalar && child->kind != Kind::list)
        return std::nullopt;
      if (json.is_object()) {
        if (!is_key(key)) return std::nullopt;
        child->key = key;
      }
      value.children.push_back(std::move(*child));
    }
  } else {
    return std::nullopt;
  }
  return value;
}

bool apply_to_table(Value& table, const Json& given);

/// Puts the elements that are named into this order; the others stay behind them, in theirs.
bool put_in_order(Value& tables, const Json& names) {
  if (!names.is_array() || names.size() > max_named) return false;
  std::vector<std::string> order;
  for (const Json& name : names) {
    if (!name.is_string()) return false;
    order.push_back(name.get<std::string>());
  }
  std::stable_sort(tables.children.begin(), tables.children.end(), [&](const Value& a, const Value& b) {
    return place_in(order, name_of(a).value_or("")) < place_in(order, name_of(b).value_or(""));
  });
  return true;
}

bool apply_to_named(Value& tables, const Json& given) {
  for (const auto& [name, change] : given.items()) {
    if (name == in_order) continue;
    if (tables.children.size() > max_named) return false;
    const auto at = std::find_if(tables.children.begin(), tables.children.end(),
                                 [&, &wanted = name](const Value& each) { return name_of(each) == wanted; });
    if (change.is_null()) {
      if (at != tables.children.end()) tables.children.erase(at);
    } else if (!change.is_object()) {
      return false;
    } else if (at != tables.children.end()) {
      if (!apply_to_table(*at, change)) return false;
    } else {
      auto added = value_of(change);
      if (!added) return false;
      added->children.insert(added->children.begin(), Value{.key = "name", .text = toml_text::quoted(name)});
      tables.children.push_back(std::move(*added));
    }
  }
  const auto order = given.find(in_order);
  return order == given.end() || put_in_order(tables, *order);
}

bool apply_to_table(Value& table, const Json& given) {
  for (const auto& [key, change] : given.items()) {
    if (!is_key(key)) return false;
    const auto at = std::find_if(table.children.begin(), table.children.end(),
                                 [&, &wanted = key](const Value& child) { return child.key == wanted; });
    const bool is_new = at == table.children.end();
    if (change.is_null()) {
      if (!is_new) table.children.erase(at);
      continue;
    }
    if (!is_new && change.is_object() && (at->kind == Kind::table || at->kind == Kind::tables)) {
      at->is_default = false;
      if (!(at->kind == Kind::table ? apply_to_table(*at, change) : apply_to_named(*at, change))) return false;
      continue;
    }
    auto value = value_of(change);
    if (!value) return false;
    value->key = key;
    if (is_new)
      table.children.push_back(std::move(*value));
    else
      *at = std::move(*value);
  }
  return true;
}

int nesting_of(std::string_view json) {
  int depth = 0, deepest = 0;
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '"')
      for (++at; at < json.size() && json[at] != '"'; ++at) at += json[at] == '\\' ? 1 : 0;
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return deepest;
}

std::set<std::string> files_of(const Scene& scene) {
  std::set<std::string> files;
  detail::each_file_name(scene, [&](const std::string& file) { files.insert(file); });
  return files;
}

tl::unexpected<Error> refused(std::string message, std::string hint = {}) {
  return tl::unexpected(Error{"", 0, 0, std::move(message), std::move(hint)});
}

}  // namespace

std::string scene_patch(const Scene& from, const Scene& to) {
  const Value old = detail::values_of(from), now = detail::values_of(to);
  if (old == now) return {};
  return changes(old, now).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<SceneDocument> patched_scene(const SceneDocument& from, std::string_view patch) {
  if (patch.empty()) return from;
  if (nesting_of(patch) > max_nesting) return refused("its changes are nested too deeply for a scene");
  const Json given = parsed(patch);
  Value values = detail::values_of(from.scene);
  if (!given.is_object() || !apply_to_table(values, given)) return refused("its changes are not those of a scene");
  const std::string text = detail::section_text(values, "");
  const auto fail = [](Error error) {
    error.file.clear();  // nobody has seen the text
    error.line = error.column = 0;
    return tl::unexpected(error);
  };
  auto read = parse_scene(text, from.path, MeshReading::skip);
  if (!read) return fail(read.error());
  const Scene& scene = read->scene;
  if (entries_of(scene.objects) > std::max(max_entries, entries_of(from.scene.objects)))
    return refused(fmt::format("its scene comes to more than the {:.0f} objects that a link may", max_entries));
  if (static_cast<double>(scene.image.width) * scene.image.height > max_pixels)
    return refused(fmt::format("its picture has more than the {:.0f} pixels that a link may ask for", max_pixels));
  const std::set<std::string> known = files_of(from.scene);
  for (const std::string& file : files_of(scene))
    if (!known.contains(file))
      return refused(fmt::format("its scene needs the file {}, which a link cannot hold", toml_text::quoted(file)),
                     "save the scene, and pass it on together with its files");
  if (!known.empty()) {
    const FileLedger ledger(FileLedger::Notes::reading);
    try {
      read = parse_scene(text, from.path);
      if (!read) return fail(read.error());
      const std::string folder = from.path.substr(0, from.path.find_last_of('/') + 1);
      if (const auto loaded = load_textures(read->scene, folder); !loaded) return fail(loaded.error());
    } catch (const std::bad_alloc&) {
      return refused("there is not enough memory for its meshes and textures");
    }
    read->files = from.files;
  }
  read->text = from.text;
  read->path = from.path;
  read->ink = from.ink;  // no part of the scene, and so of its changes
  read->keeps_ink = from.keeps_ink;
  return read;
}

bool names_files(const Scene& scene) { return !files_of(scene).empty(); }

std::uint32_t scene_sum(const Scene& scene) {
  const std::string text = detail::section_text(detail::values_of(scene), "");
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

}  // namespace raywalk
