#pragma once

#include "accel/primitives.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raywalk {

/// All segments from a point to anywhere in a ball, as to an area light: a cone with a rounded end. What lies outside
/// it need not be tested for any of these segments (E. Haines and J. Wallace, "Shaft Culling for Efficient Ray-Cast
/// Radiosity", Eurographics Workshop on Rendering 1991). In double for rays of either precision, and enlarged: by a
/// millionth, which exceeds the rounding of their directions, and by a few ulps of T for the rounding of positions on
/// the ball.
class Shaft {
 public:
  template <class T>
  Shaft(const Vec3<T>& point, const Vec3<T>& centre, T radius)
      : point_(wide(point)),
        axis_(wide(centre) - point_),
        length_(length(axis_)),
        radius_(static_cast<double>(radius)),
        grain_(8 * static_cast<double>(std::numeric_limits<T>::epsilon()) *
               (length(point_) + length(wide(centre)) + radius_)),
        all_around_(!(length_ > radius_ + grain_)) {
    if (all_around_) return;
    axis_ /= length_;
    sin_ = radius_ / length_;
    cos_ = std::sqrt(1 - sin_ * sin_);
  }

  /// Whether a sphere may overlap the shaft.
  [[nodiscard]] bool meets(const Vec3d& centre, double radius) const {
    if (all_around_) return true;
    const Vec3d way = centre - point_;
    const double square = dot(way, way), along = dot(way, axis_);
    const double near = radius + grain_ + slack * (std::sqrt(square) + radius + length_);
    if (along < -near || along > length_ + radius_ + near) return false;
    const double aside = std::sqrt(std::max(square - along * along, 0.0));
    return !(aside * cos_ - along * sin_ > near);
  }

  /// Whether a plane may cut the shaft: the point and the ball are not on the same side. NaN is on neither side.
  [[nodiscard]] bool meets_plane(const Vec3d& on_plane, const Vec3d& normal) const {
    if (all_around_) return true;
    const Vec3d way = point_ - on_plane;
    const double here = dot(normal, way), there = here + length_ * dot(normal, axis_), size = length(normal);
    const double near = size * (grain_ + slack * (length(way) + length_ + radius_)), reach = size * radius_ + near;
    return !((here > near && there > reach) || (here < -near && there < -reach));
  }

 private:
  static constexpr double slack = 1e-6;
  Vec3d point_, axis_;
  double length_, radius_, grain_;
  double sin_ = 0, cos_ = 0;  ///< of the cone's half angle
  bool all_around_;           ///< the point is inside the ball
};

/// Whether a ray spawned at the shaft's point may hit a primitive on its way to the ball.
template <class T>
[[nodiscard]] bool may_cross(const Shaft& shaft, const Primitives<T>& primitives, const Bounds<T>& box, int id,
                             Departure departure) {
  if (const auto* sphere = primitives.template plain<Sphere<T>>(id))
    return shaft.meets(wide(sphere->centre), static_cast<double>(sphere->radius));
  if (const auto* plane = primitives.template plain<Plane<T>>(id))  // a ray that departs from a plane never hits it
                                                                    // again
    return departure.primitive != id && shaft.meets_plane(wide(plane->point), wide(plane->normal));
  if (!box.bounded()) return true;
  const Vec3d min(box.min), max(box.max);
  return shaft.meets((min + max) / 2.0, length(max - min) / 2);
}

}  // namespace raywalk
