#include "io/word_reader.h"

#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace raywalk::detail {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool is_control(char c) {
  return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && !is_blank(c)) || static_cast<unsigned char>(c) == 0x7f;
}

/// A word as shown in messages.
std::string shown(std::string_view word) {
  constexpr std::size_t longest = 40;
  return word.size() <= longest ? toml_text::quoted(word) : "a long word";
}

}  // namespace

Result<void> check_plain_text(std::string_view text, const std::string& file) {
  if (text.find_first_not_of(" \t\r\n\f\v") == std::string_view::npos)
    return tl::unexpected(Error{file, 0, 0, "the file is empty (expected a scene)", "is this the right file?"});
  const auto control = std::find_if(text.begin(), text.end(), is_control);
  if (control == text.end()) return {};
  const auto line = 1 + std::count(text.begin(), control, '\n');
  return tl::unexpected(
      Error{file, static_cast<int>(line), 0,
            fmt::format("this is no text: it holds the byte 0x{:02x} (expected a scene in plain text)",
                        static_cast<unsigned>(static_cast<unsigned char>(*control))),
            "is this the right file?"});
}

std::size_t WordReader::word_end(std::size_t from) const {
  std::size_t end = from;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '#' && !is_blank(text_[end])) ++end;
  return end;
}

int WordReader::column_of(const Place& place) const {
  int column = 1;
  for (std::size_t i = place.line_begin; i < place.at; ++i)
    if ((static_cast<unsigned char>(text_[i]) & 0xc0) != 0x80) ++column;
  return column;
}

void WordReader::skip(bool over_lines) {
  std::size_t& at = here_.at;
  while (at < text_.size()) {
    if (is_blank(text_[at])) {
      ++at;
    } else if (text_[at] == '#') {
      at = std::min(text_.find('\n', at), text_.size());
    } else if (text_[at] == '\n' && over_lines) {
      here_.line_begin = ++at;
      ++here_.line;
    } else {
      return;
    }
  }
}

std::string_view WordReader::take() {
  word_place_ = here_;
  here_.at = word_end(here_.at);
  return text_.substr(word_place_.at, here_.at - word_place_.at);
}

std::string_view WordReader::item() {
  if (error_) return {};
  skip(true);
  item_ = take();
  item_place_ = word_place_;
  return item_;
}

std::string_view WordReader::word() {
  if (error_) return {};
  skip(scope_ == Scope::text);
  return take();
}

std::string_view WordReader::peek() {
  if (error_) return {};
  skip(scope_ == Scope::text);
  return text_.substr(here_.at, word_end(here_.at) - here_.at);
}

void WordReader::end_item() {
  if (scope_ == Scope::text || error_) return;
  const std::string_view more = word();
  if (!more.empty())
    fail(fmt::format("{}: found {} (expected the end of the line)", item_, shown(more)),
         "one command stands in a line, with as many numbers as it takes");
}

void WordReader::fail_at(const Place& place, std::string message, std::string hint) {
  if (!error_) error_ = Error{file_, place.line, column_of(place), std::move(message), std::move(hint)};
}

void WordReader::fail(std::string message, std::string hint) {
  fail_at(word_place_, std::move(message), std::move(hint));
}

void WordReader::fail_item(std::string message, std::string hint) {
  fail_at(item_place_, std::move(message), std::move(hint));
}

void WordReader::warn(const std::string& message) {
  warnings_.push_back(fmt::format("{}:{}:{}: warning: {}", file_, word_place_.line, column_of(word_place_), message));
}

void WordReader::fail_word(std::string_view what, std::string_view word, const std::string& expected,
                           std::string hint) {
  if (word.empty())
    return fail(fmt::format("{} of {}: the {} ends here (expected {})", what, item_,
                            here_.at < text_.size() ? "line" : "file", expected),
                std::move(hint));
  fail(fmt::format("{} of {}: found {} (expected {})", what, item_, shown(word), expected), std::move(hint));
}

double WordReader::number(std::string_view what, const schema::Number& rule) {
  const std::string_view text = word();
  if (error_) return 0;
  const std::optional<double> value = toml_text::read_number(text);
  const auto refusal = value ? rule.refusal(*value) : std::nullopt;
  if (!value)
    fail_word(what, text, rule.expected(), "a number is written as 2, -0.5 or 1e-3");
  else if (refusal)
    fail_word(what, text, refusal->expected, refusal->hint);
  else
    return *value;
  return 0;
}

int WordReader::whole(std::string_view what, schema::Whole rule) {
  std::string_view text = word();
  if (error_) return rule.low;
  const std::string_view all = text;
  if (text.size() > 1 && text.front() == '+') text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool digits = !text.empty() && end == text.data() + text.size();
  if (digits && error == std::errc() && rule.low <= value && value <= rule.high) return value;
  fail_word(what, all, rule.expected(), digits ? "choose one in this range" : "write it in plain digits");
  return rule.low;
}

Vec3d WordReader::point(std::string_view what) {
  const double x = number(what, schema::coordinate), y = number(what, schema::coordinate),
               z = number(what, schema::coordinate);
  return {x, y, z};
}

Vec3d WordReader::direction(std::string_view what) {
  const Vec3d v = point(what);
  const std::optional<Vec3d> usable = schema::usable_direction(v);
  if (!error_ && !usable)
    fail(fmt::format("{} of {}: the direction has length 0 (expected any other)", what, item_),
         "at least one of its three numbers is not 0");
  return usable.value_or(v);
}

Rgbd WordReader::colour(std::string_view what, const schema::Number& rule) {
  const double r = number(what, rule), g = number(what, rule), b = number(what, rule);
  return {r, g, b};
}

}  // namespace raywalk::detail
