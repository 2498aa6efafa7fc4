#pragma once
// The legend.

#include "view/room.h"

namespace raywalk {

/// The legend.
struct LegendRoom {
  static constexpr Tab tab{"legend"};
};

}  // namespace raywalk
