#include "accel/wide_search.h"

#include "accel/lanes_four.h"
#include "accel/wide_search_eight.h"
#include "accel/wide_search_loop.h"
#include "accel/width.h"

namespace raywalk {

namespace {

struct FourAtATime {
  using Held = four::HeldRay;
  static void hold(const MeshRay& ray, float t_far, Held& held) { four::hold(ray, t_far, held); }
  static unsigned meet(const Held& ray, const WideNode& node, BoxEntry* entries) {
    return four::meet(ray, node, entries);
  }
  template <bool wants_certain>
  static unsigned sift(const Held& ray, const TrianglePack& pack, unsigned count, unsigned& certain) {
    return four::sift<wants_certain>(*ray.ray, ray.reach, pack, count, certain);
  }
};

/// Boxes in the ray's own precision; every triangle is left to its own test.
template <class Slabs>
struct OneByOne {
  using T = typename WideSearch<Slabs>::Far;
  struct Held {
    const Slabs* slabs;
    T t_far;
  };
  static void hold(const Slabs& slabs, T t_far, Held& held) { held = {&slabs, t_far}; }
  static unsigned meet(const Held& ray, const WideNode& node, BoxEntry* entries) {
    unsigned bits = 0;
    for (unsigned lane = 0; lane < node.count; ++lane) {
      const Bounds<float> box = node.box(lane);
      entries[lane] = {0, lane};
      if (!clip(*ray.slabs, Bounds<T>{Vec3<T>(box.min), Vec3<T>(box.max)}, {0, ray.t_far}).empty()) bits |= 1U << lane;
    }
    return bits;
  }
  template <bool>
  static unsigned sift(const Held& /*ray*/, const TrianglePack& /*pack*/, unsigned count, unsigned& /*certain*/) {
    return (1U << count) - 1;
  }
};

template <class Tests, bool nearest_first, bool watched, class Terms>
bool advance(WideSearch<Terms>& search, typename WideSearch<Terms>::Far t_far) {
  return SearchLoop::run<Tests, nearest_first, watched>(search, t_far);
}

template <class Terms>
auto advance_for(bool nearest_first, bool watched) {
  if constexpr (std::is_same_v<Terms, MeshRay>) {
    // A record is of nodes, which are the same at every width.
    if (!watched && lane_width() == LaneWidth::eight) return advance_eight(nearest_first);
    if (watched)
      return nearest_first ? &advance<FourAtATime, true, true, Terms> : &advance<FourAtATime, false, true, Terms>;
    return nearest_first ? &advance<FourAtATime, true, false, Terms> : &advance<FourAtATime, false, false, Terms>;
  } else {
    if (watched)
      return nearest_first ? &advance<OneByOne<Terms>, true, true, Terms>
                           : &advance<OneByOne<Terms>, false, true, Terms>;
    return nearest_first ? &advance<OneByOne<Terms>, true, false, Terms>
                         : &advance<OneByOne<Terms>, false, false, Terms>;
  }
}

}  // namespace

template <class Terms>
WideSearch<Terms>::WideSearch(const WideTree& tree, const Terms& terms, bool nearest_first, SearchRecord* record)
    : tree_(tree), terms_(terms), record_(record), advance_(advance_for<Terms>(nearest_first, record != nullptr)) {
  if (tree.empty()) return;
  if (record != nullptr) boxes_.resize(stack_.size());
  stack_[0] = {TreeChild::node(0), {0, 0}};
  waiting_ = 1;
}

template class WideSearch<MeshRay>;
template class WideSearch<SlabRay<double>>;
template class WideSearch<NaiveSlabRay<float>>;
template class WideSearch<NaiveSlabRay<double>>;

}  // namespace raywalk
