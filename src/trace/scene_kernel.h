#pragma once
// The kernel of a scene's integrator: the tracer's own are in trace/kernel.h; those of other procedures are compiled
// here.

#include "trace/kernel.h"
#include "trace/path.h"

namespace raywalk {

/// The path tracing settings of a scene.
[[nodiscard]] PathSettings path_settings_of(const Scene& scene);

/// Traces a scene's pixels with the procedure of its integrator. Faults exist only in the tracer.
template <class T>
class SceneKernel {
 public:
  /// `world` is the scene's, and outlives this. `paths`: traces paths so, whatever the scene's integrator.
  SceneKernel(const Scene& scene, const World<T>& world, const std::optional<PathSettings>& paths = std::nullopt);

  Statistics operator()(const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put) const;
  /// The same observed by `observer`: same bits, same statistics.
  Statistics watched(
      const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer,
      const PutPixel<T>& put = [](const Pixel&, const Rgb<T>&) {}) const;

 private:
  template <class Watcher>
  Statistics run(const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put,
                 Watcher& observer) const;

  const World<T>& world_;
  Integrator integrator_;
  Kernel<T> kernel_;                     ///< of the tracer
  std::optional<Emitters<T>> emitters_;  ///< for path tracing
  PathSettings settings_;
};

extern template class SceneKernel<float>;
extern template class SceneKernel<double>;

}  // namespace raywalk
