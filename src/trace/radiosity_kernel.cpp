#include "trace/radiosity_kernel.h"

#include "scene/effects.h"
#include "trace/radiosity.h"

namespace raywalk {

RadiositySettings radiosity_settings_of(const Scene& scene, bool flat) {
  const RadiosityChoices& choices = scene.render.radiosity;
  RadiositySettings settings;
  settings.patches.size = choices.patch.value_or(infinity<double>);
  settings.patches.flat = flat;
  settings.tolerance = choices.tolerance;
  settings.shots = choices.shots;
  settings.as_ambient = takes_ambient_from_patches(scene);
  return settings;
}

template <class T>
template <class Watcher>
Statistics RadiosityKernel<T>::run(const RayGenerator<T>& camera, const Shooting* shooting, const PixelBlock& block,
                                   const PutPixel<T>& put, Watcher& observer) const {
  const auto run_with = [&]<class Chosen>() {
    RadiosityTracer<Chosen> tracer(world_, *factors_, settings_, irradiance_, camera, observer, block.stop);
    tracer.main_algorithm(shooting, block, put);
    return tracer.statistics();
  };
  if constexpr (few_kernels && !Watcher::watches) {
    ForgetfulObserver forgetful;
    return run<Observer>(camera, shooting, block, put, forgetful);
  } else {
    if (world_.numerics == Numerics::naive)
      return run_with.template operator()<Policy<T, Watcher, all_hit_effects, Numerics::naive, true>>();
    if constexpr (!Watcher::watches)
      if (world_.surface_maps.empty()) return run_with.template operator()<Policy<T, Watcher, no_maps>>();
    return run_with.template operator()<Policy<T, Watcher>>();
  }
}

template <class T>
void RadiosityKernel<T>::solve(const Stop& stop, const Shooting& shooting) {
  if (solved_) return;
  patches_ = std::make_shared<const Patches>(scene_, settings_.patches, stop);
  factors_ = std::make_unique<FormFactors>(*patches_);
  state_ = shoot_light(*factors_, settings_, shooting, stop);
  irradiance_ = PatchIrradiance(*factors_, state_.lights, shooting.run_all, stop, settings_.as_ambient);
  bounced_ = BouncedLight(*patches_, irradiance_);
  solved_ = true;
}

template <class T>
Statistics RadiosityKernel<T>::operator()(const RayGenerator<T>& camera, const PixelBlock& block,
                                          const PutPixel<T>& put) const {
  NoObserver no_observer;
  return run(camera, nullptr, block, put, no_observer);
}

template <class T>
Statistics RadiosityKernel<T>::watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer,
                                       const PutPixel<T>& put) const {
  return run(camera, nullptr, block, put, observer);
}

template <class T>
void RadiosityKernel<T>::watch_shots(const Shooting& shooting, Observer& observer, const Stop& stop) const {
  PixelBlock none;
  none.stop = stop;
  static_cast<void>(run(camera_, &shooting, none, {}, observer));
}

template class RadiosityKernel<float>;
template class RadiosityKernel<double>;

}  // namespace raywalk
