#include "io/scene_reader.h"

#include "io/spelling.h"
#include "io/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raywalk::detail {

using scene_keys::NumberRule;
using scene_keys::Presence;

namespace {

constexpr std::size_t longest_text = 10'000, longest_name = 100, longest_file = 1'000, most_prism_corners = 1'000;

/// A value as a message shows it, in few words.
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
    case toml::node_type::floating_point:
      return fmt::format("{}", node.as_floating_point()->get());
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

// --- SceneReader: what all keys share

const toml::node* SceneReader::take(std::string_view key, Presence presence) {
  known_.push_back(key);
  const toml::node* node = table_.get(key);
  if (node != nullptr) ++found_;
  if (node == nullptr && presence == Presence::required) missing_.push_back(key);
  return node;
}

std::string SceneReader::place_of(std::string_view key) const {
  return place_.empty() ? "[" + std::string(key) + "]" : std::string(key) + " of " + place_;
}

std::string SceneReader::place_of_element(std::string_view key, std::size_t number) const {
  const std::string outer = place_.empty() ? "" : place_.substr(2, place_.find("]]") - 2) + ".";
  return fmt::format("[[{}{}]] number {}", outer, key, number);
}

void SceneReader::fail(const toml::node& at, std::string_view key, const std::string& message, std::string hint) {
  const std::string place = place_.empty() ? std::string(key) : std::string(key) + " of " + place_;
  log_.fail(at.source(), place + ": " + message, std::move(hint));
}

void SceneReader::fail_type(const toml::node& at, std::string_view key, const std::string& expected, std::string hint) {
  fail(at, key, "found " + found(at) + " (expected " + expected + ")", std::move(hint));
}

void SceneReader::finish() {
  // Of several unknown keys the one that stands first in the file.
  const toml::key* unknown = nullptr;
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    const auto &at = key.source().begin, &best = unknown == nullptr ? at : unknown->source().begin;
    if (unknown == nullptr || at.line < best.line || (at.line == best.line && at.column < best.column)) unknown = &key;
  }
  const std::string in = place_.empty() ? "" : " in " + place_;
  if (unknown != nullptr) {
    const std::string nearest = nearest_word(unknown->str(), known_);
    log_.fail(unknown->source(),
              fmt::format("unknown key {}{} (expected {})", toml_text::quoted(unknown->str().substr(0, 60)), in,
                          one_of(known_)),
              nearest.empty() ? "remove it, or look it up in scenes/classic.toml, which explains every key"
                              : "did you mean \"" + nearest + "\"?");
  }
  if (!missing_.empty())
    log_.fail(table_.source(), fmt::format("{} is missing{}", missing_.front(), in),
              fmt::format("add {} = ...; scenes/classic.toml explains every key", missing_.front()));
}

// --- SceneReader: numbers

std::optional<double> SceneReader::number_of(const toml::node& node, std::string_view key, const NumberRule& rule) {
  double value = 0;
  if (const auto* floating = node.as_floating_point()) {
    value = floating->get();
  } else if (const auto* integer = node.as_integer()) {
    value = static_cast<double>(integer->get());
  } else {
    fail_type(node, key, std::string(rule.expected),
              node.is_string() ? "numbers stand without quotes" : std::string(rule.hint));
    return std::nullopt;
  }
  const std::string expected(rule.expected);
  const double least = 1 / scene_keys::most_magnitude;
  if (!std::isfinite(value)) {
    fail_type(node, key, expected, "every number of a scene is finite");
  } else if (std::abs(value) > scene_keys::most_magnitude) {
    fail_type(node, key, fmt::format("at most {:g}", scene_keys::most_magnitude), "choose another unit of length");
  } else if (value < rule.low || (rule.above_low && value == rule.low) || value > rule.high ||
             (rule.below_high && value == rule.high)) {
    fail_type(node, key, expected, std::string(rule.hint));
  } else if (rule.low == 0 && rule.above_low && value < least) {
    fail_type(node, key, fmt::format("at least {:g}", least), "choose another unit of length");
  } else {
    return value;
  }
  return std::nullopt;
}

