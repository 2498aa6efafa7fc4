#include "io/scene_values.h"

#include "io/scene_keys.h"
#include "io/toml_text.h"
#include "io/transform_words.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace raywalk::detail {

using Kind = Value::Kind;
using Shorthand = Value::Shorthand;

namespace {

/// The `Fields` of scene_keys that lists what a table would hold.
class Lister {
 public:
  void text(std::string_view key, std::string& value) { add(key, {.text = toml_text::quoted(value)}, true); }
  void name(std::string_view key, std::string& value) { add(key, {.text = toml_text::quoted(value)}, false); }
  void number(std::string_view key, double& value, const scene_keys::NumberRule& /*rule*/,
              scene_keys::Presence presence) {
    add(key, {.text = toml_text::number(value)}, presence == scene_keys::optional);
  }
  void number_or_nothing(std::string_view key, std::optional<double>& value, const scene_keys::NumberRule& /*rule*/) {
    if (value) add(key, {.text = toml_text::number(*value)}, false);
  }
  void whole(std::string_view key, int& value, scene_keys::WholeRule /*rule*/) {
    add(key, {.text = std::to_string(value)}, true);
  }
  void whole_or_nothing(std::string_view key, std::optional<int>& value, scene_keys::WholeRule /*rule*/) {
    if (value) add(key, {.text = std::to_string(*value)}, false);
  }
  void pair(std::string_view key, double& first, double& second, const scene_keys::NumberRule& /*rule*/,
            std::string_view /*expected*/) {
    add(key, list({first, second}, Shorthand::none), true);
  }
  void file(std::string_view key, std::string& value) { add(key, {.text = toml_text::quoted(value)}, false); }
  void yes_or_no(std::string_view key, bool& value) { add(key, {.text = value ? "true" : "false"}, true); }
  void colour(std::string_view key, Rgbd& value) { add(key, list({value.x, value.y, value.z}, Shorthand::grey), true); }
  void point(std::string_view key, Vec3d& value, scene_keys::Presence presence) {
    add(key, list({value.x, value.y, value.z}, Shorthand::flat), presence == scene_keys::optional);
  }
  void direction(std::string_view key, Vec3d& value, scene_keys::Presence presence) {
    add(key, list({value.x, value.y, value.z}, Shorthand::none), presence == scene_keys::optional);
  }
  void attenuation(std::string_view key, Attenuation& value) {
    add(key, list({value.constant, value.linear, value.quadratic}, Shorthand::none), true);
  }
  void corners(std::string_view key, std::vector<Vec2d>& value) {
    Value corners{.kind = Kind::list};
    for (const Vec2d& corner : value) corners.children.push_back(list({corner.x, corner.y}, Shorthand::none));
    add(key, std::move(corners), false);
  }
  void lengths(std::string_view key, Vec3d& value) {
    add(key, list({value.x, value.y, value.z}, Shorthand::grey), false);
  }
  void limit(std::string_view key, double& value) {
    if (std::isfinite(value)) add(key, {.text = toml_text::number(value)}, false);
  }
  void points(std::string_view key, std::vector<Vec3d>& value) { add(key, points_of(value), false); }
  void holes(std::string_view key, std::vector<std::vector<Vec3d>>& value) {
    Value holes{.kind = Kind::list};
    for (const auto& hole : value) holes.children.push_back(points_of(hole));
    if (!value.empty()) add(key, std::move(holes), false);
  }
  void steps(std::string_view key, std::vector<TransformStep>& value) {
    Value steps{.kind = Kind::list};
    for (const TransformStep& step : value) {
      Value& words = steps.children.emplace_back(Value{.kind = Kind::list});
      words.children.push_back({.text = toml_text::quoted(transform_words[step.kind.index()].word)});
      for (const double number : numbers_of(step)) words.children.push_back({.text = toml_text::number(number)});
    }
    if (!value.empty()) add(key, std::move(steps), false);
  }
  void motion(std::string_view key, Motion& value) {
    Value keys{.kind = Kind::list};
    for (const MotionKey& at : value)
      keys.children.push_back(list({at.time, at.offset.x, at.offset.y, at.offset.z}, Shorthand::none));
    if (!value.empty()) add(key, std::move(keys), false);
  }
  void mesh_file(std::string_view key, MeshShape& value) {
    if (!value.file.empty()) add(key, {.text = toml_text::quoted(value.file)}, false);
  }
  void vertices(std::string_view positions, std::string_view triangles, std::string_view normals, std::string_view uv,
                MeshShape& value) {
    if (!value.file.empty() || !value.mesh) return;
    const Mesh& mesh = *value.mesh;
    add(positions, points_of(mesh.positions), false);
    Value corners{.kind = Kind::list};
    for (const auto& [a, b, c] : mesh.triangles) {
      Value& three = corners.children.emplace_back(Value{.kind = Kind::list});
      for (const std::int32_t corner : {a, b, c}) three.children.push_back({.text = std::to_string(corner)});
    }
    add(triangles, std::move(corners), false);
    if (!mesh.normals.empty()) add(normals, points_of(mesh.normals), false);
    Value pairs{.kind = Kind::list};
    for (const Vec2d& at : mesh.uv) pairs.children.push_back(list({at.x, at.y}, Shorthand::none));
    if (!mesh.uv.empty()) add(uv, std::move(pairs), false);
  }
  void group_name(std::string_view key, Instance& value) { add(key, {.text = toml_text::quoted(value.group)}, false); }
  void define(const Group& /*group*/) {}
  void check(bool /*holds*/, std::string_view /*key*/, std::string_view /*message*/, std::string_view /*hint*/) {}
  template <class Choice>
  void choice(std::string_view key, Choice& value) {
    for (const auto& [each, word] : scene_keys::Names<Choice>::all)
      if (each == value) add(key, {.text = toml_text::quoted(word)}, true);
  }
  template <class... Kinds>
  void type(std::string_view key, std::variant<Kinds...>& value) {
    std::visit(
        [&](auto& kind) {
          add(key, {.text = toml_text::quoted(scene_keys::type_name(kind))}, false);
          add_members(kind);
        },
        value);
  }
  template <class T>
  void table(std::string_view key, T& value, scene_keys::Presence presence) {
    Value members = table_of(value);
    const bool all_default = std::all_of(members.children.begin(), members.children.end(),
                                         [](const Value& member) { return member.is_default; });
    add(key, std::move(members), false);
    table_.children.back().is_default = presence == scene_keys::optional && all_default;
  }
  template <class T>
  void table_or_nothing(std::string_view key, std::optional<T>& value) {
    if (value) add(key, table_of(*value), false);
  }
  template <class T>
  void tables(std::string_view key, std::vector<T>& value) {
    Value tables{.kind = Kind::tables};
    for (T& element : value) tables.children.push_back(table_of(element));
    add(key, std::move(tables), false);
  }
  template <class T>
  void together(std::optional<T>& value) {
    if (value) add_members(*value);
  }

