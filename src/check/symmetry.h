#pragma once
// Two invariances that do not hold to the bit, because they change the order of summation: with the axes exchanged, or
// traced from its other end, a ray hits the same, and t agrees within its error bounds (goal B).

#include "check/judge.h"

#include <type_traits>

namespace raywalk::check {

enum class Symmetry { permuted, reversed };

/// Component i of the result is component of[i].
struct Permutation {
  std::array<int, 3> of;
  template <class T>
  [[nodiscard]] Vec3<T> operator()(const Vec3<T>& v) const {
    return {v[of[0]], v[of[1]], v[of[2]]};
  }
};

template <class T>
Sphere<T> permuted(const Permutation& to, const Sphere<T>& s) {
  return {to(s.centre), s.radius};
}
template <class T>
Plane<T> permuted(const Permutation& to, const Plane<T>& s) {
  return {to(s.point), to(s.normal)};
}
template <class T>
Disk<T> permuted(const Permutation& to, const Disk<T>& s) {
  return {to(s.centre), to(s.normal), s.radius};
}
template <class T>
Box<T> permuted(const Permutation& to, const Box<T>& s) {
  return {to(s.min), to(s.max)};
}
template <class T>
Triangle<T> permuted(const Permutation& to, const Triangle<T>& s) {
  return {to(s.a), to(s.b), to(s.c)};
}
template <class T>
Polygon<T> permuted(const Permutation& to, Polygon<T> s) {
  for (Vec3<T>& corner : s.outline) corner = to(corner);
  for (auto& hole : s.holes)
    for (Vec3<T>& corner : hole) corner = to(corner);
  return s;
}
template <class T>
Prism<T> permuted(const Permutation& /*x_and_y*/, Prism<T> s) {
  for (Vec2<T>& corner : s.corners) std::swap(corner.x, corner.y);
  return s;
}
template <class T, QuadricKind Kind>
Quadric<T, Kind> permuted(const Permutation& to, Quadric<T, Kind> s) {
  s.radii = to(s.radii);
  return s;
}

/// Shapes about the z axis only exchange x and y.
template <class S>
[[nodiscard]] Permutation some_permutation(Random& random) {
  constexpr std::array<Permutation, 5> all{{{{1, 0, 2}}, {{1, 2, 0}}, {{2, 0, 1}}, {{0, 2, 1}}, {{2, 1, 0}}}};
  return ShapeTraits<S>::placed ? all[0] : all[static_cast<std::size_t>(random.whole(0, 4))];
}

/// Whether the axis order or the ray's direction may decide: where a ray hits an edge exactly, which of two faces gets
/// it, or whether it counts. Closed round shapes have no such edges.
template <class S, class T>
[[nodiscard]] bool may_differ(const S& /*shape*/, const Ray<T>& /*ray*/) {
  return false;
}
template <class T>
[[nodiscard]] bool may_differ(const Triangle<T>& triangle, const Ray<T>& ray) {
  return truth<Rational>(triangle, ray).optional;
}
template <class T>
[[nodiscard]] bool may_differ(const Polygon<T>& polygon, const Ray<T>& ray) {
  const Vec<Rational> n = exactly<Rational>(polygon.area_vector()), o = exactly<Rational>(ray.origin),
                      d = exactly<Rational>(ray.direction);
  const Rational slope = dot(n, d);
  if (slope == 0) return false;
  const Rational t = dot(n, exactly<Rational>(polygon.outline.front()) - o) / slope;
  const Vec<Rational> met = o + t * d;
  int kz = 0;  // any axis along which the polygon does not vanish will do
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(polygon.area_vector()[axis]) > std::abs(polygon.area_vector()[kz])) kz = axis;
  const int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
  // Corners slightly off the plane: of equal axes, the first is taken.
  const T most = std::abs(polygon.area_vector()[kz]);
  if (std::abs(polygon.area_vector()[kx]) == most || std::abs(polygon.area_vector()[ky]) == most) return true;
  const auto touched = [&](const std::vector<Vec3<T>>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec<Rational> p = exactly<Rational>(loop[i]), q = exactly<Rational>(loop[i + 1 == loop.size() ? 0 : i + 1]);
      const Rational px = p[kx] - met[kx], py = p[ky] - met[ky], qx = q[kx] - met[kx], qy = q[ky] - met[ky];
      if (px * qy == py * qx && px * qx <= 0 && py * qy <= 0) return true;
    }
    return false;
  };
  return touched(polygon.outline) || std::any_of(polygon.holes.begin(), polygon.holes.end(), touched);
}
template <class T>
[[nodiscard]] bool may_differ(const Prism<T>& prism, const Ray<T>& ray) {
  const Vec<Rational> o = exactly<Rational>(ray.origin), d = exactly<Rational>(ray.direction);
  const Rational half = exactly<Rational>(prism.height) / 2;
  if (d.z == 0 && abs(o.z) == half) return true;
  for (int i = 0; i < prism.sides(); ++i) {
    const Rational px = exactly<Rational>(prism.corner(i).x) - o.x, py = exactly<Rational>(prism.corner(i).y) - o.y;
    const Rational ex = exactly<Rational>(prism.corner_after(i).x) - o.x - px,
                   ey = exactly<Rational>(prism.corner_after(i).y) - o.y - py;
    const Rational rate = d.x * ey - d.y * ex;
    if (d.x == 0 && d.y == 0 ? px * ey == py * ex : d.x * py == d.y * px) return true;
    if (rate != 0 && abs(Rational(o.z + (px * ey - py * ex) / rate * d.z)) == half) return true;
  }
  return false;
}

