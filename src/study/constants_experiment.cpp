// E7b: terms that are constant over all tests of a ray, or over all rays of an image: computed once, or each time.
#include "accel/slabs.h"
#include "study/curve.h"
#include "study/shot.h"

#include <array>
#include <bit>

namespace raywalk::study {

namespace {

// Each test is a call that is not inlined, or the compiler would itself compute such terms once. It returns t, or -1
// for a miss.

double t_of(const std::optional<Intersection<double>>& crossing) { return crossing ? crossing->t : -1; }

[[gnu::noinline]] double test(const Triangle<double>& triangle, const ShearedRay<double>& ray) {
  return t_of(intersect(triangle, ray, infinity<double>));
}
[[gnu::noinline]] double test(const Triangle<double>& triangle, const Ray<double>& ray) {
  return t_of(intersect(triangle, ShearedRay<double>(ray), infinity<double>));
}

double t_of(const RayInterval<double>& inside) { return inside.empty() ? -1 : inside.in; }

[[gnu::noinline]] double test(const Bounds<double>& box, const SlabRay<double>& ray) {
  return t_of(clip(ray, box, RayInterval<double>{0, infinity<double>}));
}
[[gnu::noinline]] double test(const Bounds<double>& box, const Ray<double>& ray) {
  return t_of(clip(SlabRay<double>(ray), box, RayInterval<double>{0, infinity<double>}));
}

/// A sphere with the terms shared by all rays that start at `eye`.
struct SeenSphere {
  SeenSphere(const Sphere<double>& sphere, const Vec3d& eye)
      : from_centre(eye - sphere.centre), constant(dot(from_centre, from_centre) - sphere.radius * sphere.radius) {}
  [[nodiscard]] double near_root(const Vec3d& direction) const {
    const double a = dot(direction, direction), half_b = dot(from_centre, direction);
    const double discriminant = half_b * half_b - a * constant;
    return discriminant < 0 ? -1 : (-half_b - std::sqrt(discriminant)) / a;
  }
  Vec3d from_centre;
  double constant;
};

[[gnu::noinline]] double test(const SeenSphere& sphere, const Ray<double>& ray) {
  return sphere.near_root(ray.direction);
}
[[gnu::noinline]] double test(const Sphere<double>& sphere, const Ray<double>& ray) {
  return SeenSphere(sphere, ray.origin).near_root(ray.direction);
}

struct Pair {
  const char *once, *each, *says;
};
constexpr std::array<Pair, 3> pairs{
    {{"shear once a ray", "shear each test", "a triangle's shear belongs to the ray"},
     {"1/d once a ray", "1/d each test", "the reciprocals of a box test belong to the ray"},
     {"c once an image", "c each ray", "a sphere's |o - c|^2 - r^2 belongs to the eye"}}};

/// Targets for rays from one eye: equally many triangles, boxes and spheres.
struct Things {
  std::vector<Triangle<double>> triangles;
  std::vector<Bounds<double>> boxes;
  std::vector<Sphere<double>> spheres;
};

Things things(int round, int count) {
  Things all;
  int dimension = 0;
  const auto number = [&] { return 2 * drawn_for(round, dimension++) - 1; };
  const auto point = [&] {
    const double x = number(), y = number(), z = number();
    return Vec3d(x, y, z);
  };
  for (int i = 0; i < count; ++i) {
    const Vec3d a = point(), b = point(), c = point();
    all.triangles.push_back({a, b, c});
    all.boxes.emplace_back().include(a);
    all.boxes.back().include(b);
    all.spheres.push_back({c, 0.1 + 0.4 * std::abs(number())});
  }
  return all;
}

std::vector<Ray<double>> rays_from_eye(int round, int count) {
  std::vector<Ray<double>> rays;
  const Vec3d eye(0, 0, 4);
  for (int i = 0; i < count; ++i) {
    const double x = 2 * drawn_for(round, -1 - 2 * i) - 1, y = 2 * drawn_for(round, -2 - 2 * i) - 1;
    rays.push_back({eye, normalize(Vec3d(x, y, 0) - eye)});
  }
  return rays;
}

std::uint64_t digest(std::uint64_t so_far, double answer) {
  return (so_far ^ std::bit_cast<std::uint64_t>(answer)) * 0x9e3779b97f4a7c15u + (so_far >> 29);
}

Report conclude_constants(const std::vector<Trial>& trials) {
  Report report;
  Plot time;
  time.title = "Terms computed once, or each time";
  time.x_label = "tests for a ray";
  time.y_label = "nanoseconds a test, median";
  std::size_t look = 0;
  double different = 0;
  for (const Trial& t : trials) different += t.other;  // of the second method of a pair
  for (const Pair& pair : pairs) {
    const ErrorCurve once(trials, pair.once, error_of, Pool::median), each(trials, pair.each, error_of, Pool::median);
    for (const ErrorCurve* curve : {&once, &each}) {
      PlotSeries series = curve->series(curve == &once ? pair.once : pair.each);
      series.look = look++;
      time.series.push_back(std::move(series));
    }
    const std::size_t last = once.knobs().size() - 1;
    const Estimate saved = bootstrap(once.rounds(), [&](const std::vector<int>& rounds) {
      return std::log(each.at(last, rounds) / once.at(last, rounds));
    });
    report.laws.push_back({pair.once, std::string(pair.says) + ": where a ray is tested most often, once is no slower",
                           LawKind::at_least, 0, saved, 0, "Another program may have taken the processor.",
                           "the time each time over the time once", true});
  }
  report.laws.push_back({"same answers",
                         "once or each time, every test gives the same t, bit for bit",
                         LawKind::exact,
                         0,
                         {different, 0, 0},
                         0,
                         "The terms would not be the same.",
                         "how many sets of tests answered otherwise"});
  report.figures.push_back(
      {time,
       "Some terms of a test do not change from test to test. The three divisions of a box test, and the shear that "
       "turns a ray into the z axis before it meets triangles, depend on the ray alone; of a sphere's quadratic the "
       "constant term depends on where the ray starts, which all rays from the eye share. A term made ready before is "
       "paid for once: with one test for a ray nothing is gained, with hundreds its cost is gone from each of them. "
       "Raywalk makes the first two ready for every ray."});
  return report;
}

}  // namespace

Experiment constants_experiment(Effort effort) {
  const int tests = effort == Effort::full ? 1 << 18 : effort == Effort::quick ? 1 << 15 : 1 << 12;
  Experiment e;
  e.number = "E7b", e.name = "constants", e.title = "Terms computed once";
  e.question = "What does it spare to compute once what stays the same for a ray, or for an image?";
  e.weight = 1;
  e.columns = {"tests_a_ray", "nanoseconds_a_test", "answers_differ"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (int count = 1; count <= 256 && !stop.asked(); count *= 4) {
      const Things all = things(round, count);
      const std::vector<Ray<double>> rays = rays_from_eye(round, tests / count);
      const auto timed = [&](const char* method, auto tests_all) {
        std::uint64_t answers = 0;
        const double start = thread_seconds();
        tests_all(answers);
        const double seconds = thread_seconds() - start;
        const std::uint64_t tested = rays.size() * static_cast<std::uint64_t>(count);
        trials.push_back({round,
                          method,
                          static_cast<double>(count),
                          1e9 * seconds / static_cast<double>(tested),
                          0,
                          {rays.size(), 0, tested, 0, seconds}});
        return answers;
      };
      // Each ray, prepared by `ready`, against all of `tested`.
      const auto each_ray = [&rays](const auto& tested, auto ready) {
        return [&rays, &tested, ready](std::uint64_t& answers) {
          for (const Ray<double>& ray : rays) {
            const auto& as_tested = ready(ray);
            for (const auto& thing : tested) answers = digest(answers, test(thing, as_tested));
          }
        };
      };
      const auto as_it_is = [](const Ray<double>& ray) -> const Ray<double>& { return ray; };
      const auto both = [&](const Pair& pair, auto once, auto each) {
        const std::uint64_t right = timed(pair.once, once);
        trials.back().other = timed(pair.each, each) == right ? 0 : 1;
      };
      both(pairs[0], each_ray(all.triangles, [](const Ray<double>& ray) { return ShearedRay<double>(ray); }),
           each_ray(all.triangles, as_it_is));
      both(pairs[1], each_ray(all.boxes, [](const Ray<double>& ray) { return SlabRay<double>(ray); }),
           each_ray(all.boxes, as_it_is));
      both(
          pairs[2],
          [&](std::uint64_t& answers) {
            std::vector<SeenSphere> ready;
            for (const auto& sphere : all.spheres) ready.emplace_back(sphere, rays.front().origin);
            each_ray(ready, as_it_is)(answers);
          },
          each_ray(all.spheres, as_it_is));
    }
    return trials;
  };
  e.conclude = conclude_constants;
  return e;
}

}  // namespace raywalk::study
