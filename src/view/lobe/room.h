#pragma once
// The lobe of a rough surface in the plan: where light goes from the current hit, as a curve.

#include "timeline/timeline.h"
#include "view/fields.h"
#include "view/room.h"

#include <memory>

namespace raywalk {

template <class T>
struct World;
struct Scattering;

/// A curve about the hit, in each direction as far away as the scattering function times the cosine says.
struct LobeRoom {
  using Actions = Types<>;
  static constexpr Layer layer = Layer::over_rays;
  static void draw_in_plan(Painter& painter);
  static void follow(State& state, const Before& before);

  // Of the walk at a position.
  std::shared_ptr<const Timeline> of{};
  int position = -1;
  int ray = -1;                                ///< at whose hit the walk is
  std::shared_ptr<const World<double>> world;  ///< whose tables the next one speaks of
  std::shared_ptr<const Scattering> seen;      ///< none: that surface is smooth
};

}  // namespace raywalk