std::vector<double> SceneReader::numbers_of(const toml::node& node, std::string_view key, const NumberRule& rule,
                                            std::size_t least, std::size_t most, const std::string& expected) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() < least || array->size() > most) {
    fail_type(node, key, expected, std::string(rule.hint));
    return {};
  }
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    const auto value = number_of(element, key, rule);
    if (!value) return {};
    numbers.push_back(*value);
  }
  return numbers;
}

void SceneReader::number(std::string_view key, double& value, const NumberRule& rule, Presence presence) {
  if (const toml::node* node = take(key, presence)) value = number_of(*node, key, rule).value_or(value);
}

void SceneReader::number_or_nothing(std::string_view key, std::optional<double>& value, const NumberRule& rule) {
  const toml::node* node = take(key, Presence::optional);
  value = node == nullptr ? std::nullopt : number_of(*node, key, rule);
}

void SceneReader::whole(std::string_view key, int& value, scene_keys::WholeRule rule) {
  const toml::node* node = take(key, Presence::optional);
  if (node == nullptr) return;
  const auto* integer = node->as_integer();
  if (integer == nullptr || integer->get() < rule.low || integer->get() > rule.high)
    return fail_type(*node, key, fmt::format("a whole number from {} to {}", rule.low, rule.high),
                     node->is_string() ? "numbers stand without quotes" : "write it without a decimal point");
  value = static_cast<int>(integer->get());
}

void SceneReader::whole_or_nothing(std::string_view key, std::optional<int>& value, scene_keys::WholeRule rule) {
  int number = rule.low;
  whole(key, number, rule);
  value = table_.contains(key) ? std::optional(number) : std::nullopt;
}

void SceneReader::pair(std::string_view key, double& first, double& second, const NumberRule& rule,
                       std::string_view expected) {
  const toml::node* node = take(key, Presence::optional);
  if (node == nullptr) return;
  const auto both = numbers_of(*node, key, rule, 2, 2, std::string(expected));
  if (both.empty()) return;
  first = both[0];
  second = both[1];
}

void SceneReader::colour(std::string_view key, Rgbd& value) {
  const toml::node* node = take(key, Presence::optional);
  if (node == nullptr) return;
  if (node->is_number()) {
    if (const auto grey = number_of(*node, key, scene_keys::light_amount)) value = Rgbd(*grey);
    return;
  }
  const auto rgb =
      numbers_of(*node, key, scene_keys::light_amount, 3, 3, "one number for a grey, or [red, green, blue]");
  if (!rgb.empty()) value = {rgb[0], rgb[1], rgb[2]};
}

void SceneReader::point(std::string_view key, Vec3d& value, Presence presence) {
  const toml::node* node = take(key, presence);
  if (node == nullptr) return;
  const auto xyz = numbers_of(*node, key, scene_keys::coordinate, 2, 3, "[x, y] in the plan or [x, y, z]");
  if (!xyz.empty()) value = {xyz[0], xyz[1], xyz.size() == 3 ? xyz[2] : 0.0};
}

void SceneReader::direction(std::string_view key, Vec3d& value, Presence presence) {
  const bool given = table_.contains(key);
  point(key, value, presence);
  if (!given || log_.error()) return;
  const double least = 1 / scene_keys::most_magnitude;
  if (const double size = length(value); !(size >= least))
    fail(*table_.get(key), key,
         value == Vec3d(0.0) ? "found a direction of length 0 (expected any other length)"
                             : fmt::format("found a direction of length {:g} (expected at least {:g})", size, least),
         "only where it points matters, so [0, 0, 1] and [0, 0, 5] are the same");
}

void SceneReader::attenuation(std::string_view key, Attenuation& value) {
  const toml::node* node = take(key, Presence::optional);
  if (node == nullptr) return;
  const auto terms = numbers_of(*node, key, scene_keys::not_negative, 3, 3, "[constant, linear, quadratic]");
  if (terms.empty()) return;
  value = {terms[0], terms[1], terms[2]};
  if (value == Attenuation{0, 0, 0})
    fail(*node, key, "all three terms are 0, which makes the light infinite (expected at least one above 0)",
         "[1, 0, 0] is a light that does not weaken with distance");
}

