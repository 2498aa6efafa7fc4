#include "trace/ray_cone.h"

#include "math/elementary.h"
#include "math/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

RayCone cone_about(const Vec3d& origin, const Vec3d& axis, double radius, double spread, bool flat) {
  if (flat) return {origin, axis, {-axis.y, axis.x, 0}, {0, 0, 1}, radius, spread, true};
  const Basis<double> about(axis);
  return {origin, axis, about.s, about.t, radius, spread, false};
}

RayCone part_of_cone(const RayCone& cone, const Vec2d& u, double size) {
  const Vec3d direction = cone.direction(u);
  // Ray u runs aslant: it gets to a depth later than the axis by 1 / cosine, and neighbours along the radius are nearer
  // to it by cosine than they are in a plane across the axis. Those beside it are not; a round cone has the area of
  // both.
  const double cosine = 1 / length(direction), narrower = cone.flat ? cosine : std::sqrt(cosine);
  return cone_about(cone.start(u), cosine * direction, cone.radius * size * narrower,
                    cone.spread * size * cosine * narrower, cone.flat);
}

ConeWidth turned_out(ConeWidth width) {
  if (width.radius < 0) width = {-width.radius, -width.spread};
  return {width.radius, std::clamp(width.spread, -largest_spread, largest_spread)};
}

ConeWidth mirrored(ConeWidth width, ConePlane plane, double curvature, double cos_in) {
  const double turn = plane == ConePlane::of_incidence ? 1 / cos_in : cos_in;
  return {width.radius, width.spread + 2 * curvature * turn * width.radius};
}

ConeWidth refracted(ConeWidth width, ConePlane plane, double curvature, double n1, double n2, double cos_in,
                    double cos_out) {
  const double eta = n1 / n2;
  if (plane == ConePlane::across)
    return {width.radius, eta * width.spread + (eta * cos_in - cos_out) * curvature * width.radius};
  // By as much as the normal turns from one side of the cone to the other.
  const double turn = curvature * width.radius / cos_in;
  return {width.radius * cos_out / cos_in, eta * cos_in / cos_out * (width.spread + turn) - turn};
}

namespace {

ConeWidth mean(const ConeWidth& a, const ConeWidth& b) {
  return {(a.radius + b.radius) / 2, (a.spread + b.spread) / 2};
}

/// `turns`: of a direction, over that of the facet's normal, in the plane of incidence and across it. Slopes as GGX has
/// them: in the plane of a flat world half of them are beyond slope / sqrt(3) on one side or the other.
ConeWidth scattered(ConeWidth width, double slope, const Vec2d& turns, bool flat) {
  if (!(slope > 0)) return width;
  const double more =
      slope * (flat ? 2 / std::numbers::sqrt3 * turns.x : std::numbers::sqrt2 * (turns.x + turns.y) / 2);
  // What is scattered twice is so by chance: squares add up. A cone that narrows first meets in a point.
  const double spread = width.spread > 0 ? std::sqrt(width.spread * width.spread + more * more) : width.spread + more;
  return {width.radius, std::min(spread, largest_spread)};
}

/// 1 - cos of half its arc: the area that a chord cuts off the unit disc.
double segment(double versine) {
  versine = std::clamp(versine, 0.0, 2.0);
  const double arc = 2 * portable::atan2(std::sqrt(versine * (2 - versine)), 1 - versine), square = arc * arc;
  // (arc - sin arc) / 2, by its series where the difference would lose digits.
  if (arc < 0.5)
    return arc * square / 12 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72 * (1 - square / 110))));
  return (arc - portable::sin(arc)) / 2;
}

}  // namespace

ConeWidth mirrored_cone(ConeWidth width, double curvature, double cos_in, bool flat) {
  cos_in = std::max(cos_in, 1e-6);
  const ConeWidth in_plane = mirrored(width, ConePlane::of_incidence, curvature, cos_in);
  return turned_out(flat ? in_plane : mean(in_plane, mirrored(width, ConePlane::across, curvature, cos_in)));
}

ConeWidth refracted_cone(ConeWidth width, double curvature, double n1, double n2, double cos_in, double cos_out,
                         bool flat) {
  cos_in = std::max(cos_in, 1e-6), cos_out = std::max(cos_out, 1e-6);
  const ConeWidth in_plane = refracted(width, ConePlane::of_incidence, curvature, n1, n2, cos_in, cos_out);
  return turned_out(flat ? in_plane
                         : mean(in_plane, refracted(width, ConePlane::across, curvature, n1, n2, cos_in, cos_out)));
}

ConeWidth widened_by_mirrors(ConeWidth width, double slope, double cos_in, bool flat) {
  return scattered(width, slope, {2, 2 * cos_in}, flat);
}

ConeWidth widened_by_facets(ConeWidth width, double slope, double n1, double n2, double cos_in, double cos_out,
                            bool flat) {
  cos_out = std::max(cos_out, 1e-6);
  const double in = n1 / n2 * cos_in;
  return scattered(width, slope, {std::abs(1 - in / cos_out), std::abs(in - cos_out)}, flat);
}

ConeWidth widened(ConeWidth width, double one_minus_cos) {
  if (!(one_minus_cos > 0)) return width;
  const double cosine = std::max(1 - one_minus_cos, 0.0), sine = std::sqrt((1 - cosine) * (1 + cosine));
  const double more = sine < largest_spread * cosine ? sine / cosine : largest_spread;
  return {width.radius, std::min(width.spread + more, largest_spread)};
}

double share_of_disc(double distance, double radius) {
  if (!(radius > 0) || distance >= 1 + radius) return 0;
  if (distance <= std::abs(radius - 1)) return std::min(1.0, radius * radius);
  // The chord through both crossings cuts a segment off each disc.
  const double beyond = radius - (distance - 1), within = radius + (distance - 1);
  const double own = beyond * within / (2 * distance);
  const double other = beyond * (1 + distance - radius) / (2 * distance * radius);
  return std::min((segment(own) + radius * radius * segment(other)) / std::numbers::pi, 1.0);
}

double share_beyond(double distance) {
  if (distance >= 1) return 0;
  if (distance <= -1) return 1;
  return segment(1 - distance) / std::numbers::pi;
}

double twice_area_of_side(const Vec2d& from, const Vec2d& to) {
  const Vec2d along = to - from;
  const double square = dot(along, along);
  if (!(square > 0)) return 0;
  const auto sector = [](const Vec2d& a, const Vec2d& b) { return portable::atan2(cross(a, b), dot(a, b)); };
  // Where the side's line is in the disc: from + t along, t between these two.
  const double middle = -dot(from, along) / square, off = cross(from, along);
  const double inside = square - off * off;
  if (!(inside > 0)) return sector(from, to);
  const double half = std::sqrt(inside) / square;
  const double begin = std::max(middle - half, 0.0), end = std::min(middle + half, 1.0);
  if (!(begin < end)) return sector(from, to);
  const Vec2d enters = from + begin * along, leaves = from + end * along;
  double sum = cross(enters, leaves);
  if (begin > 0) sum += sector(from, enters);
  if (end < 1) sum += sector(leaves, to);
  return sum;
}

}  // namespace raywalk
