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

/// What is asked of shapes.
struct ShapeFamilies {
  std::vector<Family> own;  ///< a family a shape, a line a stratum; goals A and B: decisions, and t
  // A line a shape.
  Family spawned{"spawned", "", {}}, spawned_polygon{"spawned_polygon", "", {}};  ///< goal D: rays leave their surface
  Family laws{"laws", "", {}};                                                    ///< goal F: mirrored, scaled
  Family permuted{"permuted", "", {}}, reversed{"reversed", "", {}};  ///< goal F: axes exchanged; walked backwards
  Family normals{"normals", "", {}};                                  ///< goal B: normals
};

// One file each, because they instantiate many templates.
void add_round_shapes(ShapeFamilies& all);
void add_flat_shapes(ShapeFamilies& all);
void add_quadrics(ShapeFamilies& all);
[[nodiscard]] Family mesh_family();         ///< goal C: closed meshes do not leak
[[nodiscard]] Family accelerator_family();  ///< goal E: accelerators answer as brute force does

}  // namespace raywalk::check
