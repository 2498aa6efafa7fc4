#include "trace/kernel_of.h"

namespace raywalk {

Kernel<float> kernel_for(const World<float>& world) { return detail::fitting_kernel(world); }

}  // namespace raywalk
