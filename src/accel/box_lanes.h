#pragma once
// Four boxes at a time, in float for rays of either precision: widened by what rounding may do, boxes let through a few
// rays too many and none too few.

#include "accel/query.h"
#include "math/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace raywalk {

/// Four boxes, those that are not there empty. Each plane lies farther out than the box's own by a millionth of where
/// it lies, see LaneRay.
struct BoxLanes {
  /// The least x, y and z of all four, then the greatest.
  std::array<Lanes, 6> planes{all_lanes(infinity<float>),  all_lanes(infinity<float>),  all_lanes(infinity<float>),
                              all_lanes(-infinity<float>), all_lanes(-infinity<float>), all_lanes(-infinity<float>)};

  template <class T>
  void set(std::size_t lane, const Bounds<T>& box) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto plane = static_cast<std::size_t>(axis);
      planes[plane][lane] = -at_least(-static_cast<double>(box.min[axis]));
      planes[plane + 3][lane] = at_least(static_cast<double>(box.max[axis]));
    }
  }
  /// One of the planes, so many bytes from the first.
  [[nodiscard]] const Lanes& plane_at(std::size_t offset) const {
    return *reinterpret_cast<const Lanes*>(reinterpret_cast<const char*>(planes.data()) + offset);
  }
  [[nodiscard]] Bounds<float> box(std::size_t lane) const {
    return {{planes[0][lane], planes[1][lane], planes[2][lane]}, {planes[3][lane], planes[4][lane], planes[5][lane]}};
  }

 private:
  /// A float above x by at least 7 ulps of float; not below it where x is 0 or too small for a normal float.
  static float at_least(double x) {
    constexpr float most = std::numeric_limits<float>::max();
    const double wider = x + 8 * static_cast<double>(std::numeric_limits<float>::epsilon()) * std::abs(x);
    if (wider > static_cast<double>(most)) return infinity<float>;
    if (wider < -static_cast<double>(most)) return -most;
    const float rounded = static_cast<float>(wider);
    return static_cast<double>(rounded) < wider ? std::nextafter(rounded, infinity<float>) : rounded;
  }
};

/// Where a ray enters each of four boxes, and a bit for each that it meets.
struct LanesMet {
  Lanes in;
  unsigned bits;
};

/// How far a search looks, made ready for all boxes until it is shortened.
template <class T>
struct LaneReach {
  explicit LaneReach(T reach)
      : t(reach),
        lanes(all_lanes(reach < static_cast<T>(std::numeric_limits<float>::max()) ? static_cast<float>(reach)
                                                                                  : infinity<float>)) {}
  T t;
  Lanes lanes;
};

/// The ray's terms of slab tests, as SlabRay has them, for four boxes at a time.
template <class T>
class LaneRay {
 public:
  explicit LaneRay(const Ray<T>& ray) {
    constexpr float epsilon = std::numeric_limits<float>::epsilon(), least = std::numeric_limits<float>::min();
    const Lanes origin{static_cast<float>(ray.origin.x), static_cast<float>(ray.origin.y),
                       static_cast<float>(ray.origin.z), 0};
    const Lanes slope{static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
                      static_cast<float>(ray.direction.z), 1};
    const Lanes size = absolute(origin), inverse = all_lanes(1) / slope;
    constexpr unsigned all = 15;
    held_ = bits_of(size + absolute(slope) + absolute(inverse) < all_lanes(most)) == all || holds(ray);
    // Either end of a slab errs by four roundings at most: of the slope, its inverse, the difference and the product,
    // in all by 2 epsilon of the plane's place and of the origin's. The boxes are wider by 8 of the former; the origin,
    // itself rounded to float or into a primitive's space, is moved out by 16 of the latter. What falls below the least
    // normal float is rounded in its order, and so keeps it.
    const Lanes slack = all_lanes(16 * epsilon * (size[0] + size[1] + size[2]) + least);
    const Lanes away = with_signs_of(slope, slack), from_in = origin + away, from_out = origin - away;
    sides_ = &all_sides[bits_of(reinterpret_cast<LaneMask>(slope))];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      from_in_[axis] = all_lanes(from_in[axis]);
      from_out_[axis] = all_lanes(from_out[axis]);
      inverse_[axis] = all_lanes(inverse[axis]);
    }
  }

  /// Whether float's range holds the ray, so that no more than rounding is lost; else this answers nothing.
  [[nodiscard]] bool held() const { return held_; }

  /// The boxes that the ray meets before `reach`; all of them and, by rounding, some that it passes closely. NaN, of an
  /// origin in a face's plane without slope, is no bound.
  [[nodiscard]] LanesMet meet(const BoxLanes& boxes, LaneReach<T> reach) const {
    Lanes in = all_lanes(0), out = reach.lanes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      in = max((boxes.plane_at(sides_->near[axis]) - from_in_[axis]) * inverse_[axis], in);
      out = min((boxes.plane_at(sides_->far[axis]) - from_out_[axis]) * inverse_[axis], out);
    }
    return {in, bits_of(in <= out)};
  }

 private:
  /// Where the planes through which a ray enters and leaves a box begin in BoxLanes, in bytes, by axis.
  struct Sides {
    std::array<std::uint32_t, 3> near, far;
  };
  /// By the signs of the ray's slope, a bit for each axis.
  static constexpr std::array<Sides, 8> all_sides = [] {
    std::array<Sides, 8> all{};
    for (std::uint32_t negative = 0; negative < all.size(); ++negative)
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t least = axis * sizeof(Lanes), greatest = (axis + 3) * sizeof(Lanes);
        const bool turned = (negative >> axis & 1) != 0;
        all[negative].near[axis] = turned ? greatest : least;
        all[negative].far[axis] = turned ? least : greatest;
      }
    return all;
  }();

  static constexpr float most = 1e18F;  ///< the largest origin and slope, and the inverse of the least slope

  static bool holds(const Ray<T>& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const T slope = std::abs(ray.direction[axis]);
      if (!(std::abs(ray.origin[axis]) < most && (slope == 0 || (slope > 1 / most && slope < most)))) return false;
    }
    return true;
  }

  bool held_;
  const Sides* sides_;
  std::array<Lanes, 3> from_in_, from_out_, inverse_;
};

/// The same by slabs in T, one box after the other: for rays that float cannot hold, and naive ones.
template <class T, class Slabs>
class WideLaneRay {
 public:
  explicit WideLaneRay(const Slabs& slabs) : slabs_(slabs) {}

  [[nodiscard]] LanesMet meet(const BoxLanes& boxes, LaneReach<T> reach) const {
    LanesMet met{all_lanes(0), 0};
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Bounds<float> box = boxes.box(lane);
      if (box.empty()) continue;  // naive slabs would take it for a box turned inside out
      if (clip(slabs_, Bounds<T>{Vec3<T>(box.min), Vec3<T>(box.max)}, {0, reach.t}).empty()) continue;
      met.bits |= 1U << lane;
    }
    return met;
  }

 private:
  Slabs slabs_;
};

}  // namespace raywalk
