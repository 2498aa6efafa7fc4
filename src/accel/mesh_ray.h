#pragma once
// A ray in float, as several boxes or triangles at a time of a MeshBvh are tested against it: boxes by
// accel/float_slabs.h; triangles are ruled out where float is sure.

#include "accel/float_slabs.h"
#include "accel/wide_tree.h"
#include "shape/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
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
  // WideNode these planes are, in bytes, by axis. (A fourth, which means nothing, makes them whole lanes.)
  alignas(Lanes) float from_in[4], from_out[4], inverse[4];
  std::uint32_t near[4], far[4];

  // Of triangles, whose corners are sheared so that the ray is the z axis (shape/triangle.h): where in a corner of a
  // TrianglePack the axes that become x, y and z are, in bytes; the origin along them; the shear; how z grows with t,
  // and its sign alone; what the error of a corner is in proportion to besides the corner; and the largest coordinate
  // of the origin.
  std::uint32_t axes[4];
  float origin[3], shear[2], depth_per_t, forward, grain, size;

 private:
  static constexpr std::uint32_t lanes_bytes = tree_width * sizeof(float);
  using Offsets = std::array<std::uint32_t, 4>;
  struct PlaneOffsets {
    Offsets near, far;
  };
  static constexpr PlaneOffsets offsets_of(std::uint32_t negative) {
    PlaneOffsets all{};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t turned = negative >> axis & 1;
      all.near[axis] = lanes_bytes * (axis + 3 * turned), all.far[axis] = lanes_bytes * (axis + 3 - 3 * turned);
    }
    return all;
  }
  /// By the axis that becomes z.
  static constexpr std::array<Offsets, 3> sheared_axes{
      {{lanes_bytes, 2 * lanes_bytes, 0}, {2 * lanes_bytes, 0, lanes_bytes}, {0, lanes_bytes, 2 * lanes_bytes}}};
  template <class T>
  void set_triangles(const ShearedRay<T>& sheared);
};

template <class T>
MeshRay::MeshRay(const Ray<T>& ray, const ShearedRay<T>& sheared) {
  const FloatSlabs<T> slabs(ray);
  held = slabs.held;
  std::memcpy(from_in, &slabs.from_in, sizeof from_in);
  std::memcpy(from_out, &slabs.from_out, sizeof from_out);
  std::memcpy(inverse, &slabs.inverse, sizeof inverse);
  static constexpr std::array<PlaneOffsets, 8> plane_offsets{offsets_of(0), offsets_of(1), offsets_of(2),
                                                             offsets_of(3), offsets_of(4), offsets_of(5),
                                                             offsets_of(6), offsets_of(7)};
  const PlaneOffsets& offsets = plane_offsets[slabs.negative & 7];
  std::memcpy(near, &offsets.near, sizeof near);
  std::memcpy(far, &offsets.far, sizeof far);
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
  std::memcpy(axes, &sheared_axes[static_cast<std::size_t>(sheared.kz)], sizeof axes);
  size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
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
