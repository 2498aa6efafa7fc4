// Cones: the shares that shapes cover of them (trace/ray_cone_test.cpp has what mirrors and glass make of their width).

#include "trace/cone_cover.h"

#include "math/random.h"
#include "scene/cone_limits.h"
#include "trace/cone_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.h"

using namespace raywalk;

namespace {

double unit(int index, std::uint32_t dimension) {
  RandomKey key;
  key.seed = 24;
  key.sample = static_cast<std::uint32_t>(index);
  key.dimension = dimension;
  return random_unit<double>(key);
}

Scene with(Shape<double> shape) {
  Scene scene;
  std::visit([&](auto& its) { scene.objects = {{"It", its, Material{}}}; }, shape);
  return scene;
}

RayCone along_x(double radius, double spread, bool flat) {
  return cone_about({0, 0, 0}, {1, 0, 0}, radius, spread, flat);
}

double covered(const Scene& scene, const RayCone& cone, double depth = infinity<double>) {
  double sum = 0;
  TestCounts counts;
  for (const ConePart& part : meet_cone(cone_bodies_of(scene, cone.flat), cone, {}, depth, counts)) {
    CHECK(std::isfinite(part.t + part.place.x + part.place.y));
    sum += part.cover;
  }
  return sum;
}

double sum_of_shares(const std::vector<ConePart>& parts) {
  double sum = 0;
  for (const ConePart& part : parts) {
    CHECK(part.share >= 0);
    CHECK(part.share <= 1);
    CHECK(part.cover <= 1);
    CHECK(std::isfinite(part.t + part.place.x + part.place.y + part.size));
    sum += part.share;
  }
  return sum;
}

}  // namespace

TEST_CASE("half covered is one half") {
  for (const bool flat : {false, true}) {
    const RayCone cone = along_x(0, 0.1, flat);
    CHECK(covered(with(Box<double>{{5, 0, -9}, {6, 9, 9}}), cone) == Approx(0.5).epsilon(1e-12));
    // A quarter of the disc, but half of the plan's width.
    CHECK(covered(with(Box<double>{{5, 0, 0}, {6, 9, 9}}), cone) == Approx(flat ? 0.5 : 0.25).epsilon(1e-12));
    // The horizon of a floor or a wall.
    CHECK(covered(with(Plane<double>{{0, -1, 0}, {0, 1, 0}}), cone) == Approx(0.5).epsilon(1e-12));
    // So large a ball has a straight edge, which is where the cone's axis touches it.
    const double radius = 1e4;
    CHECK(covered(with(Sphere<double>{{5, radius, 0}, radius}), cone) == Approx(0.5).margin(1e-4));
  }
  // A prism's side whose edge is on the axis, and a polygon that is a hole's inside.
  CHECK(covered(with(Prism<double>{{{4, 0}, {6, 0}, {5, 3}}, 20}), along_x(0, 0.05, false)) ==
        Approx(0.5).epsilon(1e-9));
  const double small = 0.2;
  Polygon<double> holed{{{5, -9, -9}, {5, 9, -9}, {5, 9, 9}, {5, -9, 9}},
                        {{{5, -small, -small}, {5, small, -small}, {5, small, small}, {5, -small, small}}}};
  CHECK(covered(with(holed), along_x(0, 0.1, false)) ==
        Approx(1 - 4 * small * small / (std::numbers::pi * 0.25)).epsilon(1e-12));
}

TEST_CASE("a disc square to a cone's axis covers what one circle has in common with another") {
  TestCounts counts;
  // Half a unit wide, a quarter, and a quarter of rays that have crossed.
  for (const RayCone& cone : {along_x(0, 0.1, false), along_x(0.5, -0.05, false), along_x(0.5, -0.15, false)})
    for (const double off : {0.0, 0.06, 0.21, 0.3, 0.47, 0.54, 0.79}) {
      const double width = std::abs(cone.radius_at(5)), expected = share_of_disc(off / width, 0.3 / width);
      const Disk<double> disc{{5, 0.6 * off, -0.8 * off}, {-1, 0, 0}, 0.3};
      CAPTURE(width, off);
      CHECK(covered(with(disc), cone) == Approx(expected).epsilon(1e-9));
      CHECK(covered(with(disc), cone, 4.9) == 0);
      // The ray that stands for it meets it.
      for (const ConePart& part : meet_cone(cone_bodies_of(with(disc), false), cone, {}, infinity<double>, counts)) {
        const Vec3d met = cone.start(part.place) + part.t * cone.direction(part.place);
        CHECK(length(met - disc.centre) < disc.radius);
        CHECK(length(part.place) <= 1);
      }
    }
  // As wide as nothing where it is: all of it, or nothing.
  CHECK(covered(with(Disk<double>{{5, 0.2, 0}, {1, 0, 0}, 0.3}), along_x(0.5, -0.1, false)) == 1);
  CHECK(covered(with(Disk<double>{{5, 0.4, 0}, {1, 0, 0}, 0.3}), along_x(0.5, -0.1, false)) == 0);
}

