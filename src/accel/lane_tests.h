#pragma once
// A node's boxes and a pack's triangles against a ray, a group of lanes at a time. Included once for each width, inside
// of a namespace that says what a Group is, how many lanes it has, the functions of math/lanes.h for it, and
// RAYWALK_LANE_TARGET, which is what its functions are compiled for. No other file includes it.

/// A ray's terms in all lanes, and `t_far`, for the time that it stays the same.
struct HeldRay {
  Group from_in[3], from_out[3], inverse[3], t_far;
  std::size_t near[3], far[3];
  const MeshRay* ray;
  float reach;
};

/// How deep along the ray `t_far` is, rounded up.
RAYWALK_LANE_TARGET inline float reach_of(const MeshRay& ray, float t_far) {
  return t_far * ray.depth_per_t * (1 + 8 * std::numeric_limits<float>::epsilon());
}

RAYWALK_LANE_TARGET inline void hold(const MeshRay& ray, float t_far, HeldRay& held) {
  for (int axis = 0; axis < 3; ++axis) {
    held.from_in[axis] = all_of(ray.from_in[axis]), held.from_out[axis] = all_of(ray.from_out[axis]);
    held.inverse[axis] = all_of(ray.inverse[axis]);
    held.near[axis] = ray.near[axis], held.far[axis] = ray.far[axis];
  }
  held.t_far = all_of(t_far);
  held.ray = &ray;
  held.reach = reach_of(ray, t_far);
}

/// The lanes at a byte offset from the first, and those of a later group.
RAYWALK_LANE_TARGET inline Group at_offset(const void* first, std::size_t offset, unsigned lane) {
  return loaded(reinterpret_cast<const float*>(static_cast<const char*>(first) + offset) + lane);
}

RAYWALK_LANE_TARGET inline Group enter_slab(const HeldRay& ray, const WideNode& node, int axis, unsigned lane) {
  return (at_offset(&node, ray.near[axis], lane) - ray.from_in[axis]) * ray.inverse[axis];
}
RAYWALK_LANE_TARGET inline Group leave_slab(const HeldRay& ray, const WideNode& node, int axis, unsigned lane) {
  return (at_offset(&node, ray.far[axis], lane) - ray.from_out[axis]) * ray.inverse[axis];
}

/// A bit for each box that the ray hits before `t_far`, and where it enters them (BoxEntry): all of them and, by
/// rounding, some that it narrowly misses. NaN, from an origin in a face's plane without slope, does not limit the
/// interval; nor then does, of x and y, the other. (Two steps of `max`, where three would be waited for.)
RAYWALK_LANE_TARGET inline unsigned meet(const HeldRay& ray, const WideNode& node, BoxEntry* entries) {
  unsigned bits = 0;
  for (unsigned lane = 0; lane < (group_lanes == tree_width ? 1 : node.count); lane += group_lanes) {
    const Group near[] = {enter_slab(ray, node, 0, lane), enter_slab(ray, node, 1, lane),
                          enter_slab(ray, node, 2, lane)};
    const Group far[] = {leave_slab(ray, node, 0, lane), leave_slab(ray, node, 1, lane),
                         leave_slab(ray, node, 2, lane)};
    const Group enters = max(max(near[0], near[1]), max(near[2], all_of(0)));
    const Group leaves = min(min(far[0], far[1]), min(far[2], ray.t_far));
    store_entries(entries, lane, enters);
    bits |= bits_where(enters <= leaves) << lane;
  }
  return bits;
}

/// In each lane, what of a MeshRay its triangles are tested with: of one ray, or of several.
struct SiftedRay {
  Group origin[3], shear[2], forward, grain, size, reach;
};

/// `reach_of` in each lane.
RAYWALK_LANE_TARGET inline Group reach_of(Group t_far, Group depth_per_t) {
  return t_far * depth_per_t * all_of(1 + 8 * std::numeric_limits<float>::epsilon());
}

/// A corner seen from the ray, which is its z axis.
struct LaneCorner {
  Group x, y, z;
};

RAYWALK_LANE_TARGET inline LaneCorner sheared(const SiftedRay& ray, Group x, Group y, Group z) {
  const Group deep = z - ray.origin[2];
  return {x - ray.origin[0] - ray.shear[0] * deep, y - ray.origin[1] - ray.shear[1] * deep, deep};
}

/// The largest of three, without their signs.
RAYWALK_LANE_TARGET inline Group largest(Group a, Group b, Group c) {
  return max(absolute(a), max(absolute(b), absolute(c)));
}

