// Adaptive sampling: its interval covers what it claims, however often it looks.
#include "render/adaptive.h"

#include "render/render.h"

#include <cmath>

#include "image/srgb.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

double shown(double linear) { return srgb_encode(std::min(std::max(linear, 0.0), 1.0)); }

/// A glowing wall that fills what lies left of a slanted edge through the picture, in black.
Scene edge_scene(double slope) {
  Scene scene;
  scene.camera.eye = {0, 0, 0};
  scene.camera.look_at = {1, 0, 0};
  scene.camera.screen = {1, 2, 21};
  Material glow;
  glow.diffuse = Rgbd(0.0);
  glow.emission = Rgbd(0.5);
  // Seen at distance 1, y to the left and z up: the edge is y = slope z.
  scene.objects = {
      {"Wall", Polygon<double>{{{1, slope * -5, -5}, {1, 9, -5}, {1, 9, 5}, {1, slope * 5, 5}}, {}}, glow}};
  return scene;
}

/// Of the pixel whose corners are these, the part with y > slope z: by thin slices.
double covered(double y0, double y1, double z0, double z1, double slope) {
  constexpr int slices = 2000;
  double sum = 0;
  for (int i = 0; i < slices; ++i) {
    const double edge = slope * (z0 + (z1 - z0) * (i + 0.5) / slices);
    sum += std::min(std::max(y1 - std::max(y0, edge), 0.0), y1 - y0);
  }
  return sum / slices / (y1 - y0);
}

}  // namespace

TEST_CASE("Student's quantiles are those of the tables") {
  CHECK(student_quantile(0.05, 15) == Approx(2.13145).epsilon(1e-4));
  CHECK(student_quantile(0.05, 30) == Approx(2.04227).epsilon(1e-5));
  CHECK(student_quantile(0.01, 15) == Approx(2.94671).epsilon(1e-4));
  CHECK(student_quantile(0.001, 20) == Approx(3.84952).epsilon(2e-4));
  CHECK(student_quantile(0.05, 1000000) == Approx(1.95996).epsilon(1e-5));
}

TEST_CASE("95% covers at least 95% of the pixels on an edge, although each is looked at many times") {
  constexpr int width = 41, height = 41;
  int inside = 0, looked_at = 0, early = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const double slope = 0.05 + 0.045 * seed, tolerance = 0.04;
    Scene scene = edge_scene(slope);
    scene.render.sampler = Sampler::random;
    RenderSettings settings{ImageSize{width, height}, Sampling{4096, static_cast<std::uint64_t>(seed)}};
    settings.tolerance = tolerance;
    const auto rendering = render(scene, settings).value();
    const std::uint64_t taken = rendering.statistics.formed(RayKind::primary);
    early += taken < width * height * 4096ULL / 4;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const double pitch = 2.0 / width;
        const double y1 = 1 - column * pitch, z1 = (height / 2.0 - row) * pitch;
        const double share = covered(y1 - pitch, y1, z1 - pitch, z1, slope);
        if (share <= 0 || share >= 1) continue;
        ++looked_at;
        const double mean = rendering.film_of<double>().at(column, row).x;
        inside += std::abs(shown(mean) - shown(0.5 * share)) <= tolerance;
      }
  }
  CHECK(early == 20);
  CHECK(looked_at > 800);
  CAPTURE(inside, looked_at);
  CHECK(inside >= 0.95 * looked_at);
}

TEMPLATE_TEST_CASE("flat pixels stop at the first look, and nothing depends on threads or tiles", "", float, double) {
  using T = TestType;
  Scene scene = edge_scene(0.3);
  RenderSettings settings{ImageSize{65, 67}, Sampling{256, 3}};
  settings.precision = std::is_same_v<T, float> ? Precision::float_ : Precision::double_;
  settings.tolerance = 0.02;
  settings.threads = 1;
  const auto one = render(scene, settings).value();
  const std::uint64_t taken = one.statistics.formed(RayKind::primary);
  CHECK(taken > 65 * 67 * 16);
  CHECK(taken < 65 * 67 * 60);
  CHECK(one.finished);
  settings.threads = 3;
  settings.reorder_tiles = [](std::vector<int>& tiles) { std::reverse(tiles.begin(), tiles.end()); };
  const auto three = render(scene, settings).value();
  CHECK(three.film_of<T>().pixels() == one.film_of<T>().pixels());
  CHECK(three.statistics.rays == one.statistics.rays);
  // Pixels far from the edge hold exactly what they would with all samples.
  settings.tolerance = 0;
  const auto all = render(scene, settings).value();
  CHECK(all.statistics.formed(RayKind::primary) == 65 * 67 * 256);
  CHECK(all.film_of<T>().at(1, 1) == one.film_of<T>().at(1, 1));
  CHECK(all.film_of<T>().at(63, 60) == one.film_of<T>().at(63, 60));
}

TEST_CASE("what is not drawn stands for the whole pixel too when sampling stops early") {
  // An edge along the rows of the picture, then along its columns.
  for (const Vec3d& up : {Vec3d(0, 1, 0), Vec3d(0, 0, 1)})
    for (const int samples : {25, 64, 100, 289, 500}) {
      Scene scene = edge_scene(0.02);
      scene.camera.up = up;
      scene.render.integrator = Integrator::whitted;
      RenderSettings settings{ImageSize{9, 9}, Sampling{samples, 0}};
      const auto all = render(scene, settings).value();
      settings.tolerance = 0.05;
      const auto early = render(scene, settings).value();
      CHECK(early.statistics.formed(RayKind::primary) < all.statistics.formed(RayKind::primary));
      CAPTURE(samples, up.y);
      for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column) {
          const double whole = shown(all.film_of<double>().at(column, row).x);
          CHECK(std::abs(shown(early.film_of<double>().at(column, row).x) - whole) <= 0.05);
        }
    }
}

TEST_CASE("beams through some of a pixel's cells stand for all of it when sampling stops early") {
  for (const Vec3d& up : {Vec3d(0, 1, 0), Vec3d(0, 0, 1)})
    for (const int samples : {64, 256}) {
      Scene scene = edge_scene(0.02);
      scene.camera.up = up;
      scene.render.integrator = Integrator::beams;
      RenderSettings settings{ImageSize{9, 9}, Sampling{samples, 0}};
      const auto all = render(scene, settings).value();
      settings.tolerance = 0.05;
      const auto early = render(scene, settings).value();
      CAPTURE(samples, up.y);
      for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 9; ++column) {
          const double whole = shown(all.film_of<double>().at(column, row).x);
          CHECK(std::abs(shown(early.film_of<double>().at(column, row).x) - whole) <= 0.05);
        }
    }
}

TEST_CASE("a tolerance that nothing meets takes all samples, with the same bits") {
  Scene scene = edge_scene(0.3);
  RenderSettings settings{ImageSize{9, 9}, Sampling{50, 3}};
  const auto plain = render(scene, settings).value();
  settings.tolerance = 1e-12;
  const auto adaptive = render(scene, settings).value();
  // Where all is flat, nothing varies: those pixels are known at any tolerance.
  CHECK(adaptive.film_of<double>().at(4, 4) == plain.film_of<double>().at(4, 4));
  CHECK(adaptive.statistics.formed(RayKind::primary) < plain.statistics.formed(RayKind::primary));
  double last = -1;
  settings.threads = 1;
  settings.tolerance = 0.01;
  settings.progress = [&](const Progress& progress) {
    CHECK(progress.done >= last);
    last = progress.done;
  };
  REQUIRE(render(scene, settings).has_value());
  CHECK(last == 1);
}
