// Paths for the path tracer's tests: pictures, means with their deviations, recordings.
#pragma once

#include "trace/pictures.h"
#include "trace/scene_kernel.h"

#include <cmath>

namespace raywalk::test {

// As PathSettings::roulette_from: no path is ended by chance.
inline constexpr int never = 1 << 30;

inline Scene by_path(Scene scene, Sampler sampler = Sampler::random) {
  scene.render.integrator = Integrator::path;
  scene.render.sampler = sampler;
  return scene;
}

template <class T>
Picture<T> path_picture(const Scene& scene, int width, int height, const PathSettings& settings = {},
                        Sampling sampling = {}, Observer* observer = nullptr) {
  return picture_by<T>(by_path(scene, scene.render.sampler), width, height, sampling,
                       [&](const World<T>& world, const auto& camera, const PixelBlock& block, const PutPixel<T>& put) {
                         const SceneKernel<T> kernel(scene, world, settings);
                         return observer ? kernel.watched(camera, block, *observer, put) : kernel(camera, block, put);
                       });
}

// Mean of many samples of each pixel, and the variance of one sample.
struct Estimates {
  std::vector<Rgbd> mean, variance;
  int samples = 0;
  Statistics statistics;
  // Standard error of a pixel's mean.
  [[nodiscard]] double error(std::size_t pixel, int channel = 0) const {
    return std::sqrt(variance[pixel][channel] / samples);
  }
  [[nodiscard]] double total_variance() const {
    double sum = 0;
    for (const Rgbd& v : variance) sum += v.x + v.y + v.z;
    return sum;
  }
};

// `run(world, camera, block, put)` is one of the kernels in double.
template <class Run>
Estimates estimates_by(const Scene& scene, int width, int height, int samples, std::uint64_t seed, Run run) {
  const auto count = static_cast<std::size_t>(width * height);
  Estimates estimates{std::vector<Rgbd>(count, Rgbd(0.0)), std::vector<Rgbd>(count, Rgbd(0.0)), samples, {}};
  const World<double> world(scene);
  const RayGenerator<double> camera(scene, {width, height}, {width, height}, {samples, seed});
  for (int sample = 0; sample < samples; ++sample) {
    const PutPixel<double> put = [&](const Pixel& pixel, const Rgbd& shade) {
      const auto i = static_cast<std::size_t>(pixel.row * width + pixel.column);
      const Rgbd step = shade - estimates.mean[i];
      estimates.mean[i] += step / static_cast<double>(sample + 1);
      estimates.variance[i] += step * (shade - estimates.mean[i]);
    };
    estimates.statistics += run(world, camera, PixelBlock{0, width, 0, height, sample}, put);
  }
  for (Rgbd& v : estimates.variance) v /= static_cast<double>(samples - 1);
  return estimates;
}

inline Estimates path_estimates(const Scene& scene, int width, int height, int samples,
                                const PathSettings& settings = {}, std::uint64_t seed = 0) {
  const Scene own = by_path(scene, scene.render.sampler);
  const World<double> world(own);
  const SceneKernel<double> kernel(own, world, settings);
  return estimates_by(own, width, height, samples, seed,
                      [&](const auto& /*same*/, const auto& camera, const PixelBlock& block, const auto& put) {
                        return kernel(camera, block, put);
                      });
}

struct Estimate {
  Rgbd mean;
  double error;  // standard error of the red channel
};

// What comes along one ray, by many paths.
inline Estimate light_along(Scene scene, const Vec3d& eye, const Vec3d& target, int samples,
                            const PathSettings& settings = {}, std::uint64_t seed = 0) {
  scene.camera.screen = {1, 1e-9, 1};
  scene.camera.fov.reset();
  const Estimates estimates = path_estimates(looking(scene, eye, target), 1, 1, samples, settings, seed);
  return {estimates.mean[0], estimates.error(0)};
}

inline Material matte(double albedo, double emission = 0) {
  Material material;
  material.diffuse = Rgbd(albedo);
  material.emission = Rgbd(emission);
  return material;
}

}  // namespace raywalk::test
