#pragma once

#include "accel/query.h"
#include "scene/effects.h"
#include "trace/event.h"

#include <array>
#include <cstdint>
#include <numeric>

namespace raywalk {

/// The counters of a trace. Rays formed = hit + missed + blocked + reached_light + scattered; the other endings count
/// rays not formed.
struct Statistics {
  std::array<std::uint64_t, ray_kind_count> rays{};
  std::array<std::uint64_t, ending_count> ended{};
  TestCounts tests;
  std::array<std::uint64_t, effect_count> draws{};  ///< random numbers, for each effect
  std::uint64_t not_finite = 0;  ///< final shades that a file's float cannot represent: each one is a failure

  void drew(Effect effect, int numbers) {
    draws[static_cast<std::size_t>(effect)] += static_cast<std::uint64_t>(numbers);
  }
  /// Of all effects together.
  [[nodiscard]] std::uint64_t random_draws() const {
    return std::accumulate(draws.begin(), draws.end(), std::uint64_t{0});
  }
  [[nodiscard]] std::uint64_t drawn(Effect effect) const { return draws[static_cast<std::size_t>(effect)]; }
  std::uint64_t& formed(RayKind kind) { return rays[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t formed(RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
  std::uint64_t& ends(Ending ending) { return ended[static_cast<std::size_t>(ending)]; }
  [[nodiscard]] std::uint64_t ends(Ending ending) const { return ended[static_cast<std::size_t>(ending)]; }

  Statistics& operator+=(const Statistics& other) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    for (std::size_t i = 0; i < ended.size(); ++i) ended[i] += other.ended[i];
    tests += other.tests;
    for (std::size_t i = 0; i < draws.size(); ++i) draws[i] += other.draws[i];
    not_finite += other.not_finite;
    return *this;
  }
};

}  // namespace raywalk
