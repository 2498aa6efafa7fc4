#include "trace/plan_marks.h"

#include "math/elementary.h"
#include "math/overloaded.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace raywalk {

namespace {

/// A ray in the plan, in the direction of light.
struct PlanRay {
  Vec2d start, along;
  bool endless = false;  ///< the whole line, forwards and backwards
};

void add_meetings(std::vector<Vec2d>& points, const OutlineCircle& circle, const PlanRay& ray) {
  const Vec2d to = circle.centre - ray.start;
  const double square = dot(ray.along, ray.along), middle = dot(to, ray.along);
  // Of a ray that touches, the point where it does.
  const double root =
      std::sqrt(std::max(middle * middle - square * (dot(to, to) - circle.radius * circle.radius), 0.0));
  for (const double t : {(middle - root) / square, (middle + root) / square})
    if (ray.endless || t > 0) points.push_back(ray.start + t * ray.along);
}

void add_meetings(std::vector<Vec2d>& points, const Vec2d& on, const Vec2d& normal, const PlanRay& ray) {
  const double t = dot(normal, on - ray.start) / dot(normal, ray.along);
  if (std::isfinite(t) && t > 0) points.push_back(ray.start + t * ray.along);
}

Vec2d turned(const Vec2d& v, double sine, double cosine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

}  // namespace

std::optional<std::vector<Vec2d>> checker_lines(const Outline& outline, const OutlineStretch& stretch, double size,
                                                double most, const std::function<Vec2d(const Vec2d&)>& uv) {
  std::vector<Vec2d> points;
  const auto lines_between = [&](double low, double high, const auto& add) {
    constexpr double countable = 0x1p52;  // each whole number has a next one
    const double first = std::min(low, high) / size, last = std::max(low, high) / size;
    if (!(last - first < most && std::abs(first) < countable && std::abs(last) < countable)) return false;
    for (double line = std::ceil(first); line <= last; ++line) add(line * size);
    return true;
  };
  if (const auto* circle = std::get_if<OutlineCircle>(&outline.shape)) {
    const double radius = circle->radius, around = 2 * std::numbers::pi;
    const auto angle_of = [&](const Vec2d& at) {
      return portable::atan2(at.y - circle->centre.y, at.x - circle->centre.x);
    };
    double low = angle_of(stretch.front()), high = low, angle = low;
    for (const Vec2d& at : stretch) {
      angle += std::remainder(angle_of(at) - angle, around);
      low = std::min(low, angle), high = std::max(high, angle);
    }
    const auto add = [&](double at) {
      const auto [sine, cosine] = portable::sin_cos(at);
      points.push_back(circle->centre + radius * Vec2d(cosine, sine));
    };
    // Squares begin anew where one is once around.
    for (const double seam : {-3 * around / 2, -around / 2, around / 2, 3 * around / 2})
      if (low < seam && seam < high) add(seam);
    for (const double turns : {-around, 0.0, around}) {
      const double from = std::max(low, turns - around / 2), to = std::min(high, turns + around / 2);
      if (from < to &&
          !lines_between(radius * (from - turns), radius * (to - turns), [&](double along) { add(along / radius); }))
        return std::nullopt;
    }
    return points;
  }
  const Vec2d from = stretch.front(), to = stretch.back(), low = uv(from), high = uv(to);
  for (const int axis : {0, 1}) {
    if (low[axis] == high[axis]) continue;
    const bool few = lines_between(low[axis], high[axis], [&](double along) {
      points.push_back(from + (along - low[axis]) / (high[axis] - low[axis]) * (to - from));
    });
    if (!few) return std::nullopt;
  }
  return points;
}

std::vector<Vec2d> spot_rims(const Outline& outline, const Vec2d& place, const SpotLight::Prepared<double>& spot) {
  std::vector<Vec2d> points;
  const Vec2d axis = plan(spot.axis);
  const double level = length(axis);  // less than 1 of one that points above the plan, or below
  for (const double cosine : {spot.cos_outer / level, spot.cos_inner / level}) {
    if (!(std::abs(cosine) <= 1)) continue;
    const double sine = std::sqrt(1 - cosine * cosine);
    for (const double side : {sine, -sine}) {
      const PlanRay rim{place, turned(axis, side, cosine)};
      std::visit(Overloaded{
                     [&](const OutlineSide& of) {
                       const Vec2d edge = of.to - of.from;
                       add_meetings(points, of.from, {-edge.y, edge.x}, rim);
                     },
                     [&](const OutlineWall& of) { add_meetings(points, of.point, of.normal, rim); },
                     [&](const OutlineCircle& of) { add_meetings(points, of, rim); },
                 },
                 outline.shape);
    }
  }
  return points;
}

std::vector<Vec2d> seen_at_sine(const Outline& straight, const Vec2d& from, double sine) {
  Vec2d on, normal;
  if (const auto* wall = std::get_if<OutlineWall>(&straight.shape)) {
    on = wall->point, normal = wall->normal;
  } else {
    const auto& side = std::get<OutlineSide>(straight.shape);
    on = side.from, normal = {side.from.y - side.to.y, side.to.x - side.from.x};
  }
  const double cosine = std::sqrt(1 - sine * sine), towards = dot(normal, on - from) > 0 ? 1 : -1;
  std::vector<Vec2d> points;
  for (const double way : {sine, -sine})
    add_meetings(points, on, normal, {from, turned(towards * normal, way, cosine)});
  return points;
}

std::vector<Vec2d> shadows_on_circle(const OutlineCircle& circle, const std::vector<Outline>& outlines,
                                     const PlanLight& light) {
  std::vector<Vec2d> points;
  const Vec2d& place = light.place;
  const auto behind = [&](const Vec2d& at) {
    add_meetings(points, circle, light.is_distant ? PlanRay{at, -place, true} : PlanRay{place, at - place});
  };
  for (const Outline& outline : outlines)
    std::visit(Overloaded{
                   [&](const OutlineSide& side) { behind(side.from), behind(side.to); },
                   [](const OutlineWall&) {},
                   [&](const OutlineCircle& other) {
                     const Vec2d to = other.centre - place;
                     const double away = length(to);
                     if (light.is_distant) {
                       const Vec2d aside = other.radius / length(place) * Vec2d(-place.y, place.x);
                       behind(other.centre + aside), behind(other.centre - aside);
                     } else if (away > other.radius) {
                       // The points where rays from the light touch.
                       const double sine = other.radius / away, cosine = std::sqrt(1 - sine * sine);
                       for (const double side : {sine, -sine}) behind(place + cosine * turned(to, side, cosine));
                     }
                   },
               },
               outline.shape);
  return points;
}

}  // namespace raywalk
