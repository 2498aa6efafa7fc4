#include "trace/kernel_of.h"

namespace raywalk::detail {

template <class T>
Kernel<T> filtering_kernel(const World<T>& world) {
  const HitEffects set = hit_effects(world.effects, world.lights.size(), !world.bodies.empty());
  const bool plain = !set.penumbra && !set.lobes && !set.nesting && !set.scattering && !set.sky && !set.microfacets;
  return plain ? &run_kernel<T, plain_filtering> : &run_kernel<T, all_hit_effects>;
}

template Kernel<float> filtering_kernel(const World<float>& world);
template Kernel<double> filtering_kernel(const World<double>& world);

}  // namespace raywalk::detail
