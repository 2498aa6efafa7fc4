#include "io/scene_reader.h"

#include "text/spelling.h"
#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raywalk::detail {

namespace {

constexpr std::size_t longest_text = 10'000, longest_file = 4'000;

/// A value as shown in messages, in few words.
std::string found(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::none:
      return "nothing";
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return fmt::format("a list of {}", node.as_array()->size());
    case toml::node_type::string: {
      const std::string& text = node.as_string()->get();
      return text.size() <= 40 ? toml_text::quoted(text) : "a long text";
    }
    case toml::node_type::integer:
      return fmt::format("{}", node.as_integer()->get());
    case toml::node_type::floating_point: {
      const std::string digits = fmt::format("{}", node.as_floating_point()->get());
      const bool looks_whole = digits.find_first_not_of("-0123456789") == std::string::npos;
      return looks_whole ? digits + ".0" : digits;  // which keys of whole numbers refuse
    }
    case toml::node_type::boolean:
      return node.as_boolean()->get() ? "true" : "false";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
      return "a date or time";
  }
  return "something else";
}

}  // namespace

// --- ReadLog

void ReadLog::fail(const toml::source_region& where, std::string message, std::string hint) {
  if (error_) return;
  error_ = Error{file_, static_cast<int>(where.begin.line), static_cast<int>(where.begin.column), std::move(message),
                 std::move(hint)};
}

void ReadLog::warn(const toml::source_region& where, const std::string& message) {
  warnings_.push_back(fmt::format("{}:{}:{}: warning: {}", file_, where.begin.line, where.begin.column, message));
}

void ReadLog::claim_name(const std::string& name, const toml::source_region& where) {
  const auto [entry, is_new] = names_.emplace(name, where.begin.line);
  if (!is_new)
    fail(where,
         fmt::format("name: {} is already used in line {} (expected a name of its own)", toml_text::quoted(name),
                     entry->second),
         "every object and light needs a different name");
}

void ReadLog::claim_file(const std::string& name, const toml::source_region& where) {
  files_.emplace(std::filesystem::path(path_beside(file_, name)).lexically_normal(), Named{name, where.begin});
}

Error ReadLog::where_named(Error error) const {
  const auto found = files_.find(std::filesystem::path(error.file).lexically_normal());
  if (found == files_.end()) return error;
  const auto& [name, at] = found->second;
  return {file_, static_cast<int>(at.line), static_cast<int>(at.column),
          fmt::format("file {}: {}", toml_text::quoted(name), error.message), std::move(error.hint)};
}

// --- SceneReader: what all keys share

const toml::node* SceneReader::take(std::string_view key) {
  known_.push_back(key);
  const toml::node* node = table_.get(key);
  if (node != nullptr) ++found_;
  return node;
}

std::string SceneReader::place_of(std::string_view key) const {
  return place_.empty() ? "[" + std::string(key) + "]" : std::string(key) + " of " + place_;
}

namespace {
constexpr std::string_view of = " of ";
}  // namespace

std::string SceneReader::place_of_element(std::string_view key, std::size_t number) const {
  if (place_.empty()) return fmt::format("[[{}]] number {}", key, number);
  // As TOML names it: `map` in `material of [[object]] "Ball"` is [[object.material.map]], of "Ball".
  const std::size_t begin = place_.find('['), first = place_.find_first_not_of('[', begin), last = place_.find(']');
  std::string name = place_.substr(first, last - first) + ".", whose;
  for (std::string_view within(place_.data(), begin); !within.empty();) {
    within.remove_suffix(of.size());
    const std::size_t before = within.rfind(of);
    const std::size_t at = before == std::string_view::npos ? 0 : before + of.size();
    name += std::string(within.substr(at)) + ".";
    within = within.substr(0, at);
    whose = place_.substr(place_.find_first_not_of(']', last));
  }
  return fmt::format("[[{}{}]] number {}{}", name, key, number, whose.empty() ? "" : " of" + whose);
}

void SceneReader::fail(const toml::node& at, std::string_view key, const std::string& message, std::string hint) {
  const std::string place = place_.empty() ? std::string(key) : std::string(key) + " of " + place_;
  log_.fail(at.source(), place + ": " + message, std::move(hint));
}

void SceneReader::fail_type(const toml::node& at, std::string_view key, const std::string& expected,
                            std::string_view hint) {
  fail(at, key, "found " + found(at) + " (expected " + expected + ")", std::string(hint));
}

