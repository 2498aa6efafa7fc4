#pragma once
// accel/lane_tests.h for AVX-512, eight lanes at a time as accel/lanes_eight.h, in twice as many registers and with
// comparisons that give bits. (Sixteen rays of a packet at a time took longer: tests/benchmark/README.md.)

#if defined(__x86_64__)

#include "accel/ray_packet.h"
#include "accel/wide_search.h"

#include <immintrin.h>

namespace raywalk {

// No fused multiply-add, although such processors have it: it rounds once where four lanes round twice.
#define RAYWALK_LANE_TARGET [[gnu::target("avx512f,avx512vl,avx512dq"), gnu::always_inline]]

namespace masked {

/// What a comparison gives: a bit for each lane.
struct GroupMask {
  unsigned bits;
};
RAYWALK_LANE_TARGET inline unsigned bits_where(GroupMask mask) { return mask.bits; }
RAYWALK_LANE_TARGET inline GroupMask operator&(GroupMask a, GroupMask b) { return {a.bits & b.bits}; }
RAYWALK_LANE_TARGET inline GroupMask operator|(GroupMask a, GroupMask b) { return {a.bits | b.bits}; }

struct Group {
  __m256 of;
};
constexpr unsigned group_lanes = 8;
RAYWALK_LANE_TARGET inline Group operator+(Group a, Group b) { return {a.of + b.of}; }
RAYWALK_LANE_TARGET inline Group operator-(Group a, Group b) { return {a.of - b.of}; }
RAYWALK_LANE_TARGET inline Group operator*(Group a, Group b) { return {a.of * b.of}; }
RAYWALK_LANE_TARGET inline Group operator-(Group a) { return {-a.of}; }
RAYWALK_LANE_TARGET inline GroupMask operator<(Group a, Group b) {
  return {_mm256_cmp_ps_mask(a.of, b.of, _CMP_LT_OQ)};
}
RAYWALK_LANE_TARGET inline GroupMask operator>(Group a, Group b) { return b < a; }
RAYWALK_LANE_TARGET inline GroupMask operator<=(Group a, Group b) {
  return {_mm256_cmp_ps_mask(a.of, b.of, _CMP_LE_OQ)};
}
RAYWALK_LANE_TARGET inline Group all_of(float value) { return {_mm256_set1_ps(value)}; }
RAYWALK_LANE_TARGET inline Group loaded(const float* from) { return {_mm256_load_ps(from)}; }
RAYWALK_LANE_TARGET inline void store_entries(BoxEntry* entries, unsigned /*lane*/, Group enters) {
  const __m256i keep = _mm256_set1_epi32(~static_cast<int>(BoxEntry::lane_bits));
  const __m256i bits = _mm256_or_si256(_mm256_and_si256(_mm256_castps_si256(enters.of), keep),
                                       _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_store_si256(reinterpret_cast<__m256i*>(entries), bits);
}
RAYWALK_LANE_TARGET inline Group min(Group a, Group b) { return {_mm256_min_ps(a.of, b.of)}; }
RAYWALK_LANE_TARGET inline Group max(Group a, Group b) { return {_mm256_max_ps(a.of, b.of)}; }
RAYWALK_LANE_TARGET inline Group absolute(Group a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.of)}; }
RAYWALK_LANE_TARGET inline Group with_signs_of(Group signs, Group a) {
  return {_mm256_or_ps(a.of, _mm256_and_ps(signs.of, _mm256_set1_ps(-0.0F)))};
}

#include "accel/lane_tests.h"
#include "accel/packet_lane_tests.h"

}  // namespace masked

#undef RAYWALK_LANE_TARGET

}  // namespace raywalk

#endif
