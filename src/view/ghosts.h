#pragma once
// What the limits cut off: the rays that the depth limit and the threshold forbade, as they would have gone, and what
// each would have brought to its pixel.

#include "timeline/timeline.h"

#include <memory>
#include <vector>

namespace raywalk {

/// A ray that would have been formed but for a limit. Its own reflect and refract rays follow it.
struct GhostRay {
  RayRecord record;  ///< as a deeper walk without a threshold records it; parent: index in Ghosts::rays, else -1
  int stub = -1;  ///< index in Timeline::rays() of the stub that stands where it, or the first before it, was forbidden
  Rgbd brings{0.0};  ///< with all that follows it, to the pixel
};

/// Of one pixel.
struct Ghosts {
  std::shared_ptr<const Timeline> of;  ///< the walk that they belong to
  int pixel = -1;                      ///< in it
  static constexpr int most_levels = 4;
  int levels = 0;              ///< below the cuts that are shown, at most `most_levels`: fewer where trees are wide
  std::vector<GhostRay> rays;  ///< parents before children
  Rgbd shade{0.0};             ///< the pixel without its ghosts
  Rgbd lost{0.0};              ///< what the ghosts would add to it
};

struct State;

/// The ghosts of the pixel under way, with stubs of the state's timeline. None at the start and while paths are walked.
[[nodiscard]] Ghosts ghosts_of(const State& state);

/// How much of the pixel, ghosts included, something brings: of the channel where that is most; 0..1.
[[nodiscard]] double share_of(const Rgbd& brings, const Ghosts& ghosts);

}  // namespace raywalk
