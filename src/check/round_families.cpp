#include "check/shape_family.h"

namespace raywalk::check {

std::vector<Family> round_families() { return {shape_family<Sphere>(), shape_family<Disk>()}; }

}  // namespace raywalk::check
