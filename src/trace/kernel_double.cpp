#include "trace/kernel_of.h"

namespace raywalk {

Statistics trace(const World<double>& world, const RayGenerator<double>& camera, const PixelBlock& block,
                 const PutPixel<double>& put) {
  return detail::run_fitting_kernel(world, camera, block, put);
}

Statistics trace_watched(const World<double>& world, const RayGenerator<double>& camera, const PixelBlock& block,
                         const PutPixel<double>& put, Observer& observer) {
  return detail::run_watched_kernel(world, camera, block, put, observer);
}

}  // namespace raywalk
