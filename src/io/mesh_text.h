#pragma once
// Words and numbers of a text file, with their lines. Internal to `io`.

#include "text/error.h"

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk::detail {

/// Reads a text word by word. A word never spans lines.
class TextCursor {
 public:
  explicit TextCursor(const std::string& text, std::size_t at = 0, int line = 1) : text_(text), at_(at), line_(line) {}

  /// The next word of this line; empty at its end. A backslash before the end of a line joins it with the next one, and
  /// ends a word.
  std::string_view word() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (joins_lines()) {
        at_ = text_.find('\n', at_) + 1, ++line_;
        continue;
      }
      if (c != ' ' && c != '\t' && c != '\r') break;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && !joins_lines()) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
  }
  /// To the next word, on whatever line.
  void to_word() {
    while (at_ < text_.size() && is_blank(text_[at_]))
      if (text_[at_++] == '\n') ++line_;
  }
  /// Whether no word is left on this line.
  [[nodiscard]] bool is_line_done() const {
    const std::size_t next = text_.find_first_not_of(" \t\r", at_);
    return next == std::string::npos || text_[next] == '\n';
  }
  /// The rest of this line, trimmed.
  std::string_view rest() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    std::size_t end = at_;
    while (end > begin && is_blank(text_[end - 1])) --end;
    return std::string_view(text_).substr(begin, end - begin);
  }
  /// To the beginning of the next line; false at the end of the text.
  bool next_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    if (at_ >= text_.size()) return false;
    ++at_, ++line_;
    return at_ < text_.size();
  }
  /// The next word, on whatever line; empty at the end of the text.
  std::string_view word_anywhere() {
    for (;;) {
      const std::string_view found = word();
      if (!found.empty() || !next_line()) return found;
    }
  }
  [[nodiscard]] std::size_t position() const { return at_; }
  [[nodiscard]] int line() const { return line_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  /// Whether this line goes on in the next one here.
  [[nodiscard]] bool joins_lines() const {
    return text_[at_] == '\\' && (text_.compare(at_ + 1, 1, "\n") == 0 || text_.compare(at_ + 1, 2, "\r\n") == 0);
  }

  const std::string& text_;
  std::size_t at_;
  int line_;
};

/// A whole word as a decimal number; none if it is anything else, or not finite.
[[nodiscard]] inline std::optional<double> number_in(std::string_view word) {
  const bool hexadecimal = word.find_first_of("xX") != std::string_view::npos;  // which strtod reads
  if (word.empty() || word.size() > 400 || hexadecimal) return std::nullopt;
  // The word is part of a null-terminated text, and is followed there by a blank, a backslash or the end.
  char* end = nullptr;
  const double value = std::strtod(word.data(), &end);
  if (end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A whole word as a whole number.
[[nodiscard]] inline std::optional<std::int64_t> whole_in(std::string_view word) {
  const bool negative = !word.empty() && word[0] == '-';
  const std::string_view digits = word.substr(negative || (!word.empty() && word[0] == '+') ? 1 : 0);
  if (digits.empty() || digits.size() > 18) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
  }
  return negative ? -value : value;
}

}  // namespace raywalk::detail
