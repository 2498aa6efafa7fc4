#include "trace/kernel_of.h"

namespace raywalk {

Kernel<double> kernel_for(const World<double>& world) { return detail::fitting_kernel(world); }

}  // namespace raywalk
