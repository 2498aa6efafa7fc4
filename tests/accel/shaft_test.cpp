// What a shaft leaves out is crossed by no ray of it; and it leaves out what it can.

#include "accel/shaft.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "accel/accelerator.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

class ShaftNumbers {
 public:
  double operator()(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Vec3d point(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Vec3d direction() {
    while (true) {
      const Vec3d inside = point(1);
      if (const double square = dot(inside, inside); square > 0.01 && square < 1) return normalize(inside);
    }
  }

 private:
  std::mt19937 engine_{11};
};

// Spheres, planes, boxes and placed spheres, `size` across.
template <class T>
Primitives<T> scene(const Vec3d& about, double size, ShaftNumbers& random) {
  const auto in_t = [&](const Vec3d& p) { return Vec3<T>(about + p); };
  Primitives<T> all;
  for (int i = 0; i < 6; ++i) {
    const Sphere<T> sphere{in_t(random.point(size)), static_cast<T>(size * random(0.01, 0.6))};
    if (i % 3 == 2)
      all.add(sphere, *object_transform<T>(rotation<double>({1, 2, 3}, 50) * scaling<double>({1.5, 0.75, 1})));
    else
      all.add(sphere);
  }
  all.add(Plane<T>{in_t(random.point(size)), Vec3<T>(random.direction())});
  const Vec3d corner = random.point(size);
  all.add(Box<T>{in_t(corner), in_t(corner + Vec3d(0.5 * size))});
  return all;
}

// From a place of a primitive, or from anywhere.
template <class T>
Ray<T> start(const Primitives<T>& primitives, const Accelerator<T>& list, const Vec3d& about, double size,
             ShaftNumbers& random) {
  TestCounts counts;
  Ray<T> ray{Vec3<T>(about + random.point(2 * size)), Vec3<T>(random.direction())};
  if (random(0, 1) < 0.3) return ray;
  const auto hit = list.closest(ray, infinity<T>, counts);
  if (!hit) return ray;
  const SurfacePoint<T> point = primitives.surface_at(hit->primitive, ray, Intersection<T>{hit->t, hit->part});
  return {point.position, ray.direction, {hit->primitive, hit->part}};
}

// From the ball's middle, the way to the place of its outline, seen from a point, that is next to sphere `id`.
template <class T>
std::optional<Vec3d> outline_towards(const Vec3<T>& point, const Vec3<T>& middle, T radius,
                                     const Primitives<T>& primitives, int id) {
  const auto* sphere = primitives.template plain<Sphere<T>>(id);
  const Vec3d way = wide(middle) - wide(point);
  const double sin = static_cast<double>(radius) / length(way);
  if (sphere == nullptr || !(sin < 1)) return std::nullopt;
  const Vec3d axis = normalize(way), there = wide(sphere->centre) - wide(point);
  const Vec3d aside = normalize(there - dot(there, axis) * axis);
  return std::sqrt(1 - sin * sin) * aside - sin * axis;
}

}  // namespace

TEMPLATE_TEST_CASE("what a shaft leaves out is crossed by no ray of it", "[accel]", float, double) {
  using T = TestType;
  ShaftNumbers random;
  int left_out = 0, asked = 0, stopped = 0, differing = 0;
  for (int round = 0; round < rounds(3000); ++round) {
    const double size = std::pow(10.0, random(-3, 4));
    // Every third one so far away that few digits are left.
    const double far = 0.1 / static_cast<double>(std::numeric_limits<T>::epsilon());
    const Vec3d about = round % 3 ? Vec3d(0.0) : far * size * random.direction();
    const Primitives<T> primitives = scene<T>(about, size, random);
    const Accelerator<T> list(primitives, AcceleratorKind::none);
    const Ray<T> from = start(primitives, list, about, size, random);
    const Vec3<T> middle(about + random.point(3 * size));
    const T radius = static_cast<T>(size * std::pow(10.0, random(-3, 0.5)));
    std::vector<int> among, filters, filters_among;
    REQUIRE(list.within(Shaft(from.origin, middle, radius), from.departure, among));
    REQUIRE(std::is_sorted(among.begin(), among.end()));
    asked += primitives.size();
    left_out += primitives.size() - static_cast<int>(among.size());
    std::vector<ShadowRole> roles(static_cast<std::size_t>(primitives.size()), ShadowRole::stops);
    roles[1] = roles[3] = ShadowRole::filters;
    for (int sample = 0; sample < 40; ++sample) {
      // Most on its outline, many of these as near to a sphere as they can be: there one that was left out wrongly
      // would be met.
      Vec3d out = random.direction();
      if (sample % 2 == 0) out = outline_towards(from.origin, middle, radius, primitives, sample / 2 % 6).value_or(out);
      const double share = sample % 4 == 1 ? std::cbrt(random(0, 1)) : 1;
      const Vec3<T> place = middle + radius * Vec3<T>(share * out);
      const Ray<T> ray{from.origin, place - from.origin, from.departure};
      TestCounts counts, fewer;
      const bool any = list.occluded(ray, T(1), counts);
      stopped += any;
      differing += list.occluded(ray, T(1), fewer, {nullptr, &among}) != any;
      const bool stops = list.occluded_or_filtered(ray, T(1), counts, roles, filters);
      differing += list.occluded_or_filtered(ray, T(1), fewer, roles, filters_among, {nullptr, &among}) != stops;
      if (!stops) differing += filters != filters_among;
    }
  }
  CHECK(differing == 0);
  CHECK(stopped > rounds(3000) * 10);  // of 40
  CHECK(left_out * 3 > asked);
}

TEST_CASE("spheres that touch a shaft's side from outside are kept, those a little further off are not") {
  const Vec3d point(1, 2, 3);
  ShaftNumbers random;
  for (int round = 0; round < 1000; ++round) {
    const Vec3d axis = random.direction(), aside = normalize(cross(axis, random.direction()));
    const double length = random(2, 50), light = random(0.01, 1.9), radius = random(0.01, 1);
    const Shaft shaft(point, point + length * axis, light);
    // Where it touches the cone: on the normal of its side.
    const double half = std::asin(light / length), along = random(0.1, length * std::cos(half));
    const Vec3d side = std::cos(half) * axis + std::sin(half) * aside,
                out = std::cos(half) * aside - std::sin(half) * axis;
    const double grain = 1e-5 * (along + radius + length);
    CHECK(shaft.meets(point + along * side + radius * out, radius));
    CHECK_FALSE(shaft.meets(point + along * side + (radius + grain) * out, radius));
    CHECK(shaft.meets(point - radius * axis, radius));
    CHECK_FALSE(shaft.meets(point - (radius + grain) * axis, radius));
    CHECK(shaft.meets(point + (length + light + radius) * axis, radius));
    CHECK_FALSE(shaft.meets(point + (length + light + radius + grain) * axis, radius));
    CHECK(shaft.meets_plane(point, axis));
    CHECK(shaft.meets_plane(point + (length + light) * axis, axis));
    CHECK_FALSE(shaft.meets_plane(point - grain * axis, axis));
    CHECK_FALSE(shaft.meets_plane(point - grain * axis, -axis));
    CHECK_FALSE(shaft.meets_plane(point + (length + light + grain) * axis, axis));
  }
}

TEST_CASE("a shaft from within its ball leaves nothing out; one over a floor leaves the floor out") {
  const Shaft within(Vec3d(0.5, 0, 0), Vec3d(0.0), 1.0);
  CHECK(within.meets(Vec3d(100, 0, 0), 1));
  CHECK(within.meets_plane(Vec3d(0, 0, 9), Vec3d(0, 0, 1)));
  Primitives<double> primitives;
  primitives.add(Plane<double>{{0, 0, 0}, {0, 0, 1}});
  primitives.add(Sphere<double>{{0, 0, 5}, 1});
  primitives.add(Sphere<double>{{9, 0, 5}, 1});
  const Accelerator<double> list(primitives, AcceleratorKind::none), tree(primitives, AcceleratorKind::bvh);
  const Shaft up(Vec3d(0.0), Vec3d(0, 0, 10), 0.5);
  std::vector<int> ids{7};
  CHECK(list.within(up, {0, 0}, ids));
  CHECK(ids == std::vector<int>{1});
  CHECK(list.within(up, {}, ids));  // from a point of the floor, but not from the floor
  CHECK(ids == std::vector<int>{0, 1});
  CHECK_FALSE(tree.within(up, {0, 0}, ids));
}
