#pragma once
// Rays whose boxes are tested together.

#include "accel/mesh_ray.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace raywalk {

/// Up to sixteen rays, side by side: of each what a MeshRay has, the same bits, but for what is equal for all rays of
/// one kind.
struct RaysAbreast {
  static constexpr unsigned most = 16;

  /// `ray(i)`: the i-th of `count`, from 1 to `most`.
  template <class RayOf>
  RaysAbreast(unsigned count, const RayOf& ray);

  /// A bit for each ray that may be in one packet with the first-th: their slopes have the same signs, none of them 0,
  /// and one axis becomes z.
  [[nodiscard]] unsigned alike(unsigned first) const;
  /// The same, and it is likely to pay: they begin within `near` of each other and hardly diverge.
  [[nodiscard]] unsigned coherent(unsigned first, float near) const;

  /// By axis and ray.
  using Values = float[most];
  alignas(64) Values from_in[3], from_out[3], inverse[3], origin[3], shear[2], grain, depth_per_t;
  /// The signs of the slopes, a bit for each axis, and 8 times the axis that becomes z; -1 for a ray that must not be
  /// in a packet, or is missing.
  alignas(64) std::int32_t kind[most];

  static constexpr unsigned groups = most / 4;  ///< of four lanes
  static Lanes four(const Values& of, unsigned group) {
    Lanes lanes;
    std::memcpy(&lanes, of + 4 * group, sizeof lanes);
    return lanes;
  }

 private:
  template <class RayOf>
  void set_four(unsigned group, unsigned count, const RayOf& ray);
  /// A bit for each ray for which `is(group)` says so.
  template <class Is>
  static unsigned where(const Is& is) {
    unsigned bits = 0;
    for (unsigned group = 0; group < groups; ++group) bits |= bits_of(is(group)) << 4 * group;
    return bits;
  }
  [[nodiscard]] LaneMask is_kind(std::int32_t which, unsigned group) const {
    LaneMask kinds;
    std::memcpy(&kinds, kind + 4 * group, sizeof kinds);
    return kinds == LaneMask{which, which, which, which};
  }
};

/// Some of them that are `alike`, and what holds for all of these; of triangles they can be asked where they are
/// `coherent`.
struct RayPacket {
  static constexpr unsigned most = RaysAbreast::most;

  /// `rays` outlives this; a bit for each of its `members`, of which there is one at least.
  RayPacket(const RaysAbreast& rays, unsigned members);

  const RaysAbreast& rays;
  unsigned members;
  alignas(64) RaysAbreast::Values t_far;  ///< -1: the ray meets no box any more, or is no member
  // No ray enters a box before one from `enter` would, or leaves it after one from `leave`, were `inverse` either of
  // its bounds (packet_lane_tests.h).
  float enter[3], leave[3], least_inverse[3], most_inverse[3];
  float forward;
  std::uint32_t near[3], far[3], axes[3];

  /// The latest t_far.
  [[nodiscard]] float latest() const {
    return greatest(max(max(RaysAbreast::four(t_far, 0), RaysAbreast::four(t_far, 1)),
                        max(RaysAbreast::four(t_far, 2), RaysAbreast::four(t_far, 3))));
  }

 private:
  static float least(Lanes of) { return std::min(std::min(of[0], of[1]), std::min(of[2], of[3])); }
  static float greatest(Lanes of) { return std::max(std::max(of[0], of[1]), std::max(of[2], of[3])); }
};

template <class RayOf>
inline RaysAbreast::RaysAbreast(unsigned count, const RayOf& ray) {
  for (unsigned group = 0; group < groups; ++group) set_four(group, count, ray);
}