void SceneReader::corners(std::string_view key, std::vector<Vec2d>& value) {
  value.clear();
  const toml::node* node = take(key, Presence::required);
  if (node == nullptr) return;
  const std::string expected = fmt::format("a list of 3 to {} corners [x, y]", most_prism_corners);
  const std::string hint = "such as corners = [[0, 0], [2, 0], [1, 2]]";
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() > most_prism_corners) return fail_type(*node, key, expected, hint);
  for (const toml::node& element : *array) {
    const auto corner = numbers_of(element, key, scene_keys::coordinate, 2, 2, "a corner [x, y]");
    if (corner.empty()) return;
    value.emplace_back(corner[0], corner[1]);
  }
  if (const std::string reason = why_not_polygon(value); !reason.empty())
    fail(*node, key, reason + " (expected " + expected + " whose edges do not cross)", "the corners go once around");
}

// --- SceneReader: words and tables

void SceneReader::text(std::string_view key, std::string& value) {
  const toml::node* node = take(key, Presence::optional);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  if (text == nullptr) return fail_type(*node, key, "text in quotes", "write " + std::string(key) + " = \"...\"");
  if (text->get().size() > longest_text)
    return fail_type(*node, key, fmt::format("at most {} bytes", longest_text), "say it in fewer words");
  value = text->get();
}

void SceneReader::file(std::string_view key, std::string& value) {
  const toml::node* node = take(key, Presence::required);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  const bool is_name = text != nullptr && !text->get().empty() && text->get().size() <= longest_file &&
                       text->get().find('\0') == std::string::npos;
  if (!is_name)
    return fail_type(*node, key, "the name of a file in quotes", "it is looked for from the scene's own folder");
  value = text->get();
}

void SceneReader::name(std::string_view key, std::string& value) {
  const toml::node* node = take(key, Presence::required);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (text == nullptr || text->get().find_first_not_of(" \t") == std::string::npos ||
      text->get().size() > longest_name || std::any_of(text->get().begin(), text->get().end(), is_control))
    return fail_type(*node, key, fmt::format("one line of text in quotes, 1 to {} bytes long", longest_name),
                     "such as name = \"Solid Sphere\"");
  value = text->get();
  log_.claim_name(value, node->source());
  place_ = place_.substr(0, place_.find("]]") + 2) + " " + toml_text::quoted(value);
}

void SceneReader::yes_or_no(std::string_view key, bool& value) {
  const toml::node* node = take(key, Presence::optional);
  if (node == nullptr) return;
  const auto* flag = node->as_boolean();
  if (flag == nullptr) return fail_type(*node, key, "true or false", "without quotes");
  value = flag->get();
}

std::optional<std::size_t> SceneReader::word_of(const toml::node& node, std::string_view key,
                                                const std::vector<std::string_view>& words) {
  std::string expected;
  for (std::size_t i = 0; i < words.size(); ++i)
    expected += (i == 0 ? "\"" : i + 1 == words.size() ? " or \"" : ", \"") + std::string(words[i]) + "\"";
  const auto* text = node.as_string();
  if (text != nullptr) {
    const auto word = std::find(words.begin(), words.end(), text->get());
    if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
  }
  const std::string nearest = text == nullptr ? "" : nearest_word(text->get(), words);
  fail_type(node, key, expected,
            text == nullptr   ? "write it in quotes"
            : nearest.empty() ? "choose one of these"
                              : "did you mean \"" + nearest + "\"?");
  return std::nullopt;
}

void SceneReader::fail_without_type(std::string_view key, const std::vector<std::string_view>& words) {
  // Without it no other key can be judged, so this cannot wait for finish(). A misspelt one is the better message.
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
  fail_type(node, key, "a table",
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
