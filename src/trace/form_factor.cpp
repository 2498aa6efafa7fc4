#include "trace/form_factor.h"

#include "math/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace raywalk {

namespace {

/// The natural logarithm of x > 0. What it is scaled by is exact, and so is m - 1.
double log_of(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < std::numbers::sqrt2 / 2) m *= 2, --exponent;
  return portable::log1p(m - 1) + exponent * std::numbers::ln2;
}

/// The antiderivative of ln sqrt(w^2 + h^2) by w, without -w: around a whole polygon that adds up to nothing.
double log_along(double w, double h) {
  const double square = w * w + h * h;
  if (!(square > 0)) return 0;
  return 0.5 * w * log_of(square) + (h > 0 ? h * portable::atan2(w, h) : 0);
}

/// An edge of a polygon: `along` of unit length.
struct Side {
  Vec3d from, along;
  double length;
  [[nodiscard]] Vec3d at(double s) const { return from + s * along; }
};

std::vector<Side> sides_of(std::span<const Vec3d> corners) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
    const double size = length(edge);
    if (size > 0) sides.push_back({corners[i], edge / size, size});
  }
  return sides;
}

/// The integral of ln r over the whole of `side`, seen from a point; less the length of the side.
double log_seen(const Side& side, const Vec3d& point) {
  const Vec3d offset = point - side.from;
  const double foot = dot(offset, side.along), h = length(offset - foot * side.along);
  return log_along(side.length - foot, h) - log_along(-foot, h);
}

/// Of log_seen from s = a to b of `outer`.
double log_between(const Side& inner, const Side& outer, double a, double b, double tolerance, int halvings) {
  struct Node {
    double x, weight;
  };
  static constexpr std::array<Node, 2> three{{{0, 8.0 / 9}, {0.77459666924148337704, 5.0 / 9}}};
  static constexpr std::array<Node, 3> five{{{0, 128.0 / 225},
                                             {0.53846931010568309104, 0.47862867049936646804},
                                             {0.90617984593866399280, 0.23692688505618908751}}};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  const double in_middle = log_seen(inner, outer.at(middle));
  const auto both = [&](double x) {
    return log_seen(inner, outer.at(middle - half * x)) + log_seen(inner, outer.at(middle + half * x));
  };
  const double by_three = half * (three[0].weight * in_middle + three[1].weight * both(three[1].x));
  const double by_five =
      half * (five[0].weight * in_middle + five[1].weight * both(five[1].x) + five[2].weight * both(five[2].x));
  if (halvings == 0 || !(std::abs(by_five - by_three) > tolerance)) return by_five;
  return log_between(inner, outer, a, middle, tolerance / 2, halvings - 1) +
         log_between(inner, outer, middle, b, tolerance / 2, halvings - 1);
}

/// The part of an edge in front of another one.
std::optional<Edge> clipped(const Edge& edge, const Edge& by) {
  const Vec2d along = by.b - by.a;
  const auto height = [&](const Vec2d& p) { return along.x * (p.y - by.a.y) - along.y * (p.x - by.a.x); };
  const double a = height(edge.a), b = height(edge.b);
  const double nothing =
      1e-13 * length(along) * std::max({length(along), length(edge.a - by.a), length(edge.b - by.a)});
  if (a <= nothing && b <= nothing) return std::nullopt;
  if (a >= 0 && b >= 0) return edge;
  const Vec2d cut = edge.a + a / (a - b) * (edge.b - edge.a);
  return a < 0 ? Edge{cut, edge.b} : Edge{edge.a, cut};
}

}  // namespace

Vec3d area_vector_of(std::span<const Vec3d> corners) {
  Vec3d sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return 0.5 * sum;
}

std::vector<Vec3d> clipped(std::span<const Vec3d> corners, const Vec3d& point, const Vec3d& normal) {
  std::vector<double> heights;
  double extent = 0;
  for (const Vec3d& corner : corners) {
    heights.push_back(dot(corner - point, normal));
    extent = std::max(extent, length(corner - point));
  }
  // Rounding does not lift out of the plane what lies in it.
  for (double& height : heights)
    if (std::abs(height) <= 1e-13 * extent * length(normal)) height = 0;
  std::vector<Vec3d> kept;
  bool above = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    const double a = heights[i], b = heights[next];
    if (a >= 0) kept.push_back(corners[i]);
    if (a > 0) above = true;
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(corners[i] + a / (a - b) * (corners[next] - corners[i]));
  }
  if (!above || kept.size() < 3) kept.clear();
  return kept;
}

double exchange_area(std::span<const Vec3d> first, std::span<const Vec3d> second, double tolerance) {
  const std::vector<Vec3d> one = clipped(first, second[0], area_vector_of(second));
  if (one.empty()) return 0;
  const std::vector<Vec3d> other = clipped(second, first[0], area_vector_of(first));
  if (other.empty()) return 0;
  const std::vector<Side> outer = sides_of(one), inner = sides_of(other);
  const double area = length(area_vector_of(first));
  // Of each of the pairs; that of the rule of five points is far smaller than its difference to that of three.
  const double each = tolerance * area * 2 * std::numbers::pi / static_cast<double>(outer.size() * inner.size());
  constexpr int most_halvings = 60;
  double sum = 0;
  for (const Side& a : outer)
    for (const Side& b : inner) {
      const double cosine = dot(a.along, b.along);
      if (std::abs(cosine) <= 1e-15) continue;
      sum += cosine * log_between(b, a, 0, a.length, each, most_halvings);
    }
  return std::max(sum / (2 * std::numbers::pi), 0.0);
}

double point_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> corners) {
  const std::vector<Vec3d> seen = clipped(corners, point, normal);
  double sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Vec3d a = seen[i] - point, b = seen[(i + 1) % seen.size()] - point, across = cross(a, b);
    const double sine = length(across);
    if (sine > 0) sum += portable::atan2(sine, dot(a, b)) * dot(across, normal) / sine;
  }
  return std::abs(sum) / (2 * std::numbers::pi);
}

Strings strings_between(const Edge& first, const Edge& second) {
  const std::optional<Edge> one = clipped(first, second), other = clipped(second, first);
  if (!one || !other) return {first, second, 0, 0};
  // Both run counter-clockwise about what lies between them: the ends that face each other are a and b.
  return {*one, *other, length(other->a - one->a) + length(other->b - one->b),
          length(other->b - one->a) + length(other->a - one->b)};
}

}  // namespace raywalk
