#pragma once
// Walking by calls, and breakpoints: positions of a timeline, like its grains.

#include "scene/scene.h"
#include "timeline/timeline.h"

#include <array>
#include <optional>
#include <string>

namespace raywalk {

// By calls. Each returns a position; at the ends it stays.

/// After the next line, with all of the SHADE that it calls.
[[nodiscard]] int step_over(const Timeline& timeline, int position);
/// Before the line that has just run; where that was the last one of a SHADE, before the call.
[[nodiscard]] int step_back_over(const Timeline& timeline, int position);
/// After the SHADE under way has returned; in MAIN ALGORITHM, after the pixel has been put.
[[nodiscard]] int step_out(const Timeline& timeline, int position);
/// Before the call of the SHADE under way; in MAIN ALGORITHM, after the pixel before.
[[nodiscard]] int step_back_out(const Timeline& timeline, int position);

/// Where a walk comes to rest by itself.
struct Breakpoints {
  std::array<bool, line_count + path_line_count> before{};  ///< before this line runs
  std::optional<int> depth;                ///< where SHADE is called with this DEPTH, or a path has as many rays
  bool total_internal_reflection = false;  ///< where nothing gets out
  std::string object;                      ///< where a ray hits the object of this name; empty: none
  std::optional<int> pixel;                ///< where the pixel of this column begins, from 0

  friend bool operator==(const Breakpoints&, const Breakpoints&) = default;
  [[nodiscard]] bool any() const { return *this != Breakpoints{}; }
  [[nodiscard]] bool is_before(Line line) const { return before[static_cast<std::size_t>(line)]; }
};

/// Whether a walk comes to rest at `position`: the line that runs next has a breakpoint, or the line that has just run
/// has brought about one of the other things. `timeline` was recorded from `scene`.
[[nodiscard]] bool stops_at(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position);
/// The first such position beyond `position`, no farther than `last`; that when there is none before.
[[nodiscard]] int next_stop(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position,
                            int last);
/// The last such position before `position`; 0 when there is none.
[[nodiscard]] int previous_stop(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline,
                                int position);

}  // namespace raywalk
