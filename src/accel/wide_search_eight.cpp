#include "accel/wide_search_eight.h"

#include "accel/lanes_eight.h"
#include "accel/wide_search_loop.h"

#if defined(__x86_64__)

namespace raywalk {

namespace {

// Inlined into `advance` only: the loop itself is compiled for every processor.
struct EightAtATime {
  using Held = eight::HeldRay;
  [[gnu::target("avx2")]] static inline void hold(const MeshRay& ray, float t_far, Held& held) {
    eight::hold(ray, t_far, held);
  }
  [[gnu::target("avx2")]] static inline unsigned meet(const Held& ray, const WideNode& node, BoxEntry* entries) {
    return eight::meet(ray, node, entries);
  }
  template <bool wants_certain>
  [[gnu::target("avx2")]] static inline unsigned sift(const Held& ray, const TrianglePack& pack, unsigned count,
                                                      unsigned& certain) {
    return eight::sift<wants_certain>(*ray.ray, ray.reach, pack, count, certain);
  }
};

template <bool nearest_first>
[[gnu::target("avx2"), gnu::flatten]] bool advance(WideSearch<MeshRay>& search, float t_far) {
  return SearchLoop::run<EightAtATime, nearest_first, false>(search, t_far);
}

}  // namespace

bool (*advance_eight(bool nearest_first))(WideSearch<MeshRay>&, float) {
  return nearest_first ? &advance<true> : &advance<false>;
}

}  // namespace raywalk

#else

namespace raywalk {

bool (*advance_eight(bool /*nearest_first*/))(WideSearch<MeshRay>&, float) { return nullptr; }

}  // namespace raywalk

#endif
