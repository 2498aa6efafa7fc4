#pragma once
// accel/lane_tests.h for AVX2, eight lanes at a time, function by function: no function that other files share may be
// compiled for it, since the linker may take either's. All are inlined into functions that are compiled for AVX2.

#if defined(__x86_64__)

#include "accel/eight_floats.h"
#include "accel/ray_packet.h"

namespace raywalk::eight {

#define RAYWALK_LANE_TARGET [[gnu::target(RAYWALK_EIGHT), gnu::always_inline]]
#include "accel/lane_tests.h"
#include "accel/packet_lane_tests.h"
#undef RAYWALK_LANE_TARGET

}  // namespace raywalk::eight

#endif
