#include "trace/bodies.h"

#include "trace/world.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>

namespace raywalk {

namespace {

/// The region of a body: its box and, for a plane, what is behind it.
template <class T>
struct Region {
  Bounds<T> box;
  std::optional<Plane<T>> front;
};

template <class T>
bool overlap(const Bounds<T>& a, const Bounds<T>& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(a.min[axis] <= b.max[axis] && b.min[axis] <= a.max[axis])) return false;
  return true;
}

/// Whether part of the box lies behind the plane, or on it.
template <class T>
bool reaches_behind(const Bounds<T>& box, const Plane<T>& plane) {
  T height = 0;  // of the lowest corner
  for (int axis = 0; axis < 3; ++axis) {
    if (plane.normal[axis] == 0) continue;
    const T corner = plane.normal[axis] > 0 ? box.min[axis] : box.max[axis];
    height += plane.normal[axis] * (corner - plane.point[axis]);
  }
  return !(height > 0);
}

template <class T>
bool may_touch(const Region<T>& a, const Region<T>& b) {
  return overlap(a.box, b.box) && (!a.front || reaches_behind(b.box, *a.front)) &&
         (!b.front || reaches_behind(a.box, *b.front));
}

/// Whether any two may touch. Sorted along x, each is compared with those that begin before it ends. If these are too
/// many, the answer is yes.
template <class T>
bool any_touch(const std::vector<Region<T>>& regions) {
  std::vector<std::size_t> order(regions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return regions[a].box.min.x < regions[b].box.min.x; });
  std::size_t comparisons = 100 * regions.size() + 1000;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Region<T>&a = regions[order[i]], &b = regions[order[j]];
      if (b.box.min.x > a.box.max.x) break;
      if (may_touch(a, b) || --comparisons == 0) return true;
    }
  return false;
}

/// Sorts primitives into bodies.
template <class T>
class Sorter {
 public:
  explicit Sorter(const World<T>& world) : world_(world), primitives_(world.accelerator.primitives()) {
    bodies_.of.assign(static_cast<std::size_t>(primitives_.own_size()), -1);
    std::size_t range = 0;
    for (int id = 0; id < primitives_.own_size(); ++id) {
      while (range < world.ranges.size() && world.ranges[range].first <= id) ++range;
      if (world.surface(id).transmits) add(id, world.ranges.empty() ? id : static_cast<int>(range));
    }
    merge_twins();
  }

  [[nodiscard]] Bodies take() { return std::move(bodies_); }
  [[nodiscard]] const std::vector<Region<T>>& regions() const { return regions_; }

 private:
  void add(int id, int range) {
    const auto surface = static_cast<std::int32_t>(&world_.surface(id) - world_.surfaces.data());
    const bool single = id < primitives_.shape_count();
    const std::optional<Shape<T>> shape = single ? std::optional(primitives_.shape(id)) : std::nullopt;
    const bool flat = shape && (std::holds_alternative<Disk<T>>(*shape) || std::holds_alternative<Polygon<T>>(*shape) ||
                                std::holds_alternative<Triangle<T>>(*shape));
    if (range != range_) range_ = range, of_range_.clear();
    std::int32_t& known = flat ? of_glass_.try_emplace(glass(surface), -1).first->second
                               : of_range_.try_emplace(surface, -1).first->second;
    if (known < 0) {
      known = static_cast<std::int32_t>(bodies_.list.size());
      bodies_.list.push_back({surface, world_.surface(id).priority, false});
      regions_.emplace_back();
    }
    bodies_.of[static_cast<std::size_t>(id)] = known;
    Region<T>& region = regions_[static_cast<std::size_t>(known)];
    if (const auto* plane = shape ? std::get_if<Plane<T>>(&*shape) : nullptr) {
      region.box = {Vec3<T>(-infinity<T>), Vec3<T>(infinity<T>)};
      if (primitives_.transform_of(id) == nullptr && !primitives_.moves(id)) region.front = *plane;
    } else {
      region.box.include(primitives_.box(id));
    }
    bodies_.list[static_cast<std::size_t>(known)].endless = !region.box.empty() && !region.box.bounded();
  }

