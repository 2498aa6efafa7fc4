#include "shape/polygon.h"
#include "math/double_double.h"
#include "shape/prism.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// Sign of the turn from a over b to c: > 0 left. In double-double, which cannot tell one of less than 2^-100 of its
/// products.
int turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const DoubleDouble ux = two_sum(b.x, -a.x), uy = two_sum(b.y, -a.y), vx = two_sum(c.x, -a.x), vy = two_sum(c.y, -a.y);
  const DoubleDouble area = ux * vy - uy * vx;
  return area.hi > 0 ? 1 : area.hi < 0 ? -1 : 0;
}

/// c lies on the closed segment ab, given that the three are collinear.
bool between(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
         c.y <= std::max(a.y, b.y);
}

bool segments_meet(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
         (cdb == 0 && between(c, d, b));
}

}  // namespace

std::string why_not_polygon(const std::vector<Vec2d>& given) {
  const std::size_t n = given.size();
  // Scaled by a power of two, which is exact, to coordinates whose products neither over- nor underflow.
  double largest = 0;
  for (const Vec2d& corner : given) largest = std::fmax(largest, std::fmax(std::abs(corner.x), std::abs(corner.y)));
  const int exponent = std::isfinite(largest) && largest > 0 ? std::ilogb(largest) : 0;
  std::vector<Vec2d> corners;
  for (const Vec2d& corner : given)
    corners.emplace_back(std::scalbn(corner.x, -exponent), std::scalbn(corner.y, -exponent));

  if (n < 3) return "a polygon needs at least 3 corners, this one has " + std::to_string(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (!std::isfinite(corners[i].x) || !std::isfinite(corners[i].y))
      return "corner " + std::to_string(i + 1) + " is not a finite point";
    if (corners[i] == corners[next])
      return "corners " + std::to_string(i + 1) + " and " + std::to_string(next + 1) + " are the same point";
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n, after = (i + 2) % n;
    // Adjacent edges share a corner and must not fold back onto each other.
    if (turn(corners[i], corners[next], corners[after]) == 0 &&
        dot(corners[next] - corners[i], corners[after] - corners[next]) < 0)
      return "the edges at corner " + std::to_string(next + 1) + " fold back onto each other";
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segments_meet(corners[i], corners[next], corners[j], corners[(j + 1) % n]))
        return "the edge after corner " + std::to_string(i + 1) + " crosses the edge after corner " +
               std::to_string(j + 1);
    }
  }
  return {};
}

std::string why_not_flat(const Polygon<double>& polygon) {
  const auto few = [](const std::vector<Vec3d>& loop) { return loop.size() < 3; };
  if (few(polygon.outline)) return "a polygon needs at least 3 corners";
  if (std::any_of(polygon.holes.begin(), polygon.holes.end(), few)) return "a hole needs at least 3 corners";
  const Vec3d area = polygon.area_vector();
  Bounds<double> box;
  for (const Vec3d& corner : polygon.outline) box.include(corner);
  const double size = length(box.max - box.min);
  if (!(length(area) > 1e-12 * size * size)) return "the polygon has no area";
  const Vec3d normal = normalize(area);
  const auto aslant = [&](const Vec3d& corner) {
    return std::abs(dot(corner - polygon.outline.front(), normal)) > 1e-6 * size;
  };
  const auto warped = [&](const std::vector<Vec3d>& loop) { return std::any_of(loop.begin(), loop.end(), aslant); };
  if (warped(polygon.outline)) return "the corners do not lie in one plane";
  if (std::any_of(polygon.holes.begin(), polygon.holes.end(), warped))
    return "a hole does not lie in the polygon's plane";
  return {};
}

}  // namespace raywalk
