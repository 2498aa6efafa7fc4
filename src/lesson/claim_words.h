#pragma once
// Words that state something about numbers: "half", "twice", "root", "same". Each language has a list of them as data,
// lessons/words/CODE.toml; `raywalk lesson check` asks of every such word in a lesson which claim bears it out.

#include "io/error.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The list of a language.
struct ClaimWords {
  /// By what they state, named alike in every language. A form is one or more words in lower case; a * at the end of
  /// one stands for any ending.
  std::map<std::string, std::vector<std::string>> forms;
  /// Words before which a typed number is a name: "lesson 3", "pixel 9".
  std::vector<std::string> before_names;
};

/// By the languages' codes.
using ClaimWordsByLanguage = std::map<std::string, ClaimWords, std::less<>>;

/// Reads the lists of all languages, each a file such as pt.toml. Each has to have the same names; English has to be
/// there.
[[nodiscard]] Result<ClaimWordsByLanguage> read_claim_words(const std::string& folder);
/// One of them. Errors name `file_name`.
[[nodiscard]] Result<ClaimWords> parse_claim_words(std::string_view text, const std::string& file_name);

/// A word of a text that states something.
struct StatedWord {
  std::string name;  ///< of ClaimWords::forms
  std::string form;  ///< as the text has it
  friend bool operator==(const StatedWord&, const StatedWord&) = default;
};
/// Those of a text. A question states nothing, nor do formulas in braces and code; nor, with `quotes_state` off, what
/// stands in quotes: in a teacher's notes those are answers of students.
[[nodiscard]] std::vector<StatedWord> stated_words(std::string_view text, const ClaimWords& words,
                                                   bool quotes_state = true);

/// A whole number that is typed into a text, and neither 0, 1, a right angle, a year nor a name; empty for none.
[[nodiscard]] std::string typed_number(std::string_view text, const ClaimWords& words);

}  // namespace raywalk
