#pragma once

#include "math/elementary.h"
#include "shape/intersection.h"
#include "shape/quadratic.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace raywalk {

enum class QuadricKind {
  ellipsoid,               ///< x^2/rx^2 + y^2/ry^2 + z^2/rz^2 = 1
  elliptic_paraboloid,     ///< x^2/rx^2 + y^2/ry^2 = z
  cone,                    ///< x^2/rx^2 + y^2/ry^2 = z^2; both sheets unless clipped
  cylinder,                ///< x^2/rx^2 + y^2/ry^2 = 1
  hyperboloid_one_sheet,   ///< x^2/rx^2 + y^2/ry^2 - z^2/rz^2 = 1
  hyperboloid_two_sheets,  ///< x^2/rx^2 + y^2/ry^2 - z^2/rz^2 = -1
};

/// A quadric about the z axis, clipped to z_min <= z <= z_max and optionally closed by flat caps. Parts: 0 the wall, 1
/// the cap at z_min, 2 the cap at z_max. An open wall ends before its limits (they belong to the caps); with caps the
/// rim is hit once. Inside is where the left side is smaller than the right one.
template <class T, QuadricKind Kind>
struct Quadric {
  static constexpr QuadricKind kind = Kind;
  Vec3<T> radii{1};                             ///< rx, ry, rz, each > 0; rz only if the equation has it
  T z_min = -infinity<T>, z_max = infinity<T>;  ///< z_min < z_max; infinite: not clipped there
  bool capped = false;                          ///< caps where the limit is finite and cuts the inside
  friend bool operator==(const Quadric&, const Quadric&) = default;

  static constexpr int wall = 0, low_cap = 1, high_cap = 2;
};

template <class T>
using Ellipsoid = Quadric<T, QuadricKind::ellipsoid>;
template <class T>
using EllipticParaboloid = Quadric<T, QuadricKind::elliptic_paraboloid>;
template <class T>
using Cone = Quadric<T, QuadricKind::cone>;
template <class T>
using Cylinder = Quadric<T, QuadricKind::cylinder>;
template <class T>
using HyperboloidOneSheet = Quadric<T, QuadricKind::hyperboloid_one_sheet>;
template <class T>
using HyperboloidTwoSheets = Quadric<T, QuadricKind::hyperboloid_two_sheets>;

/// Nearest t in (0, t_max) at which the ray crosses the wall or a cap; a tangent ray counts.
///
/// Along the ray the left side minus the right one is a t^2 + 2 b t + c: negative inside. Its roots are found in
/// double, without cancellation, from the discriminant's perpendicular form (the sphere's, for any quadric). Caps and
/// wall are distinguished by t alone, as in the prism, so no ray slips through a rim. Where error bounds leave anything
/// in doubt (the sign of the discriminant, or of a when the ray is parallel to a cone's side; an origin almost on the
/// wall; a crossing near a rim) exact arithmetic decides everything. A ray that departs from the wall has c = 0
/// exactly.
template <class T, QuadricKind Kind, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Quadric<T, Kind>& quadric, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {});

template <class T, QuadricKind Kind>
[[nodiscard]] SurfacePoint<T> surface_at(const Quadric<T, Kind>& quadric, const Ray<T>& ray,
                                         const Intersection<T>& intersection);

/// The wall: the angle from +x times rx, and z. Caps: x and y; the lower one -x, for it is seen from below.
template <class T, QuadricKind Kind>
[[nodiscard]] Vec2<T> uv_at(const Quadric<T, Kind>& quadric, const SurfacePoint<T>& point, int part) {
  if (part != Quadric<T, Kind>::wall) return on_cap(part == Quadric<T, Kind>::high_cap, point.position);
  const T angle = portable::atan2(point.position.y / quadric.radii.y, point.position.x / quadric.radii.x);
  return {quadric.radii.x * angle, point.position.z};
}

template <class T, QuadricKind Kind>
[[nodiscard]] Vec3<T> normal_derivative(const Quadric<T, Kind>& quadric, const SurfacePoint<T>& point, int part,
                                        const Vec3<T>& along);

