#pragma once

#include "check/truth.h"

#include <algorithm>

namespace raywalk::check {

/// Even-odd rule, projected along the largest component of the normal, with half-open edges as the shape defines them.
/// The normal is the stored corners' area vector as the shape computes it.
template <class N, class T>
[[nodiscard]] Truth<N> truth(const Polygon<T>& polygon, const Ray<T>& ray, int departed = no_part) {
  const Vec3<T> normal = polygon.area_vector();
  const Vec<N> n = exactly<N>(normal), o = exactly<N>(ray.origin), d = exactly<N>(ray.direction);
  const N numerator = dot(n, exactly<N>(polygon.outline.front()) - o), denominator = dot(n, d);
  const Truth<N> met = crossing_of_plane(numerator, denominator, departed);
  if (met.crossings.empty()) return met;
  const int kz = raywalk::detail::plan_axis(normal), kx = (kz + 1) % 3, ky = (kz + 2) % 3;
  const N& t = met.crossings[0].t;
  const N x = o[kx] + t * d[kx], y = o[ky] + t * d[ky];
  bool inside = false;
  const auto count = [&](const std::vector<Vec3<T>>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec<N> p = exactly<N>(loop[i]), q = exactly<N>(loop[i + 1 == loop.size() ? 0 : i + 1]);
      const bool p_above = sign(N(p[ky] - y)) > 0, q_above = sign(N(q[ky] - y)) > 0;
      if (p_above == q_above) continue;
      const int side = sign(N((q[kx] - p[kx]) * (y - p[ky]) - (q[ky] - p[ky]) * (x - p[kx])));
      if (q_above ? side > 0 : side < 0) inside = !inside;
    }
  };
  count(polygon.outline);
  for (const auto& hole : polygon.holes) count(hole);
  if (!inside) return {};
  return met;
}

/// The signs of three volumes. A ray exactly through an edge or a corner may be decided either way.
template <class N, class T>
[[nodiscard]] Truth<N> truth(const Triangle<T>& triangle, const Ray<T>& ray, int departed = no_part) {
  const Vec<N> o = exactly<N>(ray.origin), d = exactly<N>(ray.direction);
  const Vec<N> a = exactly<N>(triangle.a) - o, b = exactly<N>(triangle.b) - o, c = exactly<N>(triangle.c) - o;
  const Vec<N> n = cross(b - a, c - a);
  Truth<N> met = crossing_of_plane(dot(n, a), dot(n, d), departed);
  if (met.crossings.empty()) return met;
  const int ab = sign(dot(d, cross(a, b))), bc = sign(dot(d, cross(b, c))), ca = sign(dot(d, cross(c, a)));
  if (std::min({ab, bc, ca}) < 0 && std::max({ab, bc, ca}) > 0) return {};
  met.optional = ab == 0 || bc == 0 || ca == 0;
  return met;
}

/// The polygon's intervals along the ray in plan (a corner on the line belongs to its left), clipped to the slab.
template <class N, class T>
[[nodiscard]] Truth<N> truth(const Prism<T>& prism, const Ray<T>& ray) {
  const Vec<N> o = exactly<N>(ray.origin), d = exactly<N>(ray.direction);
  const N half = exactly<N>(prism.height) * N(0.5), zero(0.0);
  const int slope = sign(d.z);
  N in(0.0), out(0.0);
  int in_part = prism.bottom(), out_part = prism.top();
  if (slope == 0) {
    if (sign(N(o.z + half)) < 0 || sign(N(half - o.z)) < 0) return {};
  } else {
    in = N((-half - o.z) / d.z), out = N((half - o.z) / d.z);
    if (slope < 0) std::swap(in, out), std::swap(in_part, out_part);
    if (sign(out) <= 0) return {};
  }
  const bool enters_slab = slope != 0 && sign(in) > 0;
  const bool upright = sign(d.x) == 0 && sign(d.y) == 0;
  // A vertical ray is one point in plan: any line through it tells whether that is inside.
  const N start = enters_slab && !upright ? in : zero;
  const N dx = upright ? N(1.0) : d.x, dy = upright ? N(0.0) : d.y;
  struct Side {
    N t;
    int part;
  };
  std::vector<Side> after;
  bool inside = false;
  for (int i = 0; i < prism.sides(); ++i) {
    const N px = exactly<N>(prism.corner(i).x) - o.x, py = exactly<N>(prism.corner(i).y) - o.y;
    const N qx = exactly<N>(prism.corner_after(i).x) - o.x, qy = exactly<N>(prism.corner_after(i).y) - o.y;
    if ((sign(N(dx * py - dy * px)) >= 0) == (sign(N(dx * qy - dy * qx)) >= 0)) continue;
    const N ex = qx - px, ey = qy - py;
    const N t = (px * ey - py * ex) / (dx * ey - dy * ex);
    if (sign(N(t - start)) <= 0)
      inside = !inside;
    else
      after.push_back({t, i});
  }
  std::sort(after.begin(), after.end(), [](const Side& a, const Side& b) { return sign(N(a.t - b.t)) < 0; });

  Truth<N> all;
  if (inside && enters_slab) all.crossings.push_back({in, in_part});
  if (upright) {
    if (inside) all.crossings.push_back({out, out_part});
    return all;
  }
  for (const Side& side : after) {
    const int before_out = slope == 0 ? 1 : sign(N(out - side.t));
    if (before_out < 0 || (before_out == 0 && !inside)) break;
    all.crossings.push_back({side.t, side.part, before_out == 0});
    inside = !inside;
    if (before_out == 0) return all;
  }
  if (inside && slope != 0) all.crossings.push_back({out, out_part});
  return all;
}

}  // namespace raywalk::check
