#pragma once

#include "accel/query.h"
#include "trace/event.h"

#include <array>
#include <cstdint>

namespace raywalk {

/// What a trace did. rays formed = hit + missed + blocked + reached_light; the other endings count rays not formed.
struct Statistics {
  std::array<std::uint64_t, ray_kind_count> rays{};
  std::array<std::uint64_t, ending_count> ended{};
  TestCounts tests;
  std::uint64_t random_draws = 0;
  std::uint64_t not_finite = 0;  ///< final shades that are NaN or infinite: failures, each one

  std::uint64_t& formed(RayKind kind) { return rays[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t formed(RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
  std::uint64_t& ends(Ending ending) { return ended[static_cast<std::size_t>(ending)]; }
  [[nodiscard]] std::uint64_t ends(Ending ending) const { return ended[static_cast<std::size_t>(ending)]; }

  Statistics& operator+=(const Statistics& other) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    for (std::size_t i = 0; i < ended.size(); ++i) ended[i] += other.ended[i];
    tests.nodes += other.tests.nodes;
    tests.primitives += other.tests.primitives;
    random_draws += other.random_draws;
    not_finite += other.not_finite;
    return *this;
  }
};

}  // namespace raywalk
