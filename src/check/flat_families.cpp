#include "check/shape_family.h"

namespace raywalk::check {

std::vector<Family> flat_families() {
  return {shape_family<Plane>(), shape_family<Box>(), shape_family<Triangle>(), shape_family<Polygon>(),
          shape_family<Prism>()};
}

}  // namespace raywalk::check
