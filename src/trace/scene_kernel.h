#pragma once
// The kernel of a scene's integrator: the tracer's own are in trace/kernel.h; those of other procedures are compiled
// here.

#include "trace/beam_faces.h"
#include "trace/cone_cover.h"
#include "trace/kernel.h"
#include "trace/path.h"
#include "trace/photon_kernel.h"
#include "trace/radiosity_kernel.h"

#include <memory>
#include <mutex>

namespace raywalk {

/// The path tracing settings of a scene.
[[nodiscard]] PathSettings path_settings_of(const Scene& scene);

/// Traces a scene's pixels with the procedure of its integrator. A fault of the tracer makes it the tracer's.
template <class T>
class SceneKernel {
 public:
  /// `world` is the scene's, and outlives this. `paths`: traces paths so, whatever the scene's integrator. `flat`:
  /// photons, the light of patches and cones stay in the plane.
  SceneKernel(const Scene& scene, const World<T>& world, const std::optional<PathSettings>& paths = std::nullopt,
              bool flat = false);

  Statistics operator()(const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put) const;
  /// Sends the photons that samples `first` to before `last` of the pixels need, if the scene is traced by photons.
  /// Else, or without this, whichever block comes first sends what it needs; blocks that are traced at the same time
  /// then have to be of the same samples.
  Statistics send_photons(std::uint64_t seed, int first, int last, const Stop& stop = {}, const RunAll& run_all = {},
                          const std::function<void(int photons)>& sent = {}) const;
  /// Null: the scene is traced in another way.
  [[nodiscard]] const PhotonKernel<T>* photons() const { return photons_ ? &photons_->kernel : nullptr; }
  /// Shoots the light of patches, if the scene is traced by radiosity or takes ambient light from it; else, or without
  /// this, whichever block comes first does.
  void shoot_light(const Stop& stop = {}, const Shooting& shooting = {}) const;
  /// Null: the scene is traced in another way.
  [[nodiscard]] const RadiosityKernel<T>* radiosity() const {
    return integrator_ == Integrator::radiosity ? &radiosity_->kernel : nullptr;
  }
  [[nodiscard]] bool shoots_light() const { return radiosity_ != nullptr; }
  /// Whether it traces cones, in a flat world.
  [[nodiscard]] bool has_flat_cones() const { return cones_ && cones_->flat; }
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
  Kernel<T> kernel_;                             ///< of the tracer
  std::unique_ptr<const Emitters<T>> emitters_;  ///< for path tracing and photon mapping
  struct Photons {
    Photons(const Scene& scene, const World<T>& world, const Emitters<T>& emitters, bool flat)
        : kernel(scene, world, emitters, photon_settings_of(scene, flat)) {}
    PhotonKernel<T> kernel;
    std::mutex sending;
  };
  std::unique_ptr<Photons> photons_;
  struct Radiosity {
    Radiosity(const Scene& scene, const World<T>& world, bool flat)
        : kernel(scene, world, radiosity_settings_of(scene, flat)) {}
    RadiosityKernel<T> kernel;
    std::mutex solving;
  };
  std::unique_ptr<Radiosity> radiosity_;  ///< also for ambient light
  struct Cones {
    ConeBodies bodies;
    bool flat;
  };
  std::unique_ptr<const Cones> cones_;
  std::unique_ptr<const BeamFaces> beams_;  ///< their faces, in space
  PathSettings settings_;
};

extern template class SceneKernel<float>;
extern template class SceneKernel<double>;

}  // namespace raywalk
