#pragma once
// Photons in the plan: a dot where each was stored, and the circle that an estimate has grown to.

#include "view/fields.h"
#include "view/room.h"

namespace raywalk {

/// Dots come one by one while photons are walked, then all at once. Those of a caustic have the colour of light.
struct PhotonRoom {
  using Actions = Types<>;
  static constexpr Layer layer = Layer::under_rays;
  static void draw_in_plan(Painter& painter);
};

}  // namespace raywalk
