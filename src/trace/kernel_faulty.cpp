// One kernel for all faults: which of them is at work, its hooks ask the world.

#include "trace/kernel_of.h"

namespace raywalk::detail {

template <class T>
Statistics run_faulty_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                             const PutPixel<T>& put) {
  if constexpr (few_kernels) {
    ForgetfulObserver observer;
    return run_watched_faulty_kernel(world, camera, block, put, observer);
  } else {
    NoObserver no_observer;
    return run_tracer<Policy<T, NoObserver, all_hit_effects, Numerics::naive, true>>(world, camera, block, put,
                                                                                     no_observer);
  }
}

template <class T>
Statistics run_watched_faulty_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                     const PutPixel<T>& put, Observer& observer) {
  return run_tracer<Policy<T, Observer, all_hit_effects, Numerics::naive, true>>(world, camera, block, put, observer);
}

#define RAYWALK_FAULTY_KERNELS(T)                                                                           \
  template Statistics run_faulty_kernel(const World<T>&, const RayGenerator<T>&, const PixelBlock&,         \
                                        const PutPixel<T>&);                                                \
  template Statistics run_watched_faulty_kernel(const World<T>&, const RayGenerator<T>&, const PixelBlock&, \
                                                const PutPixel<T>&, Observer&);
RAYWALK_FAULTY_KERNELS(float)
RAYWALK_FAULTY_KERNELS(double)
#undef RAYWALK_FAULTY_KERNELS

}  // namespace raywalk::detail