template <class T, QuadricKind Kind>
[[nodiscard]] Vec2<T> uv_derivative(const Quadric<T, Kind>& quadric, const SurfacePoint<T>& point, int part,
                                    const Vec3<T>& along) {
  if (part != Quadric<T, Kind>::wall) return on_cap(part == Quadric<T, Kind>::high_cap, along);
  const T x = point.position.x / quadric.radii.x, y = point.position.y / quadric.radii.y;
  const T turned = (x * along.y / quadric.radii.y - y * along.x / quadric.radii.x) / (x * x + y * y);
  return {quadric.radii.x * turned, along.z};
}

/// The section of the wall at a height: the square of its radius in units of rx and ry; negative where there is none.
template <class T, QuadricKind Kind>
[[nodiscard]] double squared_section(const Quadric<T, Kind>& quadric, double z) {
  const double own = z / static_cast<double>(quadric.radii.z);
  switch (Kind) {
    case QuadricKind::ellipsoid:
      return 1 - own * own;
    case QuadricKind::elliptic_paraboloid:
      return z;
    case QuadricKind::cone:
      return z * z;
    case QuadricKind::cylinder:
      return 1;
    case QuadricKind::hyperboloid_one_sheet:
      return 1 + own * own;
    case QuadricKind::hyperboloid_two_sheets:
      return own * own - 1;
  }
  return -1;
}

/// Infinite for an unbounded quadric.
template <class T, QuadricKind Kind>
[[nodiscard]] Bounds<T> bounds(const Quadric<T, Kind>& quadric);

// ---------------------------------------------------------------------------------------------------------------------

namespace detail {

template <class T, QuadricKind Kind>
[[nodiscard]] QuadricEquation equation_of(const Quadric<T, Kind>& quadric) {
  const Vec3d r(quadric.radii);
  const double xx = 1 / (r.x * r.x), yy = 1 / (r.y * r.y), zz = 1 / (r.z * r.z);
  switch (Kind) {
    case QuadricKind::ellipsoid:
      return {xx, yy, zz, 0, -1};
    case QuadricKind::elliptic_paraboloid:
      return {xx, yy, 0, -1, 0};
    case QuadricKind::cone:
      return {xx, yy, -1, 0, 0};
    case QuadricKind::cylinder:
      return {xx, yy, 0, 0, -1};
    case QuadricKind::hyperboloid_one_sheet:
      return {xx, yy, -zz, 0, -1};
    case QuadricKind::hyperboloid_two_sheets:
      return {xx, yy, -zz, 0, 1};
  }
  return {};
}

template <class T, QuadricKind Kind>
[[nodiscard]] ExactEquation exact_equation_of(const Quadric<T, Kind>& quadric) {
  const Vec3d r(quadric.radii);
  const Expansion x = Expansion(r.x) * r.x, y = Expansion(r.y) * r.y, z = Expansion(r.z) * r.z, none;
  switch (Kind) {
    case QuadricKind::ellipsoid:
      return {y * z, x * z, x * y, none, -(x * y * z)};
    case QuadricKind::elliptic_paraboloid:
      return {y, x, none, -(x * y), none};
    case QuadricKind::cone:
      return {y, x, -(x * y), none, none};
    case QuadricKind::cylinder:
      return {y, x, none, none, -(x * y)};
    case QuadricKind::hyperboloid_one_sheet:
      return {y * z, x * z, -(x * y), none, -(x * y * z)};
    case QuadricKind::hyperboloid_two_sheets:
      return {y * z, x * z, -(x * y), none, x * y * z};
  }
  return {};
}

/// `intersect` entirely by exact signs.
template <class T, QuadricKind Kind>
[[nodiscard, gnu::noinline, gnu::cold]] std::optional<Intersection<T>> intersect_exactly(
    const Quadric<T, Kind>& quadric, const Ray<T>& ray, T t_max, int departed_part) {
  using Part = Quadric<T, Kind>;
  const Vec3d o = wide(ray.origin), d = wide(ray.direction);
  const ExactQuadratic wall = exact_quadratic(exact_equation_of(quadric), o, d, departed_part == Part::wall);
  const auto lies = [&](double t) { return static_cast<T>(t) > 0 && static_cast<T>(t) < t_max; };
  const double slope = std::abs(d.z);
  struct Cut {
    int part;
    bool met;
    Expansion distance;
  };
  const auto cut = [&](T z, int part) {
    const bool met = slope > 0 && std::isfinite(z);
    if (!met || departed_part == part) return Cut{part, met, {}};
    const Expansion distance = Expansion(static_cast<double>(z)) - o.z;
    return Cut{part, met, d.z < 0 ? -distance : distance};
  };
  Cut in = cut(quadric.z_min, Part::low_cap), out = cut(quadric.z_max, Part::high_cap);
  if (d.z < 0) std::swap(in, out);
  const auto t_of = [&](const Cut& c) { return static_cast<double>(c.distance.rounded() / DoubleDouble(slope)); };
  const auto closed = [&](const Cut& c) {
    const int sign = wall.value_sign(c.distance, slope);
    return quadric.capped && c.met && (wall.flipped ? -sign : sign) <= 0 && lies(t_of(c));
  };
  if (closed(in)) return Intersection<T>{static_cast<T>(t_of(in)), in.part};
  int first = 0, last = wall.count();
  if (in.met && last > 0) {
    const auto place = wall.place(in.distance, slope);
    first = place.below + place.at;
  }
  if (out.met && last > 0) last = wall.place(out.distance, slope).below;
  for (int i = first; i < last; ++i)
    if (const double t = wall.root(i); lies(t)) return Intersection<T>{static_cast<T>(t), Part::wall};
  if (closed(out)) return Intersection<T>{static_cast<T>(t_of(out)), out.part};
  return std::nullopt;
}

/// A cap that is met is a plane: its numbers take the place of the wall's. `o`, `d`: the ray's along the axis.
template <class T, QuadricKind Kind, class Explain>
void explain_cap(const Quadric<T, Kind>& quadric, double o, double d, const std::optional<Intersection<T>>& met,
                 Explain& explain) {
  using Part = Quadric<T, Kind>;
  if constexpr (std::decay_t<Explain>::wanted)
    if (met && met->part != Part::wall)
      explain.plane(static_cast<double>(met->part == Part::low_cap ? quadric.z_min : quadric.z_max) - o, d);
}

}  // namespace detail

