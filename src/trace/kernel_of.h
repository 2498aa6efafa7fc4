#pragma once
// Selects and instantiates the kernels of one scalar type; included by one .cpp per scalar.

#include "trace/kernel.h"
#include "trace/tracer.h"

namespace raywalk::detail {

template <class Policy, class T>
Statistics run_tracer(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put, typename Policy::Observer& observer) {
  Tracer<Policy> tracer(world, camera, observer, block.stop);
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

/// With all effects: these are for study, need not be fast, and give the same bits. In a .cpp of their own, as are the
/// faulty kernels.
template <class T>
Statistics run_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                            const PutPixel<T>& put);
template <class T>
Statistics run_watched_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                    const PutPixel<T>& put, Observer& observer);
template <class T>
Statistics run_faulty_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                             const PutPixel<T>& put);
template <class T>
Statistics run_watched_faulty_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                     const PutPixel<T>& put, Observer& observer);

template <class T, HitEffects Set>
Statistics run_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put) {
  NoObserver no_observer;
  return run_tracer<Policy<T, NoObserver, Set>>(world, camera, block, put, no_observer);
}

/// There is no refraction without reflection (total internal reflection), nor lobes without it, nor nesting without
/// refraction: seven sets.
template <class T, bool Textures, bool Penumbra, bool Shadows>
Statistics run_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put) {
  const HitEffects set = hit_effects(world.effects, !world.bodies.empty());
  const auto run = [&]<bool Reflection, bool Refraction, bool Lobes, bool Nesting = false>() {
    return run_kernel<T, HitEffects{Reflection, Refraction, Textures, Penumbra, Lobes, Shadows, Nesting}>(world, camera,
                                                                                                          block, put);
  };
  if (set.nesting)
    return set.lobes ? run.template operator()<true, true, true, true>()
                     : run.template operator()<true, true, false, true>();
  if (set.lobes)
    return set.refraction ? run.template operator()<true, true, true>() : run.template operator()<true, false, true>();
  if (set.refraction) return run.template operator()<true, true, false>();
  if (set.reflection) return run.template operator()<true, false, false>();
  return run.template operator()<false, false, false>();
}

/// Each with or without textures, and with shadows, shadows and penumbras, or neither: forty-two sets. Nesting is a set
/// of its own: where nothing nests, a mere test at each hit would cost more than 0.1%.
template <class T>
Statistics run_fitting_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                              const PutPixel<T>& put) {
  if (world.numerics == Numerics::naive) return run_naive_kernel(world, camera, block, put);
  const HitEffects set = hit_effects(world.effects, !world.bodies.empty());
  const auto run = [&]<bool Penumbra, bool Shadows>() {
    return set.textures ? run_kernel<T, true, Penumbra, Shadows>(world, camera, block, put)
                        : run_kernel<T, false, Penumbra, Shadows>(world, camera, block, put);
  };
  if (set.penumbra) return run.template operator()<true, true>();
  return set.shadows ? run.template operator()<false, true>() : run.template operator()<false, false>();
}

template <class T>
Statistics run_watched_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                              const PutPixel<T>& put, Observer& observer) {
  if (world.numerics == Numerics::naive) return run_watched_naive_kernel(world, camera, block, put, observer);
  return run_tracer<Policy<T, Observer>>(world, camera, block, put, observer);
}

}  // namespace raywalk::detail
