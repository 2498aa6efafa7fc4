#include "trace/kernel_of.h"

namespace raywalk {

Statistics trace(const World<float>& world, const RayGenerator<float>& camera, const PixelBlock& block,
                 const PutPixel<float>& put) {
  return detail::run_fitting_kernel(world, camera, block, put);
}

Statistics trace_watched(const World<float>& world, const RayGenerator<float>& camera, const PixelBlock& block,
                         const PutPixel<float>& put, Observer& observer) {
  return detail::run_watched_kernel(world, camera, block, put, observer);
}

}  // namespace raywalk
