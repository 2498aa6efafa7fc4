#pragma once
// Places of a window, and random ones, for tests of beams in space.

#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace raywalk::test {

class Draw {
 public:
  explicit Draw(int seed) : engine_(static_cast<unsigned>(seed)) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3d place(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }

 private:
  std::mt19937 engine_;
};

/// How far inside a convex polygon a place lies; negative outside.
inline double inside_by(const std::vector<Vec2d>& corners, const Vec2d& place) {
  double least = std::numeric_limits<double>::infinity(), twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) twice += cross(corners[i], corners[(i + 1) % corners.size()]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d along = corners[(i + 1) % corners.size()] - corners[i];
    if (length(along) > 1e-9)
      least = std::min(least, std::copysign(1.0, twice) * cross(along, place - corners[i]) / length(along));
  }
  return least;
}

}  // namespace raywalk::test