  /// The table of `value`'s members, those marked that a new T has as well.
  template <class T>
  static Value table_of(T& value) {
    Lister lister, fresh;
    T new_value{};
    scene_keys::describe(lister, value);
    scene_keys::describe(fresh, new_value);
    for (Value& member : lister.table_.children) {
      const Value* default_member = fresh.table_.find(member.key);
      if (member.kind == Kind::scalar || member.kind == Kind::list)
        member.is_default = member.is_default && (default_member == nullptr || *default_member == member);
    }
    return std::move(lister.table_);
  }

 private:
  static Value list(std::initializer_list<double> numbers, Shorthand shorthand) {
    Value value{.kind = Kind::list, .shorthand = shorthand};
    for (const double number : numbers) value.children.push_back({.text = toml_text::number(number)});
    return value;
  }

  static Value points_of(const std::vector<Vec3d>& value) {
    Value points{.kind = Kind::list};
    for (const Vec3d& point : value) points.children.push_back(list({point.x, point.y, point.z}, Shorthand::none));
    return points;
  }

  /// `optional` stands for is_default until table_of() has compared the values.
  void add(std::string_view key, Value value, bool optional) {
    value.key = key;
    value.is_default = optional;
    table_.children.push_back(std::move(value));
  }
  template <class T>
  void add_members(T& value) {
    for (Value& member : table_of(value).children) table_.children.push_back(std::move(member));
  }

  Value table_{.kind = Kind::table};
};

std::string list_text(const Value& list) {
  std::size_t count = list.children.size();
  if (list.shorthand == Shorthand::grey && list.children[0].text == list.children[1].text &&
      list.children[0].text == list.children[2].text)
    return list.children[0].text;
  if (list.shorthand == Shorthand::flat && list.children[2].text == "0") count = 2;
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text.append(i == 0 ? "" : ", ").append(inline_text(list.children[i]));
  return text + "]";
}

/// `text` is the value's inline text. A long list of lists gets a line for each.
std::string entry_text(const Value& value) {
  std::string text = value.key + " = " + inline_text(value);
  constexpr std::size_t longest_line = 100;
  if (text.size() <= longest_line || value.kind != Kind::list || value.children[0].kind != Kind::list) return text;
  text = value.key + " = [\n";
  for (const Value& element : value.children) text += "  " + inline_text(element) + ",\n";
  return text + "]";
}

}  // namespace

const Value* Value::find(std::string_view child_key) const {
  const auto child =
      std::find_if(children.begin(), children.end(), [&](const Value& each) { return each.key == child_key; });
  return child == children.end() ? nullptr : &*child;
}

Value values_of(const Scene& scene) {
  Scene copy = scene;
  return Lister::table_of(copy);
}

std::string inline_text(const Value& value) {
  switch (value.kind) {
    case Kind::scalar:
      return value.text;
    case Kind::list:
      return list_text(value);
    case Kind::tables:
    case Kind::table:
      break;
  }
  std::string text;
  for (const Value& child : value.children) {
    if (child.is_default) continue;
    if (!text.empty()) text += ", ";
    if (!child.key.empty()) text += child.key + " = ";
    text += inline_text(child);
  }
  if (value.kind == Kind::tables) return "[" + text + "]";
  return text.empty() ? "{}" : "{ " + text + " }";
}

std::string section_text(const Value& table, const std::string& path) {
  const bool is_deep = path.find('.') != std::string::npos;  // a third level goes into braces
  std::string lines, sections;
  for (const Value& child : table.children) {
    if (child.is_default) continue;
    const std::string child_path = path.empty() ? child.key : path + "." + child.key;
    // Within a file, sections stand apart; within an object they belong together.
    const char* gap = path.empty() ? "\n" : "";
    if (child.kind == Kind::tables) {
      for (const Value& element : child.children)
        sections += "\n[[" + child_path + "]]\n" + section_text(element, child_path);
    } else if (child.kind == Kind::table && !is_deep) {
      sections += gap + ("[" + child_path + "]\n") + section_text(child, child_path);
    } else {
      lines += entry_text(child) + "\n";
    }
  }
  if (path.empty() && lines.empty() && !sections.empty()) sections.erase(0, 1);
  return lines + sections;
}

}  // namespace raywalk::detail
