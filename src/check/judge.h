#pragma once
// One ray: the tracer's answer against the truth.

#include "check/aim.h"
#include "check/ball.h"
#include "check/rational.h"
#include "check/tally.h"
#include "check/truth_polygon.h"
#include "check/truth_quadric.h"

#include <limits>

namespace raywalk::check {

/// Lets a shape report that it used exact arithmetic. Does not change the answer.
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

enum class HitVerdict { right, missed, false_hit };

struct Judgement {
  HitVerdict verdict = HitVerdict::right;
  double ulps = 0;  ///< of t, where both hit
};

/// `got` against the truth of `shape` and `ray` over the numbers N: a hit of another part than the truth's is false,
/// unless that is met at the same t but for rounding. What under- or overflows as a T is no intersection.
template <class N, class T>
[[nodiscard]] Judgement judge(const Truth<N>& truth, const std::optional<Intersection<T>>& got) {
  const double least = static_cast<double>(std::numeric_limits<T>::denorm_min());
  const double most = static_cast<double>(std::numeric_limits<T>::max());
  std::size_t i = 0;
  bool optional = truth.optional;
  for (; i < truth.crossings.size(); ++i) {
    const double t = approximate(truth.crossings[i].t);
    if (t > 2 * least) break;
    if (t > least / 4) optional = true;  // whether this rounds to 0 depends on the last digit
  }
  const bool none = i == truth.crossings.size();
  const bool too_far = !none && approximate(truth.crossings[i].t) >= most;
  if (!got) return {none || too_far || optional ? HitVerdict::right : HitVerdict::missed};
  if (std::isnan(got->t)) return {HitVerdict::false_hit};
  if (none) return {optional ? HitVerdict::right : HitVerdict::false_hit};
  if (too_far) return {};
  const double t = static_cast<double>(got->t);
  const double ulp = ulp_at<T>(approximate(truth.crossings[i].t));
  const double ulps = error_in_ulps(t, ulp, truth.crossings[i].t);
  // Far from the first intersection and close to the second: the first was missed, or invented.
  constexpr double far = 1e6;
  if (ulps > far && i + 1 < truth.crossings.size()) {
    const double second = error_in_ulps(t, ulp, truth.crossings[i + 1].t);
    if (second < ulps / 4) return {optional ? HitVerdict::right : HitVerdict::missed};
  }
  bool part_met = optional || truth.crossings[i].tie || truth.crossings[i].part == got->part;
  for (std::size_t next = i + 1; !part_met && next < truth.crossings.size(); ++next)
    part_met = truth.crossings[next].part == got->part && error_in_ulps(t, ulp, truth.crossings[next].t) <= 2;
  return {part_met ? HitVerdict::right : HitVerdict::false_hit, ulps};
}

/// The factor by which a shape's normal turns more than its corners when they move.
template <class S>
[[nodiscard]] double slenderness(const S& /*shape*/) {
  return 1;
}
template <class T>
[[nodiscard]] double slenderness(const Triangle<T>& triangle) {
  const Vec3d a(triangle.a), b = Vec3d(triangle.b) - a, c = Vec3d(triangle.c) - a;
  return std::max(1.0, length(b) * length(c) / length(raywalk::cross(b, c)));
}

/// How many ulps of t one ulp of each input causes, to first order: the sum of all |input * dt/dinput| over |t|.
template <class S, class T>
[[nodiscard]] double condition(const S& shape, const Ray<T>& ray, const Intersection<T>& intersection) {
  const Vec3d o(ray.origin), d(ray.direction);
  const double t = static_cast<double>(intersection.t);
  const SurfacePoint<T> met = surface_at(shape, ray, intersection);
  const Vec3d n(met.normal), p = o + t * d;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double shape_size = std::abs(p[axis]) + ShapeTraits<S>::size(shape);
    sum += std::abs(n[axis]) * (std::abs(o[axis]) + std::abs(t * d[axis]) + shape_size);
  }
  return std::max(1.0, sum * slenderness(shape) / std::abs(t * raywalk::dot(n, d)));
}

/// The truth over rationals.
template <class S, class T>
[[nodiscard]] Judgement judge_exactly(const Case<S, T>& tried, const std::optional<Intersection<T>>& got) {
  return judge(truth<Rational>(tried.shape, tried.ray), got);
}

/// Whether the answer is right for one of a few rays that differ from this one by an ulp or two of their origin's and
/// direction's largest components: then the input's rounding decided, and it is no defect. The first of them only drops
/// the components smaller than such an ulp: no other runs exactly along an axis or through an apex.
template <class S, class T>
[[nodiscard]] bool right_nearby(const Case<S, T>& tried, const std::optional<Intersection<T>>& got, Random& random) {
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
    return judge_exactly(Case<S, T>{tried.shape, {origin, direction}}, got).verdict == HitVerdict::right;
  };
  const Vec3<T> origin = tried.ray.origin, direction = tried.ray.direction;
  if (right(without_tiny(origin), without_tiny(direction))) return true;
  for (int i = 0; i < 1000; ++i)
    if (right(moved(origin), moved(direction))) return true;
  return false;
}

/// Tests one case, by rationals alone if `audit` is set.
template <class S, class T>
void try_case(const Case<S, T>& tried, bool audit, Random& random, Tally& tally) {
  NoteExactPath note;
  const auto got = intersect(tried.shape, tried.ray, infinity<T>, no_part, note);
  ++tally.rays;
  tally.hits += got.has_value();
  tally.exact_path += note.taken;
  if (audit) {
    const auto plain = intersect(tried.shape, tried.ray, infinity<T>);
    tally.unequal += plain.has_value() != got.has_value() || (got && (plain->t != got->t || plain->part != got->part));
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
    ++tally.rationals;
    judgement = judge_exactly(tried, got);
  }
  if (judgement.verdict != HitVerdict::right) {
    ++(judgement.verdict == HitVerdict::missed ? tally.missed : tally.false_hits);
    tally.excused += right_nearby(tried, got, random);
  }
  if (note.taken) {
    tally.exact_ulps = std::max(tally.exact_ulps, judgement.ulps);
  } else if (judgement.ulps > tally.fast_ulps || judgement.ulps > tally.fast_ulps_by_condition) {
    tally.fast_ulps = std::max(tally.fast_ulps, judgement.ulps);
    tally.fast_ulps_by_condition =
        std::max(tally.fast_ulps_by_condition, judgement.ulps / condition(tried.shape, tried.ray, *got));
  }
}

/// `count` cases of one stratum from number `first`, one in `audit` of them by rationals alone.
template <class S, class T>
[[nodiscard]] Tally try_stratum(Stratum stratum, std::uint64_t seed, std::uint64_t what, std::uint64_t first,
                                std::uint64_t count, std::uint64_t audit) {
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed, what, number);
    if (const auto tried = aim<S, T>(stratum, random)) try_case(*tried, number % audit == 0, random, tally);
  }
  return tally;
}

}  // namespace raywalk::check
