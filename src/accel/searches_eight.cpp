#if defined(__x86_64__)

#include "accel/lanes_eight.h"

#define RAYWALK_LANES eight
#define RAYWALK_LANE_CODE [[gnu::target(RAYWALK_EIGHT)]]
#define RAYWALK_LANE_LOOP [[gnu::target(RAYWALK_EIGHT), gnu::flatten]]
#include "accel/searches_at_width.h"

namespace raywalk {

constinit const LaneSearches searches_eight = searches;

}  // namespace raywalk

#endif
