#pragma once
// All keys and what they do, from the table of commands: shown in Help and, checked by a test, in lessons/README.md.

#include "text/language.h"

#include <string>
#include <vector>

namespace raywalk {

struct KeyListRow {
  std::string keys;  ///< "Space, \u2192 \u00b7 \u2190"
  std::string does;  ///< "one step on \u00b7 back"
};

[[nodiscard]] std::vector<KeyListRow> key_list(Language language);

}  // namespace raywalk