template <class T, QuadricKind Kind, class Explain>
std::optional<Intersection<T>> intersect(const Quadric<T, Kind>& quadric, const Ray<T>& ray, T t_max, int departed_part,
                                         Explain&& explain) {
  using Part = Quadric<T, Kind>;
  const Vec3d o = wide(ray.origin), d = wide(ray.direction);
  const detail::QuadricRoots wall =
      detail::quadric_roots(detail::equation_of(quadric), o, d, departed_part == Part::wall);
  if constexpr (std::decay_t<Explain>::wanted)
    explain.quadratic(wall.a, 2 * wall.b, wall.c, 4 * wall.discriminant, wall.roots.near, wall.roots.far);

  // The slab between the limits, as an interval of t.
  double slab_in = -infinity<double>, slab_out = infinity<double>;
  int in_part = Part::low_cap, out_part = Part::high_cap;
  const double z_min = static_cast<double>(quadric.z_min), z_max = static_cast<double>(quadric.z_max);
  if (d.z != 0) {
    slab_in = departed_part == Part::low_cap ? 0 : (z_min - o.z) / d.z;
    slab_out = departed_part == Part::high_cap ? 0 : (z_max - o.z) / d.z;
    if (d.z < 0) std::swap(slab_in, slab_out), std::swap(in_part, out_part);
  } else if (!(z_min < o.z && o.z < z_max)) {
    return std::nullopt;
  }

  const bool sure = wall.sure && wall.sure_about(slab_in) && wall.sure_about(slab_out);
  if (!sure) {
    note_exact(explain);
    const auto met = detail::intersect_exactly(quadric, ray, t_max, departed_part);
    detail::explain_cap(quadric, o.z, d.z, met, explain);
    return met;
  }
  std::optional<Intersection<T>> nearest;
  const auto consider = [&](double t_wide, int part) {
    const T t = static_cast<T>(t_wide);
    if (t > 0 && t < t_max && (!nearest || t < nearest->t)) nearest = Intersection<T>{t, part};
  };
  // On the wall a point must lie strictly between the limits: their own t belongs to the caps.
  for (const double t : {wall.roots.near, wall.roots.far})
    if (slab_in < t && t < slab_out)
      consider(departed_part == Part::wall ? t : wall.refined(detail::equation_of(quadric), o, d, t), Part::wall);
  if (quadric.capped) {
    if (wall.roots.inside(slab_in)) consider(slab_in, in_part);
    if (wall.roots.inside(slab_out)) consider(slab_out, out_part);
  }
  detail::explain_cap(quadric, o.z, d.z, nearest, explain);
  return nearest;
}

