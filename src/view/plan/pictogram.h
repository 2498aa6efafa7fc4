#pragma once
// The four objects of Move as small pictures, with what can be dragged on them.

#include "view/document/room.h"
#include "view/drawing/display_list.h"

namespace raywalk {

/// In a square of `edge` pixels, in the signs of the plan: the handles at which it is sized, cornered and turned.
[[nodiscard]] DisplayList pictogram(action::ObjectKind kind, Theme theme, double edge);

}  // namespace raywalk
