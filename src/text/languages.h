#pragma once
// The languages of a folder of data files (text/language.h): each XX.toml in it is one.

#include "text/error.h"
#include "text/language.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The codes of the languages with a file in a folder, "pt" for pt.md: English first, whether present or not. `ending`:
/// ".md".
[[nodiscard]] std::vector<std::string> language_codes_in(const std::string& folder, std::string_view ending);

struct LanguagesRead {
  std::shared_ptr<const Languages> languages;  ///< at least English: the built-in one if its file is broken
  std::vector<Error> broken;                   ///< one per file that could not be read
};

/// If the folder does not exist: English alone.
[[nodiscard]] LanguagesRead read_languages(const std::string& folder);

}  // namespace raywalk
