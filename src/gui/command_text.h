#pragma once
// What commands are called, and what they do: a family of view/text.h.

#include "gui/commands.h"

#include <string_view>

namespace raywalk {

struct CommandText {
  std::string_view label;  ///< as on its button: "STEP"
  std::string_view hint;   ///< what it does, in one clause, without the key
};

[[nodiscard]] CommandText english(Command command);
[[nodiscard]] CommandText portuguese(Command command);

}  // namespace raywalk