template <class T, QuadricKind Kind>
SurfacePoint<T> surface_at(const Quadric<T, Kind>& quadric, const Ray<T>& ray, const Intersection<T>& intersection) {
  Vec3<T> position = ray.at(intersection.t);
  if (intersection.part == Quadric<T, Kind>::low_cap) return {{position.x, position.y, quadric.z_min}, {0, 0, -1}};
  if (intersection.part == Quadric<T, Kind>::high_cap) return {{position.x, position.y, quadric.z_max}, {0, 0, 1}};
  const detail::QuadricEquation e = detail::equation_of(quadric);
  const auto gradient_at = [&e](const Vec3d& p) {
    return Vec3d(2 * e.xx * p.x, 2 * e.yy * p.y, 2 * e.zz * p.z + e.linear);
  };
  // One Newton step onto the wall along the gradient: a ray may hit it far away, at a grazing angle.
  const Vec3d p(position), slope = gradient_at(p);
  const double off = e.xx * p.x * p.x + e.yy * p.y * p.y + (e.zz * p.z + e.linear) * p.z + e.constant;
  if (const double square = dot(slope, slope); square > 0) position = Vec3<T>(p - off / square * slope);
  // The gradient again: next to a narrow apex it turns by more than a rounding unit in that step.
  const Vec3d gradient = gradient_at(Vec3d(position));
  const double size = length(gradient);
  return {position, size > 0 ? Vec3<T>(gradient / size) : Vec3<T>(0, 0, 1)};  // a cone's apex has no normal: any will
                                                                              // do
}

/// The normal is F' / |F'| where F = 0 is the wall: what F'' adds to the gradient, without what only makes it longer.
template <class T, QuadricKind Kind>
Vec3<T> normal_derivative(const Quadric<T, Kind>& quadric, const SurfacePoint<T>& point, int part,
                          const Vec3<T>& along) {
  if (part != Quadric<T, Kind>::wall) return Vec3<T>(0);
  const detail::QuadricEquation e = detail::equation_of(quadric);
  const Vec3d p(point.position), d(along);
  const Vec3d gradient(2 * e.xx * p.x, 2 * e.yy * p.y, 2 * e.zz * p.z + e.linear);
  const Vec3d added(2 * e.xx * d.x, 2 * e.yy * d.y, 2 * e.zz * d.z);
  return Vec3<T>(derivative_of_unit(gradient, added));
}

