// Lines by hand.

#include "view/ink/ink.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

double distance_to_segment(const Vec2d& at, const Vec2d& from, const Vec2d& to) {
  const Vec2d along = to - from;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(at - from, along) / square, 0.0, 1.0) : 0.0;
  return length(at - (from + t * along));
}

/// a + t (b - a) between the knots s and e.
Vec2d between(const Vec2d& a, const Vec2d& b, double s, double e, double t) {
  return e > s ? a + (t - s) / (e - s) * (b - a) : b;
}

}  // namespace

std::vector<Vec2d> simplified(const std::vector<Vec2d>& points, double tolerance) {
  // D. Douglas and T. Peucker, "Algorithms for the reduction of the number of points", Cartographica 10(2), 1973.
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_to_segment(points[i], points[first], points[last]);
      if (off > farthest) farthest = off, at = i;
    }
    if (at == first) continue;
    kept[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<Vec2d> left;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) left.push_back(points[i]);
  return left;
}

std::vector<Vec2d> smooth(const std::vector<Vec2d>& points, double step) {
  // The centripetal curve of E. Catmull and R. Rom, "A class of local interpolating splines", 1974: no loops, by the
  // algorithm of P. Barry and R. Goldman, "A recursive evaluation algorithm", SIGGRAPH 1988.
  if (points.size() < 3) return points;
  std::vector<Vec2d> line{points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2d p1 = points[i], p2 = points[i + 1];
    const Vec2d p0 = i > 0 ? points[i - 1] : 2.0 * p1 - p2;
    const Vec2d p3 = i + 2 < points.size() ? points[i + 2] : 2.0 * p2 - p1;
    const double t1 = std::sqrt(length(p1 - p0)), t2 = t1 + std::sqrt(length(p2 - p1)),
                 t3 = t2 + std::sqrt(length(p3 - p2));
    constexpr double most = 24;
    const int pieces = static_cast<int>(std::clamp(std::ceil(length(p2 - p1) / step), 1.0, most));
    for (int k = 1; k < pieces; ++k) {
      const double t = t1 + (t2 - t1) * k / pieces;
      const Vec2d a1 = between(p0, p1, 0, t1, t), a2 = between(p1, p2, t1, t2, t), a3 = between(p2, p3, t2, t3, t);
      const Vec2d b1 = between(a1, a2, 0, t2, t), b2 = between(a2, a3, t1, t3, t);
      line.push_back(between(b1, b2, t1, t2, t));
    }
    line.push_back(p2);
  }
  return line;
}

Vec2d rounded(const Vec2d& at, double error) {
  // By division, for 3452 / 1000 is the number that is written 3.452.
  const double decimals = std::ceil(-std::log10(2 * error));
  if (!(decimals >= -12 && decimals <= 15)) return at;
  const double scale = std::pow(10.0, std::abs(decimals));
  const auto round_one = [&](double value) {
    const double whole = decimals >= 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
    return std::isfinite(whole) ? whole + 0.0 : value;  // no -0
  };
  return {round_one(at.x), round_one(at.y)};
}

}  // namespace raywalk
