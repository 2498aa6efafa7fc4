#include "accel/packet_search_eight.h"

#include "accel/lanes_eight.h"
#include "accel/packet_search_loop.h"

#if defined(__x86_64__)

namespace raywalk {

namespace {

struct EightAtATime {
  [[gnu::target("avx2")]] static inline unsigned meet(const RayPacket& packet, float t_far, const WideNode& node,
                                                      BoxEntry* entries) {
    return eight::meet(packet, t_far, node, entries);
  }
  [[gnu::target("avx2")]] static inline unsigned rays_that_meet(const RayPacket& packet, const WideNode& node,
                                                                unsigned box, unsigned rays) {
    return eight::rays_that_meet(packet, node, box, rays);
  }
  [[gnu::target("avx2")]] static inline unsigned sift(const MeshRay& ray, float t_far, const TrianglePack& pack,
                                                      unsigned count) {
    unsigned certain;
    return eight::sift<false>(ray, eight::reach_of(ray, t_far), pack, count, certain);
  }
};

template <bool nearest_first>
[[gnu::target("avx2"), gnu::flatten]] bool advance(PacketSearch& search) {
  return PacketLoop::run<EightAtATime, nearest_first>(search);
}

}  // namespace

bool (*advance_packet_eight(bool nearest_first))(PacketSearch&) {
  return nearest_first ? &advance<true> : &advance<false>;
}

}  // namespace raywalk

#else

namespace raywalk {

bool (*advance_packet_eight(bool /*nearest_first*/))(PacketSearch&) { return nullptr; }

}  // namespace raywalk

#endif
