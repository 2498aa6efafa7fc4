#include "trace/ray_generator.h"

#include <map>
#include <numbers>

#include "support/catch.h"
#include "support/table.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using std::numbers::pi;

template <class T>
Vec3<T> direction(const RayGenerator<T>& camera, int column, int row, int sample = 0) {
  Statistics draws;
  return camera.primary_ray({column, row, sample}, draws).direction;
}

// Looks along +x with +z up: right is -y.
Camera angle_camera(double degrees, FovAxis axis) {
  Camera camera;
  camera.screen.width = std::nullopt;
  camera.fov = FieldOfView{degrees, axis};
  return camera;
}

}  // namespace

TEST_CASE("primary rays are what camera.tsv says") {
  int rows = 0;
  for (const Row& row : read_table("camera.tsv")) {
    ++rows;
    INFO(row.text("id") << " " << row.text("quantity"));
    const ImageSize size{static_cast<int>(row.number("width")), static_cast<int>(row.number("height"))};
    const FovAxis axis = row.text("fov_axis") == "x" ? FovAxis::x : FovAxis::y;
    const RayGenerator<double> camera(angle_camera(row.number("fov_deg"), axis), size, size);
    const double tolerance = row.number("tol");
    if (row.text("quantity") == "pitch") {
      const Vec3d a = direction(camera, 3, 5), b = direction(camera, 4, 5), c = direction(camera, 3, 6);
      CHECK(length(b / b.x - a / a.x) == Approx(row.number("expected")).margin(tolerance).epsilon(0));
      CHECK(length(c / c.x - a / a.x) == Approx(row.number("expected")).margin(tolerance).epsilon(0));
      continue;
    }
    const Vec3d d = direction(camera, static_cast<int>(row.number("column")), static_cast<int>(row.number("row")));
    if (row.text("quantity") == "abs_dir") {
      CHECK(length(Vec3d(std::abs(d.y), std::abs(d.z), std::abs(d.x)) - row.vector("expected")) <= tolerance);
    } else {
      REQUIRE(row.text("quantity") == "axis_deg");
      CHECK(std::acos(d.x) * 180 / pi == Approx(row.number("expected")).margin(1e-6).epsilon(0));
    }
  }
  CHECK(rows >= 5);
}

TEST_CASE("column 0 is to the left of the view, row 0 at the top") {
  const RayGenerator<double> camera(angle_camera(90, FovAxis::x), {4, 2}, {4, 2});
  // At distance 1 the picture is 2 wide, so pixel centres lie at +-0.75 and +-0.25.
  const Vec3d first = direction(camera, 0, 0), last = direction(camera, 3, 1);
  CHECK(first.y / first.x == Approx(0.75));
  CHECK(first.z / first.x == Approx(0.25));
  CHECK(last.y / last.x == Approx(-0.75));
  CHECK(last.z / last.x == Approx(-0.25));
  CHECK(length(first) == Approx(1));
}

TEST_CASE("a screen of given width spans the picture's width") {
  Camera camera;
  camera.eye = {1, 2, 3};
  camera.look_at = {1, 2, -5};  // down, with y up
  camera.up = {0, 1, 0};
  camera.screen = {2, 3.0, 21};
  const RayGenerator<double> generator(camera, {5, 5}, {5, 5});
  Statistics draws;
  const Ray<double> ray = generator.primary_ray({4, 2, 0}, draws);
  CHECK(ray.origin == camera.eye);
  // The rightmost centre: 4/5 of half of 3, at distance 2.
  CHECK(ray.direction.x / -ray.direction.z == Approx(0.8 * 1.5 / 2));
  CHECK(draws.random_draws() == 0);
  CHECK(generator.size() == ImageSize{5, 5});
}

TEMPLATE_TEST_CASE("the strip's rays are the middle row's, bit for bit", "", float, double) {
  using T = TestType;
  Camera camera;
  camera.eye = {-7.3, 0.41, 0};
  camera.look_at = {1.7, -0.13, 0};
  camera.screen = {1.3, 0.77, 21};
  const int cells = GENERATE(1, 2, 21, 40, 401);
  const int k = GENERATE(1, 3, 5, 21);
  const int height = GENERATE(1, 3, 331);
  for (const bool angle_along_y : {false, true}) {
    if (angle_along_y) camera.screen.width = std::nullopt, camera.fov = FieldOfView{37, FovAxis::y};
    const ImageSize whole{cells * k, height};
    const RayGenerator<T> image(camera, whole, whole), strip(camera, {cells, 1}, whole);
    for (int cell = 0; cell < cells; ++cell) {
      const Vec3<T> in_strip = direction(strip, cell, 0);
      const Vec3<T> in_row = direction(image, cell * k + (k - 1) / 2, (height - 1) / 2);
      if (in_strip != in_row) FAIL("cell " << cell << " of " << cells << ", k = " << k);
      if (in_strip.z != 0) FAIL("cell " << cell << " leaves the plan");
    }
  }
}

