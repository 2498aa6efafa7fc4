#pragma once
// The loops of WideSearch and PacketSearch for the lanes of one width. Included once for each, by a file of its own,
// with
//   RAYWALK_LANES       the namespace of these lanes
//   RAYWALK_LANE_CODE   the attributes of what uses them
//   RAYWALK_LANE_LOOP   those of a loop, into which all of that is inlined: the loops themselves are compiled for every
//                       processor

#include "accel/lane_searches.h"
#include "accel/packet_search_loop.h"
#include "accel/wide_search_loop.h"

namespace raywalk {

namespace {

struct InLanes {
  using Held = RAYWALK_LANES::HeldRay;
  RAYWALK_LANE_CODE static inline void hold(const MeshRay& ray, float t_far, Held& held) {
    RAYWALK_LANES::hold(ray, t_far, held);
  }
  RAYWALK_LANE_CODE static inline unsigned meet(const Held& ray, const WideNode& node, BoxEntry* entries) {
    return RAYWALK_LANES::meet(ray, node, entries);
  }
  template <bool wants_certain>
  RAYWALK_LANE_CODE static inline unsigned sift(const Held& ray, const TrianglePack& pack, unsigned count,
                                                unsigned& certain) {
    return RAYWALK_LANES::sift<wants_certain>(*ray.ray, ray.reach, pack, count, certain);
  }

  // Of packets. How many steps it takes to test all triangles of a pack, and all rays of a packet.
  static constexpr unsigned groups_of_triangles = tree_width / RAYWALK_LANES::group_lanes;
  static constexpr unsigned groups_of_rays = RayPacket::most / RAYWALK_LANES::group_lanes;
  RAYWALK_LANE_CODE static inline unsigned meet(const RayPacket& packet, float t_far, const WideNode& node,
                                                BoxEntry* entries) {
    return RAYWALK_LANES::meet(packet, t_far, node, entries);
  }
  RAYWALK_LANE_CODE static inline unsigned rays_that_meet(const RayPacket& packet, const WideNode& node, unsigned box,
                                                          unsigned rays) {
    return RAYWALK_LANES::rays_that_meet(packet, node, box, rays);
  }
  RAYWALK_LANE_CODE static inline unsigned rays_that_may_hit(const RayPacket& packet, const TrianglePack& pack,
                                                             unsigned lane, unsigned rays) {
    return RAYWALK_LANES::rays_that_may_hit(packet, pack, lane, rays);
  }
  RAYWALK_LANE_CODE static inline unsigned sift(const RayPacket& packet, unsigned ray, const TrianglePack& pack,
                                                unsigned count) {
    return RAYWALK_LANES::sift(packet, ray, pack, count);
  }
};

template <bool nearest_first>
RAYWALK_LANE_LOOP bool advance(WideSearch<MeshRay>& search, float t_far) {
  return SearchLoop::run<InLanes, nearest_first, false>(search, t_far);
}

template <bool nearest_first>
RAYWALK_LANE_LOOP bool advance_together(PacketSearch& search) {
  return PacketLoop::run<InLanes, nearest_first>(search);
}

constexpr LaneSearches searches{{&advance<false>, &advance<true>}, {&advance_together<false>, &advance_together<true>}};

}  // namespace

}  // namespace raywalk
