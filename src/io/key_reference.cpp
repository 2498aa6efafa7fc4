#include "io/key_reference.h"

#include "io/value_tree.h"
#include "scene/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace raywalk {

namespace {

using detail::Value;

template <class Kind>
std::string value_words(const Kind& kind) {
  return kind.expected();
}
std::string value_words(const schema::Number& kind) {
  const bool says_unit = kind.unit.empty() || kind.words.find(kind.unit) != std::string_view::npos;
  return says_unit ? kind.expected() : fmt::format("{}, in {}", kind.words, kind.unit);
}
std::string value_words(const schema::Whole& kind) {
  return kind.unit.empty() ? kind.expected() : fmt::format("{}, in {}", kind.expected(), kind.unit);
}
std::string value_words(const schema::Tuple& kind) {
  std::string text = kind.expected();
  const std::string_view each = kind.number.words;
  if (each != kind.words && each != schema::any_number.words) text += fmt::format(", each {}", each);
  if (kind.is_direction) text += ", of any length but 0";
  return kind.number.unit.empty() ? text : fmt::format("{}, in {}", text, kind.number.unit);
}

std::string value_words(const schema::Colour& kind) { return value_words(static_cast<const schema::Tuple&>(kind)); }

/// The `Fields` of the schema that collects the descriptions of the keys.
class Documenter {
 public:
  explicit Documenter(std::string path) : path_(std::move(path)) {}

  void about(std::string_view sentence) { own_.about = sentence; }
  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view sentence) {
    const Value default_value = detail::tree(kind, value);
    const bool is_empty =
        is_absent(default_value) || (default_value.kind == Value::Kind::list && default_value.children.empty());
    add(name, value_words(kind), is_empty ? "none" : inline_text(default_value), sentence);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& /*value*/, const Kind& kind, std::string_view sentence) {
    add(name, value_words(kind), "none", sentence);
  }
  void key(std::string_view name, std::vector<TransformStep>& /*steps*/, const schema::Steps& kind,
           std::string_view sentence) {
    add(name, value_words(kind), "none", sentence);
    add_steps(name, TransformStep{}.kind);
  }
  template <class T, class Kind>
  void required(std::string_view name, T& /*value*/, const Kind& kind, std::string_view sentence) {
    add(name, value_words(kind), "", sentence);
  }
  template <class T>
  void key(std::string_view name, T& /*value*/, const schema::Table& kind) {
    add_table<T>(name, value_words(kind), "none", false);
  }
  template <class T>
  void key(std::string_view name, std::optional<T>& /*value*/, const schema::Table& kind) {
    add_table<T>(name, value_words(kind), "none", false);
  }
  template <class T>
  void key(std::string_view name, std::vector<T>& /*value*/, const schema::Tables& kind) {
    add_table<T>(name, value_words(kind), "none", true);
  }
  template <class T>
  void required(std::string_view name, T& /*value*/, const schema::Table& kind) {
    add_table<T>(name, value_words(kind), "", false);
  }
  template <class... Kinds>
  void type(const std::variant<Kinds...>& /*value*/, std::string_view sentence) {
    add("type", schema::quoted_words({schema::type_name(Kinds{})...}), "", sentence);
    (add_type<Kinds>(), ...);
  }
  template <class T>
  void together(std::optional<T>& /*value*/) {
    T value{};
    const std::size_t before = own_.keys.size();
    schema::describe(*this, value);
    for (std::size_t i = before; i < own_.keys.size(); ++i)
      if (own_.keys[i].default_value.empty()) own_.keys[i].default_value = "none";  // all of them are optional
  }
  template <class... Rule>
  void check(const Rule&... /*rule*/) {}
  template <class T>
  void left_out(std::string_view /*name*/, const T& /*value*/, const T& /*usual*/) {}
  void without(std::string_view /*name*/, std::string_view /*message*/, std::string_view /*hint*/) {}
  template <class T>
  void complete(const T& /*value*/) {}

  /// The table of a default T, then those of its types, then those within it.
  template <class T>
  static std::vector<KeyTable> tables_of(std::string name, std::string heading, std::string path) {
    T value{};
    Documenter documenter(std::move(path));
    documenter.own_.name = std::move(name);
    documenter.own_.heading = std::move(heading);
    schema::describe(documenter, value);
    std::vector<KeyTable> all{std::move(documenter.own_)};
    for (auto* more : {&documenter.types_, &documenter.inner_}) all.insert(all.end(), more->begin(), more->end());
    return all;
  }

 private:
  void add(std::string_view name, std::string expected, std::string default_value, std::string_view sentence) {
    own_.keys.push_back({std::string(name), std::move(expected), std::move(default_value), std::string(sentence)});
  }
  template <class T>
  void add_table(std::string_view name, std::string expected, std::string default_value, bool is_many) {
    const std::string path = path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
    const auto tables = tables_of<T>(std::string(name), is_many ? "[[" + path + "]]" : "[" + path + "]", path);
    add(name, std::move(expected), std::move(default_value), tables.front().about);
    // The objects of a group and the maps of a second material are the same as those further up.
    if (!is_many || (path_ != "group" && !path_.ends_with(".second")))
      inner_.insert(inner_.end(), tables.begin(), tables.end());
  }
  template <class T>
  void add_type() {
    const std::string name(schema::type_name(T{}));
    const auto tables = tables_of<T>(name, fmt::format("{} of type \"{}\"", own_.heading, name), path_);
    types_.insert(types_.end(), tables.begin(), tables.end());
  }
  template <class... Kinds>
  void add_steps(std::string_view name, const std::variant<Kinds...>& /*kinds*/) {
    KeyTable steps{std::string(name), "steps of a transform", "Each is a list of its name and its numbers.", {}};
    const auto add_step = [&](const schema::StepWords& of) {
      steps.keys.push_back({fmt::format("[\"{}\", {}]", of.word, of.arguments), "", "", std::string(of.meaning)});
    };
    (add_step(schema::step_words(Kinds{})), ...);
    inner_.push_back(std::move(steps));
  }

  std::string path_;
  KeyTable own_;
  std::vector<KeyTable> types_, inner_;
};

/// `text` in lines of at most 100 characters, all but the first indented by `indent`.
std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t longest = 100;
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = text.size();
    if (end - at > longest - indent) end = text.rfind(' ', at + longest - indent);
    lines += std::string(at == 0 ? 0 : indent, ' ') + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::vector<KeyTable> key_tables() { return Documenter::tables_of<schema::SceneFile>("scene", "scene", ""); }

std::string reference_text(const std::vector<KeyTable>& tables) {
  constexpr std::size_t indent = 18;
  std::string text;
  for (const KeyTable& table : tables) {
    text += (text.empty() ? "" : "\n") + table.heading + "\n" + wrapped(table.about, 0);
    for (const KeyEntry& key : table.keys) {
      const std::string default_value = key.default_value.empty()     ? "must be given"
                                        : key.default_value == "none" ? "may be left out"
                                                                      : key.default_value + " when left out";
      text += fmt::format("  {:<{}}{}", key.name, indent - 2,
                          key.name.size() < indent - 2 || key.expected.empty() ? "" : " ");
      text += key.expected.empty() ? "\n" : wrapped(key.expected + "; " + default_value, indent);
      text += std::string(indent, ' ') + wrapped(key.sentence, indent);
    }
  }
  return text;
}

}  // namespace raywalk
