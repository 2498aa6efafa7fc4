#pragma once
// accel/lane_tests.h for every processor, four lanes at a time.

#include "accel/ray_packet.h"
#include "accel/wide_search.h"

#include <cstring>

namespace raywalk::four {

using Group = Lanes;
constexpr unsigned group_lanes = 4;
inline Group all_of(float value) { return all_lanes(value); }
inline Group loaded(const float* from) {
  Group lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store_entries(BoxEntry* entries, unsigned lane, Group enters) {
  constexpr int keep = ~static_cast<int>(BoxEntry::lane_bits);
  const int first = static_cast<int>(lane);
  const LaneMask bits = (reinterpret_cast<LaneMask>(enters) & LaneMask{keep, keep, keep, keep}) |
                        LaneMask{first, first + 1, first + 2, first + 3};
  std::memcpy(static_cast<void*>(entries + lane), &bits, sizeof bits);
}
inline unsigned bits_where(LaneMask mask) { return bits_of(mask); }

#define RAYWALK_LANE_TARGET
#include "accel/lane_tests.h"
#include "accel/packet_lane_tests.h"
#undef RAYWALK_LANE_TARGET

}  // namespace raywalk::four
