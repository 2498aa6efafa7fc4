#pragma once
// The legend.

#include "view/room.h"

namespace raywalk {

/// The legend.
struct LegendRoom {
  static constexpr Tab tab{"legend"};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();
};

}  // namespace raywalk
