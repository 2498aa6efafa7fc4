#pragma once
// The live equation.

#include "view/room.h"

namespace raywalk {

/// The live equation.
struct EquationRoom {
  static constexpr Tab tab{.word = "equation", .in_plan = true};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();
  static constexpr Layer layer = Layer::under_labels;
  static void draw_in_plan(Painter& painter);
};

}  // namespace raywalk
