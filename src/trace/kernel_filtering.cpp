#include "trace/kernel_of.h"

namespace raywalk::detail {

template <class T>
Kernel<T> filtering_kernel([[maybe_unused]] const World<T>& world) {
  if constexpr (!few_kernels) {
    const HitEffects set = hit_effects(world.effects, world.lights.size(), !world.bodies.empty());
    if (set.bounced) return &run_kernel<T, all_hit_effects>;
    if (!set.penumbra && !set.lobes && !set.nesting && !set.scattering && !set.sky && !set.microfacets && !set.maps)
      return set.reflection || set.refraction ? &run_kernel<T, plain_filtering> : &run_kernel<T, matt_filtering>;
    if (!set.maps) return &run_kernel<T, no_maps>;
  }
  return &run_kernel<T, all_hit_effects>;
}

template Kernel<float> filtering_kernel(const World<float>& world);
template Kernel<double> filtering_kernel(const World<double>& world);

}  // namespace raywalk::detail
