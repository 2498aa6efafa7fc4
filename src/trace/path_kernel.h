#pragma once
// Path tracing's compiled kernels, as trace/kernel.h has them for the tracer.

#include "trace/kernel.h"
#include "trace/path.h"

namespace raywalk {

/// Runs PATH TRACING over a block.
[[nodiscard]] Statistics trace_paths(const World<float>& world, const Emitters<float>& emitters,
                                     const PathSettings& settings, const RayGenerator<float>& camera,
                                     const PixelBlock& block, const PutPixel<float>& put);
[[nodiscard]] Statistics trace_paths(const World<double>& world, const Emitters<double>& emitters,
                                     const PathSettings& settings, const RayGenerator<double>& camera,
                                     const PixelBlock& block, const PutPixel<double>& put);

/// The same, observed by `observer`: same bits, same statistics.
Statistics trace_paths_watched(const World<float>& world, const Emitters<float>& emitters, const PathSettings& settings,
                               const RayGenerator<float>& camera, const PixelBlock& block, const PutPixel<float>& put,
                               Observer& observer);
Statistics trace_paths_watched(const World<double>& world, const Emitters<double>& emitters,
                               const PathSettings& settings, const RayGenerator<double>& camera,
                               const PixelBlock& block, const PutPixel<double>& put, Observer& observer);

/// The path tracing settings of a scene.
[[nodiscard]] PathSettings path_settings_of(const Scene& scene);

/// Traces a scene's pixels: with the tracer, or with the path tracer if that is the scene's integrator. Faults exist
/// only in the tracer.
template <class T>
class SceneKernel {
 public:
  /// `world` is the scene's, and outlives this. `paths`: traces paths so, whatever the scene's integrator.
  SceneKernel(const Scene& scene, const World<T>& world, const std::optional<PathSettings>& paths = std::nullopt)
      : world_(world), kernel_(kernel_for(world)) {
    if (paths || (scene.render.integrator == Integrator::path && !world.fault))
      emitters_.emplace(world), settings_ = paths.value_or(path_settings_of(scene));
  }
  [[nodiscard]] Statistics operator()(const RayGenerator<T>& camera, const PixelBlock& block,
                                      const PutPixel<T>& put) const {
    return emitters_ ? trace_paths(world_, *emitters_, settings_, camera, block, put)
                     : kernel_(world_, camera, block, put);
  }
  /// The same without output, observed by `observer`.
  void watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer) const {
    const PutPixel<T> nowhere = [](const Pixel&, const Rgb<T>&) {};
    if (emitters_)
      trace_paths_watched(world_, *emitters_, settings_, camera, block, nowhere, observer);
    else
      trace_watched(world_, camera, block, nowhere, observer);
  }

 private:
  const World<T>& world_;
  Kernel<T> kernel_;
  std::optional<Emitters<T>> emitters_;  ///< for path tracing
  PathSettings settings_;
};

}  // namespace raywalk
