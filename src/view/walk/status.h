#pragma once
// Where the walk is, in words and in numbers.

#include "view/state.h"

#include <array>
#include <string>

namespace raywalk {

/// One plain sentence on what the step did and, if a ray ended, why. At position 0, and in other modes: what to do
/// first.
[[nodiscard]] std::string sentence(const State& state);

/// A cell of SCREEN, with its shade if that is known.
[[nodiscard]] std::string cell_text(const State& state, int cell, const std::optional<Rgbd>& shade);

/// What has happened up to this position.
struct Counts {
  int position = 0, steps = 0;
  int pixel = 0, pixels = 0;  ///< pixels begun, and all of them
  std::array<int, ray_kind_count> formed{};
  std::array<int, ending_count> ended{};
  int depth = 0;  ///< of the line just run
};
[[nodiscard]] Counts counts(const State& state);
/// Counts in one line: "step 12 of 840 · pixel 3 · rays 5". Pixels are counted from 0, as everywhere.
[[nodiscard]] std::string status_line(const State& state);
/// The same in few letters: "12 / 840".
[[nodiscard]] std::string short_status_line(const State& state);
/// A line as wide as the widest of these in this walk, or in a slightly longer one.
[[nodiscard]] std::string widest_status_line(const State& state, bool in_short);

}  // namespace raywalk
