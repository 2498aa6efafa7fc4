// Closed rooms that light does not leave.
#pragma once

#include "scene/scene.h"

namespace raywalk::test {

inline const Shape<double> ball = Sphere<double>{{0.3, -0.2, 0.1}, 2};
inline const Shape<double> quadrangle = Prism<double>{{{-2, -1.5}, {2, -1}, {1.7, 1.6}, {-1.4, 1.2}}, 3};
// Not convex: rays pass behind corners, and its caps are lights that no point is drawn of.
inline const Shape<double> bent = Prism<double>{{{-3, -3}, {3, -3}, {3, -0.5}, {0.5, -0.5}, {0.5, 3}, {-3, 3}}, 3};

}  // namespace raywalk::test
