#pragma once

#include "accel/primitives.h"
#include "check/judge.h"
#include "check/normal.h"

namespace raywalk::check {

/// A scale, a shear or a translation; chains of them occur for instances in groups.
[[nodiscard]] inline Affine<double> transform_step(Random& random) {
  switch (random.whole(0, 3)) {
    case 0:
      return scaling(Vec3d(random.sign() * random.real(0.1, 10), random.real(0.1, 10), random.real(0.1, 10)));
    case 1: {
      Affine<double> shear;
      shear.y.x = random.real(-2, 2), shear.z.x = random.real(-2, 2), shear.z.y = random.real(-2, 2);
      return shear;
    }
    case 2:
      return rotation(random.unit(), random.real(-180, 180));
    default:
      return translation(random.magnitude(0, 4) * random.unit());
  }
}

/// The truth for a ray as stored in object space, with its origin on the part that it left.
template <class S, class T>
[[nodiscard]] HitVerdict judge_departure(const S& shape, const Ray<T>& own, int part,
                                         const std::optional<Intersection<T>>& met, Tally& tally) {
  try {
    return judge(truth<Ball>(shape, own, part), met).verdict;
  } catch (const Undecided&) {
    ++tally.rationals;
    return judge(truth<Rational>(shape, own, part), met).verdict;
  }
}
/// For a prism it is open on which of two neighbouring faces a ray at their edge starts. It must not hit the face that
/// it left, and if it goes inwards it must get out.
template <class T>
[[nodiscard]] HitVerdict judge_departure(const Prism<T>& prism, const Ray<T>& own, int part,
                                         const std::optional<Intersection<T>>& met, Tally& /*row*/) {
  if (met) return met->part == part ? HitVerdict::false_hit : HitVerdict::right;
  const Vec<Rational> outwards = true_normal<Rational>(prism, own.origin, part).direction;
  return sign(dot(outwards, exactly<Rational>(own.direction))) < 0 ? HitVerdict::missed : HitVerdict::right;
}

/// A ray is shot at a shape under a chain of transforms; from its hit, one is spawned in a random direction.
template <class S, class T>
[[nodiscard]] Tally spawn(std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  using B = ShapeTraits<S>;
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed, 40, number);
    Affine<double> chain;
    for (int depth = random.whole(0, 3); depth > 0; --depth) chain = transform_step(random) * chain;
    const auto transform = object_transform<T>(chain);
    const S shape = B::make(random, 1, Vec3d(0.0));
    if (!transform) continue;
    const Vec3d eye = B::centre(shape) + random.magnitude(0.2, 2) * B::size(shape) * random.unit();
    const auto in_shape =
        ray_towards<T>(eye, random.whole(0, 3) == 0 ? B::special(shape, random) : B::surface(shape, random), random);
    if (!in_shape) continue;
    const Ray<T> ray{transform->to_world.point(in_shape->origin), transform->to_world.direction(in_shape->direction)};
    Primitives<T> primitives;
    primitives.add(shape, *transform);
    const auto hit = primitives.intersect(0, ray, infinity<T>);
    if (!hit) continue;
    const SurfacePoint<T> point = primitives.surface_at(0, ray, *hit);
    const Ray<T> born{point.position, Vec3<T>(random.unit()), {0, hit->part}};
    if (!is_finite(born.origin)) continue;

    NoteExactPath note;
    const auto met = primitives.intersect(0, born, infinity<T>, note);
    ++tally.rays;
    tally.hits += met.has_value();
    tally.exact_path += note.taken;
    const HitVerdict verdict = judge_departure(shape, into_object_space(*transform, born), hit->part, met, tally);
    tally.self_hits += verdict == HitVerdict::false_hit;
    tally.missed += verdict == HitVerdict::missed;

    // A sheet 16 ulps away along the normal, on the side that the ray goes to.
    const double ulp =
        ulp_at<T>(std::max({std::abs(point.position.x), std::abs(point.position.y), std::abs(point.position.z)}));
    const double side = raywalk::dot(point.normal, born.direction) > 0 ? 1 : -1;
    const Plane<T> sheet{Vec3<T>(Vec3d(point.position) + side * 16 * ulp * Vec3d(point.normal)), point.normal};
    primitives.add(sheet);
    const bool sheet_met = primitives.intersect(1, born, infinity<T>).has_value();
    tally.sheet_missed += !sheet_met && !truth<Rational>(sheet, born).crossings.empty();
    tally.unequal += sheet_met && truth<Rational>(sheet, born).crossings.empty();
  }
  return tally;
}

}  // namespace raywalk::check
