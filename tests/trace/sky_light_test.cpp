// Skies: their radiance against formulas, their sampling against its own pdf, what all integrators see of them.

#include "trace/sky_light.h"

#include "math/transform.h"
#include "support/catch.h"
#include "support/effort.h"
#include "trace/clear_sky.h"
#include "trace/paths.h"
#include "trace/sampled.h"

#include <array>
#include <functional>
#include <numbers>
#include <random>

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr double sky_pi = std::numbers::pi;

/// A picture of this many columns and half as many rows.
Sky image_sky(int columns, const std::function<double(int column, int row)>& light, double rotation = 0) {
  Image picture{columns, columns / 2, {}};
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < columns; ++column)
      picture.pixels.emplace_back(static_cast<float>(light(column, row)));
  return {ImageSky{"a.pfm", Rgbd(1.0), std::make_shared<const Image>(std::move(picture))}, {0, 0, 1}, rotation};
}
Sky constant_sky() {
  return image_sky(8, [](int, int) { return 1.0; });
}
/// Bright and dark pixels, a black row and a black column, the poles too.
Sky uneven_sky(double rotation = 0) {
  return image_sky(
      16,
      [](int column, int row) { return row == 5 || column == 3 ? 0 : 1.0 + 7 * ((column * 5 + row * 3) % 11 == 0); },
      rotation);
}

struct Named {
  std::string name;
  Sky sky;
  Rgbd below{0.0};
};
std::vector<Named> all_skies() {
  const Rgbd blue{0.1, 0.3, 0.9};
  return {{"gradient", {GradientSky{Rgbd(0.2), blue}}},
          {"gradient to black", {GradientSky{Rgbd(0.7), Rgbd(0.0)}}},
          {"gradient from black, with ground", {GradientSky{Rgbd(0.0), Rgbd(0.7)}}, Rgbd(0.3)},
          {"overcast", {OvercastSky{}}},
          {"overcast, with ground, tilted", {OvercastSky{}, {1, -2, 0.5}, 33}, Rgbd(0.1)},
          {"clear", {ClearSky{}, {0, 0, 1}, 70}},
          {"clear, with ground, in the plan", {ClearSky{10, 5, 0.8, Rgbd(1.0)}, {0, 1, 0}, 0}, Rgbd(0.2)},
          {"image", uneven_sky(20)},
          {"image of 2 x 1", image_sky(2, [](int column, int) { return 1.0 + column; })}};
}

/// The integral over all directions, by the midpoints of small pieces of equal solid angle in the frame of `up`.
template <class Function>
double over_sphere(const Vec3d& up, int rows, int columns, const Function& f) {
  const Basis<double> basis(normalize(up));
  double sum = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double z = 1 - (row + 0.5) * 2 / rows, angle = (column + 0.5) * 2 * sky_pi / columns;
      const double radius = std::sqrt(1 - z * z);
      sum += f(basis.to_world({radius * std::cos(angle), radius * std::sin(angle), z}));
    }
  return sum * 4 * sky_pi / rows / columns;
}

/// The irradiance of a level surface, by midpoints in the square of the sine.
double irradiance(const SkyLight& light) {
  constexpr int rows = 400, columns = 400;
  double sum = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double share = (row + 0.5) / rows, radius = std::sqrt(share), angle = (column + 0.5) * 2 * sky_pi / columns;
      sum += light.radiance({radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - share)}).x;
    }
  return sum * sky_pi / rows / columns;
}

/// A white floor, of which the irradiance shows as E / sky_pi; by paths of one bounce.
Scene floor_under(const Sky& sky) {
  Scene scene;
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, lambert())};
  scene.sky = sky;
  scene.render.sampler = Sampler::sobol;
  return scene;
}

Scene busy_under(const Sky& sky) {
  Scene scene = busy_scene();
  scene.sky = sky;
  return scene;
}

}  // namespace