template <class RayOf>
inline void RaysAbreast::set_four(unsigned group, unsigned count, const RayOf& ray) {
  // What is missing is the first ray again, to be of use to nobody.
  std::array<unsigned, 4> index{};
  for (unsigned lane = 0; lane < 4; ++lane) index[lane] = 4 * group + lane < count ? 4 * group + lane : 0;
  const auto &a = ray(index[0]), &b = ray(index[1]), &c = ray(index[2]), &d = ray(index[3]);
  using T = std::decay_t<decltype(a.time)>;
  Lanes from[3], slope[3];
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = Lanes{static_cast<float>(a.origin[axis]), static_cast<float>(b.origin[axis]),
                       static_cast<float>(c.origin[axis]), static_cast<float>(d.origin[axis])};
    slope[axis] = Lanes{static_cast<float>(a.direction[axis]), static_cast<float>(b.direction[axis]),
                        static_cast<float>(c.direction[axis]), static_cast<float>(d.direction[axis])};
  }
  const auto store = [group](const auto& lanes, auto& values) {
    std::memcpy(values + 4 * group, &lanes, sizeof lanes);
  };

  // Boxes: accel/float_slabs.h.
  const Lanes size[] = {absolute(from[0]), absolute(from[1]), absolute(from[2])};
  const Lanes slack = detail::slack_of(size[0] + size[1] + size[2]);
  LaneMask held = LaneMask{-1, -1, -1, -1}, signs{};
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes per_slope = all_lanes(1) / slope[axis], away = with_signs_of(slope[axis], slack);
    store(per_slope, inverse[axis]);
    store(from[axis] + away, from_in[axis]);
    store(from[axis] - away, from_out[axis]);
    held &= detail::surely_held(from[axis], slope[axis], per_slope);
    const std::int32_t bit = 1 << axis;
    signs |= (reinterpret_cast<LaneMask>(slope[axis]) < LaneMask{}) & LaneMask{bit, bit, bit, bit};
  }

  // Triangles: MeshRay.
  const Lanes steep[] = {absolute(slope[0]), absolute(slope[1]), absolute(slope[2])};
  const LaneMask z_is_z = steep[2] > max(steep[0], steep[1]), z_is_x = ~z_is_z & (steep[0] > steep[1]);
  const auto chosen = [&](const Lanes& if_x, const Lanes& if_y, const Lanes& if_z) {
    return reinterpret_cast<Lanes>((reinterpret_cast<LaneMask>(if_x) & z_is_x) |
                                   (reinterpret_cast<LaneMask>(if_y) & ~(z_is_x | z_is_z)) |
                                   (reinterpret_cast<LaneMask>(if_z) & z_is_z));
  };
  const Lanes deep = chosen(slope[0], slope[1], slope[2]);
  store(chosen(from[1], from[2], from[0]), origin[0]);
  store(chosen(from[2], from[0], from[1]), origin[1]);
  store(chosen(from[0], from[1], from[2]), origin[2]);
  store(chosen(slope[1], slope[2], slope[0]) / deep, shear[0]);
  store(chosen(slope[2], slope[0], slope[1]) / deep, shear[1]);
  store(absolute(deep), depth_per_t);
  store(detail::grain_of<T>(max(max(size[0], size[1]), size[2])), grain);

  constexpr LaneMask for_y{8, 8, 8, 8}, for_z{16, 16, 16, 16};
  store(signs | (for_y & ~(z_is_x | z_is_z)) | (for_z & z_is_z), kind);
  const unsigned sure = bits_of(held);
  for (unsigned lane = 0; lane < 4; ++lane) {
    const unsigned i = 4 * group + lane;
    const auto finite = [&] {
      return std::isfinite(inverse[0][i]) && std::isfinite(inverse[1][i]) && std::isfinite(inverse[2][i]);
    };
    if (i >= count || ((sure >> lane & 1) == 0 && !(detail::is_held(ray(i)) && finite()))) kind[i] = -1;
  }
}

inline unsigned RaysAbreast::alike(unsigned first) const {
  const std::int32_t which = kind[first];
  return which < 0 ? 0 : where([&](unsigned group) { return is_kind(which, group); });
}

inline unsigned RaysAbreast::coherent(unsigned first, float near) const {
  constexpr float turn = 0.0625F;  // of slopes along the axis that grows fastest
  const unsigned same = alike(first);
  if (same == 0) return 0;
  const auto within = [&](const Values& of, unsigned group, float most_apart) {
    return absolute(four(of, group) - all_lanes(of[first])) < all_lanes(most_apart);
  };
  const auto is_close = [&](unsigned group) {
    return within(shear[0], group, turn) & within(shear[1], group, turn) & within(origin[0], group, near) &
           within(origin[1], group, near) & within(origin[2], group, near);
  };
  return same & where(is_close);
}

inline RayPacket::RayPacket(const RaysAbreast& of, unsigned which) : rays(of), members(which) {
  const auto first = static_cast<unsigned>(std::countr_zero(members));
  LaneMask is_member[RaysAbreast::groups];
  for (unsigned group = 0; group < RaysAbreast::groups; ++group) {
    const auto bits = static_cast<std::int32_t>(members >> 4 * group);
    is_member[group] = (LaneMask{bits, bits, bits, bits} & LaneMask{1, 2, 4, 8}) != LaneMask{};
  }
  // Of values, what one of the members has instead of those of others.
  const auto own = [&](const RaysAbreast::Values& values, unsigned group) {
    const LaneMask its = is_member[group];
    return reinterpret_cast<Lanes>((reinterpret_cast<LaneMask>(RaysAbreast::four(values, group)) & its) |
                                   (reinterpret_cast<LaneMask>(all_lanes(values[first])) & ~its));
  };
  struct Range {
    float least, greatest;
  };
  const auto range = [&](const RaysAbreast::Values& values) {
    Lanes low = own(values, 0), high = low;
    for (unsigned group = 1; group < RaysAbreast::groups; ++group) {
      const Lanes lanes = own(values, group);
      low = min(lanes, low), high = max(lanes, high);
    }
    return Range{least(low), greatest(high)};
  };
  const std::int32_t kind = rays.kind[first];
  const detail::PlaneOffsets& planes = detail::plane_offsets[static_cast<std::size_t>(kind & 7)];
  const auto deep = static_cast<std::size_t>(kind >> 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range in = range(rays.from_in[axis]), out = range(rays.from_out[axis]), slope = range(rays.inverse[axis]);
    const bool negative = slope.least < 0;
    enter[axis] = negative ? in.least : in.greatest, leave[axis] = negative ? out.greatest : out.least;
    least_inverse[axis] = slope.least, most_inverse[axis] = slope.greatest;
    near[axis] = planes.near[axis], far[axis] = planes.far[axis], axes[axis] = detail::sheared_axes[deep][axis];
  }
  forward = (kind >> deep & 1) != 0 ? -1.0F : 1.0F;
  std::fill(t_far, t_far + most, -1.0F);
}

}  // namespace raywalk
