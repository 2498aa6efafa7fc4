#pragma once
// Four floats at a time, using the vector types that g++ and clang support on all processors.

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace raywalk {

using Lanes = float __attribute__((vector_size(16)));
using LaneMask = int __attribute__((vector_size(16)));  ///< of a comparison: -1 where true, else 0

[[nodiscard]] inline Lanes all_lanes(float value) { return Lanes{value, value, value, value}; }

/// Per lane; the second argument where either is NaN, as the processors' own instructions do.
#if defined(__SSE2__)
[[nodiscard]] inline Lanes min(Lanes a, Lanes b) { return _mm_min_ps(a, b); }
[[nodiscard]] inline Lanes max(Lanes a, Lanes b) { return _mm_max_ps(a, b); }
#else
[[nodiscard]] inline Lanes min(Lanes a, Lanes b) { return a < b ? a : b; }
[[nodiscard]] inline Lanes max(Lanes a, Lanes b) { return a > b ? a : b; }
#endif

[[nodiscard]] inline Lanes absolute(Lanes a) {
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneMask>(a) &
                                 LaneMask{0x7fffffff, 0x7fffffff, 0x7fffffff, 0x7fffffff});
}
/// Non-negative `a` with the signs of `signs`.
[[nodiscard]] inline Lanes with_signs_of(Lanes signs, Lanes a) {
  const LaneMask sign = reinterpret_cast<LaneMask>(all_lanes(-0.0F));
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneMask>(a) | (reinterpret_cast<LaneMask>(signs) & sign));
}

/// Bit i is set where lane i is true, or negative.
[[nodiscard]] inline unsigned bits_of(LaneMask mask) {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < 4; ++lane) bits |= static_cast<unsigned>(mask[lane] < 0) << lane;
  return bits;
#endif
}

}  // namespace raywalk
