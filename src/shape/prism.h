#pragma once

#include "shape/crossing.h"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace raywalk {

/// A polygon of the plan, convex or concave, raised to a solid: its sides are vertical, its caps lie at z = -height/2
/// and z = +height/2. Parts: side i runs from corner i to the next one; after the sides come the top and the bottom.
template <class T>
struct Prism {
  std::vector<Vec2<T>> corners;  ///< at least 3, either turn, edges that do not cross
  T height{1};                   ///< > 0
  friend bool operator==(const Prism&, const Prism&) = default;

  [[nodiscard]] int sides() const { return static_cast<int>(corners.size()); }
  [[nodiscard]] int top() const { return sides(); }
  [[nodiscard]] int bottom() const { return sides() + 1; }
  [[nodiscard]] const Vec2<T>& corner(int i) const { return corners[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Vec2<T>& corner_after(int i) const { return corner(i + 1 == sides() ? 0 : i + 1); }

  /// Twice the area, positive when the corners turn counter-clockwise.
  [[nodiscard]] T twice_signed_area() const;
};

/// The nearest t in (0, t_max) at which the ray crosses the prism's surface.
///
/// The prism is an extrusion: along the ray it is the polygon's intervals cut with the slab's. A corner's side of the
/// ray is computed once and shared by both of its edges (half-open rule, so an edge's end belongs to one of the two),
/// and a cap is hit where an odd number of side crossings lies before it. Every decision is made in t alone, so no
/// ray slips between two faces. The face that the ray departs from is crossed at exactly t = 0.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Prism<T>& prism, const Ray<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {});

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Prism<T>& prism, const Ray<T>& ray, Crossing<T> crossing);

/// Sides: u runs along the edge from its first corner, v up. Caps: x and y.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Prism<T>& prism, const SurfacePoint<T>& point, int part) {
  if (part >= prism.sides()) return plan(point.position);
  return {length(plan(point.position) - prism.corner(part)), point.position.z};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Prism<T>& prism) {
  Bounds<T> box;
  for (const Vec2<T>& corner : prism.corners) {
    box.include(Vec3<T>(corner, -prism.height / 2));
    box.include(Vec3<T>(corner, prism.height / 2));
  }
  return box;
}

/// Why these corners do not make a polygon, in words; empty when they do: at least three, finite, no two neighbours
/// equal, no edge that crosses or touches another. Takes time quadratic in the number of corners.
[[nodiscard]] std::string why_not_polygon(const std::vector<Vec2d>& corners);

// ---------------------------------------------------------------------------------------------------------------------

template <class T>
T Prism<T>::twice_signed_area() const {
  T area{0};
  for (int i = 1; i + 1 < sides(); ++i) area += cross(corner(i) - corner(0), corner(i + 1) - corner(0));
  return area;
}

template <class T, class Explain>
std::optional<Crossing<T>> intersect(const Prism<T>& prism, const Ray<T>& ray, T t_max, int departed_part,
                                     Explain&& explain) {
  const Vec2<T> o = plan(ray.origin), d = plan(ray.direction);

  // The slab between the caps.
  const T half = prism.height / 2;
  T slab_in = -infinity<T>, slab_out = infinity<T>;
  int in_part = prism.bottom(), out_part = prism.top();
  if (ray.direction.z != 0) {
    slab_in = departed_part == prism.bottom() ? T(0) : (-half - ray.origin.z) / ray.direction.z;
    slab_out = departed_part == prism.top() ? T(0) : (half - ray.origin.z) / ray.direction.z;
    if (ray.direction.z < 0) {
      std::swap(slab_in, slab_out);
      std::swap(in_part, out_part);
    }
  } else if (!(-half <= ray.origin.z && ray.origin.z <= half)) {
    return std::nullopt;
  }

  // The sides: which are crossed, at which t, and whether an odd number of crossings lies before each cap.
  const bool upright = d.x == 0 && d.y == 0;
  const Vec2<T> across = upright ? Vec2<T>(1, 0) : d;  // an upright ray asks only whether it is inside
  std::optional<Crossing<T>> nearest;
  T numerator{0}, denominator{0};
  bool inside_at_in = false, inside_at_out = false;
  T side = cross(across, prism.corner(0) - o);
  for (int i = 0; i < prism.sides(); ++i) {
    const T next_side = cross(across, prism.corner_after(i) - o);
    if ((side >= 0) != (next_side >= 0)) {
      const Vec2<T> edge = prism.corner_after(i) - prism.corner(i);
      const T above = cross(prism.corner(i) - o, edge), below = next_side - side;
      const T t = departed_part == i ? T(0) : above / below;
      if (t < (upright ? T(0) : slab_in)) inside_at_in = !inside_at_in;
      if (t < (upright ? T(0) : slab_out)) inside_at_out = !inside_at_out;
      if (!upright && t > 0 && t < t_max && slab_in <= t && t <= slab_out && (!nearest || t < nearest->t)) {
        nearest = Crossing<T>{t, i};
        numerator = above, denominator = below;
      }
    }
    side = next_side;
  }
  for (const auto& [t, part, inside] :
       {std::tuple{slab_in, in_part, inside_at_in}, std::tuple{slab_out, out_part, inside_at_out}}) {
    if (inside && t > 0 && t < t_max && (!nearest || t < nearest->t)) {
      nearest = Crossing<T>{t, part};
      denominator = ray.direction.z;
      numerator = t * denominator;
    }
  }
  if constexpr (std::decay_t<Explain>::wanted)
    explain.plane(static_cast<double>(numerator), static_cast<double>(denominator));
  return nearest;
}

template <class T>
SurfacePoint<T> surface_at(const Prism<T>& prism, const Ray<T>& ray, Crossing<T> crossing) {
  Vec3<T> position = ray.at(crossing.t);
  if (crossing.part >= prism.sides()) {
    const T up = crossing.part == prism.top() ? T(1) : T(-1);
    position.z = up * (prism.height / 2);
    return {position, {0, 0, up}};
  }
  const Vec2<T> first = prism.corner(crossing.part);
  const Vec2<T> edge = prism.corner_after(crossing.part) - first;
  const Vec2<T> along = edge / length(edge);
  const T turn = prism.twice_signed_area() < 0 ? T(-1) : T(1);
  const Vec2<T> outwards = turn * Vec2<T>(along.y, -along.x);
  const Vec2<T> onto = plan(position) - dot(plan(position) - first, outwards) * outwards;
  return {{onto, position.z}, {outwards, 0}};
}

}  // namespace raywalk