TEST_CASE("the pdf of every sky is that of its samples: chi-square, by cells of equal solid angle", "[odds]") {
  for (const auto& [name, sky, below] : all_skies())
    for (const SkySampling how : {SkySampling::by_brightness, SkySampling::uniform}) {
      INFO(name << (how == SkySampling::uniform ? ", uniformly" : ""));
      const SkyLight light(sky, below);
      constexpr int rows = 12, columns = 24, finer = 40, samples = 200'000;
      const Basis<double> basis(normalize(sky.up));
      // Expected, by the pdf's integral over each cell; seen, by samples.
      std::vector<double> expected(rows * columns, 0.0), seen(rows * columns, 0.0);
      const auto cell_of = [&](const Vec3d& d) {
        const Vec3d local{dot(d, basis.s), dot(d, basis.t), dot(d, basis.n)};
        const double angle = std::atan2(local.y, local.x);
        const int row = std::clamp(static_cast<int>((1 - local.z) / 2 * rows), 0, rows - 1);
        const int column = std::clamp(
            static_cast<int>((angle < 0 ? angle + 2 * sky_pi : angle) / (2 * sky_pi) * columns), 0, columns - 1);
        return static_cast<std::size_t>(row * columns + column);
      };
      const double piece = 4 * sky_pi / (rows * columns * finer * finer);
      over_sphere(sky.up, rows * finer, columns * finer, [&](const Vec3d& d) {
        expected[cell_of(d)] += light.pdf(d, how) * piece * samples;
        return 0;
      });
      double worst_direction = 0, worst_pdf = 0;
      std::mt19937_64 random(7);
      std::uniform_real_distribution<double> unit(0, 1);
      for (int i = 0; i < samples; ++i) {
        const double u = unit(random), v = unit(random);
        const auto sample = light.sample({u, v}, how);
        REQUIRE(sample.has_value());
        worst_direction = std::max(worst_direction, std::abs(length(sample->direction) - 1));
        ++seen[cell_of(sample->direction)];
        if (i % 64 == 0) worst_pdf = std::max(worst_pdf, std::abs(sample->pdf / light.pdf(sample->direction, how) - 1));
      }
      CHECK(worst_direction < 1e-12);
      CHECK(worst_pdf < 1e-6);
      double chi = 0, sum = 0;
      int cells = 0;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        sum += expected[i];
        if (expected[i] < 5) {
          CHECK(seen[i] <= expected[i] + 25);
          continue;
        }
        chi += std::pow(seen[i] - expected[i], 2) / expected[i];
        ++cells;
      }
      CHECK(sum == Approx(samples).epsilon(2e-3));
      CHECK(chi < cells + 6 * std::sqrt(2.0 * cells));
    }
}

