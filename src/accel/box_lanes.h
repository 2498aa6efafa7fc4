#pragma once
// Four boxes at a time, in float for rays of either precision (accel/float_slabs.h).

#include "accel/float_slabs.h"
#include "accel/slabs.h"
#include "math/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace raywalk {

/// Four boxes, rounded out; missing ones are empty.
struct BoxLanes {
  /// The least x, y and z of all four, then the greatest.
  std::array<Lanes, 6> planes{all_lanes(infinity<float>),  all_lanes(infinity<float>),  all_lanes(infinity<float>),
                              all_lanes(-infinity<float>), all_lanes(-infinity<float>), all_lanes(-infinity<float>)};

  template <class T>
  void set(std::size_t lane, const Bounds<T>& box) {
    const Bounds<float> out = rounded_out(box);
    for (int axis = 0; axis < 3; ++axis) {
      const auto plane = static_cast<std::size_t>(axis);
      planes[plane][lane] = out.min[axis];
      planes[plane + 3][lane] = out.max[axis];
    }
  }
  /// The plane at a byte offset from the first.
  [[nodiscard]] const Lanes& plane_at(std::size_t offset) const {
    return *reinterpret_cast<const Lanes*>(reinterpret_cast<const char*>(planes.data()) + offset);
  }
  [[nodiscard]] Bounds<float> box(std::size_t lane) const {
    return {{planes[0][lane], planes[1][lane], planes[2][lane]}, {planes[3][lane], planes[4][lane], planes[5][lane]}};
  }
};

/// Where a ray enters each of four boxes, and a bit for each box that it hits.
struct LaneHits {
  Lanes in;
  unsigned bits;
};

/// t_far of a search, in all lanes, until it becomes shorter.
template <class T>
struct LaneFar {
  explicit LaneFar(T t_far)
      : t(t_far),
        lanes(all_lanes(t_far < static_cast<T>(std::numeric_limits<float>::max()) ? static_cast<float>(t_far)
                                                                                  : infinity<float>)) {}
  T t;
  Lanes lanes;
};

/// The terms of a ray for slab tests, like SlabRay, for four boxes at a time.
template <class T>
class LaneRay {
 public:
  explicit LaneRay(const Ray<T>& ray) {
    const FloatSlabs<T> slabs(ray);
    held_ = slabs.held;
    offsets_ = &all_offsets[slabs.negative];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      from_in_[axis] = all_lanes(slabs.from_in[axis]);
      from_out_[axis] = all_lanes(slabs.from_out[axis]);
      inverse_[axis] = all_lanes(slabs.inverse[axis]);
    }
  }

  /// Whether the ray is within float's range; otherwise this must not be used.
  [[nodiscard]] bool held() const { return held_; }

  /// The boxes that the ray hits before `t_far`: all of them and, by rounding, some that it narrowly misses. NaN, from
  /// an origin in a face's plane without slope, does not limit the interval.
  [[nodiscard]] LaneHits intersect(const BoxLanes& boxes, LaneFar<T> t_far) const {
    Lanes in = all_lanes(0), out = t_far.lanes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      in = max((boxes.plane_at(offsets_->near[axis]) - from_in_[axis]) * inverse_[axis], in);
      out = min((boxes.plane_at(offsets_->far[axis]) - from_out_[axis]) * inverse_[axis], out);
    }
    return {in, bits_of(in <= out)};
  }

 private:
  /// The byte offsets in BoxLanes of the planes through which a ray enters and leaves a box, by axis.
  struct PlaneOffsets {
    std::array<std::uint32_t, 3> near, far;
  };
  /// By the signs of the ray's direction, one bit per axis.
  static constexpr std::array<PlaneOffsets, 8> all_offsets = [] {
    std::array<PlaneOffsets, 8> all{};
    for (std::uint32_t negative = 0; negative < all.size(); ++negative)
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t least = axis * sizeof(Lanes), greatest = (axis + 3) * sizeof(Lanes);
        const bool turned = (negative >> axis & 1) != 0;
        all[negative].near[axis] = turned ? greatest : least;
        all[negative].far[axis] = turned ? least : greatest;
      }
    return all;
  }();

  bool held_;
  const PlaneOffsets* offsets_;
  std::array<Lanes, 3> from_in_, from_out_, inverse_;
};

/// The same by slabs in T, one box after the other: for rays outside float's range, and for naive rays.
template <class T, class Slabs>
class WideLaneRay {
 public:
  explicit WideLaneRay(const Slabs& slabs) : slabs_(slabs) {}

  [[nodiscard]] LaneHits intersect(const BoxLanes& boxes, LaneFar<T> t_far) const {
    LaneHits met{all_lanes(0), 0};
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Bounds<float> box = boxes.box(lane);
      if (box.empty()) continue;  // naive slabs would treat it as an inverted box
      if (clip(slabs_, Bounds<T>{Vec3<T>(box.min), Vec3<T>(box.max)}, {0, t_far.t}).empty()) continue;
      met.bits |= 1U << lane;
    }
    return met;
  }

 private:
  Slabs slabs_;
};

}  // namespace raywalk
