#include "accel/lane_searches.h"

#include "accel/width.h"

namespace raywalk {

const LaneSearches& lane_searches() {
#if defined(__x86_64__)
  switch (lane_width()) {
    case LaneWidth::four:
      return searches_four;
    case LaneWidth::eight:
      return searches_eight;
    case LaneWidth::eight_masked:
      return searches_masked;
  }
#endif
  return searches_four;
}

}  // namespace raywalk