template <class T, QuadricKind Kind>
Bounds<T> bounds(const Quadric<T, Kind>& quadric) {
  // At height z the cross section has radii rx, ry times sqrt(widest(z)), where that is not negative.
  const detail::QuadricEquation e = detail::equation_of(quadric);
  const double rz = static_cast<double>(quadric.radii.z);
  const auto widest = [&](double z) {
    // Near a pole the difference of the squares has no digits.
    const double square = (z - rz) / rz * ((z + rz) / rz);
    if (Kind == QuadricKind::ellipsoid) return -square;
    if (Kind == QuadricKind::hyperboloid_two_sheets) return square;
    return -((e.zz * z + e.linear) * z + e.constant);
  };
  double low = static_cast<double>(quadric.z_min), high = static_cast<double>(quadric.z_max);
  if (Kind == QuadricKind::ellipsoid) low = std::max(low, -rz), high = std::min(high, rz);
  if (Kind == QuadricKind::elliptic_paraboloid) low = std::max(low, 0.0);
  double square = std::max(Kind == QuadricKind::ellipsoid && low < 0 && high > 0 ? 1.0 : 0.0,
                           std::isfinite(low) && std::isfinite(high) ? std::max(widest(low), widest(high)) : 0.0);
  if (Kind == QuadricKind::cylinder) square = 1;
  if (Kind != QuadricKind::cylinder && !(std::isfinite(low) && std::isfinite(high))) square = infinity<double>;
  if (square < 0 || low > high) return {};
  const double reach = std::sqrt(square);
  const Vec3d corner(static_cast<double>(quadric.radii.x) * reach, static_cast<double>(quadric.radii.y) * reach, 0);
  return {Vec3<T>(Vec3d(-corner.x, -corner.y, low)), Vec3<T>(Vec3d(corner.x, corner.y, high))};
}

template <class T, QuadricKind Kind>
[[nodiscard]] bool has_inside(const Quadric<T, Kind>& quadric) {
  const bool is_whole = std::isinf(quadric.z_min) && std::isinf(quadric.z_max);
  return quadric.capped || (Kind == QuadricKind::ellipsoid && is_whole);
}

template <class Cutter, QuadricKind Kind>
void cut(Cutter& to, const Quadric<double, Kind>& quadric) {
  const double rx = quadric.radii.x, ry = quadric.radii.y;
  double low = quadric.z_min, high = quadric.z_max;
  if (Kind == QuadricKind::ellipsoid) low = std::max(low, -quadric.radii.z), high = std::min(high, quadric.radii.z);
  if (Kind == QuadricKind::elliptic_paraboloid) low = std::max(low, 0.0);
  if (!(std::isfinite(low) && std::isfinite(high) && low < high)) return;
  const auto radius = [&](double z) { return std::sqrt(std::max(squared_section(quadric, z), 0.0)); };
  if (Kind == QuadricKind::ellipsoid) {
    const auto angle = [&](double z) {
      const double s = std::clamp(z / quadric.radii.z, -1.0, 1.0);
      return portable::atan2(s, std::sqrt((1 - s) * (1 + s)));
    };
    const int steps = std::max(to.least_sides() / 2, to.pieces(to.world_length({0, 0, high - low}) * 1.6));
    to.swept(0, Cutter::round_profile(steps, angle(low), angle(high), quadric.radii.z), rx, ry);
  } else {
    const bool straight = Kind == QuadricKind::cylinder || Kind == QuadricKind::cone;
    const int steps = std::max(straight ? 1 : 8, to.pieces(to.world_length({0, 0, high - low})));
    std::vector<double> heights;
    for (int i = 0; i <= steps; ++i) heights.push_back(i == steps ? high : low + (high - low) * i / steps);
    // The apex, and the tips of two sheets.
    for (const double tip : {0.0, -quadric.radii.z, quadric.radii.z}) {
      const bool is_one =
          Kind == QuadricKind::cone ? tip == 0 : Kind == QuadricKind::hyperboloid_two_sheets && tip != 0;
      if (is_one && low < tip && tip < high) heights.push_back(tip);
    }
    std::sort(heights.begin(), heights.end());
    std::vector<Vec2d> profile;
    for (const double z : heights) {
      if (squared_section(quadric, z) >= 0) {
        profile.push_back({radius(z), z});
      } else {  // between two sheets
        to.swept(0, profile, rx, ry);
        profile.clear();
      }
    }
    to.swept(0, profile, rx, ry);
  }
  using Whole = Quadric<double, Kind>;
  if (!quadric.capped) return;
  if (std::isfinite(quadric.z_min) && squared_section(quadric, quadric.z_min) > 0)
    to.lid(Whole::low_cap, quadric.z_min, radius(quadric.z_min), rx, ry, false);
  if (std::isfinite(quadric.z_max) && squared_section(quadric, quadric.z_max) > 0)
    to.lid(Whole::high_cap, quadric.z_max, radius(quadric.z_max), rx, ry, true);
}

}  // namespace raywalk
