#pragma once
// The lobe of a rough surface in the plan: where light goes from the current hit, as a curve. Of glass, to air.

#include "view/fields.h"
#include "view/room.h"

namespace raywalk {

/// A curve about the hit, in each direction as far away as the scattering function times the cosine says.
struct LobeRoom {
  using Actions = Types<>;
  static constexpr Layer layer = Layer::over_rays;
  static void draw_in_plan(Painter& painter);
};

}  // namespace raywalk
