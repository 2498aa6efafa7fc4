#pragma once
// The call stack.

#include "view/room.h"

namespace raywalk {

/// The call stack.
struct StackRoom {
  static constexpr Tab tab{"stack"};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();
};

}  // namespace raywalk
