#include "trace/kernel_of.h"

namespace raywalk {

Kernel<double> kernel_for(const World<double>& world) { return detail::fitting_kernel(world); }

Statistics trace_watched(const World<double>& world, const RayGenerator<double>& camera, const PixelBlock& block,
                         const PutPixel<double>& put, Observer& observer) {
  return detail::run_watched_kernel(world, camera, block, put, observer);
}

}  // namespace raywalk
