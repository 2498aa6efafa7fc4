// Patterns over footprints in whole pictures: towards the horizon, while the camera moves, by every integrator and
// however they are traced.

#include "support/catch.h"
#include "trace/kernel_of.h"
#include "trace/pictures.h"
#include "trace/scene_kernel.h"
#include "trace/texture_pyramid.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// A checkered floor to the horizon, which lies between two rows, lit evenly.
Scene floor_scene(CheckerFilter filter) {
  Scene scene;
  scene.camera.eye = {0.3, -0.2, 1.2};
  scene.camera.look_at = {1.3, 0.35, 1.2};
  scene.camera.fov = FieldOfView{70};
  scene.ambient = Rgbd(1.0);
  scene.background = Rgbd(0.5);
  Object floor{"Floor", Plane<double>{}, {}};
  floor.material.ambient = Rgbd(1.0);
  floor.material.diffuse = Rgbd(0.5);
  floor.material.checker = Checker{Rgbd(1.0), Rgbd(0.0), 1, filter};
  scene.objects = {floor};
  return scene;
}

/// With a mirror and a ball of glass on it, and something behind the eye.
Scene busy_floor(CheckerFilter filter) {
  Scene scene = floor_scene(filter);
  Object mirror{"Mirror", Sphere<double>{{4, 0.5, 1}, 1}, {}};
  mirror.material.reflection = Rgbd(0.9);
  Object ball{"Ball", Sphere<double>{{3, 2.4, 0.8}, 0.8}, {}};
  ball.material.transmission = Rgbd(0.9);
  ball.material.dielectric = true;
  Object wall{"Wall", Box<double>{{7, -3, 0}, {7.5, 3, 2.5}}, {}};
  wall.material.checker = Checker{Rgbd(0.9, 0.4, 0.1), Rgbd(0.1, 0.1, 0.6), 0.11, filter};
  wall.material.reflection = Rgbd(0.2);
  scene.objects.insert(scene.objects.end(), {mirror, ball, wall});
  scene.lights.push_back({"Sun", Rgbd(0.6), PointLight{{2, -3, 6}, {}}});
  return scene;
}

double apart(const Rgbd& a, const Rgbd& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}
double largest_difference(const Picture<double>& a, const Picture<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) most = std::max(most, apart(a.pixels[i], b.pixels[i]));
  return most;
}

}  // namespace

TEST_CASE("a filtered checker errs by less than a tenth of one sample, towards the horizon", "[odds]") {
  constexpr int width = 160, height = 120, fine = 33;
  const auto sampled = picture<double>(floor_scene(CheckerFilter::none), width, height);
  const auto filtered = picture<double>(floor_scene(CheckerFilter::closed), width, height);
  const auto many = picture<double>(floor_scene(CheckerFilter::none), width * fine, height * fine);
  double error_sampled = 0, error_filtered = 0;
  for (int row = height / 2; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      double mean = 0;
      for (int y = 0; y < fine; ++y)
        for (int x = 0; x < fine; ++x) mean += many.at(column * fine + x, row * fine + y).x / (fine * fine);
      error_sampled += std::abs(sampled.at(column, row).x - mean);
      error_filtered += std::abs(filtered.at(column, row).x - mean);
    }
  CAPTURE(error_sampled, error_filtered);
  CHECK(error_filtered < error_sampled / 10);
}

TEST_CASE("a thousandth of a pixel's move changes no pixel of a filtered floor by more than a hundredth") {
  constexpr int width = 160, height = 120;
  for (const CheckerFilter filter : {CheckerFilter::closed, CheckerFilter::none}) {
    Scene scene = floor_scene(filter);
    double most = 0;
    auto before = picture<double>(scene, width, height);
    const Vec3d view = scene.camera.look_at - scene.camera.eye;
    for (int step = 1; step <= 40; ++step) {
      // Turned, about the vertical.
      const double angle = step * 0.001 * 2 * scene.camera.half_extent() / width;
      scene.camera.look_at = scene.camera.eye + view + angle * cross(Vec3d(0, 0, 1), view);
      const auto now = picture<double>(scene, width, height);
      most = std::max(most, largest_difference(before, now));
      before = now;
    }
    CAPTURE(most);
    CHECK((most <= 0.01) == (filter == CheckerFilter::closed));
  }
}

TEST_CASE("a floor in a flat mirror is the floor that the mirrored eye sees") {
  // The mirror stands upright across the view, at x = 2; the eye's picture in it is at x = 3.7.
  Scene scene = floor_scene(CheckerFilter::closed);
  scene.camera.look_at = scene.camera.eye + Vec3d(1, 0, 0);
  Scene mirrored = scene;
  Object mirror{"Mirror", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, {}};
  mirror.material.reflection = Rgbd(1.0);
  mirror.material.diffuse = Rgbd(0.0);
  mirrored.objects.push_back(mirror);
  scene.camera.eye.x = 4 - scene.camera.eye.x;
  scene.camera.look_at = scene.camera.eye + Vec3d(-1, 0, 0);
  const auto direct = picture<double>(scene, 120, 90), seen = picture<double>(mirrored, 120, 90);
  double most = 0;
  for (int row = 45; row < 60; ++row)  // below the horizon, and beyond the floor before the mirror
    for (int column = 0; column < 120; ++column)
      most = std::max(most, apart(direct.at(119 - column, row), seen.at(column, row)));
  CHECK(most < 1e-9);
}

