#pragma once
// Refraction of a beam by flat glass in the plan: P. Heckbert and P. Hanrahan, "Beam Tracing Polygonal Objects",
// SIGGRAPH 1984. Snell's law does not keep a beam's rays those of one point. With tangents for its sines it does: what
// is along the face's normal is stretched by tan / tan', and so is the way to the point that the rays seem to come
// from. The paper's n2 / n1 is that ratio for rays along the normal; here it is that of the middle ray, whatever its
// angle, so that this ray is Snell's.

#include "math/elementary.h"
#include "math/vec.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

class FlatRefraction {
 public:
  /// `normal`: of any length, to the side that the rays come from. n1 and n2: indices there and beyond. The cosines are
  /// those of the middle ray to the normal, neither 0.
  FlatRefraction(const Vec2d& normal, double n1, double n2, double cos_in, double cos_out)
      : normal_(normal / length(normal)), n1_(n1), n2_(n2), ratio_(n1 == n2 ? 1 : n2 * cos_out / (n1 * cos_in)) {}

  /// The direction beyond of a ray, and the way beyond from where its like seem to come to a point of the face, in the
  /// place of the way from where they come.
  [[nodiscard]] Vec2d bent(const Vec2d& way) const { return way + (ratio_ - 1) * dot(normal_, way) * normal_; }

  /// The angle in radians between a ray's direction beyond and that by Snell's law; along the face where all of it
  /// would be reflected.
  [[nodiscard]] double off(const Vec2d& direction) const {
    const Vec2d along(-normal_.y, normal_.x), taken = bent(direction);
    const double sine = n1_ / n2_ * dot(direction, along) / length(direction);
    const Vec2d snell = sine * along - std::sqrt(std::max(1 - sine * sine, 0.0)) * normal_;
    return n1_ == n2_ ? 0 : portable::atan2(std::abs(cross(snell, taken)), dot(snell, taken));
  }

 private:
  Vec2d normal_;
  double n1_, n2_, ratio_;
};

}  // namespace raywalk
