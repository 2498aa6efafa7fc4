#include "shape/prism.h"

#include <algorithm>
#include <vector>

#include "shape/numbers.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using Long = long double;

// Polygons of all kinds; each is tried in both windings.
const std::vector<std::vector<Vec2d>> polygons{
    {{0, 0}, {4, 0}, {0, 3}},                                                                // triangle
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},                                                    // square
    {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                                        // L
    {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                        // U
    {{0, 2}, {-0.5, 0.5}, {-2, 0}, {-0.5, -0.5}, {0, -2}, {0.5, -0.5}, {2, 0}, {0.5, 0.5}},  // star
    {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}},                                        // collinear corners
    {{0, 0}, {5, 0.001}, {5, 0.002}},                                                        // sliver
    {{0, 0}, {2, 1}, {0, 2}, {0.5, 1}},                                                      // arrowhead
};

template <class T>
Prism<T> prism_of(const std::vector<Vec2d>& corners, double height, bool clockwise) {
  Prism<T> prism;
  for (const Vec2d& corner : corners) prism.corners.emplace_back(corner);
  if (clockwise) std::reverse(prism.corners.begin(), prism.corners.end());
  prism.height = static_cast<T>(height);
  return prism;
}

struct Point {
  Long x, y;
};
Long cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
template <class T>
Point operator-(const Vec2<T>& a, const Point& b) {
  return {static_cast<Long>(a.x) - b.x, static_cast<Long>(a.y) - b.y};
}

template <class T>
bool contains(const Prism<T>& prism, const Point& p) {
  bool inside = false;
  for (int i = 0; i < prism.sides(); ++i) {
    const Point a = prism.corner(i) - p, b = prism.corner_after(i) - p;
    if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

// How far a point of the plan is from the outline.
template <class T>
Long distance_to_outline(const Prism<T>& prism, const Point& p) {
  Long least = std::numeric_limits<Long>::infinity();
  for (int i = 0; i < prism.sides(); ++i) {
    const Point a = prism.corner(i) - p, b = prism.corner_after(i) - p, edge{b.x - a.x, b.y - a.y};
    const Long s = -(a.x * edge.x + a.y * edge.y) / (edge.x * edge.x + edge.y * edge.y);
    const Long k = std::clamp<Long>(s, 0, 1);
    least = std::min(least, std::hypot(a.x + k * edge.x, a.y + k * edge.y));
  }
  return least;
}

// The oracle: every face by itself, in long double. `sure` is false where a hit lies so near an edge that either face,
// or none, would be right.
struct Answer {
  std::optional<Long> t;
  int part = -1;
  bool sure = true;
};

template <class T>
Answer face_by_face(const Prism<T>& prism, const Ray<T>& ray, int departed_part = no_part) {
  const Point o{ray.origin.x, ray.origin.y}, d{ray.direction.x, ray.direction.y};
  const Long oz = ray.origin.z, dz = ray.direction.z, half = static_cast<Long>(prism.height) / 2;
  const Long margin = 1000 * static_cast<Long>(std::numeric_limits<T>::epsilon());
  Answer answer;
  const auto offer = [&](Long t, int part, Long slack) {
    if (part == departed_part || t < -margin) return;
    if (std::abs(t) < margin) answer.sure = false;
    if (std::abs(slack) < margin) answer.sure = false;
    if (slack > 0 && t > 0 && (!answer.t || t < *answer.t)) answer.t = t, answer.part = part;
  };
  for (int i = 0; i < prism.sides(); ++i) {
    const Point a = prism.corner(i) - o, edge = prism.corner_after(i) - Point{prism.corner(i).x, prism.corner(i).y};
    const Long rate = cross(d, edge);
    if (rate == 0) continue;
    const Long t = cross(a, edge) / rate, s = cross(a, d) / rate;
    const Long size = std::hypot(edge.x, edge.y);
    offer(t, i, std::min({s * size, (1 - s) * size, half - std::abs(oz + t * dz)}));
  }
  for (const int part : {prism.top(), prism.bottom()}) {
    if (dz == 0) continue;
    const Long t = ((part == prism.top() ? half : -half) - oz) / dz;
    const Point p{o.x + t * d.x, o.y + t * d.y};
    const Long distance = distance_to_outline(prism, p);
    offer(t, part, contains(prism, p) ? distance : -distance);
  }
  return answer;
}

template <class T>
std::optional<Crossing<T>> meet(const Prism<T>& prism, const Ray<T>& ray, int departed_part = no_part) {
  return intersect(prism, ray, infinity<T>, departed_part);
}

// A point well inside the solid.
template <class T>
Vec3<T> point_inside(const Prism<T>& prism, Numbers& next, Long margin) {
  const Bounds<T> box = bounds(prism);
  for (;;) {
    const Vec3d low(box.min), high(box.max);
    const double x = next.real(low.x, high.x), y = next.real(low.y, high.y), z = next.real(low.z, high.z);
    const Vec3<T> p(Vec3d(x, y, z));
    const Point at{p.x, p.y};
    if (contains(prism, at) && distance_to_outline(prism, at) > margin &&
        static_cast<Long>(prism.height) / 2 - std::abs(static_cast<Long>(p.z)) > margin)
      return p;
  }
}

template <class T>
void compare(const Prism<T>& prism, const Ray<T>& ray, int& wrong, int& unsure, int& hits) {
  const Answer expected = face_by_face(prism, ray);
  const auto got = meet(prism, ray);
  if (!expected.sure) {
    ++unsure;
    return;
  }
  hits += expected.t.has_value();
  if (got.has_value() != expected.t.has_value() || (got && got->part != expected.part)) {
    ++wrong;
  } else if (got) {
    const Long error = std::abs(static_cast<Long>(got->t) - *expected.t) / *expected.t;
    wrong += error > 1e4L * std::numeric_limits<T>::epsilon();
  }
}

}  // namespace

TEMPLATE_TEST_CASE("a prism answers as its faces do one by one", "", float, double) {
  using T = TestType;
  Numbers next(1);
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon)
    for (const bool clockwise : {false, true}) {
      const auto prism = prism_of<T>(polygons[polygon], 1.5, clockwise);
      CAPTURE(polygon, clockwise);
      int wrong = 0, unsure = 0, hits = 0;
      for (int i = 0; i < 6000; ++i) {
        const Vec3<T> origin = i % 3 == 0 ? point_inside(prism, next, 1e-5L) : next.in_box<T>(6);
        Ray<T> ray{origin, point_inside(prism, next, 1e-5L) + next.in_box<T>(0.5) - origin};
        if (i % 5 == 0) ray.direction.z = 0;
        if (i % 7 == 0) ray.direction.x = 0;
        if (i % 11 == 0) ray.direction.y = T(-0.0);
        if (ray.direction == Vec3<T>(0)) continue;
        compare(prism, ray, wrong, unsure, hits);
      }
      CHECK(wrong == 0);
      CHECK(hits > 2000);
      CHECK(unsure < 600);
    }
}

