#pragma once
// Chooses which objects of very large scenes the line view draws. Included only by the files of this folder that draw
// it.

#include "view/state.h"

#include <memory>
#include <vector>

namespace raywalk {

/// At most this many objects are drawn, unless rays have hit more.
inline constexpr std::size_t max_drawn = 1500;

/// Requires a pass over all objects, so it is computed once per recording of a scene.
struct Crowd {
  std::vector<int> drawn;  ///< indices in Scene::objects, ascending: half are the largest, the others spread evenly
  Bounds<double> room;     ///< room_of
  std::vector<Vec3d> at_first;  ///< seen_at_first
};

/// Null for a scene whose objects are all drawn.
[[nodiscard]] std::shared_ptr<const Crowd> crowd_of(const State& state);

/// Computed for this scene.
[[nodiscard]] Crowd chosen(const Scene& scene);

}  // namespace raywalk
