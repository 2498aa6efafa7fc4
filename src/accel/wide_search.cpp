#include "accel/wide_search.h"

#include "accel/lane_searches.h"
#include "accel/wide_search_loop.h"

namespace raywalk {

namespace {

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

template <class Terms, bool nearest_first, bool watched>
bool advance(WideSearch<Terms>& search, typename WideSearch<Terms>::Far t_far) {
  return SearchLoop::run<OneByOne<Terms>, nearest_first, watched>(search, t_far);
}

template <class Terms>
auto advance_for(bool nearest_first, bool watched) {
  if constexpr (std::is_same_v<Terms, MeshRay>) {
    return watched ? watched_search(nearest_first) : lane_searches().alone[nearest_first];
  } else {
    if (watched) return nearest_first ? &advance<Terms, true, true> : &advance<Terms, false, true>;
    return nearest_first ? &advance<Terms, true, false> : &advance<Terms, false, false>;
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