  /// Bodies that coincide entirely count once.
  void merge_twins() {
    constexpr std::int32_t unknown = -2, none = -1;
    std::vector<std::int32_t> twins(bodies_.list.size(), unknown);
    for (int id = 0; id < primitives_.own_size(); ++id) {
      const std::int32_t body = bodies_.of_primitive(id), first = bodies_.of_primitive(primitives_.first_equal(id));
      if (body < 0) continue;
      std::int32_t& twin = twins[static_cast<std::size_t>(body)];
      twin = first >= 0 && first < body && (twin == unknown || twin == first) ? first : none;
    }
    for (std::int32_t& body : bodies_.of)
      if (body >= 0 && twins[static_cast<std::size_t>(body)] >= 0) body = twins[static_cast<std::size_t>(body)];
    for (std::size_t body = 0; body < twins.size(); ++body)
      if (twins[body] >= 0) regions_[body] = {};
    for (int id = 0; id < primitives_.own_size(); ++id) {
      const int first = primitives_.first_equal(id);
      const std::int32_t body = bodies_.of_primitive(id), first_body = bodies_.of_primitive(first);
      if (body >= 0 && first_body >= 0 && body != first_body) bodies_.doubles[first].push_back(id);
    }
  }

  using Glass = std::array<T, 8>;
  [[nodiscard]] std::pair<Glass, double> glass(std::int32_t surface) const {
    const auto& inside = world_.surfaces[static_cast<std::size_t>(surface)];
    const auto scattering = inside.scatters() ? world_.scatterings[static_cast<std::size_t>(inside.scattering)]
                                              : typename World<T>::Scattering{};
    const Rgb<T>&lost = inside.extinction, &on = scattering.coefficient;
    return {{inside.ior, lost.x, lost.y, lost.z, on.x, on.y, on.z, scattering.anisotropy}, inside.priority};
  }

  const World<T>& world_;
  const Primitives<T>& primitives_;
  Bodies bodies_;
  std::vector<Region<T>> regions_;  ///< by body
  int range_ = -1;
  std::map<std::int32_t, std::int32_t> of_range_;              ///< bodies by surface
  std::map<std::pair<Glass, double>, std::int32_t> of_glass_;  ///< those of flat shapes
};

/// The shortest distance from a point to a body's surface, along the axes. Of two bodies that contain the point, one
/// inside the other, the inner one has the shorter distance.
template <class T>
T distance_out(const World<T>& world, const Bodies& bodies, std::int32_t body, const Vec3<T>& place, T time) {
  std::vector<std::uint8_t> asked(bodies.list.size(), 0);
  asked[static_cast<std::size_t>(body)] = 1;
  T shortest = infinity<T>;
  TestCounts uncounted;
  for (int axis = 0; axis < 3; ++axis)
    for (const T sign : {T(1), T(-1)}) {
      Ray<T> ray{place, Vec3<T>(0), {}, time};
      ray.direction[axis] = sign;
      const auto hit = world.accelerator.closest(ray, infinity<T>, uncounted, OfBodies{bodies.of, asked});
      if (hit) shortest = std::min(shortest, hit->t);
    }
  return shortest;
}

}  // namespace

template <class T>
Bodies bodies_that_nest(const World<T>& world, const Camera& camera) {
  if (std::none_of(world.surfaces.begin(), world.surfaces.end(), [](const auto& each) { return each.transmits; }))
    return {};
  Sorter<T> sorter(world);
  const std::vector<Region<T>>& regions = sorter.regions();
  Bodies bodies = sorter.take();
  const Vec3<T> eye(camera.eye);
  const Region<T> lens{{eye - Vec3<T>(static_cast<T>(camera.aperture)), eye + Vec3<T>(static_cast<T>(camera.aperture))},
                       std::nullopt};
  for (std::size_t body = 0; body < regions.size(); ++body)
    if (may_touch(regions[body], lens)) bodies.around_eye.push_back(static_cast<std::int32_t>(body));
  if (bodies.around_eye.empty() && !any_touch(regions)) return {};
  std::vector<std::pair<T, std::int32_t>> distances;
  for (const std::int32_t body : bodies.around_eye)
    distances.emplace_back(distance_out(world, bodies, body, eye, static_cast<T>(camera.shutter_open)), body);
  std::sort(distances.begin(), distances.end(),
            [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
  for (std::size_t i = 0; i < distances.size(); ++i) bodies.around_eye[i] = distances[i].second;
  return bodies;
}

template Bodies bodies_that_nest(const World<float>& world, const Camera& camera);
template Bodies bodies_that_nest(const World<double>& world, const Camera& camera);

}  // namespace raywalk