void SceneReader::check(std::string_view key, bool holds, std::string_view message, std::string_view hint) {
  if (holds || broken_) return;
  const toml::node* node = table_.get(key);
  broken_ = [this, at = node == nullptr ? &table_ : node, key, text = std::string(message), hint = std::string(hint)] {
    fail(*at, key, text, hint);
  };
}

void SceneReader::finish() {
  // Of several unknown keys, the first in the file.
  const toml::key* unknown = nullptr;
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    const auto &at = key.source().begin, &best = unknown == nullptr ? at : unknown->source().begin;
    if (unknown == nullptr || at.line < best.line || (at.line == best.line && at.column < best.column)) unknown = &key;
  }
  const std::string in = place_.empty() ? "" : " in " + place_;
  if (unknown != nullptr) {
    const std::string nearest = nearest_word(unknown->str(), known_);
    log_.fail(
        unknown->source(),
        fmt::format("unknown key {}{} (expected {})", toml_text::quoted(unknown->str().substr(0, 60)), in,
                    one_of(known_)),
        nearest.empty() ? "remove it; `raywalk info --keys` explains every key" : "did you mean \"" + nearest + "\"?");
  }
  if (!missing_.empty())
    log_.fail(table_.source(), fmt::format("{} is missing{}", missing_.front(), in),
              fmt::format("add {} = ...; `raywalk info --keys` explains every key", missing_.front()));
  if (broken_) broken_();
}

// --- SceneReader: numbers

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Number& kind, double& value) {
  if (!node.is_number()) {
    fail_type(node, key, kind.expected(), node.is_string() ? "numbers stand without quotes" : kind.hint);
    return false;
  }
  const auto* integer = node.as_integer();  // as a double, an integer that is not representable would be 0
  const double given = integer != nullptr ? static_cast<double>(integer->get()) : node.as_floating_point()->get();
  const auto refusal = kind.refusal(given);
  if (!std::isfinite(given))
    fail_type(node, key, kind.expected(), "every number of a scene is finite");
  else if (refusal)
    fail_type(node, key, refusal->expected, refusal->hint);
  else
    value = given;
  return std::isfinite(given) && !refusal;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Whole& kind, int& value) {
  const auto* integer = node.as_integer();
  if (integer != nullptr && kind.low <= integer->get() && integer->get() <= kind.high) {
    value = static_cast<int>(integer->get());
    return true;
  }
  fail_type(node, key, kind.expected(),
            node.is_string() ? "numbers stand without quotes" : "write it without a decimal point");
  return false;
}

