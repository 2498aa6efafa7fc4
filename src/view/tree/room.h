#pragma once
// The ray tree.

#include "view/room.h"

namespace raywalk {

/// The ray tree.
struct TreeRoom {
  static constexpr Tab tab{"tree", true};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();
};

}  // namespace raywalk
