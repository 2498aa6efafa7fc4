#pragma once
// Rays whose boxes are tested together.

#include "accel/mesh_ray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

namespace raywalk {

/// Up to sixteen rays, side by side, and what holds for all of them.
struct RayPacket {
  static constexpr unsigned most = 16;

  /// Of rays that are `alike`; of triangles they can be asked where they are `coherent`. What is missing is a ray that
  /// meets no box.
  explicit RayPacket(std::span<const MeshRay> rays);

  /// Whether two may be in one packet: their slopes have the same signs, none of them 0.
  [[nodiscard]] static bool alike(const MeshRay& a, const MeshRay& b);
  /// The same, and whether it is likely to pay: they begin within `near` of each other and hardly diverge.
  [[nodiscard]] static bool coherent(const MeshRay& a, const MeshRay& b, float near);

  [[nodiscard]] unsigned all() const { return (1U << count) - 1; }  ///< a bit for each ray

  // As in MeshRay, by axis and ray. A t_far of -1: the ray meets no box any more.
  alignas(64) float from_in[3][most], from_out[3][most], inverse[3][most], t_far[most];
  float origin[3][most], shear[2][most], grain[most], depth_per_t[most];
  // No ray enters a box before one from `enter` would, or leaves it after one from `leave`, were `inverse` either of
  // its bounds (packet_lane_tests.h).
  float enter[3], leave[3], least_inverse[3], most_inverse[3];
  float forward;
  std::uint32_t near[3], far[3], axes[3];
  unsigned count;

 private:
  struct Range {
    explicit Range(const float (&of)[most]) {
      Lanes low, high, four;
      std::memcpy(&low, of, sizeof low);
      high = low;
      for (unsigned i = 4; i < most; i += 4) {
        std::memcpy(&four, of + i, sizeof four);
        low = min(four, low), high = max(four, high);
      }
      least = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
      greatest = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
    }
    float least, greatest;
  };
};

inline bool RayPacket::alike(const MeshRay& a, const MeshRay& b) {
  if (!a.held || !b.held) return false;
  LaneMask near_a, near_b;
  Lanes inverse_a, inverse_b;
  std::memcpy(&near_a, a.near, sizeof near_a), std::memcpy(&near_b, b.near, sizeof near_b);
  std::memcpy(&inverse_a, a.inverse, sizeof inverse_a), std::memcpy(&inverse_b, b.inverse, sizeof inverse_b);
  const Lanes endless = all_lanes(infinity<float>);
  constexpr unsigned all = 7;
  return (bits_of((near_a == near_b) & (absolute(inverse_a) < endless) & (absolute(inverse_b) < endless)) & all) == all;
}

inline bool RayPacket::coherent(const MeshRay& a, const MeshRay& b, float near) {
  constexpr float turn = 0.0625F;  // of slopes along the axis that grows fastest
  // What incoherent rays fail at comes first.
  if (!(std::abs(a.shear[0] - b.shear[0]) < turn && std::abs(a.shear[1] - b.shear[1]) < turn)) return false;
  bool all = true;
  for (int axis = 0; axis < 3; ++axis)
    all &= a.axes[axis] == b.axes[axis] && std::abs(a.origin[axis] - b.origin[axis]) < near;
  return all && alike(a, b);
}

inline RayPacket::RayPacket(std::span<const MeshRay> rays) : count(static_cast<unsigned>(rays.size())) {
  for (unsigned i = 0; i < most; ++i) {
    const MeshRay& ray = rays[i < count ? i : 0];
    for (int axis = 0; axis < 3; ++axis) {
      from_in[axis][i] = ray.from_in[axis], from_out[axis][i] = ray.from_out[axis];
      inverse[axis][i] = ray.inverse[axis], origin[axis][i] = ray.origin[axis];
    }
    shear[0][i] = ray.shear[0], shear[1][i] = ray.shear[1];
    grain[i] = ray.grain, depth_per_t[i] = ray.depth_per_t;
    t_far[i] = -1;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Range in(from_in[axis]), out(from_out[axis]), slope(inverse[axis]);
    const bool negative = slope.least < 0;
    enter[axis] = negative ? in.least : in.greatest, leave[axis] = negative ? out.greatest : out.least;
    least_inverse[axis] = slope.least, most_inverse[axis] = slope.greatest;
    near[axis] = rays[0].near[axis], far[axis] = rays[0].far[axis], axes[axis] = rays[0].axes[axis];
  }
  forward = rays[0].forward;
}

}  // namespace raywalk