/// `difference` of two t, each of which may be off by its condition times its ulp, in multiples of that.
struct Comparison {
  double ulps = 0, by_condition = 0;
};

/// How to compare the two answers.
template <class S, class T>
[[nodiscard]] Comparison compare(double difference, const Case<S, T>& one, const Intersection<T>& t_one,
                                 const Case<S, T>& other, const Intersection<T>& t_other) {
  const double ulp_one = ulp_at<T>(static_cast<double>(t_one.t)), ulp_other = ulp_at<T>(static_cast<double>(t_other.t));
  return {difference / std::max(ulp_one, ulp_other),
          difference / (condition(one.shape, one.ray, t_one) * ulp_one +
                        condition(other.shape, other.ray, t_other) * ulp_other)};
}

inline void keep_worst(Tally& tally, const Comparison& found, bool both_exact) {
  const auto keep = [](double& worst, double error) {
    if (!(error <= worst)) worst = error;  // NaN is the worst of all
  };
  if (both_exact) {
    keep(tally.exact_ulps, found.ulps);
  } else {
    keep(tally.fast_ulps, found.ulps);
    keep(tally.fast_ulps_by_condition, found.by_condition);
  }
}

template <class S, class T>
void try_permuted(const Case<S, T>& tried, Random& random, Tally& tally) {
  const Permutation to = some_permutation<S>(random);
  const Case<S, T> image{permuted(to, tried.shape), {to(tried.ray.origin), to(tried.ray.direction)}};
  NoteExactPath exact, exact_image;
  const auto one = intersect(tried.shape, tried.ray, infinity<T>, no_part, exact),
             other = intersect(image.shape, image.ray, infinity<T>, no_part, exact_image);
  ++tally.rays;
  tally.hits += one.has_value();
  tally.exact_path += exact.taken;
  tally.unequal += one.has_value() != other.has_value() && !may_differ(tried.shape, tried.ray);
  if (!one || !other) return;
  const double difference = std::abs(static_cast<double>(one->t) - static_cast<double>(other->t));
  const Comparison found = compare(difference, tried, *one, image, *other);
  if (found.ulps > 1 && may_differ(tried.shape, tried.ray)) return;
  keep_worst(tally, found, exact.taken && exact_image.taken);
}

/// A ray and the origin of its reverse, `length` times its direction ahead.
template <class T>
struct Walk {
  Ray<T> there, back;
  T length;
};