TEMPLATE_TEST_CASE("no ray leaks out of a closed prism", "", float, double) {
  using T = TestType;
  const double scale = GENERATE(1e-6, 1.0, 1e9);
  const double shift = GENERATE(0.0, 1e3);
  CAPTURE(scale, shift);
  Numbers next(2);
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon) {
    if (polygon == 6 && (sizeof(T) == 4 || shift > 0))
      continue;  // the sliver is thinner than the steps of numbers there
    std::vector<Vec2d> corners = polygons[polygon];
    for (Vec2d& corner : corners) corner = scale * (corner + Vec2d(shift, -shift));
    const auto prism = prism_of<T>(corners, 1.5 * scale, polygon % 2 == 0);
    CAPTURE(polygon);
    int leaks = 0, astray = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3<T> origin = point_inside(prism, next, static_cast<Long>(scale) * (sizeof(T) == 4 ? 1e-3L : 1e-5L));
      // Aimed at corners, at rims, at points of upright edges, and anywhere.
      const int side = next.integer(0, prism.sides() - 1);
      const T half = prism.height / 2, along = static_cast<T>(next.real(0, 1));
      const Vec2<T> corner = prism.corner(side), rim = corner + along * prism.edge(side);
      Vec3<T> target;
      switch (i % 4) {
        case 0:
          target = {corner, i % 8 ? half : -half};
          break;
        case 1:
          target = {rim, i % 8 == 1 ? half : -half};
          break;
        case 2:
          target = {corner, (2 * along - 1) * half};
          break;
        case 3:
          target = origin + static_cast<T>(scale) * next.in_box<T>();
          break;
      }
      Ray<T> ray{origin, target - origin};
      if (i % 16 == 2) ray.direction.z = 0;
      const auto got = meet(prism, ray);
      if (!got) {
        ++leaks;
        continue;
      }
      // Where it is met lies on the surface.
      const SurfacePoint<T> point = surface_at(prism, ray, *got);
      const Long off = distance_to_outline(prism, Point{point.position.x, point.position.y});
      const bool on_cap = got->part >= prism.sides();
      const Long slack =
          static_cast<Long>(scale) * (1 + static_cast<Long>(shift)) * 16 * std::numeric_limits<T>::epsilon();
      astray += on_cap ? std::abs(point.position.z) != half : off > slack;
    }
    CHECK(leaks == 0);
    CHECK(astray == 0);
  }
}

