#pragma once
// The truth about a ray and a shape, over any arithmetic with `sign`: balls, which may be undecided, or rationals.
//
// Each `truth` follows from the shape's definition alone and shares no code with the shape's own `intersect`. All
// inputs are the stored numbers, taken as exact.

#include "shape/shape.h"

#include <array>
#include <cstddef>
#include <vector>

namespace raywalk::check {

/// A vector over the oracle's numbers.
template <class N>
struct Vec {
  N x, y, z;
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(const N& k, const Vec& v) { return {k * v.x, k * v.y, k * v.z}; }
  [[nodiscard]] const N& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

template <class N>
[[nodiscard]] N dot(const Vec<N>& a, const Vec<N>& b) {
  return N(a.x * b.x + a.y * b.y + a.z * b.z);
}
template <class N>
[[nodiscard]] Vec<N> cross(const Vec<N>& a, const Vec<N>& b) {
  return {N(a.y * b.z - a.z * b.y), N(a.z * b.x - a.x * b.z), N(a.x * b.y - a.y * b.x)};
}
template <class N, class T>
[[nodiscard]] N exactly(T value) {
  return N(static_cast<double>(value));
}
template <class N, class T>
[[nodiscard]] Vec<N> exactly(const Vec3<T>& v) {
  return {exactly<N>(v.x), exactly<N>(v.y), exactly<N>(v.z)};
}

template <class N>
struct TrueCrossing {
  N t;  ///< > 0
  int part;
  bool tie = false;  ///< other parts are hit at the same t, perhaps but for rounding
};

/// The intersections at t > 0, ascending: the tests use the first two.
template <class N>
struct Truth {
  std::vector<TrueCrossing<N>> crossings;
  bool optional = false;  ///< the ray runs exactly along an edge: hit and miss are both right
};

/// a t^2 + 2 b t + c, and its roots compared with any number, by signs alone.
template <class N>
class Quadratic {
 public:
  Quadratic(N a, N b, N c) : a_(a), b_(b), c_(c), flipped_(sign(a) < 0) {
    if (flipped_) a_ = -a_, b_ = -b_, c_ = -c_;
    degree_ = sign(a_) != 0 ? 2 : sign(b_) != 0 ? 1 : 0;
    discriminant_ = b_ * b_ - a_ * c_;
    if (degree_ == 2) {
      const int roots = sign(discriminant_);
      count_ = roots < 0 ? 0 : roots + 1;
    } else {
      count_ = degree_;
    }
  }

  [[nodiscard]] int count() const { return count_; }  ///< of distinct roots
  /// How many roots lie below s, and how many at s.
  struct RootCounts {
    int below, at;
  };
  [[nodiscard]] RootCounts place(const N& s) const {
    if (count_ == 0) return {0, 0};
    const N at = value(s);
    const int here = sign(at);
    if (degree_ == 1) {
      if (here == 0) return {0, 1};
      return {here == sign(b_) ? 1 : 0, 0};
    }
    if (here < 0) return {1, 0};
    const int beside_vertex = sign(N(a_ * s + b_));
    if (here == 0) return {count_ == 2 && beside_vertex > 0 ? 1 : 0, 1};
    return {beside_vertex > 0 ? count_ : 0, 0};
  }
  /// Sign of the quadratic as given, at s.
  [[nodiscard]] int sign_at(const N& s) const { return flipped_ ? -sign(value(s)) : sign(value(s)); }

  /// Root number i, ascending, without cancellation.
  [[nodiscard]] N root_at(int i) const {
    if (degree_ == 1) return N(-c_ / (b_ + b_));
    const N r = root(discriminant_);
    const int b_sign = sign(b_);
    if (count_ == 1) return N(-b_ / a_);
    // Only terms of equal sign are added, so that nothing cancels.
    if (b_sign > 0) return i == 0 ? N(-(b_ + r) / a_) : N(-c_ / (b_ + r));
    return i == 0 ? N(c_ / (r - b_)) : N((r - b_) / a_);
  }

 private:
  [[nodiscard]] N value(const N& s) const { return N((a_ * s + b_ + b_) * s + c_); }

