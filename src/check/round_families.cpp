#include "check/shape_family.h"

namespace raywalk::check {

void add_round_shapes(ShapeFamilies& all) {
  add_shapes<Sphere, Disk>(all);
  add_invariances<Sphere, Disk>(all);
}

}  // namespace raywalk::check