namespace {

constexpr int rays_of_flat_cone = 20000;

/// How many of as many rays of a flat cone meet a ball.
int rays_that_meet(const Vec3d& centre, double radius, const RayCone& cone) {
  int met = 0;
  for (int i = 0; i < rays_of_flat_cone; ++i) {
    const Vec2d place{(2 * i + 1.0) / rays_of_flat_cone - 1, 0};
    const Vec3d direction = normalize(cone.direction(place)), to = centre - cone.start(place);
    if (length(to - dot(to, direction) * direction) < radius && dot(to, direction) > 0) ++met;
  }
  return met;
}

}  // namespace

TEST_CASE("in the plan the share of one object is how much of the cone's rays meet it") {
  for (int number = 0; number < 200; ++number) {
    const auto at = [&](std::uint32_t dimension) { return unit(number, dimension); };
    const RayCone cone = along_x(at(0) < 0.5 ? 0 : 0.3 * at(1), 0.3 * at(2) - (at(0) < 0.3 ? 0 : 0.1), true);
    const Vec3d centre{2 + 4 * at(3), 2 * at(4) - 1, 0};
    const double radius = 0.1 + at(5);
    if (length(centre) <= radius + 0.4) continue;
    const double share = covered(with(Sphere<double>{centre, radius}), cone);
    const int met = rays_that_meet(centre, radius, cone);
    CAPTURE(number);
    CHECK(share == Approx(static_cast<double>(met) / rays_of_flat_cone).margin(2.0 / rays_of_flat_cone));
  }
}

TEST_CASE("in space the share of one ball, box, prism or disc is how much of the cone's rays meet it") {
  for (int number = 0; number < 60; ++number) {
    const auto at = [&](std::uint32_t dimension) { return unit(number, dimension); };
    const RayCone cone = along_x(0.2 * at(0), 0.12 + 0.1 * at(1), false);
    const Vec3d middle{3 + 2 * at(2), 1.2 * at(3) - 0.6, 1.2 * at(4) - 0.6};
    const double size = 0.15 + 0.4 * at(5);
    const Shape<double> shape = number % 3 == 0   ? Shape<double>(Sphere<double>{middle, size})
                                : number % 3 == 1 ? Shape<double>(Box<double>{middle - size, middle + size})
                                                  : Shape<double>(Disk<double>{middle, {1, at(6), at(7)}, size});
    const double share = covered(with(shape), cone);
    const Primitives<double> primitives({shape});
    // On a spiral of even density: rows would all stand on one side of a box's edge at once.
    constexpr int rays = 200000;
    int met = 0;
    for (int i = 0; i < rays; ++i) {
      const double away = std::sqrt((i + 0.5) / rays), turn = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
      const Vec2d place{away * std::cos(turn), away * std::sin(turn)};
      TestCounts tests;
      const Ray<double> ray{cone.start(place), normalize(cone.direction(place))};
      if (primitives.intersect(0, ray, infinity<double>, tests)) ++met;
    }
    CAPTURE(number);
    CHECK(share == Approx(static_cast<double>(met) / rays).margin(number % 3 == 0 ? 0.002 : 0.00015));
  }
}

TEST_CASE("a wide cone meets a ball whose centre is level with its start or behind it, and none that is all behind") {
  int level = 0, crossed = 0;
  for (int number = 0; number < 400; ++number) {
    const auto at = [&](std::uint32_t dimension) { return unit(number, dimension); };
    // Every other one converges, to a point among the balls.
    const double start = 0.2 + 0.6 * at(1), spread = number % 2 == 0 ? 4 * at(0) : -start / (0.2 + 0.8 * at(0));
    const RayCone cone = along_x(number % 4 == 0 ? 0 : start, spread, true);
    const Vec3d centre{2 * at(2) - 1, 4 * at(3) - 2, 0};
    const double radius = 0.1 + at(4);
    // Rays that start in the ball are another thing.
    if (length(Vec3d(centre.x, std::max(std::abs(centre.y) - cone.radius, 0.0), 0)) <= radius) continue;
    const double share = covered(with(Sphere<double>{centre, radius}), cone);
    const int met = rays_that_meet(centre, radius, cone);
    CAPTURE(number, centre.x, centre.y, radius, cone.radius, spread);
    CHECK(share == Approx(static_cast<double>(met) / rays_of_flat_cone).margin(3.0 / rays_of_flat_cone));
    level += met > 0 && centre.x <= 0;
    crossed += met > 0 && spread < 0;
  }
  CHECK(level > 5);
  CHECK(crossed > 20);
  for (const bool flat : {false, true}) {
    // A ground that curves away by less than a hundredth, under a cone that starts behind, over and before its middle.
    for (const double x : {-5.0, 0.0, 5.0})
      CHECK(covered(with(Sphere<double>{{x, -10001, 0}, 10000}), along_x(0, 1, flat)) == Approx(0.5).margin(0.01));
    // Where the rays' point is in the plane that touches the ball from behind, its far edge is nowhere.
    const double share = covered(with(Sphere<double>{{1, 3, 0}, 1}), along_x(0, 4, flat));
    CHECK(share == Approx(flat ? 1 / 3.0 : share_beyond(1 / 3.0)).epsilon(1e-9));
    for (const double spread : {-0.5, 0.0, 4.0})
      CHECK(covered(with(Sphere<double>{{-2, 0.5, 0}, 1.5}), along_x(0.5, spread, flat)) == 0);
  }
}

