#pragma once
// All keys and what they do, from the table of commands: Help shows this list and lessons/README.md has it as a table,
// which a test compares.

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
