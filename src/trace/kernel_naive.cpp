#include "trace/kernel_of.h"

namespace raywalk::detail {

namespace {

template <class T, class Watcher>
Statistics run(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put,
               Watcher& observer) {
  Tracer<Policy<T, Watcher, all_hit_effects, Numerics::naive>> tracer(world, camera, observer);
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

}  // namespace

template <class T>
Statistics run_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                            const PutPixel<T>& put) {
  NoObserver nobody;
  return run(world, camera, block, put, nobody);
}

template <class T>
Statistics run_watched_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                    const PutPixel<T>& put, Observer& observer) {
  return run(world, camera, block, put, observer);
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
