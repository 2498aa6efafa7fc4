#include "check/normal.h"

#include "check/family.h"

namespace raywalk::check {

namespace {

template <template <class> class S>
void add(Family& family) {
  const std::string name(shape_name(S<double>{}));
  family.lines.push_back({name, "float", try_normals<S<float>, float>, {}});
  family.lines.push_back({name, "double", try_normals<S<double>, double>, {}});
}

template <template <class> class... Shapes>
void add_all(Family& family) {
  (add<Shapes>(family), ...);
}

}  // namespace

std::vector<Family> normal_families() {
  Family family{"normals", "", {}};
  add_all<Sphere, Plane, Disk, Box, Triangle, Polygon, Prism, Ellipsoid, EllipticParaboloid, Cone, Cylinder,
          HyperboloidOneSheet, HyperboloidTwoSheets>(family);
  return {family};
}

}  // namespace raywalk::check
