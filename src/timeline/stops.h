#pragma once
// Stepping by calls, and breakpoints: positions of a timeline.

#include "scene/scene.h"
#include "timeline/timeline.h"

#include <array>
#include <optional>
#include <string>

namespace raywalk {

/// Event::depth; after a line that forms the next ray of a path, with this ray.
[[nodiscard]] int depth_after(const Event& event);

// Stepping by calls. Each returns a position; at the ends it stays.

/// After the next line and any SHADE that it calls.
[[nodiscard]] int step_over(const Timeline& timeline, int position);
/// Before the line that has just run; if that was the last line of a SHADE, before its call.
[[nodiscard]] int step_back_over(const Timeline& timeline, int position);
/// After the current SHADE has returned; in MAIN ALGORITHM, after the pixel has been put.
[[nodiscard]] int step_out(const Timeline& timeline, int position);
/// Before the call of the current SHADE; in MAIN ALGORITHM, after the previous pixel.
[[nodiscard]] int step_back_out(const Timeline& timeline, int position);

/// Where a walk pauses by itself.
struct Breakpoints {
  std::array<bool, all_lines_count> before{};  ///< before this line runs
  std::optional<int> depth;                    ///< where SHADE is called with this DEPTH, or a path has this many rays
  bool total_internal_reflection = false;      ///< where nothing is transmitted
  std::string object;                          ///< where a ray hits the object of this name; empty: none
  std::optional<int> pixel;                    ///< where the pixel of this column begins, from 0

  friend bool operator==(const Breakpoints&, const Breakpoints&) = default;
  [[nodiscard]] bool any() const { return *this != Breakpoints{}; }
  [[nodiscard]] bool is_before(Line line) const { return before[static_cast<std::size_t>(line)]; }
};

/// Whether a walk pauses at `position`: the next line has a breakpoint, or the line that has just run meets one of the
/// other conditions. `timeline` was recorded from `scene`.
[[nodiscard]] bool stops_at(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position);
/// The first such position after `position` and before `last`, or else `last`.
[[nodiscard]] int next_stop(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position,
                            int last);
/// The last such position before `position`, or else 0.
[[nodiscard]] int previous_stop(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline,
                                int position);

}  // namespace raywalk
