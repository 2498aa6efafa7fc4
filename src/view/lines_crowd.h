#pragma once
// Scenes of very many objects in the line view: which of them are drawn. Included by the files of this folder that draw
// it, and by nobody else.

#include "view/state.h"

#include <memory>
#include <vector>

namespace raywalk::detail {

/// Of more objects than this no more are drawn, unless rays have met as many.
inline constexpr std::size_t most_drawn = 1500;

/// What all objects have to be looked at for, and so is found once for each recording of a scene.
struct Crowd {
  std::vector<int> drawn;  ///< indices in Scene::objects, ascending: half of them the largest, the others spread evenly
  Bounds<double> room;     ///< room_of
  std::vector<Vec3d> at_first;  ///< seen_at_first
};

/// Null for a scene whose objects are all drawn.
[[nodiscard]] std::shared_ptr<const Crowd> crowd_of(const State& state);

/// Of this scene, looked at anew.
[[nodiscard]] Crowd chosen(const Scene& scene);

}  // namespace raywalk::detail
