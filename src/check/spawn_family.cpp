#include "check/spawn.h"

#include "check/family.h"

namespace raywalk::check {

namespace {

template <template <class> class S>
void add(Family& family) {
  const std::string name(shape_name(S<double>{}));
  family.lines.push_back({name, "float", spawn<S<float>, float>, {}});
  family.lines.push_back({name, "double", spawn<S<double>, double>, {}});
}

template <template <class> class... Shapes>
void add_all(Family& family) {
  (add<Shapes>(family), ...);
}

}  // namespace

std::vector<Family> spawn_families() {
  Family family{"spawned", "", {}};
  add_all<Sphere, Plane, Disk, Box, Triangle, Polygon, Ellipsoid, EllipticParaboloid, Cone, Cylinder,
          HyperboloidOneSheet, HyperboloidTwoSheets>(family);
  Family prisms{"spawned_polygon", "", {}};
  add<Prism>(prisms);
  return {family, prisms};
}

}  // namespace raywalk::check
