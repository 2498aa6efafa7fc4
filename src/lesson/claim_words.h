#pragma once
// Words that state something about numbers: "half", "twice", "root", "same". Each language has a list of them,
// lessons/words/CODE.toml; `raywalk lesson check` demands a claim for every such word in a lesson.

#include "text/error.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The list of a language.
struct ClaimWords {
  /// By what they state, with the same names in every language. A form is one or more words in lower case; a final *
  /// matches any ending.
  std::map<std::string, std::vector<std::string>> forms;
  /// Words after which a typed number is a name: "lesson 3", "pixel 9".
  std::vector<std::string> before_names;
};

/// By the languages' codes.
using ClaimWordsByLanguage = std::map<std::string, ClaimWords, std::less<>>;

/// Reads the lists of all languages, each a file such as pt.toml. All must have the same names; English is required.
[[nodiscard]] Result<ClaimWordsByLanguage> read_claim_words(const std::string& folder);
/// One list. Errors name `file_name`.
[[nodiscard]] Result<ClaimWords> parse_claim_words(std::string_view text, const std::string& file_name);

/// A word of a text that states something.
struct StatedWord {
  std::string name;  ///< of ClaimWords::forms
  std::string form;  ///< as in the text
  friend bool operator==(const StatedWord&, const StatedWord&) = default;
};
/// The stated words of a text. Questions, formulas in braces and code state nothing; nor, with `quotes_state` off, do
/// quotes: in a teacher's notes those are answers of students.
[[nodiscard]] std::vector<StatedWord> stated_words(std::string_view text, const ClaimWords& words,
                                                   bool quotes_state = true);

/// An integer typed into a text that is not 0, 1, a right angle, a year or a name; empty if none.
[[nodiscard]] std::string typed_number(std::string_view text, const ClaimWords& words);

}  // namespace raywalk
