// E2: the origin of a spawned ray: offset by an epsilon, by ulps, by an error bound, or not at all.
#include "shape/naive.h"
#include "study/curve.h"
#include "study/shot.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace raywalk::study {

namespace {

using Vec3f = Vec3<float>;

/// A ball, a point on it as a float tracer finds it, an outward direction, and a sheet close by.
struct SpawnCase {
  Sphere<float> ball;
  Vec3f point, normal, way;
  Plane<float> sheet;
};

/// Balls of 1/100 to 100 units, about as far from the origin; sheets at 1e-5 to 1e-1 radii, farther than a float's
/// spacing there.
SpawnCase spawn_case(int round, int which) {
  int dimension = 0;
  const auto draw = [&] { return drawn_for(round, 16 * which + dimension++); };
  const double radius = std::pow(10.0, 4 * draw() - 2);
  const Vec3d centre = radius * Vec3d(2 * draw() - 1, 2 * draw() - 1, 2 * draw() - 1);
  SpawnCase l;
  l.ball = {Vec3f(centre), static_cast<float>(radius)};
  // From outside, at the middle of the visible side.
  const Vec3d out = sample_uniform_sphere(Vec2d(draw(), draw()));
  const Ray<float> ray{Vec3f(centre + 3 * radius * out), Vec3f(-out)};
  const auto crossing = intersect(l.ball, ray, infinity<float>);
  l.point = ray.at(crossing->t);
  l.normal = normalize(l.point - l.ball.centre);
  l.way = Vec3f(Basis<double>(Vec3d(l.normal)).to_world(sample_uniform_cone(Vec2d(draw(), draw()), 0.9)));
  const double gap = radius * std::pow(10.0, 4 * draw() - 5);
  l.sheet = {Vec3f(Vec3d(l.point) + gap * Vec3d(l.normal)), l.normal};
  return l;
}

/// The naive tracer's tests: anything at t > 0 counts.
template <class S>
bool meets(const S& shape, const SpawnCase& l, const Vec3f& origin) {
  return intersect(shape, NaiveRay<float>{{origin, l.way}}, infinity<float>).has_value();
}

/// 256 float steps along the normal; near 0, where they are tiny, a fixed length (C. Waechter and N. Binder, Ray
/// Tracing Gems, ch. 6, 2019).
Vec3f by_ulps(const SpawnCase& l) {
  Vec3f moved = l.point;
  for (int axis = 0; axis < 3; ++axis) {
    const float p = l.point[axis], n = l.normal[axis];
    const auto steps = static_cast<std::int32_t>(256 * n);
    constexpr float near_zero = 1.0F / 32, fixed = 1.0F / 65536;
    moved[axis] = std::abs(p) < near_zero
                      ? p + fixed * n
                      : std::bit_cast<float>(std::bit_cast<std::int32_t>(p) + (p < 0 ? -steps : steps));
  }
  return moved;
}

/// Along the normal by the bound of the point's error (M. Pharr, W. Jakob and G. Humphreys, Physically Based Rendering,
/// 3rd ed. 2016, 3.9), then to the next float outwards.
Vec3f by_bound(const SpawnCase& l) {
  // o + t d, from three radii away: the product, the sum, and t itself err by a few halves of an ulp.
  constexpr float gamma = 8 * 0x1p-24F;
  const Vec3f from = l.point - l.ball.centre;
  float reach = 0;
  for (int axis = 0; axis < 3; ++axis)
    reach +=
        std::abs(l.normal[axis]) * gamma * (std::abs(l.ball.centre[axis]) + 4 * l.ball.radius + std::abs(from[axis]));
  Vec3f moved = l.point + reach * l.normal;
  for (int axis = 0; axis < 3; ++axis)
    moved[axis] = std::nextafter(moved[axis], l.normal[axis] > 0 ? infinity<float> : -infinity<float>);
  return moved;
}

struct Wrong {
  int self_hits = 0, sheets_missed = 0;
};

template <class Start>
Wrong tried(const std::vector<SpawnCase>& all, Start start) {
  Wrong wrong;
  for (const SpawnCase& l : all) {
    const Vec3f origin = start(l);
    wrong.self_hits += meets(l.ball, l, origin) ? 1 : 0;
    wrong.sheets_missed += meets(l.sheet, l, origin) ? 0 : 1;
  }
  return wrong;
}

/// Raywalk's: the ray starts at the point itself and knows its source primitive.
Wrong tried_aware(const std::vector<SpawnCase>& all) {
  Wrong wrong;
  for (const SpawnCase& l : all) {
    const Ray<float> ray{l.point, l.way};
    wrong.self_hits += intersect(l.ball, ray, infinity<float>, 0) ? 1 : 0;
    wrong.sheets_missed += intersect(l.sheet, ray, infinity<float>) ? 0 : 1;
  }
  return wrong;
}

Report conclude_offsets(const std::vector<Trial>& trials) {
  Report report;
  Plot both, apart;
  both.title = "Wrong answers to rays that leave a surface";
  both.x_label = apart.x_label = "epsilon, in the scene's units";
  both.y_label = apart.y_label = "share of rays";
  both.log_y = apart.log_y = false;
  apart.title = "The two sides of the U";
  for (const char* method : {"absolute", "ulps", "error bound", "surface-aware"})
    both.series.push_back(ErrorCurve(trials, method, error_of, Pool::mean).series(method));
  const ErrorCurve absolute(trials, "absolute", error_of, Pool::mean);
  apart.series = {ErrorCurve(trials, "absolute", other_of, Pool::mean).series("hits itself"),
                  ErrorCurve(
                      trials, "absolute", [](const Trial& t) { return t.error - t.other; }, Pool::mean)
                      .series("jumps over the sheet")};
  const auto arm = [&](std::size_t end) {
    return bootstrap(absolute.rounds(), [&](const std::vector<int>& rounds) {
      double best = 2;
      for (std::size_t i = 0; i < absolute.knobs().size(); ++i) best = std::min(best, absolute.at(i, rounds));
      return std::log(absolute.at(end, rounds) / best);
    });
  };
  const std::string wrong_answers = "how many times as many wrong answers as with the best epsilon";
  report.laws.push_back({"epsilon too small",
                         "at 1e-12 there are more than twice the wrong answers of the best epsilon: "
                         "rays hit where they start",
                         LawKind::at_least, std::log(2.0), arm(0), 0,
                         "The scene would be too small, or the numbers too many.", wrong_answers, true});
  report.laws.push_back({"epsilon too large", "at 0.1 too: rays start behind what they should hit", LawKind::at_least,
                         std::log(2.0), arm(absolute.knobs().size() - 1), 0, "The sheet would lie too far away.",
                         wrong_answers, true});
  double most = 0;
  for (const Trial& t : trials)
    if (t.method == "surface-aware") most = std::max(most, t.error);
  report.laws.push_back({"surface-aware",
                         "no ray hits where it starts, and none misses the sheet",
                         LawKind::exact,
                         0,
                         {most, 0, 0},
                         0,
                         "An offset would be too small, or too large.",
                         "the largest share of any round"});
  report.figures.push_back(
      {both,
       "A shadow ray leaves a ball; both are computed in float, and naively, as --numerics naive does. It must not "
       "meet the ball again, and it must meet a sheet that "
       "runs close by. Balls are of 1/100 to 100 units: an epsilon that is right for one of them is wrong for another, "
       "and the best of all still errs. Steps of the floats follow the size of the numbers, but for the fixed length "
       "that "
       "they fall back to near 0, which is too long for the smallest balls. An error bound follows it everywhere. "
       "Raywalk's rays start at the point itself and carry the surface along, whose root t = 0 is known: no epsilon, "
       "and no wrong answer."});
  report.figures.push_back({apart,
                            "The U of the absolute epsilon, taken apart: on the left surfaces that shadow "
                            "themselves, as speckles that every beginner knows; on the right light that leaks "
                            "through whatever is thinner or nearer than epsilon."});
  return report;
}

}  // namespace