TEMPLATE_TEST_CASE("rays aimed past a corner into the solid always hit it", "", float, double) {
  using T = TestType;
  Numbers next(3);
  for (const auto& corners : {polygons[0], polygons[1], polygons[5]})  // convex: the corner is the first thing met
    for (const bool clockwise : {false, true}) {
      const auto prism = prism_of<T>(corners, 2, clockwise);
      int missed = 0;
      for (int i = 0; i < 4000; ++i) {
        const Vec3<T> inside = point_inside(prism, next, 0.05L);
        const int side = next.integer(0, prism.sides() - 1);
        const T along = static_cast<T>(next.real(-1, 1));
        const Vec3<T> target(i % 2 ? prism.corner(side) : prism.corner(side) + (along + 1) / 2 * prism.edge(side),
                             i % 4 < 2   ? along
                             : i % 8 < 4 ? T(1)
                                         : T(-1));
        const Ray<T> ray{target + static_cast<T>(next.real(0.1, 20)) * (target - inside), inside - target};
        const auto got = meet(prism, ray);
        const T expected = length(target - ray.origin) / length(ray.direction);
        missed += !got || std::abs(got->t - expected) > 1000 * std::numeric_limits<T>::epsilon() * (1 + expected);
      }
      CHECK(missed == 0);
    }
}

TEMPLATE_TEST_CASE("upright rays meet the caps and nothing else", "", float, double) {
  using V = Vec3<TestType>;
  const auto prism = prism_of<TestType>(polygons[3], 2, GENERATE(false, true));  // the U; its notch is 1 < x < 3, y > 1
  CHECK(meet(prism, {V(0.5, 2, 5), V(0, 0, -1)})->t == 4);
  CHECK(meet(prism, {V(0.5, 2, 5), V(0, 0, -1)})->part == prism.top());
  CHECK(meet(prism, {V(0.5, 2, -5), V(0, 0, 2)})->t == 2);
  CHECK(meet(prism, {V(0.5, 2, -5), V(0, 0, 2)})->part == prism.bottom());
  CHECK(meet(prism, {V(0.5, 2, 0.5), V(0, 0, 1)})->t == 0.5);
  CHECK(meet(prism, {V(0.5, 2, 0.5), V(0, 0, 1)})->part == prism.top());
  CHECK_FALSE(meet(prism, {V(2, 2, 5), V(0, 0, -1)}));
  CHECK_FALSE(meet(prism, {V(5, 1, 5), V(0, 0, -1)}));
  CHECK_FALSE(meet(prism, {V(0.5, 2, 5), V(0, 0, 1)}));
  // Departing, down through the solid and up away from it.
  CHECK(meet(prism, {V(0.5, 2, 1), V(0, 0, -1)}, prism.top())->t == 2);
  CHECK_FALSE(meet(prism, {V(0.5, 2, 1), V(0, 0, 1)}, prism.top()));
}

TEMPLATE_TEST_CASE("level rays cross the sides one after the other", "", float, double) {
  using V = Vec3<TestType>;
  const bool clockwise = GENERATE(false, true);
  const auto prism = prism_of<TestType>(polygons[3], 2, clockwise);
  // Through both arms of the U at y = 2: in at 0, out at 1, in at 3, out at 4.
  Ray<TestType> ray{V(-1, 2, 0.25), V(1, 0, 0)};
  std::vector<TestType> crossings;
  int part = no_part;
  while (const auto got = meet(prism, ray, part)) {
    const auto point = surface_at(prism, ray, *got);
    crossings.push_back(point.position.x);
    CHECK(point.normal.z == 0);
    CHECK(point.normal.x == (crossings.size() % 2 ? -1 : 1));
    ray.origin = point.position, part = got->part;
    REQUIRE(crossings.size() < 10);
  }
  CHECK(crossings == std::vector<TestType>{0, 1, 3, 4});
  // Just above the top nothing is met; in the plane of the caps the rim counts as part of the solid.
  CHECK_FALSE(meet(prism, {V(-1, 2, std::nextafter(TestType(1), TestType(2))), V(1, 0, 0)}));
  CHECK(meet(prism, {V(-1, 2, 1), V(1, 0, 0)}));
}

