#include "view/space/lines_crowd.h"

#include "math/random.h"
#include "view/plan/plan_geometry.h"
#include "view/space/orbit.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace raywalk {

namespace {

/// An object's size; infinite ones are largest.
double extent(const Object& object) {
  const Bounds<double> box = bounds(object.shape);
  if (box.empty()) return 0;
  if (!box.bounded()) return std::numeric_limits<double>::infinity();
  const Bounds<double> placed = image_of(affine_of(object.transform), box);
  return length(placed.max - placed.min);
}

/// A pseudo-random order, independent of the scene's.
std::uint64_t scrambled(int index) { return detail::mix(static_cast<std::uint64_t>(index)); }

}  // namespace

Crowd chosen(const Scene& scene) {
  Crowd crowd{{}, room_of(scene), seen_at_first(scene)};
  std::vector<double> extents;
  extents.reserve(scene.objects.size());
  for (const Object& object : scene.objects) extents.push_back(extent(object));
  std::vector<int> order(scene.objects.size());
  std::iota(order.begin(), order.end(), 0);
  const std::size_t count = std::min(max_drawn, order.size());
  const auto largest = order.begin() + static_cast<std::ptrdiff_t>(count / 2);
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(count);
  const auto extent_of = [&](int i) { return extents[static_cast<std::size_t>(i)]; };
  // The largest dominate the picture; some small ones show that there are any. Ties are broken at random, from all over
  // the scene.
  std::nth_element(order.begin(), largest, order.end(), [&](int a, int b) {
    return extent_of(a) != extent_of(b) ? extent_of(a) > extent_of(b) : scrambled(a) < scrambled(b);
  });
  std::nth_element(largest, end, order.end(), [](int a, int b) { return scrambled(a) < scrambled(b); });
  crowd.drawn.assign(order.begin(), end);
  std::sort(crowd.drawn.begin(), crowd.drawn.end());
  return crowd;
}

std::shared_ptr<const Crowd> crowd_of(const State& state) {
  const std::vector<Object>& objects = state.scene().objects;
  if (objects.size() <= max_drawn) return nullptr;
  // Every change of a scene makes a new recording, and recordings are immutable.
  struct CachedCrowd {
    std::weak_ptr<const Timeline> timeline;
    const Object* objects = nullptr;
    std::size_t count = 0;
    std::shared_ptr<const Crowd> crowd;
  };
  static CachedCrowd kept;
  if (!kept.crowd || kept.timeline.lock() != state.walk.timeline || kept.objects != objects.data() ||
      kept.count != objects.size())
    kept = {state.walk.timeline, objects.data(), objects.size(), std::make_shared<const Crowd>(chosen(state.scene()))};
  return kept.crowd;
}

}  // namespace raywalk
