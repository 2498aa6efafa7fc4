#pragma once

#include "math/transform.h"

#include <array>
#include <variant>
#include <vector>

namespace raywalk {

/// The elementary transforms that place an object. Points are columns; angles are in degrees by the right-hand rule.
struct Translate {
  Vec3d by{0.0};
  friend bool operator==(const Translate&, const Translate&) = default;
};
struct Rotate {
  Vec3d axis{0.0, 0.0, 1.0};  ///< through the origin; any length but 0
  double degrees = 0;
  friend bool operator==(const Rotate&, const Rotate&) = default;
};
struct Scale {
  Vec3d by{1.0};  ///< no component 0; a negative one mirrors
  friend bool operator==(const Scale&, const Scale&) = default;
};
/// Mirrors in the plane through the origin with this normal.
struct Mirror {
  Vec3d normal{1.0, 0.0, 0.0};  ///< any length but 0
  friend bool operator==(const Mirror&, const Mirror&) = default;
};
/// Each coordinate grows by multiples of the other two: x by xy y + xz z, and so on.
struct Shear {
  double xy = 0, xz = 0, yx = 0, yz = 0, zx = 0, zy = 0;
  friend bool operator==(const Shear&, const Shear&) = default;
};
/// Any affine map, row by row: the factors of x, y, z and a constant.
struct Matrix {
  std::array<double, 12> rows{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  friend bool operator==(const Matrix&, const Matrix&) = default;
};

struct TransformStep {
  std::variant<Translate, Rotate, Scale, Mirror, Shear, Matrix> kind;
  friend bool operator==(const TransformStep&, const TransformStep&) = default;
};

/// The composition of the steps, the first one applied first.
[[nodiscard]] Affine<double> affine_of(const std::vector<TransformStep>& steps);

}  // namespace raywalk
