#include "trace/path_kernel.h"

namespace raywalk {

namespace {

template <class T, class Watcher>
Statistics run(const World<T>& world, const Emitters<T>& emitters, const PathSettings& settings,
               const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put, Watcher& observer) {
  const auto run_with = [&](auto tracer) {
    tracer.main_algorithm(block, put);
    return tracer.statistics();
  };
  constexpr HitEffects no_nesting{.nesting = false};
  using Robust = Policy<T, Watcher, no_nesting>;
  using Nesting = Policy<T, Watcher>;
  using Naive = Policy<T, Watcher, all_hit_effects, Numerics::naive>;
  const auto run_as = [&]<class Own>() {
    return run_with(PathTracer<Own>(world, emitters, settings, camera, observer, block.stop));
  };
  if (world.numerics == Numerics::naive) return run_as.template operator()<Naive>();
  return world.bodies.empty() ? run_as.template operator()<Robust>() : run_as.template operator()<Nesting>();
}

}  // namespace

PathSettings path_settings_of(const Scene& scene) {
  PathSettings settings;
  settings.max_length = scene.render.path_length.value_or(0);
  return settings;
}

Statistics trace_paths(const World<float>& world, const Emitters<float>& emitters, const PathSettings& settings,
                       const RayGenerator<float>& camera, const PixelBlock& block, const PutPixel<float>& put) {
  NoObserver no_observer;
  return run(world, emitters, settings, camera, block, put, no_observer);
}

Statistics trace_paths(const World<double>& world, const Emitters<double>& emitters, const PathSettings& settings,
                       const RayGenerator<double>& camera, const PixelBlock& block, const PutPixel<double>& put) {
  NoObserver no_observer;
  return run(world, emitters, settings, camera, block, put, no_observer);
}

Statistics trace_paths_watched(const World<float>& world, const Emitters<float>& emitters, const PathSettings& settings,
                               const RayGenerator<float>& camera, const PixelBlock& block, const PutPixel<float>& put,
                               Observer& observer) {
  return run(world, emitters, settings, camera, block, put, observer);
}

Statistics trace_paths_watched(const World<double>& world, const Emitters<double>& emitters,
                               const PathSettings& settings, const RayGenerator<double>& camera,
                               const PixelBlock& block, const PutPixel<double>& put, Observer& observer) {
  return run(world, emitters, settings, camera, block, put, observer);
}

}  // namespace raywalk