TEST_CASE("of a solid a cone meets the faces that its rays go into, wherever its point is") {
  // Two of its sides are turned to where the cone's middle starts, but only one to the rays.
  const Prism<double> wedge{{{10, 0.3}, {12, 1}, {10, 1}}, 20};
  for (int number = 0; number < 400; ++number) {
    const auto at = [&](std::uint32_t dimension) { return unit(number, dimension); };
    const bool closing = number % 2 == 0;
    const double start = 0.1 + at(0);
    const RayCone cone = along_x(start, closing ? -start / (1 + 8 * at(1)) : number % 3 == 0 ? 0 : at(1), true);
    std::vector<Vec2d> corners;
    for (std::uint32_t i = 0; i < 3; ++i) corners.push_back({1.5 + 4 * at(2 + i), 4 * at(5 + i) - 2});
    const Prism<double> solid = number == 0 ? wedge : Prism<double>{corners, 20};
    if (std::abs(solid.twice_signed_area()) < 0.3) continue;
    const Scene scene = with(solid);
    const double share = covered(scene, cone);
    const Primitives<double> primitives({Shape<double>(solid)});
    constexpr int rays = 10000;
    int met = 0;
    for (int i = 0; i < rays; ++i) {
      const Vec2d place{(2 * i + 1.0) / rays - 1, 0};
      const Ray<double> ray{cone.start(place), normalize(cone.direction(place))};
      TestCounts tests;
      if (primitives.intersect(0, ray, infinity<double>, tests)) ++met;
    }
    CAPTURE(number, cone.radius, cone.spread);
    CHECK(share == Approx(static_cast<double>(met) / rays).margin(3.0 / rays));
  }
  // As on the way to a lamp, too.
  const RayCone to_lamp = along_x(0.5, -0.5 / 20, true);
  TestCounts counts;
  for (const RayCone& cone : {to_lamp, along_x(0.5, 0.1, true), along_x(1, 0, true), along_x(0.5, 0.1, false)}) {
    const ConeBodies bodies = cone_bodies_of(with(wedge), cone.flat);
    for (const ConePart& part : meet_cone(bodies, cone, {}, 19, counts))
      for (const ConeFace& face : std::get<ConeFaces>(bodies[0].shape).faces)
        if (face.part == part.part) CHECK(dot(cone.direction(part.place), face.normal) < 0);
  }
}

TEST_CASE("a cone that starts in the plane of a solid's face is inside if it goes in") {
  const Scene room = with(Box<double>{{-1, -1, -1}, {1, 1, 1}});
  for (const bool flat : {false, true})
    for (const double radius : {0.0, 0.01}) {
      const Vec3d in = normalize(Vec3d(-1, 0.3, 0));
      CHECK(covered(room, cone_about({1, 0.2, 0}, in, radius, 0.1, flat)) == Approx(1).epsilon(1e-12));
      CHECK(covered(room, cone_about({1, 0.2, 0}, -in, radius, 0.1, flat)) == 0);
      // In an edge, in by one of its faces and out by the other.
      const Vec3d edge(1, 1, 0);
      CHECK(covered(room, cone_about(edge, normalize(Vec3d(-1, -0.5, 0)), radius, 0.1, flat)) ==
            Approx(1).epsilon(1e-12));
      CHECK(covered(room, cone_about(edge, normalize(Vec3d(-1, 0.5, 0)), radius, 0.1, flat)) == 0);
    }
}

