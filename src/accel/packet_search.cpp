#include "accel/packet_search.h"

#include "accel/lane_searches.h"

namespace raywalk {

PacketSearch::PacketSearch(const WideTree& tree, std::span<const MeshRay> rays, bool nearest_first)
    : tree_(tree),
      mesh_rays_(rays.data()),
      packet_(rays),
      advance_(lane_searches().together[nearest_first]),
      begun_(tree.empty()) {}

}  // namespace raywalk
