#pragma once
// What accel/lane_tests.h asks of lanes, for the registers of AVX2, which AVX-512 has too. All are inlined.

#if defined(__x86_64__)

#include "accel/wide_search.h"

#include <immintrin.h>

/// What accel/width.cpp asks a processor for. No fused multiply-add, although such processors have it: it rounds once
/// where four lanes round twice.
#define RAYWALK_EIGHT "avx2"

namespace raywalk::eight {

#define RAYWALK_LANE_TARGET [[gnu::target(RAYWALK_EIGHT), gnu::always_inline]]

using Group = __m256;
constexpr unsigned group_lanes = 8;
RAYWALK_LANE_TARGET inline Group all_of(float value) { return _mm256_set1_ps(value); }
RAYWALK_LANE_TARGET inline Group loaded(const float* from) { return _mm256_load_ps(from); }
RAYWALK_LANE_TARGET inline void store_entries(BoxEntry* entries, unsigned /*lane*/, Group enters) {
  const __m256i keep = _mm256_set1_epi32(~static_cast<int>(BoxEntry::lane_bits));
  const __m256i bits =
      _mm256_or_si256(_mm256_and_si256(_mm256_castps_si256(enters), keep), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_store_si256(reinterpret_cast<__m256i*>(entries), bits);
}
RAYWALK_LANE_TARGET inline Group min(Group a, Group b) { return _mm256_min_ps(a, b); }
RAYWALK_LANE_TARGET inline Group max(Group a, Group b) { return _mm256_max_ps(a, b); }
RAYWALK_LANE_TARGET inline Group absolute(Group a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a); }
RAYWALK_LANE_TARGET inline Group with_signs_of(Group signs, Group a) {
  return _mm256_or_ps(a, _mm256_and_ps(signs, _mm256_set1_ps(-0.0F)));
}
template <class Mask>
RAYWALK_LANE_TARGET inline unsigned bits_where(Mask mask) {
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Group>(mask)));
}

#undef RAYWALK_LANE_TARGET

}  // namespace raywalk::eight

#endif