TEST_CASE("samples stay in their pixel, one in each stratum") {
  // Pixels of width 2/3 at distance 1.
  const RayGenerator<double> centre(angle_camera(90, FovAxis::x), {3, 3}, {3, 3});
  const int samples = GENERATE(2, 4, 9, 10, 16);
  const RayGenerator<double> camera(angle_camera(90, FovAxis::x), {3, 3}, {3, 3}, {samples, 99});
  int k = 1;
  while ((k + 1) * (k + 1) <= samples) ++k;
  for (const auto& [column, row] : {std::pair{0, 0}, {1, 1}, {2, 0}}) {
    const Vec3d c = direction(centre, column, row);
    std::vector<int> strata(static_cast<std::size_t>(k * k));
    for (int sample = 0; sample < samples; ++sample) {
      const Vec3d d = direction(camera, column, row, sample);
      // In pixels from the pixel's upper left corner.
      const double x = (c.y / c.x - d.y / d.x) * 1.5 + 0.5, y = (c.z / c.x - d.z / d.x) * 1.5 + 0.5;
      CHECK((x > -1e-12 && x < 1 + 1e-12 && y > -1e-12 && y < 1 + 1e-12));
      if (sample >= k * k) continue;
      const int cell = static_cast<int>((1 - y) * k) * k + static_cast<int>(x * k);
      ++strata[static_cast<std::size_t>(cell)];
    }
    for (const int count : strata) CHECK(count == 1);
  }
}

TEST_CASE("samples without random numbers are even, however many: each row and column of the pixel has one") {
  Scene scene;
  scene.render.integrator = Integrator::whitted;
  scene.camera = angle_camera(90, FovAxis::x);
  const RayGenerator<double> centre(scene, {3, 3}, {3, 3});
  const int samples = GENERATE(2, 3, 5, 6, 7, 8, 12, 1000);
  const RayGenerator<double> camera(scene, {3, 3}, {3, 3}, {samples, 99});
  const Vec3d c = direction(centre, 1, 1);
  std::vector<int> columns(static_cast<std::size_t>(samples)), rows = columns;
  for (int sample = 0; sample < samples; ++sample) {
    const Vec3d d = direction(camera, 1, 1, sample);
    const double x = (c.y / c.x - d.y / d.x) * 1.5 + 0.5, y = (c.z / c.x - d.z / d.x) * 1.5 + 0.5;
    ++columns.at(static_cast<std::size_t>(x * samples));
    ++rows.at(static_cast<std::size_t>(y * samples));
  }
  const std::vector<int> one_each(static_cast<std::size_t>(samples), 1);
  CHECK(columns == one_each);
  CHECK(rows == one_each);
}

TEST_CASE("samples depend on the seed and on nothing else, and are counted") {
  const Camera camera = angle_camera(90, FovAxis::x);
  const RayGenerator<double> a(camera, {8, 6}, {8, 6}, {4, 1}), same(camera, {8, 6}, {8, 6}, {4, 1}),
      other(camera, {8, 6}, {8, 6}, {4, 2});
  Statistics draws;
  const Ray<double> later = a.primary_ray({5, 2, 3}, draws);
  const Ray<double> again = same.primary_ray({5, 2, 3}, draws);
  CHECK(later.direction == again.direction);
  CHECK(draws.random_draws() == 4);
  CHECK(draws.drawn(Effect::antialiasing) == 4);
  CHECK(other.primary_ray({5, 2, 3}, draws).direction != again.direction);
  // The same pixel from the centre in a larger picture of the same pitch draws the same numbers: its strip or crop.
  const RayGenerator<double> strip(camera, {9, 1}, {9, 9}, {4, 1}), row(camera, {9, 9}, {9, 9}, {4, 1});
  CHECK(strip.primary_ray({3, 0, 2}, draws).direction == row.primary_ray({3, 4, 2}, draws).direction);
}

TEST_CASE("samples drawn ahead are those drawn one by one") {
  Scene scene;
  scene.camera.aperture = GENERATE(0, 0.25);
  scene.render.sampler = GENERATE(Sampler::random, Sampler::jittered, Sampler::sobol);
  const int samples = GENERATE(1, 9, 40);  // 40: more than are drawn at a time
  const RayGenerator<double> camera(scene, {5, 4}, {5, 4}, {samples, 3});
  Statistics together, apart;
  RayGenerator<double>::PixelDraws draws;
  for (const int column : {1, 2})
    for (int sample = 0; sample < samples; ++sample) {
      // Asked for up to the last but one, and then all the same for that one too.
      const Ray<double> ray = camera.primary_ray({column, 3, sample, samples - 1}, draws, together);
      const Ray<double> alone = camera.primary_ray({column, 3, sample}, apart);
      CHECK(ray.origin == alone.origin);
      CHECK(ray.direction == alone.direction);
    }
  CHECK(together.draws == apart.draws);
}

