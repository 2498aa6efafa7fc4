#include "shape/prisms.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

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
