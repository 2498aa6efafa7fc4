#pragma once
// One ray: what the tracer answers against what is true.

#include "check/aim.h"
#include "check/ball.h"
#include "check/rational.h"
#include "check/row.h"
#include "check/truth_polygon.h"
#include "check/truth_quadric.h"

#include <limits>

namespace raywalk::check {

/// Asks a shape to say when its exact arithmetic had to be called. The answer is the same bits as without.
struct NoteExactPath {
  static constexpr bool wanted = true;
  bool taken = false;
  void quadratic(double, double, double, double, double, double) {}
  void plane(double, double) {}
  void exact() { taken = true; }
};

template <class T>
[[nodiscard]] double ulp_at(double value) {
  constexpr int digits = std::numeric_limits<T>::digits;
  const double least = static_cast<double>(std::numeric_limits<T>::denorm_min());
  const double size = std::abs(value);
  return size > 0 ? std::max(least, std::ldexp(1.0, std::ilogb(size) - digits + 1)) : least;
}

enum class Verdict { right, missed, false_hit };

struct Judgement {
  Verdict verdict = Verdict::right;
  double ulps = 0;  ///< of t, where both hit
};

/// `got` against the truth of `shape` and `ray` over the numbers N. What under- or overflows as a T is no crossing.
template <class N, class T>
[[nodiscard]] Judgement judge(const Truth<N>& truth, const std::optional<Crossing<T>>& got) {
  const double least = static_cast<double>(std::numeric_limits<T>::denorm_min());
  const double most = static_cast<double>(std::numeric_limits<T>::max());
  std::size_t i = 0;
  bool optional = truth.optional;
  for (; i < truth.crossings.size(); ++i) {
    const double t = approximate(truth.crossings[i].t);
    if (t > 2 * least) break;
    if (t > least / 4) optional = true;  // whether this rounds to 0 is a matter of the last digit
  }
  const bool none = i == truth.crossings.size();
  const bool too_far = !none && approximate(truth.crossings[i].t) >= most;
  if (!got) return {none || too_far || optional ? Verdict::right : Verdict::missed};
  if (none) return {optional ? Verdict::right : Verdict::false_hit};
  if (too_far) return {};
  const double t = static_cast<double>(got->t);
  const double ulp = ulp_at<T>(approximate(truth.crossings[i].t));
  const double ulps = error_in_ulps(t, ulp, truth.crossings[i].t);
  // Far from the first crossing and close to the second: the first was passed over, or made up.
  constexpr double far = 1e6;
  if (ulps > far && i + 1 < truth.crossings.size()) {
    const double second = error_in_ulps(t, ulp, truth.crossings[i + 1].t);
    if (second < ulps / 4) return {optional ? Verdict::right : Verdict::missed};
  }
  return {Verdict::right, ulps};
}

/// By how much more the normal of a shape turns than its corners do when they move.
template <class S>
[[nodiscard]] double slenderness(const S& /*shape*/) {
  return 1;
}
template <class T>
[[nodiscard]] double slenderness(const Triangle<T>& triangle) {
  const Vec3d a(triangle.a), b = Vec3d(triangle.b) - a, c = Vec3d(triangle.c) - a;
  return std::max(1.0, length(b) * length(c) / length(raywalk::cross(b, c)));
}

/// How many ulps of t one ulp of each input can make, to first order: the sum of all |input * dt/dinput| over |t|.
template <class S, class T>
[[nodiscard]] double condition(const S& shape, const Ray<T>& ray, Crossing<T> crossing) {
  const Vec3d o(ray.origin), d(ray.direction);
  const double t = static_cast<double>(crossing.t);
  const SurfacePoint<T> met = surface_at(shape, ray, crossing);
  const Vec3d n(met.normal), p = o + t * d;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double shape_size = std::abs(p[axis]) + Bench<S>::size(shape);
    sum += std::abs(n[axis]) * (std::abs(o[axis]) + std::abs(t * d[axis]) + shape_size);
  }
  return std::max(1.0, sum * slenderness(shape) / std::abs(t * raywalk::dot(n, d)));
}

