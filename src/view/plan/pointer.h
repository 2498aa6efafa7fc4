#pragma once
// The pointer on the plan.

#include "view/state.h"

namespace raywalk {

void end_drag(State& state);
void hover(State& state);
/// After a change of the pane, or of what is as wide as the theme wants it.
void refit(State& state);

}  // namespace raywalk
