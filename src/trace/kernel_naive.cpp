#include "trace/kernel_of.h"

namespace raywalk::detail {

template <class T>
Statistics run_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                            const PutPixel<T>& put) {
  if constexpr (few_kernels) {
    ForgetfulObserver observer;
    return run_watched_naive_kernel(world, camera, block, put, observer);
  } else {
    if (world.fault) return run_faulty_kernel(world, camera, block, put);
    NoObserver no_observer;
    return run_tracer<Policy<T, NoObserver, all_hit_effects, Numerics::naive>>(world, camera, block, put, no_observer);
  }
}

template <class T>
Statistics run_watched_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                    const PutPixel<T>& put, Observer& observer) {
  if (world.fault) return run_watched_faulty_kernel(world, camera, block, put, observer);
  return run_tracer<Policy<T, Observer, all_hit_effects, Numerics::naive>>(world, camera, block, put, observer);
}

#define RAYWALK_NAIVE_KERNELS(T)                                                                           \
  template Statistics run_naive_kernel(const World<T>&, const RayGenerator<T>&, const PixelBlock&,         \
                                       const PutPixel<T>&);                                                \
  template Statistics run_watched_naive_kernel(const World<T>&, const RayGenerator<T>&, const PixelBlock&, \
                                               const PutPixel<T>&, Observer&);
RAYWALK_NAIVE_KERNELS(float)
RAYWALK_NAIVE_KERNELS(double)
#undef RAYWALK_NAIVE_KERNELS

}  // namespace raywalk::detail
