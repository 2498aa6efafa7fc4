#include "check/shape_family.h"

namespace raywalk::check {

std::vector<Family> quadric_families() {
  std::vector<Family> all = {
      shape_family<Ellipsoid>(), shape_family<EllipticParaboloid>(),  shape_family<Cone>(),
      shape_family<Cylinder>(),  shape_family<HyperboloidOneSheet>(), shape_family<HyperboloidTwoSheets>()};
  for (Family& family : all) {
    family.instead =
        "subnormal: products of components below 1e-160 underflow, so there a decision is right for a ray within 2 "
        "ulps";
    for (TableLine& line : family.lines)
      if (line.name == stratum_name(Stratum::subnormal)) line.goals.decisions = false;
  }
  return all;
}

}  // namespace raywalk::check