TEST_CASE("a ray's differential is the difference to its neighbours, of the image's pixels and of n samples") {
  Scene scene;
  scene.camera.eye = {1, 2, 3};
  scene.camera.look_at = {4, 3, 2.5};
  scene.camera.screen = {1, 1.4, 21};
  for (const double aperture : {0.0, 0.3}) {
    scene.camera.aperture = aperture;
    scene.render.integrator = Integrator::distributed;
    constexpr ImageSize fine{63000, 45}, coarse{63, 45};
    for (const int samples : {1, 4}) {
      const RayGenerator<double> camera(scene, coarse, coarse, {samples, 3});
      // A strip of 21 cells has the footprints of the image's pixels.
      const RayGenerator<double> strip(scene, {21, 1}, coarse, {samples, 3});
      const Vec3d here = direction(camera, 40, 30, samples - 1);
      const auto found = camera.differential(here);
      CHECK(camera.spacing() == 1 / std::sqrt(samples));
      CHECK(found.x.dP == Vec3d(0.0));
      CHECK(strip.differential(here).x.dD == found.x.dD);
      CHECK(std::abs(dot(found.x.dD, here)) < 1e-15);
      if (aperture > 0 || samples > 1) continue;
      const RayGenerator<double> between(scene, fine, fine);
      // The pixels of the fine picture are a thousandth as wide; those around the middle of pixel 40.
      const Vec3d x = direction(between, 40501, 30) - direction(between, 40499, 30);
      const Vec3d y = direction(between, 40500, 29) - direction(between, 40500, 31);
      const auto in_fine = between.differential(direction(between, 40500, 30));
      CHECK(length(in_fine.x.dD - x / 2.0) < 1e-6 * length(x));
      CHECK(length(in_fine.y.dD - y / 2.0) < 1e-6 * length(y));
    }
  }
  // Through the lens: the point in focus moves by a pixel at that distance, wherever the ray begins.
  scene.camera.aperture = 0.3;
  const RayGenerator<double> lens(scene, {63, 45}, {63, 45}, {2, 3});
  Statistics draws;
  const Ray<double> ray = lens.primary_ray({20, 10, 1}, draws);
  const Vec3d forward = normalize(scene.camera.look_at - scene.camera.eye);
  const double focus = scene.camera.focus_distance(), t = focus / dot(ray.direction, forward);
  const auto there = transfer(lens.differential(ray.direction), ray.direction, t, forward);
  CHECK(length(there.x.dP) == Approx(focus * 1.4 / 63 / std::sqrt(2)));
  CHECK(length(there.y.dP) == Approx(focus * 1.4 / 63 / std::sqrt(2)));
}

TEST_CASE("rays through corners are as far apart as those through the middles of pixels") {
  const Camera camera;
  const ImageSize pixels{6, 4}, corners{7, 5};
  Sampling sampling;
  sampling.corners = true;
  const RayGenerator<double> middle(camera, pixels, pixels), corner(camera, corners, pixels, sampling);
  const Vec3d direction = normalize(camera.look_at - camera.eye);
  const auto a = middle.differential(direction), b = corner.differential(direction);
  CHECK(a.x.dD == b.x.dD);
  CHECK(a.y.dD == b.y.dD);
  CHECK(length(a.x.dD) > 0);
}

TEST_CASE("from the eye to a hit at once is as by way of the ray") {
  const Camera camera;
  const RayGenerator<double> rays(camera, {40, 30}, {40, 30});
  for (const Vec3d& N : {Vec3d(0, 0, 1), normalize(Vec3d(-1, 0.3, 0.2)), normalize(Vec3d(0.1, 1, -1))})
    for (const Vec3d& towards : {Vec3d(1, 0.2, -0.3), Vec3d(1, -0.4, 0.1)}) {
      const Vec3d D = normalize(normalize(camera.look_at - camera.eye) + 0.3 * towards);
      const auto at_once = rays.differential_at_hit(D, 3.5, N), by_way = transfer(rays.differential(D), D, 3.5, N);
      CHECK(length(at_once.x.dP - by_way.x.dP) < 1e-13);
      CHECK(length(at_once.y.dP - by_way.y.dP) < 1e-13);
      CHECK(at_once.x.dD == by_way.x.dD);
      CHECK(at_once.y.dD == by_way.y.dD);
    }
}