/// A bit for each lane whose ray certainly misses its triangle, or reaches it only beyond `reach`. Of the lanes in
/// `asked`; what it says of others means nothing.
///
/// The test is that of shape/triangle.h. With h = 2^-24, half an ulp of 1, a corner's x or y errs by at most 3h|x| +
/// 8h|z| + 4h|o|: h each of x and z by the difference; where positions are in double, h each of x, z and twice of the
/// origin by rounding them to float; 4h|z| by the shear, a quotient of two that are at most 1, and its product; h|x| by
/// the last difference. Twice that is taken. An edge function, the difference of two products of such coordinates, then
/// errs by less than 4 * across * that: it can be larger only where across is at least twice as large as the corner's
/// error, which bounds the product of two errors. Their sum weighs the corners' z to the triangle's own on the ray:
/// each of three products errs by at most error (depth + corner_error) + 2 across^2 corner_error, that is error (depth
/// + across / 2 + corner_error), and by rounding, which the fourth part of `slack` has room for. The area, three times
/// an edge function's error, can be trusted from four on. Below the smallest normal float all rounding is less than
/// `grain` and `least` account for. Where something leaves float's range, or is NaN, no comparison is true, and nothing
/// is ruled out.
///
/// With `certain`, a bit there for each that is as certainly hit before its t_far, and not so near that a ray which
/// leaves a neighbour may be taken to leave this one (Triangles::leaves_by_edge).
template <bool wants_certain>
RAYWALK_LANE_TARGET inline unsigned certainly_missed(const SiftedRay& ray, const LaneCorner& a, const LaneCorner& b,
                                                     const LaneCorner& c, unsigned asked, unsigned& certain) {
  constexpr float half_ulp = std::numeric_limits<float>::epsilon() / 2, least = std::numeric_limits<float>::min();
  const Group across = max(largest(a.x, b.x, c.x), largest(a.y, b.y, c.y)), depth = largest(a.z, b.z, c.z);
  const Group corner_error = all_of(8 * half_ulp) * (across + (depth + depth) + ray.grain);
  const Group error = all_of(4) * across * corner_error + all_of(least);
  const Group u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  const unsigned outside = bits_where((max(u, max(v, w)) > error) & (min(u, min(v, w)) < -error));
  if ((asked & ~outside) == 0) return outside;
  // The interval of the triangle's depth along the ray; t is computed to within less than the triangle's own extent.
  const Group az = a.z * ray.forward, bz = b.z * ray.forward, cz = c.z * ray.forward;
  const Group nearest = min(az, min(bz, cz)), farthest = max(az, max(bz, cz));
  const Group margin = corner_error + corner_error;
  const auto behind = farthest < -corner_error;
  const auto beyond = nearest - (farthest - nearest) > ray.reach + margin;
  // Where the triangle is seen broadly enough, its depth on the ray itself, times its area.
  const Group area = absolute(u + v + w), wide = area + all_of(4) * error;
  const Group at = with_signs_of(u + v + w, all_of(1)) * (u * az + v * bz + w * cz);
  const Group slack = all_of(4) * error * (across + depth + corner_error) + margin * wide + all_of(least);
  const auto broad = area > all_of(4) * error;
  const auto off = (at < -slack) | (at - slack > ray.reach * wide);
  if constexpr (wants_certain) {
    const Group short_of_it = ray.reach * all_of(1 - 64 * half_ulp), narrow = area - all_of(4) * error;
    const Group size = across + depth + ray.size;
    const auto inside = (min(u, min(v, w)) > error) | (max(u, max(v, w)) < -error);
    const auto ahead = (at - slack > all_of(128 * half_ulp) * size * wide) & (at + slack < short_of_it * narrow);
    certain = bits_where(inside & broad & ahead);
  }
  return outside | bits_where(behind | beyond | (broad & off));
}

/// `axes`: MeshRay::axes.
RAYWALK_LANE_TARGET inline LaneCorner sheared(const std::uint32_t* axes, const SiftedRay& ray, const TrianglePack& pack,
                                              unsigned corner, unsigned lane) {
  const auto& of = pack.corners[corner];
  return sheared(ray, at_offset(of, axes[0], lane), at_offset(of, axes[1], lane), at_offset(of, axes[2], lane));
}

/// A bit for each of the pack's first `count` lanes, unless the ray, whose terms are the same in all lanes, certainly
/// misses its triangle or reaches it only beyond its reach; and `certain` of certainly_missed.
template <bool wants_certain>
RAYWALK_LANE_TARGET inline unsigned sift(const std::uint32_t* axes, const SiftedRay& ray, const TrianglePack& pack,
                                         unsigned count, unsigned& certain) {
  const unsigned all = (1U << count) - 1;
  unsigned missed = 0;
  for (unsigned lane = 0; lane < (group_lanes == tree_width ? 1 : count); lane += group_lanes) {
    unsigned certain_here = 0;
    missed |= certainly_missed<wants_certain>(ray, sheared(axes, ray, pack, 0, lane), sheared(axes, ray, pack, 1, lane),
                                              sheared(axes, ray, pack, 2, lane),
                                              all >> lane & ((1U << group_lanes) - 1), certain_here)
              << lane;
    if constexpr (wants_certain) certain |= certain_here << lane;
  }
  if constexpr (wants_certain) certain &= all;
  return ~missed & all;
}

/// The same for a ray that is searched alone; `held_reach`: `reach_of` its t_far.
template <bool wants_certain>
RAYWALK_LANE_TARGET inline unsigned sift(const MeshRay& ray, float held_reach, const TrianglePack& pack, unsigned count,
                                         unsigned& certain) {
  const SiftedRay terms{{all_of(ray.origin[0]), all_of(ray.origin[1]), all_of(ray.origin[2])},
                        {all_of(ray.shear[0]), all_of(ray.shear[1])},
                        all_of(ray.forward),
                        all_of(ray.grain),
                        all_of(ray.size),
                        all_of(held_reach)};
  return sift<wants_certain>(ray.axes, terms, pack, count, certain);
}
