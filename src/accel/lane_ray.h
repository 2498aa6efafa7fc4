#pragma once
// A ray in float, as several boxes or triangles at a time are tested against it: boxes are widened by the rounding
// error, so that no hit is lost and a few misses pass; triangles are ruled out where float is sure.

#include "accel/wide_tree.h"
#include "math/lanes.h"
#include "shape/triangle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace raywalk {

/// The terms of a ray, of either precision, that its tests share.
struct LaneRay {
  /// `sheared`: the same ray, where triangles will be tested; else null.
  template <class T>
  LaneRay(const Ray<T>& ray, const ShearedRay<T>* sheared);

  /// Whether the ray is within float's range; otherwise this must not be used.
  bool held;

  // Of boxes: the origin relative to the planes through which the ray enters and leaves, 1 / direction, and where in a
  // TreeNode these planes are, in bytes, by axis.
  float from_in[3], from_out[3], inverse[3];
  std::uint32_t near[3], far[3];

  // Of triangles, whose corners are sheared so that the ray is the z axis (shape/triangle.h): where in a corner of a
  // TrianglePack the axes that become x, y and z are, in bytes; the origin along them; the shear; how z grows with t,
  // and its sign alone; and what the error of a corner is in proportion to besides the corner.
  std::uint32_t axes[3] = {};
  float origin[3] = {}, shear[2] = {}, depth_per_t = 1, forward = 1, grain = 0;

  static constexpr float most = 1e18F;  ///< the largest origin and slope, and the inverse of the smallest slope

 private:
  static constexpr std::uint32_t lanes_bytes = tree_width * sizeof(float);
  template <class T>
  static bool holds(const Ray<T>& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const T slope = std::abs(ray.direction[axis]);
      if (!(std::abs(ray.origin[axis]) < most && (slope == 0 || (slope > 1 / most && slope < most)))) return false;
    }
    return true;
  }
  template <class T>
  void set_triangles(const ShearedRay<T>& sheared);
};

template <class T>
LaneRay::LaneRay(const Ray<T>& ray, const ShearedRay<T>* sheared) {
  constexpr float epsilon = std::numeric_limits<float>::epsilon(), least = std::numeric_limits<float>::min();
  const Lanes from{static_cast<float>(ray.origin.x), static_cast<float>(ray.origin.y), static_cast<float>(ray.origin.z),
                   0};
  const Lanes slope{static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
                    static_cast<float>(ray.direction.z), 1};
  const Lanes size = absolute(from), per_slope = all_lanes(1) / slope;
  constexpr unsigned all = 15;
  held = bits_of(size + absolute(slope) + absolute(per_slope) < all_lanes(most)) == all || holds(ray);
  // Either end of a slab errs by four roundings at most, of the slope, its inverse, the difference and the product: in
  // all by 2 epsilon of the plane's and of the origin's coordinate. The boxes are widened by 8 of the former; the
  // origin, itself rounded to float or into object space, is moved outward by 16 of the latter. Rounding below the
  // smallest normal float is monotonic and so keeps the order.
  const Lanes slack = all_lanes(16 * epsilon * (size[0] + size[1] + size[2]) + least);
  const Lanes away = with_signs_of(slope, slack), in = from + away, out = from - away;
  const unsigned negative = bits_of(reinterpret_cast<LaneMask>(slope));
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const bool turned = (negative >> axis & 1) != 0;
    near[axis] = lanes_bytes * (turned ? axis + 3 : axis);
    far[axis] = lanes_bytes * (turned ? axis : axis + 3);
    from_in[axis] = in[axis], from_out[axis] = out[axis], inverse[axis] = per_slope[axis];
  }
  if (sheared != nullptr) set_triangles(*sheared);
}

template <class T>
void LaneRay::set_triangles(const ShearedRay<T>& sheared) {
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
