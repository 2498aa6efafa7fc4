#include "trace/scene_kernel.h"

#include "scene/beam_limits.h"
#include "scene/cone_limits.h"
#include "trace/beam_scene.h"
#include "trace/cone_kernel.h"
#include "trace/cone_scene.h"
#include "trace/pencil_kernel.h"
#include "trace/space_beam_kernel.h"

namespace raywalk {

namespace {

/// Runs a procedure, such as PathTracer, over a block. `own`: what it takes beside the world.
template <template <class> class Procedure, class T, class Watcher, class... Own>
Statistics run_procedure(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                         const PutPixel<T>& put, Watcher& observer, const Own&... own) {
  const auto run_with = [&]<class Chosen>() {
    Procedure<Chosen> procedure(world, own..., camera, observer, block.stop);
    if constexpr (std::is_same_v<typename Chosen::Ray, Ray<T>>) procedure.look_ahead(block);
    procedure.main_algorithm(block, put);
    return procedure.statistics();
  };
  constexpr auto without = [](auto... members) {
    HitEffects set = no_filtering_nor_facets;
    ((set.*members = false), ...);
    return set;
  };
  [[maybe_unused]] constexpr HitEffects clear = without(&HitEffects::scattering),
                                        no_sky = without(&HitEffects::scattering, &HitEffects::sky),
                                        neither =
                                            without(&HitEffects::scattering, &HitEffects::sky, &HitEffects::nesting);
  if constexpr (few_kernels && !Watcher::watches) {
    if (world.numerics == Numerics::naive) {
      ForgetfulObserver forgetful;
      return run_procedure<Procedure, T, Observer>(world, camera, block, put, forgetful, own...);
    }
  } else if (world.numerics == Numerics::naive) {
    return run_with.template operator()<Policy<T, Watcher, all_hit_effects, Numerics::naive, true>>();
  }
  if constexpr (!Watcher::watches) {
    if (!world.dipoles.empty()) return run_with.template operator()<Policy<T, Watcher>>();
    constexpr HitEffects no_dipole{.dipole = few_kernels};
    if (!world.surface_maps.empty()) return run_with.template operator()<Policy<T, Watcher, no_dipole>>();
    const bool filters = world.filters(), scatters = world.effects.used(Effect::scattering);
    const bool facets = !world.microsurfaces.empty();
    if (!filters && !facets && !scatters && !world.sky && world.bodies.empty())
      return run_with.template operator()<Policy<T, Watcher, neither>>();
    if constexpr (!few_kernels) {
      if (!filters && facets) return run_with.template operator()<Policy<T, Watcher, no_filtering>>();
      if (!filters && scatters) return run_with.template operator()<Policy<T, Watcher, no_filtering_nor_facets>>();
      if (!filters && !world.sky) return run_with.template operator()<Policy<T, Watcher, no_sky>>();
      if (!filters) return run_with.template operator()<Policy<T, Watcher, clear>>();
      return run_with.template operator()<Policy<T, Watcher, no_maps>>();
    }
  }
  return run_with.template operator()<Policy<T, Watcher>>();
}

}  // namespace

PathSettings path_settings_of(const Scene& scene) {
  PathSettings settings;
  settings.max_length = scene.render.path_length.value_or(0);
  return settings;
}

template <class T>
SceneKernel<T>::SceneKernel(const Scene& scene, const World<T>& world, const std::optional<PathSettings>& paths,
                            bool flat)
    : world_(world),
      integrator_(paths                                                                 ? Integrator::path
                  : world.fault && integrator_of(*world.fault) == Integrator::automatic ? Integrator::automatic
                                                                                        : scene.render.integrator),
      kernel_(kernel_for(world)),
      settings_(paths.value_or(path_settings_of(scene))) {
  if (traits_of(integrator_).is_global && integrator_ != Integrator::radiosity)
    emitters_ = std::make_unique<const Emitters<T>>(world);
  if (integrator_ == Integrator::photons) photons_ = std::make_unique<Photons>(scene, world, *emitters_, flat);
  if (integrator_ == Integrator::cones && why_no_cones(scene).empty())
    cones_ = std::make_unique<const Cones>(Cones{cone_bodies_of(scene, flat), flat});
  if (integrator_ == Integrator::beams && !flat && why_no_space_beams(scene).empty())
    beams_ = std::make_unique<const BeamFaces>(beam_faces_of(scene));
  const bool as_ambient = !paths && !world.fault && takes_ambient_from_patches(scene);
  if (integrator_ == Integrator::radiosity || as_ambient)
    radiosity_ = std::make_unique<Radiosity>(scene, world, flat && !as_ambient);
}

template <class T>
Statistics SceneKernel<T>::send_photons(std::uint64_t seed, int first, int last, const Stop& stop,
                                        const RunAll& run_all, const std::function<void(int)>& sent) const {
  if (!photons_) return {};
  const std::lock_guard lock(photons_->sending);
  if (photons_->kernel.ready_for(seed, first, last)) return {};
  return photons_->kernel.send(seed, first, last, stop, run_all, sent);
}

template <class T>
void SceneKernel<T>::shoot_light(const Stop& stop, const Shooting& shooting) const {
  if (!radiosity_) return;
  const std::lock_guard lock(radiosity_->solving);
  radiosity_->kernel.solve(stop, shooting);
}

template <class T>
template <class Watcher>
Statistics SceneKernel<T>::run(const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put,
                               Watcher& observer) const {
  if (integrator_ == Integrator::path)
    return run_procedure<PathTracer>(world_, camera, block, put, observer, *emitters_, settings_);
  if (photons_) {
    Statistics statistics =
        send_photons(camera.sampling().seed, block.sample, block.sample + block.samples, block.stop);
    if constexpr (Watcher::watches)
      statistics += photons_->kernel.watched(camera, block, observer, put);
    else
      statistics += photons_->kernel(camera, block, put);
    return statistics;
  }
  if (cones_) {
    if constexpr (Watcher::watches)
      return trace_cones_watched(world_, cones_->bodies, cones_->flat, camera, block, put, observer);
    else
      return trace_cones(world_, cones_->bodies, cones_->flat, camera, block, put);
  }
  if (beams_) {
    if constexpr (Watcher::watches)
      return trace_space_beams_watched(world_, *beams_, camera, block, put, observer);
    else
      return trace_space_beams(world_, *beams_, camera, block, put);
  }
  if (radiosity_) shoot_light(block.stop);
  if (integrator_ == Integrator::radiosity) {
    if constexpr (Watcher::watches)
      return radiosity_->kernel.watched(camera, block, observer, put);
    else
      return radiosity_->kernel(camera, block, put);
  }
  PixelBlock lit = block;
  if (radiosity_) lit.bounced = &radiosity_->kernel.bounced();
  if constexpr (Watcher::watches)
    return integrator_ == Integrator::pencils ? trace_pencils_watched(world_, camera, lit, put, observer)
                                              : trace_watched(world_, camera, lit, put, observer);
  else
    return kernel_(world_, camera, lit, put);
}

template <class T>
Statistics SceneKernel<T>::operator()(const RayGenerator<T>& camera, const PixelBlock& block,
                                      const PutPixel<T>& put) const {
  NoObserver no_observer;
  return run(camera, block, put, no_observer);
}

template <class T>
Statistics SceneKernel<T>::watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer,
                                   const PutPixel<T>& put) const {
  return run(camera, block, put, observer);
}

template class SceneKernel<float>;
template class SceneKernel<double>;

}  // namespace raywalk
