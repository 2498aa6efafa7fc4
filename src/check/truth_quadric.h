#pragma once

#include "check/truth.h"

namespace raywalk::check {

/// xx x^2 + yy y^2 + zz z^2 + linear z + constant, negative inside: the definition times the squared radii, so that
/// there is no division.
template <class N>
struct QuadricForm {
  N xx, yy, zz, linear, constant;
};

template <class N, class T, QuadricKind Kind>
[[nodiscard]] QuadricForm<N> form_of(const Quadric<T, Kind>& quadric) {
  const Vec<N> r = exactly<N>(quadric.radii);
  const N x = r.x * r.x, y = r.y * r.y, z = r.z * r.z, none = N(0.0);
  switch (Kind) {
    case QuadricKind::ellipsoid:
      return {N(y * z), N(x * z), N(x * y), none, N(-(x * y * z))};
    case QuadricKind::elliptic_paraboloid:
      return {y, x, none, N(-(x * y)), none};
    case QuadricKind::cone:
      return {y, x, N(-(x * y)), none, none};
    case QuadricKind::cylinder:
      return {y, x, none, none, N(-(x * y))};
    case QuadricKind::hyperboloid_one_sheet:
      return {N(y * z), N(x * z), N(-(x * y)), none, N(-(x * y * z))};
    case QuadricKind::hyperboloid_two_sheets:
      return {N(y * z), N(x * z), N(-(x * y)), none, N(x * y * z)};
  }
  return {};
}

/// The wall strictly between the cuts, and the caps' closed faces.
template <class N, class T, QuadricKind Kind>
[[nodiscard]] Truth<N> truth(const Quadric<T, Kind>& quadric, const Ray<T>& ray, int departed = no_part) {
  using Part = Quadric<T, Kind>;
  const QuadricForm<N> f = form_of<N>(quadric);
  const Vec<N> o = exactly<N>(ray.origin), d = exactly<N>(ray.direction);
  const N a = f.xx * d.x * d.x + f.yy * d.y * d.y + f.zz * d.z * d.z;
  const N twice_b = (f.xx * o.x * d.x + f.yy * o.y * d.y + f.zz * o.z * d.z) * N(2.0) + f.linear * d.z;
  const N c = departed == Part::wall
                  ? N(0.0)
                  : N(f.xx * o.x * o.x + f.yy * o.y * o.y + f.zz * o.z * o.z + f.linear * o.z + f.constant);
  const Quadratic<N> wall(a, N(twice_b * N(0.5)), c);

  struct Cut {
    N t;
    int part;
  };
  std::vector<Cut> in, out;  // one each, or none
  const int slope = sign(d.z);
  const bool cut_low = std::isfinite(quadric.z_min), cut_high = std::isfinite(quadric.z_max);
  if (slope == 0) {
    if (cut_low && sign(N(o.z - exactly<N>(quadric.z_min))) <= 0) return {};
    if (cut_high && sign(N(exactly<N>(quadric.z_max) - o.z)) <= 0) return {};
  } else {
    const auto meet = [&](T z, int part) {
      return Cut{departed == part ? N(0.0) : N((exactly<N>(z) - o.z) / d.z), part};
    };
    if (cut_low) (slope > 0 ? in : out).push_back(meet(quadric.z_min, Part::low_cap));
    if (cut_high) (slope > 0 ? out : in).push_back(meet(quadric.z_max, Part::high_cap));
  }

  Truth<N> all;
  const auto cap = [&](const std::vector<Cut>& cut) {
    if (!cut.empty() && quadric.capped && sign(cut[0].t) > 0 && wall.sign_at(cut[0].t) <= 0)
      all.crossings.push_back({cut[0].t, cut[0].part});
  };
  cap(in);
  if (wall.count() > 0) {
    const auto zero = wall.place(N(0.0));
    int first = zero.below + zero.at, last = wall.count();
    if (!in.empty()) {
      const auto place = wall.place(in[0].t);
      first = std::max(first, place.below + place.at);
    }
    if (!out.empty()) last = wall.place(out[0].t).below;
    for (int i = first; i < last; ++i) all.crossings.push_back({wall.root_at(i), Part::wall});
  }
  cap(out);
  return all;
}

}  // namespace raywalk::check
