#pragma once
// The suite's families: what `raywalk check numerics` lists, runs and tables.

#include "check/tally.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raywalk::check {

/// What a line must satisfy; a line without numbers for a goal does not test it.
struct Goals {
  bool decisions = true;              ///< 0 missed, 0 false
  double exact_ulps = 1;              ///< t of rays that took the exact path
  double fast_ulps_by_condition = 4;  ///< t of the others, in multiples of the condition number
};

/// One line of the table: tests numbered from 0, each a function of the seed and its number.
struct TableLine {
  std::string name;    ///< the stratum
  std::string scalar;  ///< "float" or "double"
  std::function<Tally(std::uint64_t seed, std::uint64_t first, std::uint64_t count)> run;
  Goals goals{};
};

struct Family {
  std::string name;     ///< as on the command line: "sphere"
  std::string instead;  ///< if a goal is not met by design: what holds instead, and why
  std::vector<TableLine> lines;
};

/// One test in this many is audited: by rationals alone, without the filter.
inline constexpr std::uint64_t audit_every = 100;

/// Which of `goals` a line violates, in words; empty if none.
[[nodiscard]] std::string broken_goal(const Goals& goals, const Tally& tally);

/// All of them, in the order of the table.
[[nodiscard]] std::vector<Family> all_families();

// One file each, because they instantiate many templates.
[[nodiscard]] std::vector<Family> round_families();
[[nodiscard]] std::vector<Family> flat_families();
[[nodiscard]] std::vector<Family> quadric_families();
[[nodiscard]] std::vector<Family> mesh_families();         ///< goal C: closed meshes do not leak
[[nodiscard]] std::vector<Family> spawn_families();        ///< goal D: spawned rays leave their surface
[[nodiscard]] std::vector<Family> accelerator_families();  ///< goal E: accelerators answer as brute force does
[[nodiscard]] std::vector<Family> invariance_families();   ///< goal F: mirrored, scaled
[[nodiscard]] std::vector<Family> symmetry_families();     ///< goal F: with the axes exchanged; walked backwards
[[nodiscard]] std::vector<Family> normal_families();       ///< goal B: normals

}  // namespace raywalk::check