TEST_CASE("a sky's pdf integrates to 1") {
  // The exact integral of what is linear in z, or constant in cells whose borders are borders of the pieces.
  for (const auto& [name, sky, below] : all_skies()) {
    INFO(name);
    const SkyLight light(sky, below);
    if (std::holds_alternative<GradientSky>(sky.kind) || std::holds_alternative<OvercastSky>(sky.kind)) {
      CHECK(over_sphere(sky.up, 1000, 8, [&](const Vec3d& d) { return light.pdf(d); }) == Approx(1).epsilon(1e-12));
      continue;
    }
    const auto* image = std::get_if<ImageSky>(&sky.kind);
    const int rows = image != nullptr ? image->pixels->height : 64, columns = 2 * rows;
    const Affine<double> turn = rotation(Vec3d(0, 0, 1), sky.rotation);
    double sum = 0;
    for (int row = 0; row < rows; ++row) {
      const double angle = sky_pi * (row + 0.5) / rows;
      const double solid = 2 * sky_pi / columns * (std::cos(sky_pi * row / rows) - std::cos(sky_pi * (row + 1) / rows));
      for (int column = 0; column < columns; ++column) {
        const double azimuth = sky_pi - 2 * sky_pi * (column + 0.5) / columns;
        const Vec3d d{std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
        // In the plan x stays x, and z is y.
        sum += solid * light.pdf(sky.up.y == 1 ? Vec3d(d.x, d.z, -d.y) : turn.direction(d));
      }
    }
    CHECK(sum == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("a constant sky lights a level floor with pi L, an overcast one with 7/9 pi of its zenith", "[odds]") {
  CHECK(irradiance(SkyLight(constant_sky(), Rgbd(0.0))) == Approx(sky_pi).epsilon(1e-12));
  CHECK(irradiance(SkyLight({OvercastSky{Rgbd(2.0)}}, Rgbd(0.0))) == Approx(2 * 7 * sky_pi / 9).epsilon(5e-5));
  CHECK(irradiance(SkyLight({GradientSky{Rgbd(0.5), Rgbd(2.0)}}, Rgbd(9.0))) ==
        Approx(0.5 * sky_pi + 1.5 * 2 * sky_pi / 3).epsilon(5e-5));
  std::size_t number = 0;
  for (const PathStrategy strategy : {PathStrategy::both, PathStrategy::lights, PathStrategy::directions})
    for (const SkySampling how : {SkySampling::by_brightness, SkySampling::uniform}) {
      if (left_out(number++, 4)) continue;
      const PathSettings settings{2, never, strategy, how};
      const auto seen = [&](const Sky& sky) {
        return light_along(floor_under(sky), {0, 0, 2}, {0, 0, 0}, 1 << 16, settings).mean.x;
      };
      CHECK(seen(constant_sky()) == Approx(1).epsilon(1e-3));
      CHECK(seen({OvercastSky{Rgbd(1.0)}}) == Approx(7.0 / 9).epsilon(1e-3));
    }
}

TEST_CASE("the uneven sky lights alike by every strategy", "[odds]") {
  for (const auto& [name, sky, below] : all_skies()) {
    INFO(name);
    if (sky.up != Vec3d(0, 0, 1)) continue;
    const double truth = irradiance(SkyLight(sky, below)) / sky_pi;
    for (const PathStrategy strategy : {PathStrategy::both, PathStrategy::lights, PathStrategy::directions}) {
      const auto seen = light_along(floor_under(sky), {0, 0, 2}, {0, 0, 0}, 1 << 16,
                                    {2, never, strategy, SkySampling::by_brightness});
      CHECK(seen.mean.x == Approx(truth).epsilon(4e-3));
    }
  }
}

TEST_CASE("a constant picture of a sky is a constant background") {
  Scene with = busy_under(constant_sky()), without = busy_scene();
  without.background = Rgbd(1.0);
  for (const Integrator integrator : {Integrator::cast, Integrator::whitted, Integrator::distributed}) {
    with.render.integrator = without.render.integrator = integrator;
    CHECK(same_bits(picture<double>(with, 41, 31, {2, 3}), picture<double>(without, 41, 31, {2, 3})));
  }
  // The white furnace: a body of albedo 1 disappears.
  Scene furnace = floor_under(constant_sky());
  furnace.objects = {object("Ball", Sphere<double>{{0, 0, 0}, 1}, lambert())};
  const Estimates seen = path_estimates(looking(furnace, {-4, 0, 0}, {0, 0, 0}), 9, 9, 4096, {0, never});
  for (std::size_t i = 0; i < seen.mean.size(); ++i)
    CHECK(seen.mean[i].x == Approx(1).margin(1e-3 + 4 * seen.error(i)));
}

TEST_CASE("a sky turns about its zenith, and stands where its up says") {
  const SkyLight still(uneven_sky(0), Rgbd(0.0)), turned(uneven_sky(90), Rgbd(0.0)), back(uneven_sky(-270), Rgbd(0.0));
  Sky lying = uneven_sky(0);
  lying.up = {0, 3, 0};
  const SkyLight in_plan(lying, Rgbd(0.0));
  for (int i = 0; i < 500; ++i) {
    const Vec3d d = sample_uniform_sphere(Vec2d((i + 0.5) / 500, std::fmod(0.1234 + i * 0.618, 1.0)));
    const Rgbd expected = still.radiance(d);
    CHECK(turned.radiance({-d.y, d.x, d.z}) == expected);  // counter-clockwise, seen from above
    CHECK(back.radiance({-d.y, d.x, d.z}) == expected);
    CHECK(in_plan.radiance({d.x, d.z, -d.y}).x == Approx(expected.x).epsilon(1e-9));
    CHECK(turned.pdf({-d.y, d.x, d.z}) == still.pdf(d));
  }
  // Also where up is all but along x, from which azimuths are counted.
  for (const double lean : {0.0, 1e-200, 1e-300, 1e-12}) {
    Sky aside = uneven_sky(0);
    aside.up = {1, lean, 0};
    const Rgbd seen = SkyLight(aside, Rgbd(0.0)).radiance({0.3, 0.4, 0.5});
    CAPTURE(lean, seen.x);
    CHECK((seen.x > 0 && seen.x < 100));
  }
  const SkyLight sun({ClearSky{40, 3, 0.2, Rgbd(1.0)}, {0, 0, 1}, 90}, Rgbd(0.0));
  const double c = std::cos(40 * degree), s = std::sin(40 * degree);
  CHECK(sun.radiance({0, c, s}).x > 3 * sun.radiance({c, 0, s}).x);
  CHECK(sun.place({0, 1, 1}).elevation == Approx(45));
  CHECK(sun.place({1, 0, 0}).azimuth == Approx(-90));
  // The middle of a picture lies along x, its left half to the left of that.
  const SkyLight halves(image_sky(8, [](int column, int) { return column == 3 ? 1.0 : 0.0; }), Rgbd(0.0));
  CHECK(halves.radiance({1, 0.4, 0}).x > 0.9);
  CHECK(halves.radiance({1, -0.5, 0}).x == 0);
}

TEST_CASE("a clear sky is that of Hosek and Wilkie") {
  // CIE X, Y, Z by the authors' sample implementation, version 1.4a: turbidity, albedo, the sun's elevation, the angle
  // from the zenith and the azimuth from the sun, in degrees.
  struct Known {
    double turbidity, albedo, elevation, theta, azimuth;
    Vec3d xyz;
  };
  const std::vector<Known> known{
      {1, 0, 0, 0, 0, {0.480541434089, 0.50187026942, 0.556582528409}},
      {1, 0, 0, 40, 35, {0.846577080214, 0.905168583126, 0.916378046196}},
      {1, 0, 0, 75, 120, {1.77951803332, 1.89894755997, 1.3417953203}},
      {1, 0, 0, 89, 180, {2.57215925732, 2.24238518372, 0.534336807249}},
      {2, 0.2, 5, 0, 0, {1.15771954085, 1.21889751605, 2.04147242618}},
      {2, 0.2, 5, 40, 35, {1.97942035861, 2.14360475545, 3.20125007711}},
      {2, 0.2, 5, 75, 120, {4.49009735276, 5.01187952492, 5.71329323774}},
      {2, 0.2, 5, 89, 180, {9.85550275586, 10.4591054875, 5.83114652867}},
      {3.5, 0.7, 30, 0, 0, {3.93350708764, 4.0785385956, 8.12059352211}},
      {3.5, 0.7, 30, 40, 35, {7.8163783198, 8.25728960471, 13.3773420032}},
      {3.5, 0.7, 30, 75, 120, {11.7113957466, 12.6563758306, 20.2710852402}},
      {3.5, 0.7, 30, 89, 180, {23.9228366534, 26.2680453837, 28.977710107}},
      {6, 1, 60, 0, 0, {11.6673383748, 12.2397291456, 19.9041733933}},
      {6, 1, 60, 40, 35, {22.8417946916, 24.2974516458, 32.9385769798}},
      {6, 1, 60, 75, 120, {20.8495304068, 22.2326664591, 34.2746058451}},
      {6, 1, 60, 89, 180, {33.5850587991, 35.8631352277, 42.9131377027}},
      {10, 0.5, 90, 0, 0, {115.145525971, 118.55107845, 108.677210081}},
      {10, 0.5, 90, 40, 35, {19.6762432834, 20.7755595873, 24.5532741398}},
      {10, 0.5, 90, 75, 120, {15.6843557716, 16.3593473453, 19.7559926889}},
      {10, 0.5, 90, 89, 180, {16.3139616705, 16.8557474159, 16.5837094512}},
  };
  for (const Known& k : known) {
    const ClearSkyRadiance sky(ClearSky{k.elevation, k.turbidity, k.albedo, Rgbd(1.0)});
    const double t = k.theta * degree, a = k.azimuth * degree;
    const Vec3d xyz = sky.xyz({std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)});
    for (int c = 0; c < 3; ++c) CHECK(xyz[c] == Approx(k.xyz[c]).epsilon(1e-6));
  }
  // No light is negative, wherever one looks.
  for (const double elevation : {0.0, 3.0, 20.0, 90.0})
    for (const double turbidity : {1.0, 2.5, 9.9, 10.0}) {
      const SkyLight light({ClearSky{elevation, turbidity, 1, Rgbd(1.0)}}, Rgbd(0.0));
      over_sphere({0, 0, 1}, 40, 40, [&](const Vec3d& d) {
        const Rgbd seen = light.radiance(d);
        CHECK((seen.x >= 0 && seen.y >= 0 && seen.z >= 0));
        CHECK(is_finite(seen));
        return 0;
      });
    }
}

TEST_CASE("mirrors and glass show the sky, by every integrator") {
  Scene scene;
  Material mirror = black();
  mirror.reflection = Rgbd(0.5);
  scene.objects = {object("Mirror", Plane<double>{{0, 0, 0}, {0, 0, 1}}, mirror)};
  scene.sky = Sky{GradientSky{Rgbd(0.0), Rgbd(1.0)}};
  scene.render.integrator = Integrator::whitted;
  const Vec3d eye{-3, 0, 4};
  CHECK(shade_along(scene, eye, {0, 0, 0}).x == Approx(0.5 * 0.8).epsilon(1e-12));
  scene.render.integrator = Integrator::distributed;
  CHECK(shade_along(scene, eye, {0, 0, 0}).x == Approx(0.5 * 0.8).epsilon(1e-12));
  CHECK(light_along(scene, eye, {0, 0, 0}, 64).mean.x == Approx(0.5 * 0.8).epsilon(1e-9));
  // A pane of glass does not bend what it lets through.
  Material glass = black();
  glass.transmission = Rgbd(1.0);
  scene.objects = {object("Pane", Box<double>{{-1, -9, -9}, {-0.5, 9, 9}}, glass)};
  scene.render.integrator = Integrator::whitted;
  CHECK(shade_along(scene, {-3, 0, 0}, {0, 0, 4}).x == Approx(0.8).epsilon(1e-12));
  // Straight at it, and below its horizon.
  CHECK(shade_along(scene, {0, 0, 0}, {0, 0, 1}).x == Approx(1).epsilon(1e-12));
  scene.background = Rgbd(0.25);
  CHECK(shade_along(scene, {3, 0, 0}, {4, 0, -1}).x == 0.25);
}

TEMPLATE_TEST_CASE("under a sky, watched and unwatched give the same bits and the same counts", "", float, double) {
  using T = TestType;
  std::size_t number = 0;
  for (const auto& [name, sky, below] : all_skies()) {
    INFO(name);
    Scene scene = busy_under(sky);
    scene.background = below;
    ++number;
    for (const Integrator integrator : {Integrator::whitted, Integrator::distributed}) {
      if (left_out(number++, 2)) continue;  // each sky has one of them
      scene.render.integrator = integrator;
      Recording recording;
      const auto plain = picture<T>(scene, 31, 23, {2, 7});
      const auto watched = watched_picture<T>(scene, 31, 23, recording, {2, 7});
      CHECK(same_bits(plain, watched));
      CHECK(same_counts(plain.statistics, watched.statistics));
    }
    Recording recording;
    const auto plain = path_picture<T>(scene, 31, 23, {}, {2, 7});
    const auto watched = path_picture<T>(scene, 31, 23, {}, {2, 7}, &recording);
    CHECK(same_bits(plain, watched));
    CHECK(same_counts(plain.statistics, watched.statistics));
    CHECK(plain.statistics.not_finite == 0);
    CHECK(plain.statistics.drawn(Effect::sky) > 0);
    bool told = false;
    for (const Found& found : recording.all<Found>())
      if (const auto* numbers = std::get_if<SkyNumbers>(&found.numbers))
        told = told || (found.ending == Ending::missed && std::isfinite(numbers->pdf));
    CHECK(told);
  }
}

TEST_CASE("without a sky, nothing of it is drawn or told") {
  Recording recording;
  const auto paths = path_picture<double>(busy_scene(), 31, 23, {}, {2, 7}, &recording);
  CHECK(paths.statistics.drawn(Effect::sky) == 0);
  for (const Found& found : recording.all<Found>()) CHECK_FALSE(std::holds_alternative<SkyNumbers>(found.numbers));
  CHECK_FALSE(effects_of(busy_scene()).used(Effect::sky));
  CHECK(effects_of(busy_under({OvercastSky{}}))[Effect::sky].why ==
        "rays that leave the scene meet the sky, of type overcast");
}

TEST_CASE("what a sky adds to a pixel is told, and adds up") {
  Scene scene = busy_under(uneven_sky());
  scene.lights.clear();
  Recording recording;
  const auto traced = path_picture<double>(scene, 31, 23, {5, 2}, {1, 3}, &recording);
  Rgbd sum(0.0), pixels(0.0);
  for (const Event& event : recording.events) {
    if (const auto* added = std::get_if<LightAdded>(&event.detail)) sum += added->added;
    if (const auto* added = std::get_if<EmissionAdded>(&event.detail)) sum += added->added;
    if (const auto* added = std::get_if<BackgroundAdded>(&event.detail)) sum += added->added;
  }
  for (const Rgbd& pixel : traced.pixels) pixels += pixel;
  for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(pixels[c]).epsilon(1e-9));
  int aimed = 0;
  for (const LightAdded& added : recording.all<LightAdded>()) {
    CHECK(added.light == light_of_sky);
    aimed += added.weight < 1;
  }
  CHECK(aimed > 100);
}
