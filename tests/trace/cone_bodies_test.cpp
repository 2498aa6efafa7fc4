// Which objects a cone asks: all that its rays meet.

#include "trace/cone_bodies.h"

#include <algorithm>
#include <cmath>

#include "math/random.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

bool is_hit(const ConeBody& body, const Ray<double>& ray, double t_max) {
  if (const auto* ball = std::get_if<ConeBall>(&body.shape))
    return intersect(Sphere<double>{ball->centre, ball->radius}, ray, t_max).has_value();
  const std::vector<Vec3d>& corners = std::get<ConeFaces>(body.shape).faces.front().loops.front();
  return intersect(Triangle<double>{corners[0], corners[1], corners[2]}, ray, t_max).has_value();
}

}  // namespace

TEST_CASE("a cone asks each object that one of its rays meets, and hardly another") {
  RandomKey key;
  key.seed = 24;
  const auto next = [&] { return ++key.dimension, random_unit<double>(key); };
  const auto point = [&](double size) {
    const double x = next(), y = next();
    return size * Vec3d(2 * x - 1, 2 * y - 1, 2 * next() - 1);
  };
  constexpr int count = 300;
  std::vector<ConeBody> all;
  std::vector<Vec3d> middles;
  for (int i = 0; i < count; ++i) {
    const Vec3d at = point(10), a = point(0.5), b = point(0.5);
    middles.push_back(at);
    if (i % 2 == 0)
      all.push_back({ConeBall{at, 0.05 + 0.5 * next()}, i});
    else
      all.push_back({ConeFaces{{{{{at, at + a, at + b}}, normalize(cross(a, b)), 0}}, false}, i});
  }
  all.push_back({ConeWall{{0, 0, -12}, {0, 0, 1}}, count});
  const ConeBodies bodies(all);
  int forgotten = 0, met = 0;
  std::size_t asked = 0;
  constexpr int cones = 60, rays = 60;
  for (int i = 0; i < cones; ++i) {
    // Wide or narrow; some converge; as far as a light, or endless; towards some object.
    const double spread = i % 3 == 0 ? -0.05 : (i % 3 == 1 ? 0.1 : 1.0) * next(),
                 radius = i % 3 == 0 ? 0.4 : 0.1 * next();
    const double depth = i % 2 == 0 ? infinity<double> : 2 + 8 * next();
    const Vec3d from = point(10), to = middles[static_cast<std::size_t>((count - 1) * next())];
    const RayCone cone = cone_about(from, normalize(to - from), radius, spread, false);
    const std::vector<int> near = bodies.near(cone, depth);
    asked += near.size();
    CHECK(std::is_sorted(near.begin(), near.end()));
    CHECK(near.back() == count);
    for (int k = 0; k < rays; ++k) {
      const double turn = 6.28 * next(), off = std::sqrt(next());
      const Vec2d u(off * std::cos(turn), off * std::sin(turn));
      const Ray<double> ray{cone.start(u), cone.direction(u)};
      for (int body = 0; body < count; ++body) {
        const bool hit = is_hit(bodies[body], ray, depth);
        met += hit;
        forgotten += hit && !std::binary_search(near.begin(), near.end(), body);
      }
    }
  }
  CHECK(forgotten == 0);
  CHECK(met > 500);
  CHECK(asked < std::size_t{cones} * 100);
}
