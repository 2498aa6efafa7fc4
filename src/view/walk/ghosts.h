#pragma once
// What the limits cut off: the rays that depth limit and threshold prevented, and what each would have contributed to
// its pixel.

#include "timeline/timeline.h"

#include <memory>
#include <vector>

namespace raywalk {

/// A ray prevented by a limit. Its own reflect and refract rays follow it.
struct GhostRay {
  RayRecord record;        ///< from a deeper walk without a threshold; parent: index in Ghosts::rays, else -1
  int stub = -1;           ///< index in Timeline::rays() of the stub of this ray, or of its first prevented ancestor
  Rgbd contribution{0.0};  ///< to the pixel, with its descendants
};

/// Of one pixel.
struct Ghosts {
  std::shared_ptr<const Timeline> of;  ///< their walk
  int pixel = -1;                      ///< in it
  static constexpr int max_levels = 4;
  int levels = 0;              ///< shown below the cuts, at most `max_levels`: fewer for wide trees
  std::vector<GhostRay> rays;  ///< parents before children
  Rgbd shade{0.0};             ///< of the pixel without ghosts
  Rgbd lost{0.0};              ///< what the ghosts would add
};

struct State;

/// The ghosts of the current pixel, with stubs of the state's timeline. None at the start, and of walks that are no ray
/// trees or whose depth does not count: paths, beams, cones.
[[nodiscard]] Ghosts ghosts_of(const State& state);

/// The fraction of the pixel, ghosts included, that something contributes: the maximum over the channels; 0..1.
[[nodiscard]] double share_of(const Rgbd& contribution, const Ghosts& ghosts);

}  // namespace raywalk