std::vector<double> SceneReader::numbers_of(const toml::node& node, std::string_view key, const schema::Tuple& kind,
                                            std::size_t count) {
  double number = 0;
  if (node.is_number() && kind.shorthand == schema::Shorthand::grey)
    return read(node, key, kind.number, number) ? std::vector(count, number) : std::vector<double>();
  const bool may_be_short = kind.shorthand == schema::Shorthand::flat || kind.is_direction;
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() > count || array->size() + (may_be_short ? 1 : 0) < count) {
    fail_type(node, key, kind.expected(), kind.number.hint);
    return {};
  }
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    if (!read(element, key, kind.number, number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

bool SceneReader::to_direction(const toml::node& node, std::string_view key, Vec3d& value) {
  const std::optional<Vec3d> usable = schema::usable_direction(value);
  if (usable)
    value = *usable;
  else
    fail(node, key, "found a direction of length 0 (expected any other length)",
         "only where it points matters, so [0, 0, 1] and [0, 0, 5] are the same");
  return usable.has_value();
}

const toml::array* SceneReader::rows_of(const toml::node& node, std::string_view key, const schema::Rows& kind) {
  const toml::array* array = node.as_array();
  if (array != nullptr && kind.least <= array->size() && array->size() <= kind.most) return array;
  fail_type(node, key, kind.expected(), kind.hint);
  return nullptr;
}

// --- SceneReader: words and tables

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Text& kind, std::string& value) {
  const auto* text = node.as_string();
  if (text == nullptr) {
    fail_type(node, key, kind.expected(), "write " + std::string(key) + " = \"...\"");
  } else if (text->get().size() > longest_text) {
    fail_type(node, key, fmt::format("at most {} bytes", longest_text), "say it in fewer words");
  } else {
    value = text->get();
    return true;
  }
  return false;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::FileName& kind, std::string& value) {
  const auto* text = node.as_string();
  if (text != nullptr && !text->get().empty() && text->get().size() <= longest_file &&
      text->get().find('\0') == std::string::npos) {
    value = text->get();
    log_.claim_file(value, node.source());
    return true;
  }
  fail_type(node, key, kind.expected(), kind.hint);
  return false;
}

/// The text of `node`, if it is one line that says something; else null.
static const std::string* one_line_of(const toml::node& node, std::size_t longest) {
  const auto* text = node.as_string();
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (text == nullptr || text->get().find_first_not_of(" \t") == std::string::npos || text->get().size() > longest ||
      std::any_of(text->get().begin(), text->get().end(), is_control))
    return nullptr;
  return &text->get();
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::OneLine& kind, std::string& value) {
  const std::string* line = one_line_of(node, kind.longest);
  if (line == nullptr) {
    fail_type(node, key, kind.expected(), "write " + std::string(key) + " = \"...\"");
    return false;
  }
  value = *line;
  return true;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Name& kind, std::string& value) {
  const std::string* name = one_line_of(node, kind.longest);
  if (name == nullptr) {
    fail_type(node, key, kind.expected(), "such as name = \"Solid Sphere\"");
    return false;
  }
  value = *name;
  log_.claim_name(value, node.source());
  place_ = place_.substr(0, place_.find("]]") + 2) + " " + toml_text::quoted(value);
  return true;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Names& kind,
                       std::vector<std::string>& value) {
  value.clear();
  const toml::array* array = node.as_array();
  const bool fits = array != nullptr && array->size() <= kind.most;
  if (!fits) fail_type(node, key, kind.expected(), "such as [\"Lamp\", \"Floor\"]");
  for (std::size_t i = 0; fits && i < array->size(); ++i)
    if (!read(*array->get(i), key, schema::text, value.emplace_back())) return false;
  return fits;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Flag& kind, bool& value) {
  const auto* flag = node.as_boolean();
  if (flag == nullptr)
    fail_type(node, key, kind.expected(), "without quotes");
  else
    value = flag->get();
  return flag != nullptr;
}

std::optional<std::size_t> SceneReader::word_of(const toml::node& node, std::string_view key,
                                                const std::vector<std::string_view>& words) {
  const auto* text = node.as_string();
  if (text != nullptr) {
    const auto word = std::find(words.begin(), words.end(), text->get());
    if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
  }
  const std::string nearest = text == nullptr ? "" : nearest_word(text->get(), words);
  fail_type(node, key, schema::quoted_words(words),
            text == nullptr   ? "write it in quotes"
            : nearest.empty() ? "choose one of these"
                              : "did you mean \"" + nearest + "\"?");
  return std::nullopt;
}

void SceneReader::fail_without_type(const std::vector<std::string_view>& words) {
  constexpr std::string_view key = "type";
  // Without it no other key can be checked, so this cannot wait for finish(). A misspelt one gives the better message.
  for (const auto& [other, node] : table_) {
    if (nearest_word(other.str(), {key}).empty()) continue;
    log_.fail(other.source(), fmt::format("unknown key {} in {}", toml_text::quoted(other.str()), place_),
              fmt::format("did you mean \"{}\"?", key));
  }
  log_.fail(table_.source(), fmt::format("{} is missing in {} (expected {})", key, place_, one_of(words)),
            fmt::format("add {} = \"{}\"", key, words.front()));
}

const toml::table* SceneReader::table_of(const toml::node& node, std::string_view key) {
  if (node.is_table()) return node.as_table();
  const bool doubled = node.is_array_of_tables() && place_.empty();
  fail_type(node, key, schema::table.expected(),
            doubled ? fmt::format("there is only one: write [{0}], not [[{0}]]", key)
                    : fmt::format("write [{}] on a line of its own, its keys below", key));
  return nullptr;
}

const toml::array* SceneReader::tables_of(const toml::node& node, std::string_view key) {
  const toml::array* array = node.as_array();
  if (array != nullptr && (array->empty() || node.is_array_of_tables())) return array;
  fail_type(node, key, fmt::format("[[{}]] tables", key),
            fmt::format("write [[{}]] with two brackets above the keys of each {}", key, key));
  return nullptr;
}

}  // namespace raywalk::detail
