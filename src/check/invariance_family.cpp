#include "check/invariance.h"

#include "check/shape_family.h"

namespace raywalk::check {

namespace {

template <template <class> class S>
void add(Family& family) {
  for (const Invariance invariance : {Invariance::mirrored, Invariance::scaled}) {
    const std::string name =
        std::string(shape_name(S<double>{})) + (invariance == Invariance::mirrored ? ", mirrored" : ", times 4^k");
    add_lines<S>(family, name, [invariance]<class Shape, class T>(auto... range) {
      return test_invariance<Shape, T>(invariance, range...);
    });
  }
}

template <template <class> class... Shapes>
void add_all(Family& family) {
  (add<Shapes>(family), ...);
}

}  // namespace

std::vector<Family> invariance_families() {
  Family family{"laws", "", {}};
  add_all<Sphere, Plane, Disk, Box, Ellipsoid, EllipticParaboloid, Cone, Cylinder, HyperboloidOneSheet,
          HyperboloidTwoSheets>(family);
  return {family};
}

}  // namespace raywalk::check
