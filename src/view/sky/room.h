#pragma once
// The sky in the plan: a ring around it, as the directions of the plan see the sky.

#include "scene/sky.h"
#include "view/fields.h"
#include "view/room.h"

#include <memory>
#include <optional>

namespace raywalk {

class SkyLight;

/// The ring has the sky's colour in each direction of the plan; for paths, a curve inside says how often they aim
/// there.
struct SkyRoom {
  using Actions = Types<>;
  static constexpr Layer layer = Layer::under_labels;
  static void keep_free_in_plan(Painter& painter);
  static void draw_in_plan(Painter& painter);
  static void follow(State& state, const Before& before);

  // Prepared from the scene's after every action: a sky takes its time.
  std::optional<Sky> of;
  Rgbd below{0.0};
  std::shared_ptr<const SkyLight> light;
};

}  // namespace raywalk
