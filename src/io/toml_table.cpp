#include "io/toml_table.h"

#include "io/scene_values.h"
#include "text/toml_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace raywalk {

namespace {

using detail::Value;

std::string key_text(std::string_view key) {
  const bool is_bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '_' || c == '-');
  });
  return is_bare ? std::string(key) : toml_text::quoted(key);
}

std::string scalar_text(const toml::node& node) {
  if (node.is_string()) return toml_text::quoted(node.value_or(std::string()));
  if (const double number = node.value_or(0.0); node.is_floating_point()) {
    if (std::isnan(number)) return "nan";
    if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
    return toml_text::number(number);
  }
  std::ostringstream text;  // integers, booleans, dates and times
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) text << value;
  });
  return text.str();
}

Value value_of(const toml::node& node, std::string key) {
  Value value;
  value.key = std::move(key);
  if (const toml::table* table = node.as_table()) {
    value.kind = Value::Kind::table;
    for (const auto& [name, child] : *table) value.children.push_back(value_of(child, key_text(name.str())));
  } else if (const toml::array* array = node.as_array()) {
    value.kind = array->is_array_of_tables() ? Value::Kind::tables : Value::Kind::list;
    for (const toml::node& child : *array) value.children.push_back(value_of(child, ""));
  } else {
    value.text = scalar_text(node);
  }
  return value;
}

}  // namespace

std::string text_of(const toml::table& table) { return detail::section_text(value_of(table, ""), ""); }

}  // namespace raywalk
