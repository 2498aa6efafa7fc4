#pragma once
// What a family of tests reports: sums of counts, one per table line.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raywalk::check {

/// One line: a family and stratum in one scalar type.
struct Tally {
  std::uint64_t rays = 0, hits = 0;
  std::uint64_t missed = 0;      ///< true intersections that the tracer does not report
  std::uint64_t false_hits = 0;  ///< the reverse
  std::uint64_t leaks = 0;       ///< rays that slipped through a closed mesh, or crossed it an odd number of times too
                                 ///< often
  std::uint64_t self_hits = 0;   ///< a spawned ray hit the surface that it left
  std::uint64_t sheet_missed = 0;     ///< the sheet close behind was not met
  std::uint64_t unequal = 0;          ///< answers that should be bit-identical and were not
  std::uint64_t excused = 0;          ///< missed or false ones that are right for a ray a few ulps away
  std::uint64_t exact_path = 0;       ///< decided by the tracer's own exact arithmetic
  std::uint64_t rationals = 0;        ///< decided only by the oracle's rationals
  double exact_ulps = 0;              ///< worst error of t, in ulps, of rays that took the exact path
  double fast_ulps = 0;               ///< the same for the others
  double fast_ulps_by_condition = 0;  ///< the same, divided by the condition number of t

  Tally& operator+=(const Tally& other) {
    rays += other.rays, hits += other.hits, missed += other.missed, false_hits += other.false_hits;
    leaks += other.leaks, self_hits += other.self_hits, sheet_missed += other.sheet_missed, unequal += other.unequal;
    excused += other.excused, exact_path += other.exact_path, rationals += other.rationals;
    exact_ulps = std::max(exact_ulps, other.exact_ulps), fast_ulps = std::max(fast_ulps, other.fast_ulps);
    fast_ulps_by_condition = std::max(fast_ulps_by_condition, other.fast_ulps_by_condition);
    return *this;
  }
};

}  // namespace raywalk::check
