#pragma once
// Path tracing's compiled kernels, as trace/kernel.h has them for the tracer.

#include "trace/kernel.h"
#include "trace/path.h"

namespace raywalk {

/// Runs PATH TRACING over a block.
[[nodiscard]] Statistics trace_paths(const World<float>& world, const PathLights<float>& lights,
                                     const PathSettings& settings, const RayGenerator<float>& camera,
                                     const PixelBlock& block, const PutPixel<float>& put);
[[nodiscard]] Statistics trace_paths(const World<double>& world, const PathLights<double>& lights,
                                     const PathSettings& settings, const RayGenerator<double>& camera,
                                     const PixelBlock& block, const PutPixel<double>& put);

/// The same, watched by `observer`: same bits, same statistics.
Statistics trace_paths_watched(const World<float>& world, const PathLights<float>& lights, const PathSettings& settings,
                               const RayGenerator<float>& camera, const PixelBlock& block, const PutPixel<float>& put,
                               Observer& observer);
Statistics trace_paths_watched(const World<double>& world, const PathLights<double>& lights,
                               const PathSettings& settings, const RayGenerator<double>& camera,
                               const PixelBlock& block, const PutPixel<double>& put, Observer& observer);

/// How far the paths of a scene go.
[[nodiscard]] PathSettings path_settings_of(const Scene& scene);

/// What traces a scene's pixels: the tracer, or the path tracer where that is the scene's integrator. What is broken on
/// purpose is always the tracer.
template <class T>
class SceneKernel {
 public:
  /// `world` is the scene's, and outlives this.
  SceneKernel(const Scene& scene, const World<T>& world) : world_(world) {
    if (scene.render.integrator == Integrator::path && !world.fault)
      lights_.emplace(world), settings_ = path_settings_of(scene);
  }
  [[nodiscard]] Statistics operator()(const RayGenerator<T>& camera, const PixelBlock& block,
                                      const PutPixel<T>& put) const {
    return lights_ ? trace_paths(world_, *lights_, settings_, camera, block, put) : trace(world_, camera, block, put);
  }
  /// The same with nobody to put the shades, watched by `observer`.
  void watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer) const {
    const PutPixel<T> nowhere = [](const Pixel&, const Rgb<T>&) {};
    if (lights_)
      trace_paths_watched(world_, *lights_, settings_, camera, block, nowhere, observer);
    else
      trace_watched(world_, camera, block, nowhere, observer);
  }

 private:
  const World<T>& world_;
  std::optional<PathLights<T>> lights_;  ///< for path tracing
  PathSettings settings_;
};

}  // namespace raywalk
