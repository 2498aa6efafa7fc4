#include "io/scene_values.h"

#include "io/value_tree.h"
#include "text/toml_text.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace raywalk::detail {

using Kind = Value::Kind;
using Shorthand = Value::Shorthand;

template <class T>
static Value tree(const schema::Table& kind, T& value);
template <class T>
static Value tree(const schema::Tables& /*kind*/, std::vector<T>& value) {
  Value tables{.kind = Kind::tables};
  for (T& element : value) tables.children.push_back(tree(schema::table, element));
  return tables;
}

namespace {

/// The `Fields` of the schema that lists the values of a table.
class Lister {
 public:
  void about(std::string_view /*sentence*/) {}
  template <class T, class ValueKind>
  void key(std::string_view name, T& value, const ValueKind& kind, std::string_view /*sentence*/ = {}) {
    Value member = tree(kind, value);
    const bool is_empty = member.kind == Kind::list && member.children.empty();
    add(name, is_empty ? Value{} : std::move(member), true);
  }
  template <class T, class ValueKind>
  void key(std::string_view name, std::optional<T>& value, const ValueKind& kind, std::string_view /*sentence*/ = {}) {
    add(name, value ? tree(kind, *value) : Value{}, true);
  }
  template <class T, class ValueKind>
  void required(std::string_view name, T& value, const ValueKind& kind, std::string_view /*sentence*/ = {}) {
    add(name, tree(kind, value), false);
  }
  template <class T>
  void left_out(std::string_view name, const T& value, const T& usual) {
    depending_.emplace_back(name, value == usual);
  }
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view /*sentence*/) {
    std::visit(
        [&](auto& kind) {
          add("type", scalar(toml_text::quoted(schema::type_name(kind))), false);
          add_members(kind);
        },
        value);
  }
  template <class T>
  void together(std::optional<T>& value) {
    if (value) add_members(*value);
  }
  template <class... Rule>
  void check(const Rule&... /*rule*/) {}
  void without(std::string_view /*name*/, std::string_view /*message*/, std::string_view /*hint*/) {}
  template <class T>
  void complete(const T& /*value*/) {}

  /// The table of `value`'s members, with those of a default T marked.
  template <class T>
  static Value table_of(T& value) {
    static const Value fresh = [] {
      Lister of_new;
      T new_value{};
      schema::describe(of_new, new_value);
      return std::move(of_new.table_);
    }();
    Lister lister;
    schema::describe(lister, value);
    std::vector<Value>& members = lister.table_.children;
    for (Value& member : members) {
      const Value* usual = fresh.find(member.key);
      if (member.kind == Kind::tables)
        member.is_default = !std::is_same_v<T, schema::SceneFile> && member.children.empty();
      else if (member.kind == Kind::table)
        member.is_default = member.is_default && usual != nullptr && !is_absent(*usual) &&
                            std::all_of(member.children.begin(), member.children.end(),
                                        [](const Value& child) { return child.is_default; });
      else
        member.is_default = member.is_default && (usual == nullptr || *usual == member);
      for (const auto& [key, is_usual] : lister.depending_)
        if (member.key == key) member.is_default = is_usual;
    }
    std::erase_if(members, is_absent);
    return std::move(lister.table_);
  }

 private:
  /// `optional` is stored in is_default until table_of() has compared the values.
  void add(std::string_view name, Value value, bool optional) {
    value.key = name;
    value.is_default = optional;
    table_.children.push_back(std::move(value));
  }
  template <class T>
  void add_members(T& value) {
    for (Value& member : table_of(value).children) table_.children.push_back(std::move(member));
  }

  Value table_{.kind = Kind::table};
  std::vector<std::pair<std::string_view, bool>> depending_;  ///< keys whose default depends on others, if they have it
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

/// A long list of lists is put on a line each.
std::string entry_text(const Value& value) {
  std::string text = value.key + " = " + inline_text(value);
  constexpr std::size_t longest_line = 100;
  if (text.size() <= longest_line || value.kind != Kind::list || value.children[0].kind != Kind::list) return text;
  text = value.key + " = [\n";
  for (const Value& element : value.children) text += "  " + inline_text(element) + ",\n";
  return text + "]";
}

}  // namespace

template <class T>
static Value tree(const schema::Table& /*kind*/, T& value) {
  return Lister::table_of(value);
}

const Value* Value::find(std::string_view child_key) const {
  const auto child =
      std::find_if(children.begin(), children.end(), [&](const Value& each) { return each.key == child_key; });
  return child == children.end() ? nullptr : &*child;
}

Value values_of(const Scene& scene, const Ink& ink) {
  schema::SceneFile copy{scene, ink};
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
  const bool is_deep = path.find('.') != std::string::npos;  // a third level is put in braces
  std::string lines, sections;
  for (const Value& child : table.children) {
    if (child.is_default) continue;
    const std::string child_path = path.empty() ? child.key : path + "." + child.key;
    // Sections of a file are separated; those of an object are not.
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

bool have_same_values(schema::SceneFile a, schema::SceneFile b) {
  std::vector<Object> of_a = std::exchange(a.scene.objects, {}), of_b = std::exchange(b.scene.objects, {});
  const auto same = [](Object& one, Object& other) { return tree(schema::table, one) == tree(schema::table, other); };
  return Lister::table_of(a) == Lister::table_of(b) &&
         std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), same);
}

SceneText scene_text(schema::SceneFile file, std::size_t most) {
  std::vector<Object> objects = std::exchange(file.scene.objects, {});
  Ink ink = std::exchange(file.ink, {});
  SceneText listed{section_text(Lister::table_of(file), "")};
  const auto add = [&](const std::string& key, auto& table) {
    listed.text += "\n[[" + key + "]]\n" + section_text(tree(schema::table, table), key);
  };
  // The last keys of a file.
  for (Object& object : objects) {
    if (listed.text.size() > most) return listed;
    add("object", object);
    ++listed.objects;
  }
  for (InkMark& mark : ink) add("ink", mark);
  return listed;
}

}  // namespace raywalk::detail
