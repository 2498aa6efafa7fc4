// Photon mapping for its tests: small scenes, and what comes along single rays.
#pragma once

#include "support/catch.h"
#include "trace/paths.h"
#include "trace/pictures.h"
#include "trace/sampled.h"
#include "trace/scene_kernel.h"

#include <cmath>
#include <vector>

namespace raywalk::test {

inline Scene by_photons(Scene scene, int count, int nearest) {
  scene.render.integrator = Integrator::photons;
  scene.render.photons.count = count;
  scene.render.photons.nearest = nearest;
  scene.background = Rgbd(0.0);
  scene.ambient = Rgbd(0.0);
  return scene;
}

inline Material matt(double albedo, double emission = 0) {
  Material material;
  material.diffuse = Rgbd(albedo);
  material.emission = Rgbd(emission);
  return material;
}

/// A ball seen from inside, with a lamp that weakens by this law.
inline Scene hollow_ball(double radius, double albedo, const Vec3d& lamp, const Attenuation& law) {
  Scene scene;
  scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, radius}, matt(albedo)}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{lamp, law}}};
  scene.camera.eye = {0.1, 0.2, 0};
  scene.camera.look_at = {1, 0.2, 0};
  scene.camera.up = {0, 0, 1};
  scene.camera.screen = {1, 3, 8};
  return scene;
}

struct Means {
  double mean = 0, error = 0;  ///< of the red channel: over all pixels and seeds, each seed one value
};
inline Means means_of(const std::vector<double>& values) {
  const auto seeds = static_cast<double>(values.size());
  Means means;
  for (const double value : values) means.mean += value / seeds;
  double squares = 0;
  for (const double value : values) squares += (value - means.mean) * (value - means.mean);
  means.error = std::sqrt(squares / (seeds - 1) / seeds);
  return means;
}
/// The mean of one picture.
inline double mean_of_picture(const SceneKernel<double>& kernel, const Scene& scene, ImageSize size, int samples,
                              std::uint64_t seed) {
  const RayGenerator<double> camera(scene, size, size, {samples, seed});
  double sum = 0;
  const PutPixel<double> put = [&](const Pixel&, const Rgbd& shade) { sum += shade.x; };
  static_cast<void>(kernel(camera, PixelBlock{0, size.width, 0, size.height, 0, 1, samples}, put));
  return sum / (size.width * size.height * samples);
}
/// The mean of a picture over seeds. `of`: 3-D or flat.
inline Means mean_of_pictures(const Scene& scene, int width, int height, int samples, int seeds, bool flat = false) {
  const World<double> world(scene);
  const SceneKernel<double> kernel(scene, world, std::nullopt, flat);
  std::vector<double> values;
  for (int seed = 0; seed < seeds; ++seed)
    values.push_back(mean_of_picture(kernel, scene, {width, height}, samples, static_cast<std::uint64_t>(seed)));
  return means_of(values);
}

/// Photons, with and without final gathering, bring on average what paths brought to 10 x 10 pixels. `precise`: the
/// most that their own error may be, of the truth.
inline void check_against_paths(Scene scene, const Estimates& paths, double precise = 0.02) {
  double truth = 0, error = 0;
  for (std::size_t i = 0; i < paths.mean.size(); ++i) {
    truth += paths.mean[i].x / static_cast<double>(paths.mean.size());
    error += paths.variance[i].x / paths.samples / std::pow(static_cast<double>(paths.mean.size()), 2);
  }
  for (const bool gather : {false, true}) {
    scene.render.photons.gather = gather;
    const Means photons = mean_of_pictures(scene, 10, 10, 16, 8);
    CAPTURE(gather, truth, std::sqrt(error), photons.mean, photons.error);
    CHECK(photons.error < precise * truth);
    // Circles blur what is near an edge: one percent.
    CHECK(std::abs(photons.mean - truth) < 4 * (std::sqrt(error) + photons.error) + 0.01 * truth);
  }
}

}  // namespace raywalk::test
