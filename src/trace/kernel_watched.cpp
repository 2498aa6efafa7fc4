#include "trace/kernel_of.h"

namespace raywalk {

Statistics trace_watched(const World<float>& world, const RayGenerator<float>& camera, const PixelBlock& block,
                         const PutPixel<float>& put, Observer& observer) {
  return detail::run_watched_kernel(world, camera, block, put, observer);
}

Statistics trace_watched(const World<double>& world, const RayGenerator<double>& camera, const PixelBlock& block,
                         const PutPixel<double>& put, Observer& observer) {
  return detail::run_watched_kernel(world, camera, block, put, observer);
}

}  // namespace raywalk