TEST_CASE("rays through corners and along edges enter and leave in turn") {
  int touches = 0, crossings = 0;
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon)
    for (const bool clockwise : {false, true}) {
      const auto prism = prism_of<double>(polygons[polygon], 1, clockwise);
      for (int i = 0; i < prism.sides(); ++i)
        for (int j = 0; j < prism.sides(); ++j) {
          if (i == j) continue;
          const Vec2d a = prism.corner(i), b = prism.corner(j);
          Ray<double> ray{Vec3d(a + 6.5 * (a - b), 0.125), Vec3d(b - a, 0)};
          int part = no_part, passed = 0;
          CAPTURE(polygon, clockwise, i, j);
          bool at_corner = false;
          for (; const auto got = meet(prism, ray, part); ++passed) {
            const auto point = surface_at(prism, ray, *got);
            if ((dot(point.normal, ray.direction) > 0) != (passed % 2 == 1))
              FAIL("crossing " << passed << " leads wrong");
            ray.origin = point.position, part = got->part;
            REQUIRE(passed < 10);
            const Vec2d at = plan(point.position);
            at_corner = std::any_of(prism.corners.begin(), prism.corners.end(),
                                    [&](const Vec2d& corner) { return length(corner - at) < 1e-12; });
          }
          crossings += passed;
          // A corner that the ray only touches is entered and, having no inside there, not left.
          if (passed % 2 == 1) {
            ++touches;
            CHECK(at_corner);
          }
        }
    }
  CHECK(crossings > 500);
  CHECK(touches < 50);
}

TEMPLATE_TEST_CASE("a ray that leaves a prism never meets the face it left", "", float, double) {
  using T = TestType;
  const double scale = GENERATE(1e-6, 1.0, 1e9);
  const double shift = GENERATE(0.0, 1e3);
  CAPTURE(scale, shift);
  Numbers next(4);
  for (const std::size_t polygon : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{4}}) {
    std::vector<Vec2d> corners = polygons[polygon];
    for (Vec2d& corner : corners) corner = scale * (corner + Vec2d(shift, shift));
    const auto prism = prism_of<T>(corners, 1.5 * scale, polygon % 2 == 0);
    CAPTURE(polygon);
    int wrong = 0, unsure = 0, tried = 0, self = 0, out_hits = 0, trapped = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3<T> inside = point_inside(prism, next, static_cast<Long>(scale) * 1e-3L);
      // Half of the hits lie at corners and rims, where a neighbouring face is near.
      Vec3<T> target = inside + static_cast<T>(scale) * next.in_box<T>();
      const int side = next.integer(0, prism.sides() - 1);
      if (i % 2) target = {prism.corner(side), i % 4 == 1 ? prism.height / 2 : target.z};
      const Vec3<T> start = target + T(2) * (target - inside);
      const Ray<T> ray = i % 3 ? Ray<T>{start, inside - start} : Ray<T>{inside, target - inside};
      const auto hit = meet(prism, ray);
      if (!hit) continue;
      const auto point = surface_at(prism, ray, *hit);
      Vec3<T> away = next.unit<T>();
      if (dot(away, point.normal) < 0) away = -away;
      const Vec3<T> outward = away, inward = -away;
      ++tried;
      const bool convex = polygon < 2;
      const auto out = meet(prism, {point.position, outward}, hit->part);
      out_hits += convex && out;
      trapped += !meet(prism, {point.position, inward}, hit->part);
      for (const Vec3<T>& direction : {outward, inward}) {
        // Units of the scale, so that the oracle's margin means the same everywhere.
        const Ray<T> leaving{point.position, static_cast<T>(scale) * direction};
        const auto got = meet(prism, leaving, hit->part);
        self += got && got->part == hit->part;
        const Answer expected = face_by_face(prism, leaving, hit->part);
        if (!expected.sure) {
          ++unsure;
          continue;
        }
        if (got.has_value() != expected.t.has_value() || (got && got->part != expected.part)) ++wrong;
      }
    }
    CHECK(tried > 3000);
    CHECK(self == 0);
    CHECK(out_hits == 0);
    CHECK(trapped == 0);
    if (shift == 0 && scale == 1) {
      CHECK(wrong == 0);
      CHECK(unsure < tried * 3 / 2);
    }
  }
}

