#pragma once
// Reads texts of words and numbers, such as NFF and the course format, word by word, with a place for every message.
// Internal to `io`.

#include "scene/schema_kinds.h"
#include "text/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::detail {

/// Refuses what is not text: an empty file, or one with control characters.
[[nodiscard]] Result<void> check_plain_text(std::string_view text, const std::string& file);

/// Reads a text. The first error is kept; after it every call returns nothing or zero at once, so callers need to check
/// only once per item. `#` begins a comment to the end of the line.
class WordReader {
 public:
  /// Where the numbers of an item may be.
  enum class Scope {
    line,  ///< in the line of its first word
    text,  ///< on any lines
  };

  WordReader(std::string_view text, std::string file, Scope scope)
      : text_(text), file_(std::move(file)), scope_(scope) {}

  /// The first word of the next item, on any line; empty at the end of the text and after an error.
  [[nodiscard]] std::string_view item();
  /// The item's next word; empty if there are no more.
  [[nodiscard]] std::string_view word();
  /// The same without consuming it.
  [[nodiscard]] std::string_view peek();
  /// In a line-based text: refuses extra words.
  void end_item();

  /// The item's next number. `what` names it in messages: "the radius".
  double number(std::string_view what, const schema::Number& rule);
  int whole(std::string_view what, schema::Whole rule);
  Vec3d point(std::string_view what);
  Vec3d direction(std::string_view what);
  Rgbd colour(std::string_view what, const schema::Number& rule = schema::light_amount);

  /// At the last word.
  void fail(std::string message, std::string hint);
  void warn(const std::string& message);
  /// In the line of the item.
  void fail_item(std::string message, std::string hint);
  /// "found X (expected ...)" about the last word, or that none is left.
  void fail_word(std::string_view what, std::string_view word, const std::string& expected, std::string hint);

  [[nodiscard]] bool ok() const { return !error_; }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  /// Skips blanks and comments, and line ends if `over_lines`. Stops at a word, a line end or the text's end.
  void skip(bool over_lines);
  [[nodiscard]] std::string_view take();
  [[nodiscard]] std::size_t word_end(std::size_t from) const;
  /// The place of a word. Its column is counted only for messages: a line may have a million words.
  struct Place {
    int line = 1;
    std::size_t line_begin = 0, at = 0;
  };
  [[nodiscard]] int column_of(const Place& place) const;
  void fail_at(const Place& place, std::string message, std::string hint);

  std::string_view text_;
  std::string file_;
  Scope scope_;
  Place here_;
  Place word_place_;  ///< of the last word, or where one is missing
  Place item_place_;
  std::string_view item_;
  std::optional<Error> error_;
  std::vector<std::string> warnings_;
};

}  // namespace raywalk::detail
