#pragma once
// How many boxes or triangles this processor tests at a time. The width decides nothing but the time: every width gives
// the same bits, tests/accel/width_test.cpp.

#include "math/words.h"

#include <optional>
#include <vector>

namespace raywalk {

/// Floats in a vector register: SSE2, NEON, WebAssembly's SIMD or what the compiler makes of four; AVX2; AVX-512, of
/// which as many lanes are used.
enum class LaneWidth { four, eight, eight_masked };
template <>
inline constexpr Word<LaneWidth> words_of<LaneWidth>[] = {
    {LaneWidth::four, "4"}, {LaneWidth::eight, "8"}, {LaneWidth::eight_masked, "8 masked"}};

/// The widths that this processor has, narrowest first; asked once.
[[nodiscard]] const std::vector<LaneWidth>& lane_widths();

/// The width that this thread's searches take: the widest, unless another is forced.
[[nodiscard]] LaneWidth lane_width();

/// For tests and benchmarks: searches that this thread begins from now on take `width`, one of `lane_widths`, until
/// this ends.
class ForcedWidth {
 public:
  explicit ForcedWidth(LaneWidth width);
  ~ForcedWidth();
  ForcedWidth(const ForcedWidth&) = delete;
  ForcedWidth& operator=(const ForcedWidth&) = delete;

 private:
  std::optional<LaneWidth> before_;
};

}  // namespace raywalk
