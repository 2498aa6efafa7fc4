#pragma once
// accel/lane_tests.h for AVX-512, eight lanes at a time as accel/lanes_eight.h, in twice as many registers and with
// comparisons that give bits. (Sixteen rays of a packet at a time took longer: tests/benchmark/README.md.)

#if defined(__x86_64__)

#include "accel/eight_floats.h"
#include "accel/ray_packet.h"

/// The same as RAYWALK_EIGHT.
#define RAYWALK_MASKED "avx512f,avx512vl"

namespace raywalk::masked {

#define RAYWALK_LANE_TARGET [[gnu::target(RAYWALK_MASKED), gnu::always_inline]]

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
RAYWALK_LANE_TARGET inline Group all_of(float value) { return {eight::all_of(value)}; }
RAYWALK_LANE_TARGET inline Group loaded(const float* from) { return {eight::loaded(from)}; }
RAYWALK_LANE_TARGET inline void store_entries(BoxEntry* entries, unsigned lane, Group enters) {
  eight::store_entries(entries, lane, enters.of);
}
RAYWALK_LANE_TARGET inline Group min(Group a, Group b) { return {eight::min(a.of, b.of)}; }
RAYWALK_LANE_TARGET inline Group max(Group a, Group b) { return {eight::max(a.of, b.of)}; }
RAYWALK_LANE_TARGET inline Group absolute(Group a) { return {eight::absolute(a.of)}; }
RAYWALK_LANE_TARGET inline Group with_signs_of(Group signs, Group a) { return {eight::with_signs_of(signs.of, a.of)}; }

#include "accel/lane_tests.h"
#include "accel/packet_lane_tests.h"
#undef RAYWALK_LANE_TARGET

}  // namespace raywalk::masked

#endif
