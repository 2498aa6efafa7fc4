#include "accel/lanes_four.h"

#define RAYWALK_LANES four
#define RAYWALK_LANE_CODE
#define RAYWALK_LANE_LOOP
#include "accel/searches_at_width.h"

namespace raywalk {

constinit const LaneSearches searches_four = searches;

bool (*watched_search(bool nearest_first))(WideSearch<MeshRay>&, float) {
  constexpr bool (*all[])(WideSearch<MeshRay>&, float) = {
      [](WideSearch<MeshRay>& search, float t_far) { return SearchLoop::run<InLanes, false, true>(search, t_far); },
      [](WideSearch<MeshRay>& search, float t_far) { return SearchLoop::run<InLanes, true, true>(search, t_far); }};
  return all[nearest_first];
}

}  // namespace raywalk
