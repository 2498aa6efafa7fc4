#include "accel/packet_search.h"

#include "accel/lane_searches.h"

namespace raywalk {

PacketSearch::PacketSearch(const WideTree& tree, const RaysAbreast& rays, unsigned members, bool nearest_first)
    : tree_(tree), packet_(rays, members), advance_(lane_searches().together[nearest_first]), begun_(tree.empty()) {}

}  // namespace raywalk
