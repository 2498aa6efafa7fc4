#include "check/shape_family.h"

namespace raywalk::check {

void add_flat_shapes(ShapeFamilies& all) {
  add_shapes<Plane, Box, Triangle, Polygon, Prism>(all);
  add_invariances<Plane, Box>(all);
}

}  // namespace raywalk::check
