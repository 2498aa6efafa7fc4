#pragma once
// Names in reports; those of choices are their words (view/words.h).

#include "view/state.h"

#include <string_view>

namespace raywalk {

[[nodiscard]] std::string_view name_of(Question::Kind kind);
[[nodiscard]] std::string_view name_of(PathPrompt prompt);  ///< empty for none

}  // namespace raywalk
