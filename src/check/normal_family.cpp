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

}  // namespace

std::vector<Family> normal_families() {
  Family family{"normals", "", {}};
  add<Sphere>(family);
  add<Plane>(family);
  add<Disk>(family);
  add<Box>(family);
  add<Triangle>(family);
  add<Polygon>(family);
  add<Prism>(family);
  add<Ellipsoid>(family);
  add<EllipticParaboloid>(family);
  add<Cone>(family);
  add<Cylinder>(family);
  add<HyperboloidOneSheet>(family);
  add<HyperboloidTwoSheets>(family);
  return {family};
}

}  // namespace raywalk::check
