#pragma once
// What a pencil's matrix has to be: the rays beside an axis, by their derivatives (trace/ray_differential.h).

#include "trace/pencil.h"
#include "trace/ray_differential.h"

#include <algorithm>
#include <cmath>

namespace raywalk::test {

/// The rays beside an axis, of unit length: those that start to its left and above it, and at an angle.
struct Derivatives {
  RayDerivative<double> left, leftwards, up, upwards;

  explicit Derivatives(const Vec3d& axis)
      : left{sides_of(axis).left, Vec3d(0.0)},
        leftwards{Vec3d(0.0), sides_of(axis).left},
        up{sides_of(axis).up, Vec3d(0.0)},
        upwards{Vec3d(0.0), sides_of(axis).up} {}
  template <class Change>
  void each(Change&& change) {
    for (RayDerivative<double>* one : {&left, &leftwards, &up, &upwards}) *one = change(*one);
  }
  /// In a plane across the axis.
  [[nodiscard]] PencilSystem system(const Vec3d& axis) const {
    const auto made = [&](const RayDerivative<double>& offset, const RayDerivative<double>& slope, const Vec3d& side) {
      const auto one = transfer(offset, axis, 0.0, axis), other = transfer(slope, axis, 0.0, axis);
      return PencilMatrix{raywalk::dot(one.dP, side), raywalk::dot(other.dP, side), raywalk::dot(one.dD, side),
                          raywalk::dot(other.dD, side)};
    };
    const PencilSides sides = sides_of(axis);
    return {made(left, leftwards, sides.left), made(up, upwards, sides.up), made(up, upwards, sides.left),
            made(left, leftwards, sides.up)};
  }
};

/// The largest of a number, against the size of all.
inline double difference(const PencilSystem& one, const PencilSystem& other) {
  double size = 1, most = 0;
  for (const auto block :
       {&PencilSystem::plan, &PencilSystem::across, &PencilSystem::left_from_up, &PencilSystem::up_from_left})
    for (const auto number : {&PencilMatrix::a, &PencilMatrix::b, &PencilMatrix::c, &PencilMatrix::d}) {
      size += std::abs(other.*block.*number);
      most = std::max(most, std::abs(one.*block.*number - other.*block.*number));
    }
  return most / size;
}

}  // namespace raywalk::test
