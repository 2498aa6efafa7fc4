#include "trace/kernel_of.h"

namespace raywalk {

Kernel<float> kernel_for(const World<float>& world) { return detail::fitting_kernel(world); }

Statistics trace_watched(const World<float>& world, const RayGenerator<float>& camera, const PixelBlock& block,
                         const PutPixel<float>& put, Observer& observer) {
  return detail::run_watched_kernel(world, camera, block, put, observer);
}

}  // namespace raywalk
