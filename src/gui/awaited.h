#pragma once
// What an action has to read or to make before the window can go on.

#include "view/action.h"

#include <optional>
#include <string>

namespace raywalk {

/// What may take seconds: the name of the scene file or lesson, and what is said meanwhile.
struct Awaited {
  std::string name, words;
};

/// What the action has to read or to make first; none if nothing.
[[nodiscard]] std::optional<Awaited> awaited_by(const State& state, const Action& action);

}  // namespace raywalk
