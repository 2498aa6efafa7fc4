#if defined(__x86_64__)

#include "accel/lanes_masked.h"

#define RAYWALK_LANES masked
#define RAYWALK_LANE_CODE [[gnu::target(RAYWALK_MASKED)]]
#define RAYWALK_LANE_LOOP [[gnu::target(RAYWALK_MASKED), gnu::flatten]]
#include "accel/searches_at_width.h"

namespace raywalk {

constinit const LaneSearches searches_masked = searches;

}  // namespace raywalk

#endif
