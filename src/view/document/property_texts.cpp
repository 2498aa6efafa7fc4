#include "text/toml_text.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/document/properties.h"
#include "view/state.h"
#include "view/text/key_label.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace raywalk {

namespace {

/// A property that is to be given a value, and what came of it.
struct Wanted {
  std::string_view key, text;
  bool found = false;
  std::string refused{}, hint{};
};

std::vector<std::string_view> split(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;
       begin = text.find_first_not_of(blanks)) {
    text.remove_prefix(begin);
    words.push_back(text.substr(0, text.find_first_of(blanks)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

std::optional<std::vector<double>> numbers_of(std::string_view text) {
  // As they are shown, too: with the language's decimal mark and a true minus sign.
  constexpr std::string_view minus = "\u2212";
  std::vector<double> numbers;
  for (const std::string_view word : split(text)) {
    std::string points = word.starts_with(minus) ? "-" + std::string(word.substr(minus.size())) : std::string(word);
    std::replace(points.begin(), points.end(), ',', '.');
    const std::optional<double> number = toml_text::read_number(points);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Lists the properties as texts, and gives one of them another value.
class TextRows final : public PropertyRows {
 public:
  TextRows(Language language, std::vector<PropertyText>* list, Wanted* wanted)
      : language_(language), list_(list), wanted_(wanted) {}

  bool number(const Key& key, double& value, const schema::Number& kind) override {
    return change(key, {&value, 1}, kind, kind.expected());
  }
  bool whole(const Key& key, int& value, const schema::Whole& kind) override {
    const std::string expected = kind.expected();
    const schema::Number limits{
        .words = expected, .low = static_cast<double>(kind.low), .high = static_cast<double>(kind.high)};
    double number = value;
    if (!change(key, {&number, 1}, limits, expected)) return false;
    if (number != std::floor(number)) return refuse("expected " + expected, {});
    value = static_cast<int>(number);
    return true;
  }
  bool flag(const Key& key, bool& value) override {
    std::size_t chosen = value ? 0 : 1;
    if (!choice(key, chosen, {on_or_off.yes, on_or_off.no})) return false;
    value = chosen == 0;
    return true;
  }
  bool choice(const Key& key, std::size_t& chosen, const std::vector<std::string_view>& words) override {
    if (!is_wanted(key, std::string(words[chosen]), words)) return false;
    const auto given = split(wanted_->text);
    const auto at = given.size() == 1 ? std::find(words.begin(), words.end(), given.front()) : words.end();
    if (at == words.end()) return refuse("expected " + schema::quoted_words(words), {});
    const auto now = static_cast<std::size_t>(at - words.begin());
    return std::exchange(chosen, now) != now;
  }
  bool numbers(const Key& key, std::span<double> values, const schema::Tuple& kind) override {
    return change(key, values, kind.number, kind.expected(), kind.shorthand, kind.is_direction);
  }
  bool colour(const Key& key, Rgbd& value, const schema::Colour& kind) override {
    std::array<double, 3> channels{value.x, value.y, value.z};
    if (!numbers(key, channels, kind)) return false;
    value = {channels[0], channels[1], channels[2]};
    return true;
  }
  bool file(const Key& key, std::string& value) override { return words(key, value); }
  bool name(std::string& value) override { return words({"object", "name"}, value); }
  void heading(std::string_view /*id*/) override {}
  void enter(std::string_view table) override { prefix_ += std::string(table) + "."; }
  void leave() override {
    prefix_.pop_back();
    prefix_.erase(prefix_.find_last_of('.') + 1);
  }
  void broken(std::string_view message, std::string_view hint) override { static_cast<void>(refuse(message, hint)); }

 private:
  bool refuse(std::string_view message, std::string_view hint) {
    if (wanted_ != nullptr && wanted_->refused.empty()) wanted_->refused = message, wanted_->hint = hint;
    return false;
  }

  [[nodiscard]] std::string path_of(const Key& key) const {
    std::string path = prefix_ + std::string(key.name);
    return key.row == 0 ? path : fmt::format("{}.{}", path, key.row);
  }

  /// Lists it, and says whether it is the one that is wanted.
  bool is_wanted(const Key& key, std::string value, std::vector<std::string_view> words = {}) {
    const std::string path = path_of(key);
    if (list_ != nullptr) {
      const KeyLabel label(KeyLabel(key.table, key.name, key.sentence), key.row);
      list_->push_back({path, label.words(language_), std::move(value), std::move(words)});
    }
    if (wanted_ == nullptr || wanted_->key != path) return false;
    wanted_->found = true;
    return true;
  }

  bool words(const Key& key, std::string& value) {
    if (!is_wanted(key, value)) return false;
    return std::exchange(value, std::string(wanted_->text)) != wanted_->text;
  }

  bool change(const Key& key, std::span<double> values, const schema::Number& each, const std::string& what,
              schema::Shorthand shorthand = schema::Shorthand::none, bool is_direction = false) {
    std::string shown;
    // One that is not finite is no limit, and no text.
    for (const double value : values)
      if (std::isfinite(value))
        shown += (shown.empty() ? "" : " ") + typeset_number(fmt::format("{:.6g}", value), language_);
    if (!is_wanted(key, shown)) return false;
    auto given = numbers_of(wanted_->text);
    if (!given) return refuse("expected numbers, with spaces between them", {});
    if (given->empty() && shown.empty()) return false;
    if (shorthand == schema::Shorthand::grey && given->size() == 1) given->resize(values.size(), given->front());
    if ((shorthand == schema::Shorthand::flat || is_direction) && given->size() + 1 == values.size())
      given->push_back(0);
    if (given->size() != values.size()) return refuse("expected " + what, each.hint);
    for (const double number : *given)
      if (const auto why = each.refusal(number)) return refuse("expected " + why->expected, why->hint);
    if (std::equal(given->begin(), given->end(), values.begin())) return false;
    std::copy(given->begin(), given->end(), values.begin());
    return true;
  }

  Language language_;
  std::vector<PropertyText>* list_;
  Wanted* wanted_;
  std::string prefix_;
};

}  // namespace

std::vector<PropertyText> property_texts(const State& state, const Target& target) {
  std::vector<PropertyText> list;
  TextRows rows(state.appearance.language, &list, nullptr);
  static_cast<void>(property_rows(state, target, rows));
  return list;
}

Result<std::optional<PropertyEdit>> edit_of_property(const State& state, const Target& target, std::string_view key,
                                                     std::string_view value) {
  Wanted wanted{key, value};
  TextRows rows(state.appearance.language, nullptr, &wanted);
  std::optional<PropertyEdit> edit = property_rows(state, target, rows);
  if (!wanted.found) {
    std::string known;
    for (const PropertyText& each : property_texts(state, target)) known += (known.empty() ? "" : ", ") + each.key;
    return tl::unexpected(Error{{}, 0, 0, fmt::format("there is no key '{}' here", key), "one of: " + known});
  }
  if (!wanted.refused.empty())
    return tl::unexpected(Error{{}, 0, 0, fmt::format("{}: {}", key, wanted.refused), wanted.hint});
  return edit;
}

void action::SetKey::apply(State& state) const {
  if (!exists(state, target)) return;
  const std::size_t gap = std::min(setting.find(' '), setting.size());
  const std::string_view key = std::string_view(setting).substr(0, gap), rest = std::string_view(setting).substr(gap);
  const auto edit =
      edit_of_property(state, target, key, rest.substr(std::min(rest.find_first_not_of(' '), rest.size())));
  if (!edit) return complain(state, edit.error().text());
  if (*edit) std::visit([&](const auto& each) { each.apply(state); }, **edit);
}

}  // namespace raywalk
