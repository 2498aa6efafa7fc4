#pragma once
// Chooses and instantiates the kernels of one scalar type; included by one .cpp a scalar.

#include "trace/kernel.h"
#include "trace/tracer.h"

namespace raywalk::detail {

template <class T, HitEffects Set>
Statistics run_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put) {
  NoObserver nobody;
  Tracer<Policy<T, NoObserver, Set>> tracer(world, camera, nobody);
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

/// Refraction never comes without reflection (total internal reflection), nor do lobes: five sets, each with or without
/// textures and penumbras.
template <class T, bool Textures, bool Penumbra>
Statistics run_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put) {
  const HitEffects set = hit_effects(world.effects);
  if (set.lobes)
    return set.refraction ? run_kernel<T, HitEffects{true, true, Textures, Penumbra, true}>(world, camera, block, put)
                          : run_kernel<T, HitEffects{true, false, Textures, Penumbra, true}>(world, camera, block, put);
  if (set.refraction)
    return run_kernel<T, HitEffects{true, true, Textures, Penumbra, false}>(world, camera, block, put);
  if (set.reflection)
    return run_kernel<T, HitEffects{true, false, Textures, Penumbra, false}>(world, camera, block, put);
  return run_kernel<T, HitEffects{false, false, Textures, Penumbra, false}>(world, camera, block, put);
}

template <class T>
Statistics run_fitting_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                              const PutPixel<T>& put) {
  const HitEffects set = hit_effects(world.effects);
  if (set.textures)
    return set.penumbra ? run_kernel<T, true, true>(world, camera, block, put)
                        : run_kernel<T, true, false>(world, camera, block, put);
  return set.penumbra ? run_kernel<T, false, true>(world, camera, block, put)
                      : run_kernel<T, false, false>(world, camera, block, put);
}

template <class T>
Statistics run_watched_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                              const PutPixel<T>& put, Observer& observer) {
  Tracer<Policy<T, Observer, all_hit_effects>> tracer(world, camera, observer);
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

}  // namespace raywalk::detail
