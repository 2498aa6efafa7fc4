// One shape of every kind, of about unit size about the origin.
#pragma once

#include <vector>

#include "shape/shape.h"

namespace raywalk::test {

inline std::vector<Shape<double>> one_of_each() {
  constexpr double inf = infinity<double>;
  return {Sphere<double>{{0.1, 0.2, -0.1}, 0.8},
          Plane<double>{{0, 0, 0.1}, {0.3, -0.2, 1}},
          Prism<double>{{{-0.8, -0.6}, {0.9, -0.5}, {0.1, 0.1}, {0.2, 0.9}}, 1.1},
          Box<double>{{-0.7, -0.4, -0.5}, {0.6, 0.8, 0.3}},
          Ellipsoid<double>{{0.9, 0.5, 0.7}, -inf, inf, false},
          EllipticParaboloid<double>{{0.8, 0.6, 1}, -inf, 0.7, true},
          Cone<double>{{0.8, 0.9, 1}, -0.7, 0.6, true},
          Cylinder<double>{{0.5, 0.7, 1}, -0.6, 0.5, true},
          HyperboloidOneSheet<double>{{0.4, 0.5, 0.6}, -0.7, 0.8, false},
          HyperboloidTwoSheets<double>{{0.4, 0.5, 0.3}, -0.9, 0.9, true},
          Disk<double>{{0.1, 0, 0.2}, {0.2, 0.5, 1}, 0.8},
          Polygon<double>{{{-0.9, -0.8, 0}, {0.9, -0.7, 0}, {0.8, 0.9, 0}, {0, 0.2, 0}, {-0.7, 0.8, 0}},
                          {{{0.2, -0.4, 0}, {0.5, -0.4, 0}, {0.4, 0, 0}}}},
          Triangle<double>{{-0.8, -0.6, 0.1}, {0.9, -0.4, -0.2}, {0.1, 0.8, 0.3}}};
}

}  // namespace raywalk::test
