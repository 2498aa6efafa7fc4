#pragma once
// Radiosity in the plan: patches as bright as they are, with the light that they have not shot yet, and the strings
// between two of them.

#include "view/fields.h"
#include "view/room.h"

namespace raywalk {

/// A patch is a strip along its edge in the colour of its light, and on it a bar for its unshot light.
struct RadiosityRoom {
  using Actions = Types<>;
  static constexpr Layer layer = Layer::under_rays;
  static void draw_in_plan(Painter& painter);
};

}  // namespace raywalk