TEST_CASE("what does not filter keeps its bits beside what does") {
  Scene plain = busy_floor(CheckerFilter::none), other = plain;
  Object far{"Far Disk", Disk<double>{{0, 0, 400}, {0, 0, 1}, 1}, {}};
  far.material.checker = Checker{Rgbd(1.0), Rgbd(0.0), 1, CheckerFilter::none};
  plain.objects.push_back(far);
  far.material.checker->filter = CheckerFilter::closed;
  other.objects.push_back(far);
  CHECK(same_bits(picture<double>(plain, 63, 45), picture<double>(other, 63, 45)));
  for (const Integrator integrator : {Integrator::path, Integrator::photons}) {
    plain.render.integrator = other.render.integrator = integrator;
    plain.render.photons.count = other.render.photons.count = 500;
    const auto by = [&](const Scene& scene) {
      return picture_by<double>(scene, 31, 21, {}, [&](const World<double>& world, const auto&... a) {
        return SceneKernel<double>(scene, world)(a...);
      });
    };
    CHECK(same_bits(by(plain), by(other)));
  }
}

TEMPLATE_TEST_CASE("watched or not, filtered patterns have the same bits, by every integrator", "", float, double) {
  using T = TestType;
  Scene scene = busy_floor(CheckerFilter::closed);
  for (const Integrator integrator :
       {Integrator::cast, Integrator::whitted, Integrator::distributed, Integrator::path, Integrator::photons}) {
    CAPTURE(name_of(integrator));
    scene.render.integrator = integrator;
    scene.render.photons.count = 500;
    Recording recording;
    const auto plain = picture_by<T>(scene, 31, 21, {2, 5}, [&](const World<T>& world, const auto&... a) {
      return SceneKernel<T>(scene, world)(a...);
    });
    const auto watched = picture_by<T>(
        scene, 31, 21, {2, 5},
        [&](const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put) {
          return SceneKernel<T>(scene, world).watched(camera, block, recording, put);
        });
    CHECK(same_bits(plain, watched));
    CHECK(same_counts(plain.statistics, watched.statistics));
    Scene sharp = busy_floor(CheckerFilter::none);
    sharp.render.integrator = integrator;
    sharp.render.photons.count = 500;
    CHECK_FALSE(same_bits(plain, picture_by<T>(sharp, 31, 21, {2, 5}, [&](const World<T>& world, const auto&... a) {
                            return SceneKernel<T>(sharp, world)(a...);
                          })));
  }
}

TEST_CASE("n samples filter over a share of the pixel each, and agree with one") {
  // The mean of 16 samples, each over a sixteenth, is one over the whole, as far as footprints are parallelograms.
  Scene scene = floor_scene(CheckerFilter::closed);
  scene.render.integrator = Integrator::whitted;  // at fixed places
  const World<double> world(scene);
  constexpr int width = 80, height = 60;
  const auto one = picture<double>(scene, width, height);
  const RayGenerator<double> camera(scene, {width, height}, {width, height}, {16, 0});
  std::vector<double> mean(one.pixels.size());
  const PutPixel<double> put = [&](const Pixel& pixel, const Rgbd& shade) {
    mean[static_cast<std::size_t>(pixel.row * width + pixel.column)] += shade.x / 16;
  };
  for (int sample = 0; sample < 16; ++sample)
    static_cast<void>(trace(world, camera, PixelBlock{0, width, 0, height, sample}, put));
  double most = 0;
  for (int row = height / 2 + 8; row < height; ++row)  // below those where the footprint is far from one
    for (int column = 0; column < width; ++column)
      most = std::max(most, std::abs(mean[static_cast<std::size_t>(row * width + column)] - one.at(column, row).x));
  CAPTURE(most);
  CHECK(most < 0.06);
}

TEST_CASE("an image is filtered where a material asks for it") {
  auto image = std::make_shared<Image>(Image{32, 32, {}});
  for (int i = 0; i < 32 * 32; ++i) image->pixels.emplace_back((i / 32 + i) % 2 == 0 ? 1.0F : 0.0F);
  const auto sum_of_steps = [&](TextureFilter filter) {
    Scene scene = floor_scene(CheckerFilter::none);
    scene.objects[0].material.checker.reset();
    scene.objects[0].material.texture = ImageTexture{"squares.png", 16, 16, image, filter};
    const auto seen = picture<double>(scene, 80, 60);
    double steps = 0;
    for (int row = 32; row < 40; ++row)
      for (int column = 1; column < 80; ++column)
        steps += std::abs(seen.at(column, row).x - seen.at(column - 1, row).x);
    return steps;
  };
  const double none = sum_of_steps(TextureFilter::none);
  CHECK(none > 50);
  CHECK(sum_of_steps(TextureFilter::trilinear) < none / 20);
  CHECK(sum_of_steps(TextureFilter::ewa) < none / 4);
}
