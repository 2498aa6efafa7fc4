// The languages that ship, as the program reads them.
#pragma once

#include "text/languages.h"

#include <string>

namespace raywalk::test {

inline const LanguagesRead& shipped_texts() {
  static const LanguagesRead read = read_languages(std::string(RAYWALK_SOURCE_DIR) + "/src/text");
  return read;
}

inline std::vector<Language> all_languages() { return shipped_texts().languages->all(); }

inline const Language in_english = shipped_texts().languages->english();
inline const Language in_portuguese = shipped_texts().languages->find("pt").value();

}  // namespace raywalk::test