  N a_, b_, c_, discriminant_;
  bool flipped_;
  int degree_ = 0, count_ = 0;
};

/// A sphere's intersections: all roots at t > 0. If departed, the origin is on the surface by definition, and c is 0.
template <class N, class T>
[[nodiscard]] Truth<N> truth(const Sphere<T>& sphere, const Ray<T>& ray, int departed = no_part) {
  const Vec<N> d = exactly<N>(ray.direction), o = exactly<N>(ray.origin) - exactly<N>(sphere.centre);
  const N r = exactly<N>(sphere.radius);
  const N c = departed == no_part ? N(dot(o, o) - r * r) : N(0.0);
  Truth<N> all;
  // Outside and pointing away: no discriminant needed.
  if (sign(c) > 0 && sign(dot(d, o)) > 0) return all;
  const Quadratic<N> quadratic(dot(d, d), dot(d, o), c);
  const auto zero = quadratic.place(N(0.0));
  for (int i = zero.below + zero.at; i < quadratic.count(); ++i) all.crossings.push_back({quadratic.root_at(i), 0});
  return all;
}

/// An intersection at t = numerator / denominator if that is positive; none for parallel rays.
template <class N>
[[nodiscard]] Truth<N> crossing_of_plane(const N& numerator, const N& denominator, int departed) {
  if (departed != no_part || sign(denominator) == 0 || sign(numerator) != sign(denominator)) return {};
  return {{{N(numerator / denominator), 0}}};
}

template <class N, class T>
[[nodiscard]] Truth<N> truth(const Plane<T>& plane, const Ray<T>& ray, int departed = no_part) {
  const Vec<N> n = exactly<N>(plane.normal);
  return crossing_of_plane(dot(n, exactly<N>(plane.point) - exactly<N>(ray.origin)), dot(n, exactly<N>(ray.direction)),
                           departed);
}

template <class N, class T>
[[nodiscard]] Truth<N> truth(const Disk<T>& disk, const Ray<T>& ray, int departed = no_part) {
  const Vec<N> n = exactly<N>(disk.normal), d = exactly<N>(ray.direction);
  const Vec<N> to_centre = exactly<N>(disk.centre) - exactly<N>(ray.origin);
  const N numerator = dot(n, to_centre), denominator = dot(n, d), radius = exactly<N>(disk.radius);
  Truth<N> met = crossing_of_plane(numerator, denominator, departed);
  if (met.crossings.empty()) return met;
  const Vec<N> offset = numerator * d - denominator * to_centre;
  if (sign(N(dot(offset, offset) - radius * radius * denominator * denominator)) > 0) return {};
  return met;
}

/// The interval of the line inside the closed box.
template <class N, class T>
[[nodiscard]] Truth<N> truth(const Box<T>& box, const Ray<T>& ray, int departed = no_part) {
  struct End {
    N t;
    int part;
    bool tie;
  };
  std::vector<End> in, out;
  // Which of two faces comes first is not asked for where their quotients are the same but for rounding.
  const auto same = [](const N& s, const N& t) {
    const N off = s - t, room = s * N(0x1p-50);
    return sign(N(off * off - room * room)) <= 0;
  };
  const auto take = [&](std::vector<End>& best, const N& t, int part, int sense) {
    const bool tie = !best.empty() && same(best[0].t, t);
    if (best.empty() || sense * sign(N(t - best[0].t)) > 0)
      best = {{t, part, tie}};
    else
      best[0].tie = best[0].tie || tie;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const N o = exactly<N>(ray.origin[axis]), d = exactly<N>(ray.direction[axis]);
    const N low = exactly<N>(box.min[axis]), high = exactly<N>(box.max[axis]);
    const int sense = sign(d);
    if (sense == 0) {
      if (sign(N(o - low)) < 0 || sign(N(high - o)) < 0) return {};
      continue;
    }
    const N t_low = departed == 2 * axis ? N(0.0) : N((low - o) / d);
    const N t_high = departed == 2 * axis + 1 ? N(0.0) : N((high - o) / d);
    take(in, sense > 0 ? t_low : t_high, 2 * axis + (sense > 0 ? 0 : 1), 1);
    take(out, sense > 0 ? t_high : t_low, 2 * axis + (sense > 0 ? 1 : 0), -1);
  }
  Truth<N> all;
  if (in.empty() || sign(N(out[0].t - in[0].t)) < 0) return all;
  for (const auto* end : {&in[0], &out[0]})
    if (sign(end->t) > 0) all.crossings.push_back({end->t, end->part, end->tie});
  return all;
}

}  // namespace raywalk::check