TEST_CASE("parts of a cone add up to it, whatever is in the way: hard cases") {
  Scene scene;
  scene.objects = {{"Ball", Sphere<double>{{3, 0.5, 0}, 0.5}, Material{}},
                   {"Touching", Sphere<double>{{3, -0.5, 0}, 0.5}, Material{}},
                   {"Mirror", Box<double>{{2, -1, -1}, {2, 1, 1}}, Material{}},
                   {"End on", Box<double>{{1, 0, -1}, {4, 0, 1}}, Material{}},
                   {"Around", Sphere<double>{{0, 0, 0}, 9}, Material{}},
                   {"Through eye", Plane<double>{{0, 0, 0}, {0, 1, 0}}, Material{}},
                   {"Corner", Prism<double>{{{0, 0}, {2, 1}, {2, 2}}, 2}, Material{}},
                   {"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, Material{}}};
  TestCounts counts;
  for (const bool flat : {false, true}) {
    const ConeBodies all = cone_bodies_of(scene, flat);
    for (unsigned set = 1; set < 1U << all.size(); ++set) {
      std::vector<ConeBody> bodies;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (set >> i & 1U) bodies.push_back(all[static_cast<int>(i)]);
      for (const double radius : {0.0, 0.2})
        for (const double spread : {-0.1, 0.0, 0.05, 4.0}) {
          if (radius == 0 && spread <= 0) continue;
          const RayCone cone = along_x(radius, spread, flat);
          CHECK(sum_of_shares(cover_cone(ConeBodies(bodies), cone, {}, counts)) == Approx(1).epsilon(1e-12));
        }
    }
  }
}

TEST_CASE("random cones among random things: no NaN, no share outside 0..1, the sum is 1") {
  TestCounts counts;
  for (int number = 0; number < 400; ++number) {
    std::uint32_t dimension = 0;
    const auto next = [&] { return 4 * unit(number, dimension++) - 2; };
    const auto point = [&] {
      const double x = next(), y = next();
      return Vec3d(x, y, next());
    };
    const bool flat = number % 2 == 0;
    Scene scene;
    for (int i = 0; i < 3; ++i) {
      Vec3d at = point();
      if (flat) at.z = 0;
      scene.objects.push_back({"S", Sphere<double>{at, 0.1 + std::abs(next()) / 3}, Material{}});
      const Vec3d low = point(), far = point(),
                  size(std::abs(far.x) + 0.1, std::abs(far.y) + 0.1, std::abs(far.z) + 0.1);
      scene.objects.push_back({"B", Box<double>{low, low + size}, Material{}});
      scene.objects.push_back({"D", Disk<double>{point() + Vec3d(0, 0, flat ? 30 : 0), point(), 0.5}, Material{}});
    }
    Vec3d origin = point(), axis = point();
    if (flat) origin.z = axis.z = 0;
    const RayCone cone =
        cone_about(origin, normalize(axis), number % 3 == 0 ? 0 : 0.2, number % 3 == 0 ? 0.2 : next() / 8, flat);
    CAPTURE(number);
    CHECK(sum_of_shares(cover_cone(cone_bodies_of(scene, flat), cone, {}, counts)) == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("what is in front is first, along the rays that both cover") {
  Scene scene;
  scene.objects = {{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, Material{}},
                   {"Ball", Sphere<double>{{10, 0, -0.5}, 0.5}, Material{}},
                   {"Behind", Sphere<double>{{20, 0, -0.5}, 9}, Material{}}};
  // Towards the place where the ball stands on the floor: the floor before it is nearer than the ball.
  const RayCone cone = cone_about({0, 0, 0}, normalize(Vec3d(9.7, 0, -0.95)), 0, 0.02, false);
  const ConeBodies bodies = cone_bodies_of(scene, false);
  TestCounts counts;
  const std::vector<ConePart> parts = cover_cone(bodies, cone, {}, counts);
  REQUIRE(parts.size() >= 2);
  CHECK(parts[0].body == 1);
  CHECK(parts[0].share > 0);
  CHECK(parts[0].share < 1);
  CHECK(parts[1].body == 0);
}

TEST_CASE("cones are refused where a shape's share is not known, by the object's name") {
  Scene scene = with(Sphere<double>{{0, 0, 0}, 1});
  CHECK(why_no_cones(scene).empty());
  scene.objects.push_back({"Star", Prism<double>{{{0, 0}, {4, 1}, {0, 2}, {1, 1}}, 1}, Material{}});
  CHECK(why_no_cones(scene) == "Star is not convex");
  CHECK(object_against_cones(scene) == "Star");
  scene.objects[1] = {"Egg", Ellipsoid<double>{}, Material{}};
  CHECK(why_no_cones(scene) == "Egg is neither a sphere, a plane, a disc, a polygon, a prism nor a box");
  scene.objects[1] = {"Turned", Box<double>{{0, 0, 0}, {1, 1, 1}}, Material{}};
  scene.objects[1].transform.push_back({Scale{{1, 2, 1}}});
  CHECK(why_no_cones(scene) == "Turned is transformed");
  scene.objects[1] = {"Sided", Box<double>{{0, 0, 0}, {1, 1, 1}}, Material{}};
  scene.objects[1].material.normal = ShadingNormal::fixed;
  CHECK(why_no_cones(scene) == "Sided has a fixed normal");
}