TEMPLATE_TEST_CASE("a ray that starts inwards at a corner leaves there at once", "", float, double) {
  using V = Vec3<TestType>;
  // From the top edge of the U's left arm, in its corner (1, 3): inwards as that edge sees it, but out through x = 1,
  // across the notch, and through the right arm.
  const bool clockwise = GENERATE(false, true);
  const auto prism = prism_of<TestType>(polygons[3], 2, clockwise);
  const int top_edge = clockwise ? 0 : 6, arm_edge = clockwise ? 1 : 5;
  REQUIRE(prism.corner(clockwise ? 1 : 6) == Vec2<TestType>(1, 3));
  const auto got = meet(prism, {V(1, 3, 0.5), V(1, TestType(-0.1), 0)}, top_edge);
  REQUIRE(got);
  CHECK(got->part == arm_edge);
  CHECK(got->t > 0);
  CHECK(got->t < 1e-30);
  // One step to the left it crosses the arm first.
  const auto inside = meet(prism, {V(0.5, 3, 0.5), V(1, TestType(-0.1), 0)}, top_edge);
  REQUIRE(inside);
  CHECK(inside->part == arm_edge);
  CHECK(inside->t == 0.5);
  // At a rim: inwards as the side sees it, but out through the top.
  const auto over = meet(prism, {V(0.5, 3, 1), V(0, -1, 1)}, top_edge);
  REQUIRE(over);
  CHECK(over->part == prism.top());
  CHECK(over->t < 1e-30);
}

TEMPLATE_TEST_CASE("normals of a prism point outwards in both windings", "", float, double) {
  using T = TestType;
  Numbers next(5);
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon)
    for (const bool clockwise : {false, true}) {
      const auto prism = prism_of<T>(polygons[polygon], 1, clockwise);
      for (int i = 0; i < 300; ++i) {
        const Ray<T> ray{point_inside(prism, next, 1e-5L), next.unit<T>()};
        const auto got = meet(prism, ray);
        REQUIRE(got);
        const auto point = surface_at(prism, ray, *got);
        if (!(dot(point.normal, ray.direction) > 0)) FAIL("inwards at " << i << " of polygon " << polygon);
        if (std::abs(length(point.normal) - 1) > 4 * std::numeric_limits<T>::epsilon()) FAIL("not a unit");
        if (got->part < prism.sides() && point.normal.z != 0) FAIL("a side's normal is not level");
        if (std::abs(point.position.z) > prism.height / 2) FAIL("above the cap");
      }
    }
}

TEST_CASE("coordinates of a prism's faces are lengths") {
  const auto prism = prism_of<double>(polygons[0], 2, false);
  const auto uv = [&](const Vec3d& p, int part) { return uv_at(prism, SurfacePoint<double>{p, Vec3d(0)}, part); };
  CHECK(uv({1, 0, 0.5}, 0) == Vec2d(1, 0.5));
  CHECK(uv({0, 3, -0.5}, 1) == Vec2d(5, -0.5));
  CHECK(uv({0, 3, 0}, 2) == Vec2d(0, 0));
  CHECK(uv({0.5, 0.25, 1}, prism.top()) == Vec2d(0.5, 0.25));
  CHECK(uv({0.5, 0.25, -1}, prism.bottom()) == Vec2d(0.5, 0.25));
}

TEST_CASE("the area of a polygon is signed by its winding") {
  CHECK(prism_of<double>(polygons[0], 1, false).twice_signed_area() == 12);
  CHECK(prism_of<double>(polygons[0], 1, true).twice_signed_area() == -12);
  CHECK(prism_of<double>(polygons[3], 1, false).twice_signed_area() == 16);
  CHECK(prism_of<double>(polygons[7], 1, true).twice_signed_area() == -3);
}

TEST_CASE("a prism is met only before t_max, and its bounds hold it") {
  const auto prism = prism_of<double>(polygons[4], 3, true);
  const Bounds<double> box = bounds(prism);
  CHECK(box.min == Vec3d(-2, -2, -1.5));
  CHECK(box.max == Vec3d(2, 2, 1.5));
  const Ray<double> ray{{-5, 0, 0}, {1, 0, 0}};
  CHECK_FALSE(intersect(prism, ray, 3.0));
  CHECK(intersect(prism, ray, 3.0001)->t == 3);
}
