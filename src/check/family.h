#pragma once
// The suite's families: what `raywalk check numerics` lists, runs and tables.

#include "check/row.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raywalk::check {

/// What must hold of a line; a line that says nothing of a goal does not test it.
struct Goals {
  bool decisions = true;              ///< 0 missed, 0 false
  double exact_ulps = 1;              ///< t of rays that took the exact path
  double fast_ulps_by_condition = 4;  ///< t of the others, in multiples of the condition number
};

/// One line of the table: tests numbered from 0, each a function of the seed and its number.
struct Line {
  std::string name;    ///< the stratum
  std::string scalar;  ///< "float" or "double"
  std::function<Row(std::uint64_t seed, std::uint64_t first, std::uint64_t count)> run;
  Goals goals{};
};

struct Family {
  std::string name;     ///< as on the command line: "sphere"
  std::string instead;  ///< where a goal is not met by design: what holds, and why
  std::vector<Line> lines;
};

/// Of numbers 0, 1 .. a share of this size is audited: by rationals alone, without the filter.
inline constexpr std::uint64_t audit_every = 100;

/// What of `goals` a line breaks, in words; empty when it keeps them all.
[[nodiscard]] std::string broken_goal(const Goals& goals, const Row& row);

/// All of them, in the order of the table.
[[nodiscard]] std::vector<Family> all_families();

// By file, because each instantiates much.
[[nodiscard]] std::vector<Family> round_families();
[[nodiscard]] std::vector<Family> flat_families();
[[nodiscard]] std::vector<Family> quadric_families();
[[nodiscard]] std::vector<Family> mesh_families();         ///< goal C: closed meshes do not leak
[[nodiscard]] std::vector<Family> spawn_families();        ///< goal D: rays leave what they were born on
[[nodiscard]] std::vector<Family> accelerator_families();  ///< goal E: accelerators answer as brute force does
[[nodiscard]] std::vector<Family> law_families();          ///< goal F: mirrored, scaled
[[nodiscard]] std::vector<Family> symmetry_families();     ///< goal F: with the axes exchanged; walked backwards
[[nodiscard]] std::vector<Family> normal_families();       ///< goal B: normals

}  // namespace raywalk::check
