#include "check/shape_family.h"

namespace raywalk::check {

void add_quadrics(ShapeFamilies& all) {
  const std::size_t first = all.own.size();
  add_shapes<Ellipsoid, EllipticParaboloid, Cone, Cylinder, HyperboloidOneSheet, HyperboloidTwoSheets>(all);
  add_invariances<Ellipsoid, EllipticParaboloid, Cone, Cylinder, HyperboloidOneSheet, HyperboloidTwoSheets>(all);
  for (std::size_t i = first; i < all.own.size(); ++i) {
    Family& family = all.own[i];
    family.instead =
        "subnormal: products of components below 1e-160 underflow, so there a decision is right for a ray within 2 "
        "ulps";
    for (TableLine& line : family.lines)
      if (line.name == stratum_name(Stratum::subnormal)) line.goals.decisions = false;
  }
}

}  // namespace raywalk::check