/// The ray with its digits cut so that both ends, and their distance, are exact.
template <class S, class T>
[[nodiscard]] std::optional<Walk<T>> both_ways(const Case<S, T>& tried) {
  const Vec3d o(tried.ray.origin), d(tried.ray.direction);
  const double wanted = 2 * (length(o - ShapeTraits<S>::centre(tried.shape)) + 2 * ShapeTraits<S>::size(tried.shape));
  const double reach = std::exp2(std::ceil(std::log2(wanted / length(d))));
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) most = std::max({most, std::abs(o[axis]), reach * std::abs(d[axis])});
  if (!(most > 0x1p-100 && most < 0x1p100 && reach > 0x1p-100 && reach < 0x1p100)) return std::nullopt;
  const double grain = std::ldexp(1.0, std::ilogb(most) + 4 - std::numeric_limits<T>::digits);
  Walk<T> walk{{}, {}, static_cast<T>(reach)};
  for (int axis = 0; axis < 3; ++axis) {
    const double from = grain * std::round(o[axis] / grain), way = grain * std::round(reach * d[axis] / grain);
    walk.there.origin[axis] = static_cast<T>(from), walk.there.direction[axis] = static_cast<T>(way / reach);
    walk.back.origin[axis] = static_cast<T>(from + way), walk.back.direction[axis] = -walk.there.direction[axis];
  }
  if (walk.there.direction == Vec3<T>(0)) return std::nullopt;
  return walk;
}

/// Whatever is hit between the two ends is hit from both, the closest from one end no farther along than that from the
/// other.
template <class S, class T>
void try_reversed(const Case<S, T>& tried, Tally& tally) {
  const auto walk = both_ways(tried);
  if (!walk) return;
  NoteExactPath exact, exact_back;
  const auto one = intersect(tried.shape, walk->there, infinity<T>, no_part, exact),
             other = intersect(tried.shape, walk->back, infinity<T>, no_part, exact_back);
  // Intersections at an end, or hidden by one, are not compared.
  const T margin = walk->length / 1024;
  const auto between = [&](const auto& hit) { return hit && hit->t > margin && hit->t < walk->length - margin; };
  const auto at_an_end = [&](const auto& hit) { return hit && !between(hit) && hit->t < walk->length + margin; };
  if (at_an_end(one) || at_an_end(other)) return;
  ++tally.rays;
  tally.hits += between(one);
  tally.exact_path += exact.taken;
  const Case<S, T> there{tried.shape, walk->there}, back{tried.shape, walk->back};
  // Flat shapes are hit in one point.
  constexpr bool flat = std::is_same_v<S, Plane<T>> || std::is_same_v<S, Disk<T>> || std::is_same_v<S, Triangle<T>> ||
                        std::is_same_v<S, Polygon<T>>;
  if (between(one) != between(other)) {
    // Along a face, t is too inaccurate to tell on which side of an end it is.
    const auto vague = [&](const auto& hit, const Case<S, T>& of) {
      return hit && 8 * condition(of.shape, of.ray, *hit) * ulp_at<T>(static_cast<double>(hit->t)) > margin;
    };
    const bool told = !(vague(one, there) || vague(other, back)) || !(flat || (one && other));
    tally.unequal += told && !may_differ(tried.shape, walk->there);
  }
  if (!between(one) || !between(other)) return;
  const double beyond = static_cast<double>(two_sum(static_cast<double>(one->t), -static_cast<double>(walk->length)) +
                                            DoubleDouble(other->t));
  const Comparison compared = compare(flat ? std::abs(beyond) : std::max(0.0, beyond), there, *one, back, *other);
  if (compared.by_condition > 1 && may_differ(tried.shape, walk->there)) return;  // one face of an edge, then the other
  keep_worst(tally, compared, exact.taken && exact_back.taken);
}

template <class S, class T>
[[nodiscard]] Tally keep_symmetry(Symmetry symmetry, std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed, 61, number);
    const auto stratum = static_cast<Stratum>(random.whole(0, stratum_count - 1));
    if (stratum == Stratum::subnormal) continue;  // underflow depends on the order
    const auto tried = aim<S, T>(stratum, random);
    if (!tried) continue;
    switch (symmetry) {
      case Symmetry::permuted:
        try_permuted(*tried, random, tally);
        break;
      case Symmetry::reversed:
        try_reversed(*tried, tally);
        break;
    }
  }
  return tally;
}

}  // namespace raywalk::check
