#include "accel/packet_search.h"

#include "accel/lanes_four.h"
#include "accel/packet_search_eight.h"
#include "accel/packet_search_loop.h"
#include "accel/width.h"

namespace raywalk {

namespace {

struct FourAtATime {
  static unsigned meet(const RayPacket& packet, float t_far, const WideNode& node, BoxEntry* entries) {
    return four::meet(packet, t_far, node, entries);
  }
  static unsigned rays_that_meet(const RayPacket& packet, const WideNode& node, unsigned box, unsigned rays) {
    return four::rays_that_meet(packet, node, box, rays);
  }
  static unsigned sift(const MeshRay& ray, float t_far, const TrianglePack& pack, unsigned count) {
    unsigned certain;
    return four::sift<false>(ray, four::reach_of(ray, t_far), pack, count, certain);
  }
};

template <bool nearest_first>
bool advance(PacketSearch& search) {
  return PacketLoop::run<FourAtATime, nearest_first>(search);
}

auto advance_for(bool nearest_first) {
  if (lane_width() == LaneWidth::eight) return advance_packet_eight(nearest_first);
  return nearest_first ? &advance<true> : &advance<false>;
}

}  // namespace

PacketSearch::PacketSearch(const WideTree& tree, std::span<const MeshRay> rays, bool nearest_first)
    : tree_(tree), mesh_rays_(rays.data()), packet_(rays), advance_(advance_for(nearest_first)), begun_(tree.empty()) {}

}  // namespace raywalk
