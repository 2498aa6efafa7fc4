// E9: a ball of triangles against the ball.
#include "accel/accelerator.h"
#include "study/curve.h"
#include "study/shot.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace raywalk::study {

namespace {

/// n bands of 2n quadrilaterals of two triangles each, every vertex on the unit sphere, rotated per round.
Mesh ball(int n, int round) {
  const auto turned = [round](const Vec3d& p) {
    const double a = 2 * std::numbers::pi * drawn_for(round, 0), b = 2 * std::numbers::pi * drawn_for(round, 1);
    const Vec3d q(std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z);
    return Vec3d(q.x, std::cos(b) * q.y - std::sin(b) * q.z, std::sin(b) * q.y + std::cos(b) * q.z);
  };
  Mesh mesh;
  const int around = 2 * n;
  for (int band = 0; band <= n; ++band)
    for (int step = 0; step < around; ++step) {
      const double theta = std::numbers::pi * band / n, phi = 2 * std::numbers::pi * step / around;
      mesh.positions.push_back(
          turned({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}));
    }
  mesh.normals = mesh.positions;
  for (int band = 0; band < n; ++band)
    for (int step = 0; step < around; ++step) {
      const int a = band * around + step, b = band * around + (step + 1) % around;
      // At the poles one of the two has no area.
      if (band + 1 < n) mesh.triangles.push_back({a, a + around, b + around});
      if (band > 0) mesh.triangles.push_back({a, b + around, b});
    }
  return mesh;
}

struct BallHit {
  double t;
  Vec3d normal, smooth;
};

Report conclude_tessellation(const std::vector<Trial>& trials, double most) {
  Report report;
  Plot error, price;
  error.title = "Error of a ball of triangles";
  error.x_label = "bands from pole to pole, n (about 4 n^2 triangles)";
  error.y_label = "root mean square error, radius 1 or radians";
  price.title = "What exactness costs as triangles";
  price.x_label = "triangles and their structure, bytes";
  price.y_label = "root mean square error of the place";
  const struct {
    const char *method, *name, *law_name, *says;
    double law;
  } kinds[] = {{"place", "place", "n^-2", "the chord's height over its arc falls with the square of its length", -2},
               {"flat", "normal, flat", "n^-1", "a triangle's normal is right in its middle only", -1},
               {"smooth", "normal, interpolated", "n^-2", "interpolation leaves what is of second order", -2}};
  for (const auto& kind : kinds) {
    const ErrorCurve curve(trials, kind.method);
    PlotSeries series = curve.series(kind.name);
    series.law = kind.law, series.law_name = kind.law_name;
    error.series.push_back(series);
    report.laws.push_back({kind.name, fmt::format("error falls as {}: {}", kind.law_name, kind.says), LawKind::exact,
                           kind.law, curve.exponent(16, most), 0.05,
                           "Few bands are not yet in the limit; exact means within 0.05 of the exponent here."});
  }
  price.series.push_back(ErrorCurve(trials, "place").series("triangles", other_of));
  report.figures.push_back(
      {error,
       "Twice the bands, four times the triangles: the surface then lies four times nearer to the ball. The normals of "
       "flat triangles, which shading shows, become only twice as good; interpolated between the corners they are as "
       "good as the places are. That is why a coarse ball looks round inside and shows its corners on the outline."});
  report.figures.push_back(
      {price,
       "The same error against memory: a hundred times the bytes for a hundredth of the error. The ball itself needs "
       "four numbers and errs by rounding alone; a ray takes the time given in the table of raw data for either."});
  return report;
}

}  // namespace

Experiment tessellation_experiment(Effort effort) {
  const int most = by_effort(effort, 256, 128, 32);
  const int rays = by_effort(effort, 20000, 4000, 500);
  Experiment e;
  e.number = "E9", e.name = "tessellation", e.title = "Triangles for a ball";
  e.question = "How many triangles make a ball, and what do they cost?";
  e.weight = 8;
  e.columns = {"bands", "rms_error", "bytes"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Ray<double>> aimed;
    for (int i = 0; i < rays; ++i) {
      // From afar, well inside the silhouette: near it a ray may miss the triangles.
      const Vec2d at = 0.8 * sample_concentric_disk(Vec2d(drawn_for(round, 10 + 2 * i), drawn_for(round, 11 + 2 * i)));
      aimed.push_back({{at.x, at.y, 5}, {0, 0, -1}});
    }
    std::vector<Trial> trials;
    for (int n = 4; n <= most && !stop.asked(); n *= 2) {
      const Mesh mesh = ball(n, round);
      Primitives<double> primitives;
      primitives.add(mesh, Affine<double>{}, true);
      const Accelerator<double> accelerator(primitives, AcceleratorKind::bvh);
      TestCounts counts;
      const double start = thread_seconds();
      std::vector<std::optional<Hit<double>>> hits;
      for (const Ray<double>& ray : aimed) hits.push_back(accelerator.closest(ray, infinity<double>, counts));
      const double seconds = thread_seconds() - start;
      double place = 0, flat = 0, smooth = 0;
      for (std::size_t i = 0; i < aimed.size(); ++i) {
        if (!hits[i]) continue;
        const Hit<double>& hit = *hits[i];
        const Sphere<double> whole{{0, 0, 0}, 1};
        const auto crossing = intersect(whole, aimed[i], infinity<double>);
        const SurfacePoint<double> point =
            accelerator.primitives().surface_at(hit.primitive, aimed[i], Intersection<double>{hit.t, hit.part});
        const Vec3d normal = surface_at(whole, aimed[i], *crossing).normal;
        const auto angle = [&](const Vec3d& other) { return std::asin(std::min(length(cross(normal, other)), 1.0)); };
        const Vec3d between = accelerator.primitives().smooth_normal(hit.primitive, point).value_or(point.normal);
        place += (hit.t - crossing->t) * (hit.t - crossing->t);
        flat += angle(point.normal) * angle(point.normal);
        smooth += angle(normalize(between)) * angle(normalize(between));
      }
      const auto bytes =
          static_cast<double>(accelerator.statistics().bytes + mesh.triangles.size() * sizeof(Mesh::Corners) +
                              mesh.positions.size() * 2 * sizeof(Vec3d));
      const Cost cost{static_cast<std::uint64_t>(rays), counts.nodes, counts.primitives, 0, seconds};
      const auto rms = [&](double sum) { return std::sqrt(sum / rays); };
      trials.push_back({round, "place", static_cast<double>(n), rms(place), bytes, cost});
      trials.push_back({round, "flat", static_cast<double>(n), rms(flat), bytes, cost});
      trials.push_back({round, "smooth", static_cast<double>(n), rms(smooth), bytes, cost});
    }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) { return conclude_tessellation(trials, most); };
  return e;
}

}  // namespace raywalk::study
