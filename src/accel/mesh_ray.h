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

namespace detail {

using ByteOffsets = std::array<std::uint32_t, 4>;  ///< by axis; the fourth, which means nothing, makes them whole lanes

/// Where in a WideNode the planes are through which a ray enters and leaves, in bytes, by the signs of its slopes
/// (FloatSlabs::negative); and where in a corner of a TrianglePack the axes that become x, y and z, by the last.
struct PlaneOffsets {
  ByteOffsets near, far;
};
inline constexpr std::uint32_t lanes_bytes = tree_width * sizeof(float);
inline constexpr std::array<PlaneOffsets, 8> plane_offsets = [] {
  std::array<PlaneOffsets, 8> all{};
  for (std::uint32_t negative = 0; negative < 8; ++negative)
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t turned = negative >> axis & 1;
      all[negative].near[axis] = lanes_bytes * (axis + 3 * turned);
      all[negative].far[axis] = lanes_bytes * (axis + 3 - 3 * turned);
    }
  return all;
}();
inline constexpr std::array<ByteOffsets, 3> sheared_axes{
    {{lanes_bytes, 2 * lanes_bytes, 0}, {2 * lanes_bytes, 0, lanes_bytes}, {0, lanes_bytes, 2 * lanes_bytes}}};

/// What the error of a corner is in proportion to besides the corner, given the largest coordinate of the origin: where
/// the ray is in double, both are rounded.
template <class T, class Float>
[[nodiscard]] Float grain_of(Float size) {
  constexpr bool rounds = !std::is_same_v<T, float>;
  return (rounds ? size : Float{}) + std::numeric_limits<float>::min();
}

}  // namespace detail

/// The terms of a ray, of either precision, that its tests share.
struct MeshRay {
  MeshRay() = default;  ///< means nothing
  template <class T>
  explicit MeshRay(const Ray<T>& ray);
  /// Of a ray that may be off by up to `off` along each axis, beside what it meets, and whose direction's components
  /// may err by `turned` of its largest.
  MeshRay(const Ray<double>& ray, const Vec3d& off, double turned);

  /// Whether the ray is within float's range; otherwise this must not be used.
  bool held;

  // Of boxes: the origin relative to the planes through which the ray enters and leaves, 1 / direction, and where the
  // planes are. (Of a fourth axis, which means nothing, to make them whole lanes.)
  alignas(Lanes) float from_in[4], from_out[4], inverse[4];
  std::uint32_t near[4], far[4];

  // Of triangles, whose corners are sheared so that the ray is the z axis (shape/triangle.h): where the axes are that
  // become x, y and z; the origin along them; the shear; how z grows with t, and its sign alone; `grain_of`; and the
  // largest coordinate of the origin.
  std::uint32_t axes[4];
  float origin[3], shear[2], depth_per_t, forward, grain, size;

 private:
  /// The axes that become x, y and z: z the one along which the ray goes fastest, x and y keep their orientation.
  static std::array<std::size_t, 3> axes_of(const float (&slope)[4]) {
    // Without branches, which no processor foresees.
    const float x = std::abs(slope[0]), y = std::abs(slope[1]), z = std::abs(slope[2]);
    const auto beside = static_cast<std::size_t>(!(x > y)), deep = z > (x > y ? x : y) ? 2 : beside;
    constexpr std::size_t after[] = {1, 2, 0, 1};
    return {after[deep], after[deep + 1], deep};
  }
};

template <class T>
MeshRay::MeshRay(const Ray<T>& ray) {
  const FloatSlabs<T> slabs(ray);
  held = slabs.held;
  std::memcpy(from_in, &slabs.from_in, sizeof from_in);
  std::memcpy(from_out, &slabs.from_out, sizeof from_out);
  std::memcpy(inverse, &slabs.inverse, sizeof inverse);
  const detail::PlaneOffsets& offsets = detail::plane_offsets[slabs.negative & 7];
  std::memcpy(near, &offsets.near, sizeof near);
  std::memcpy(far, &offsets.far, sizeof far);
  float from[4], slope[4];
  std::memcpy(from, &slabs.origin, sizeof from);
  std::memcpy(slope, &slabs.slope, sizeof slope);
  const auto [kx, ky, kz] = axes_of(slope);
  std::memcpy(axes, &detail::sheared_axes[kz], sizeof axes);
  origin[0] = from[kx], origin[1] = from[ky], origin[2] = from[kz];
  size = std::max({std::abs(from[0]), std::abs(from[1]), std::abs(from[2])});
  shear[0] = slope[kx] / slope[kz], shear[1] = slope[ky] / slope[kz];
  depth_per_t = std::abs(slope[kz]), forward = std::copysign(1.0F, slope[kz]);
  grain = detail::grain_of<T>(size);
}

inline MeshRay::MeshRay(const Ray<double>& ray, const Vec3d& off, double turned) : MeshRay(ray) {
  constexpr float half_ulp = std::numeric_limits<float>::epsilon() / 2;
  float most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float slack = rounded_up(off[axis]), away = std::signbit(ray.direction[axis]) ? -slack : slack;
    from_in[axis] += away, from_out[axis] -= away;
    most = std::max(most, slack);
  }
  // A sheared corner is off by twice that; `sift` counts 8 half ulps of `grain`. Of the 16 half ulps of the depth it
  // has room for four that a turned ray would need, if the shear, with terms in double, errs by one and not by three.
  grain += most / (4 * half_ulp);
  const auto deep = static_cast<int>(axes[2] / detail::lanes_bytes);
  for (int i = 0; i < 2; ++i) {
    const auto aside = static_cast<int>(axes[i] / detail::lanes_bytes);
    shear[i] = static_cast<float>(ray.direction[aside] / ray.direction[deep]);
  }
  if (!(turned < half_ulp)) grain = std::numeric_limits<float>::infinity();
}

/// Not before t_far.
template <class T>
[[nodiscard]] float far_in_float(T t_far) {
  constexpr float most = std::numeric_limits<float>::max(), epsilon = std::numeric_limits<float>::epsilon();
  return t_far < static_cast<T>(most) ? static_cast<float>(t_far) * (1 + 4 * epsilon) : infinity<float>;
}

}  // namespace raywalk
