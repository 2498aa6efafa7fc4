#include "io/toml_table.h"

#include "io/scene_values.h"
#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace raywalk {

namespace {

using detail::Value;

std::string key_text(std::string_view key) {
  const bool is_bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '_' || c == '-');
  });
  return is_bare ? std::string(key) : toml_text::quoted(key);
}

std::string date_text(const toml::date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

std::string time_text(const toml::time& time) {
  std::string text = fmt::format("{:02}:{:02}:{:02}", time.hour, time.minute, time.second);
  return time.nanosecond == 0 ? text : text + fmt::format(".{:09}", time.nanosecond);
}

std::string offset_text(const std::optional<toml::time_offset>& offset) {
  if (!offset) return "";
  const int minutes = std::abs(offset->minutes);
  return minutes == 0 ? "Z" : fmt::format("{}{:02}:{:02}", offset->minutes < 0 ? '-' : '+', minutes / 60, minutes % 60);
}

std::string scalar_text(const toml::node& node) {
  if (node.is_string()) return toml_text::quoted(node.value_or(std::string()));
  if (const double number = node.value_or(0.0); node.is_floating_point()) {
    if (std::isnan(number)) return "nan";
    if (std::isinf(number)) return number < 0 ? "-inf" : "inf";
    return toml_text::number(number);
  }
  if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
  if (const auto* date = node.as_date()) return date_text(date->get());
  if (const auto* time = node.as_time()) return time_text(time->get());
  const toml::date_time moment = node.value_or(toml::date_time());
  return date_text(moment.date) + "T" + time_text(moment.time) + offset_text(moment.offset);
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