/// The truth over rationals.
template <class S, class T>
[[nodiscard]] Judgement judge_exactly(const Case<S, T>& tried, const std::optional<Crossing<T>>& got) {
  return judge(truth<Rational>(tried.shape, tried.ray), got);
}

/// Whether the answer is right for one of a few rays that differ from this one by an ulp or two of their origin's and
/// direction's largest components: then it is the rounding of the input that was decided, and no defect. The first of
/// them only lacks the components smaller than such an ulp: no other goes exactly along an axis or through an apex.
template <class S, class T>
[[nodiscard]] bool right_nearby(const Case<S, T>& tried, const std::optional<Crossing<T>>& got, Random& random) {
  const auto ulp_of = [](Vec3<T> v) { return ulp_at<T>(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)})); };
  const auto without_tiny = [&](Vec3<T> v) {
    const double ulp = ulp_of(v);
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(v[axis]) < ulp) v[axis] = 0;
    return v;
  };
  const auto moved = [&](Vec3<T> v) {
    const double ulp = ulp_of(v);
    for (int axis = 0; axis < 3; ++axis) v[axis] += static_cast<T>(random.whole(-2, 2) * ulp);
    return v;
  };
  const auto right = [&](Vec3<T> origin, Vec3<T> direction) {
    return judge_exactly(Case<S, T>{tried.shape, {origin, direction}}, got).verdict == Verdict::right;
  };
  const Vec3<T> origin = tried.ray.origin, direction = tried.ray.direction;
  if (right(without_tiny(origin), without_tiny(direction))) return true;
  for (int i = 0; i < 1000; ++i)
    if (right(moved(origin), moved(direction))) return true;
  return false;
}

/// Tries one case, and by rationals alone where `audit` says so.
template <class S, class T>
void try_case(const Case<S, T>& tried, bool audit, Random& random, Row& row) {
  NoteExactPath note;
  const auto got = intersect(tried.shape, tried.ray, infinity<T>, no_part, note);
  ++row.rays;
  row.hits += got.has_value();
  row.exact_path += note.taken;
  if (audit) {
    const auto plain = intersect(tried.shape, tried.ray, infinity<T>);
    row.unequal += plain.has_value() != got.has_value() || (got && (plain->t != got->t || plain->part != got->part));
  }
  Judgement judgement;
  bool settled = false;
  if (!audit) {
    try {
      judgement = judge(truth<Ball>(tried.shape, tried.ray), got);
      settled = true;
    } catch (const Undecided&) {
    }
  }
  if (!settled) {
    ++row.rationals;
    judgement = judge_exactly(tried, got);
  }
  if (judgement.verdict != Verdict::right) {
    ++(judgement.verdict == Verdict::missed ? row.missed : row.false_hits);
    row.excused += right_nearby(tried, got, random);
  }
  if (note.taken) {
    row.exact_ulps = std::max(row.exact_ulps, judgement.ulps);
  } else if (judgement.ulps > row.fast_ulps || judgement.ulps > row.fast_ulps_by_condition) {
    row.fast_ulps = std::max(row.fast_ulps, judgement.ulps);
    row.fast_ulps_by_condition =
        std::max(row.fast_ulps_by_condition, judgement.ulps / condition(tried.shape, tried.ray, *got));
  }
}

/// `count` cases from number `first` of one stratum, one in `audit` of them by rationals alone.
template <class S, class T>
[[nodiscard]] Row try_stratum(Stratum stratum, std::uint64_t seed, std::uint64_t what, std::uint64_t first,
                              std::uint64_t count, std::uint64_t audit) {
  Row row;
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed, what, number);
    if (const auto tried = aim<S, T>(stratum, random)) try_case(*tried, number % audit == 0, random, row);
  }
  return row;
}

}  // namespace raywalk::check
