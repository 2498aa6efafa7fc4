#pragma once
// A ray in float, as several boxes or triangles at a time of a MeshBvh are tested against it: boxes by
// accel/float_slabs.h; triangles are ruled out where float is sure.

#include "accel/float_slabs.h"
#include "accel/wide_tree.h"
#include "shape/triangle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace raywalk {

/// The terms of a ray, of either precision, that its tests share.
struct MeshRay {
  MeshRay() = default;  ///< means nothing
  /// `sheared`: the same ray.
  template <class T>
  MeshRay(const Ray<T>& ray, const ShearedRay<T>& sheared);
  /// Of a ray that may be off by up to `off` along each axis, beside what it meets, and whose direction's components
  /// may err by `turned` of its largest.
  MeshRay(const Ray<double>& ray, const ShearedRay<double>& sheared, const Vec3d& off, double turned);

  /// Whether the ray is within float's range; otherwise this must not be used.
  bool held;

  // Of boxes: the origin relative to the planes through which the ray enters and leaves, 1 / direction, and where in a
  // WideNode these planes are, in bytes, by axis.
  float from_in[3], from_out[3], inverse[3];
  std::uint32_t near[3], far[3];

  // Of triangles, whose corners are sheared so that the ray is the z axis (shape/triangle.h): where in a corner of a
  // TrianglePack the axes that become x, y and z are, in bytes; the origin along them; the shear; how z grows with t,
  // and its sign alone; and what the error of a corner is in proportion to besides the corner.
  std::uint32_t axes[3];
  float origin[3], shear[2], depth_per_t, forward, grain;

 private:
  static constexpr std::uint32_t lanes_bytes = tree_width * sizeof(float);
  template <class T>
  void set_triangles(const ShearedRay<T>& sheared);
};

template <class T>
MeshRay::MeshRay(const Ray<T>& ray, const ShearedRay<T>& sheared) {
  const FloatSlabs<T> slabs(ray);
  held = slabs.held;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const bool turned = (slabs.negative >> axis & 1) != 0;
    near[axis] = lanes_bytes * (turned ? axis + 3 : axis);
    far[axis] = lanes_bytes * (turned ? axis : axis + 3);
    from_in[axis] = slabs.from_in[axis], from_out[axis] = slabs.from_out[axis], inverse[axis] = slabs.inverse[axis];
  }
  set_triangles(sheared);
}

inline MeshRay::MeshRay(const Ray<double>& ray, const ShearedRay<double>& sheared, const Vec3d& off, double turned)
    : MeshRay(ray, sheared) {
  constexpr float half_ulp = std::numeric_limits<float>::epsilon() / 2;
  float most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float slack = rounded_up(off[axis]), away = std::signbit(ray.direction[axis]) ? -slack : slack;
    from_in[axis] += away, from_out[axis] -= away;
    most = std::max(most, slack);
  }
  // A sheared corner is off by twice that; `sift` counts 8 half ulps of `grain`, and has room for four half ulps of the
  // depth that a turned ray would need.
  grain += most / (4 * half_ulp);
  if (!(turned < half_ulp)) grain = std::numeric_limits<float>::infinity();
}

/// Not before t_far.
template <class T>
[[nodiscard]] float far_in_float(T t_far) {
  constexpr float most = std::numeric_limits<float>::max(), epsilon = std::numeric_limits<float>::epsilon();
  return t_far < static_cast<T>(most) ? static_cast<float>(t_far) * (1 + 4 * epsilon) : infinity<float>;
}

template <class T>
void MeshRay::set_triangles(const ShearedRay<T>& sheared) {
  const int of[] = {sheared.kx, sheared.ky, sheared.kz};
  float size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i] = lanes_bytes * static_cast<std::uint32_t>(of[i]);
    origin[i] = static_cast<float>(sheared.from[i]);
    size = std::max(size, std::abs(origin[i]));
  }
  shear[0] = static_cast<float>(sheared.x), shear[1] = static_cast<float>(sheared.y);
  depth_per_t = static_cast<float>(
      std::max({std::abs(sheared.direction.x), std::abs(sheared.direction.y), std::abs(sheared.direction.z)}));
  forward = std::copysign(1.0F, static_cast<float>(sheared.inverse));
  // Where the ray is in double, its origin and the corners are rounded.
  constexpr bool rounds = !std::is_same_v<T, float>;
  grain = (rounds ? size : 0) + std::numeric_limits<float>::min();
}

}  // namespace raywalk