Experiment offsets_experiment(Effort effort) {
  const int rays = by_effort(effort, 20000, 4000, 300);
  Experiment e;
  e.number = "E2", e.name = "offsets", e.title = "Where a ray leaves";
  e.question = "A reflected or shadow ray starts on a surface. How far from it should it start?";
  e.weight = 2;
  e.columns = {"epsilon", "share_wrong", "share_self_hits"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<SpawnCase> all;
    for (int i = 0; i < rays; ++i) all.push_back(spawn_case(round, i));
    std::vector<Trial> trials;
    for (int power = -12; power <= -1 && !stop.asked(); ++power) {
      const double epsilon = std::pow(10.0, power);
      const auto judge = [&](const char* method, auto run) {
        const double start = thread_seconds();
        const Wrong wrong = run();
        const Cost cost{2 * static_cast<std::uint64_t>(rays), 0, 2 * static_cast<std::uint64_t>(rays), 0,
                        thread_seconds() - start};
        // A ray is wrong at most once: after a self-intersection it does not reach the sheet.
        trials.push_back({round, method, epsilon, static_cast<double>(wrong.self_hits + wrong.sheets_missed) / rays,
                          static_cast<double>(wrong.self_hits) / rays, cost});
      };
      const auto absolute = [epsilon](const SpawnCase& l) { return l.point + static_cast<float>(epsilon) * l.normal; };
      judge("absolute", [&] { return tried(all, absolute); });
      // These have no epsilon; they are run beside each for timing.
      judge("ulps", [&] { return tried(all, by_ulps); });
      judge("error bound", [&] { return tried(all, by_bound); });
      judge("surface-aware", [&] { return tried_aware(all); });
    }
    return trials;
  };
  e.conclude = conclude_offsets;
  return e;
}

}  // namespace raywalk::study
