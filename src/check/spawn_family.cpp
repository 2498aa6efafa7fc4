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

}  // namespace

std::vector<Family> spawn_families() {
  Family family{"spawned", "", {}};
  add<Sphere>(family);
  add<Plane>(family);
  add<Disk>(family);
  add<Box>(family);
  add<Triangle>(family);
  add<Polygon>(family);
  add<Ellipsoid>(family);
  add<EllipticParaboloid>(family);
  add<Cone>(family);
  add<Cylinder>(family);
  add<HyperboloidOneSheet>(family);
  add<HyperboloidTwoSheets>(family);
  Family prisms{"spawned_polygon", "", {}};
  add<Prism>(prisms);
  return {family, prisms};
}

}  // namespace raywalk::check
