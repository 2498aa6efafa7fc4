#pragma once
// The languages of a folder of data files (text/language.h): each XX.toml in it is one.

#include "io/error.h"
#include "text/language.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The codes of the languages that a folder has a file of, "pt" of pt.md: English first, whether it is there or not.
/// `ending`: ".md".
[[nodiscard]] std::vector<std::string> language_codes_in(const std::string& folder, std::string_view ending);

struct LanguagesRead {
  std::shared_ptr<const Languages> languages;  ///< English at least: where its file is broken, as the program holds it
  std::vector<Error> broken;                   ///< a file each that could not be read
};

/// Of a folder that is not there: English alone.
[[nodiscard]] LanguagesRead read_languages(const std::string& folder);

}  // namespace raywalk
