#pragma once
// A packet's rays against boxes and triangles, a group of lanes at a time. Included where lane_tests.h is.

/// A bit for each box of the node that some ray of the packet may hit before `t_far`, and a bound of where the first
/// enters it: interval arithmetic (I. Wald, S. Boulos and P. Shirley, "Ray tracing deformable scenes using dynamic
/// bounding volume hierarchies", 2007). A ray's own test rounds (plane - from) * inverse. Rounding keeps order: with
/// the right bound of `from`, the lesser of the products with the bounds of `inverse` is no more than any ray gets, and
/// the greater no less. So no box is left out that a ray's own test lets pass. None of it is NaN.
RAYWALK_LANE_TARGET inline unsigned meet(const RayPacket& packet, float t_far, const WideNode& node,
                                         BoxEntry* entries) {
  unsigned bits = 0;
  for (unsigned lane = 0; lane < (group_lanes == tree_width ? 1 : node.count); lane += group_lanes) {
    Group enters = all_of(0), leaves = all_of(t_far);
    for (int axis = 0; axis < 3; ++axis) {
      const Group least = all_of(packet.least_inverse[axis]), most = all_of(packet.most_inverse[axis]);
      const Group near = at_offset(&node, packet.near[axis], lane) - all_of(packet.enter[axis]);
      const Group far = at_offset(&node, packet.far[axis], lane) - all_of(packet.leave[axis]);
      enters = max(min(near * least, near * most), enters);
      leaves = min(max(far * least, far * most), leaves);
    }
    store_entries(entries, lane, enters);
    bits |= bits_where(enters <= leaves) << lane;
  }
  return bits;
}

/// A float at a byte offset, in all lanes.
RAYWALK_LANE_TARGET inline Group in_all(const float* first, std::size_t offset) {
  return all_of(*reinterpret_cast<const float*>(reinterpret_cast<const char*>(first) + offset));
}

/// A bit for each of `rays` that hits the node's box in lane `box` before its t_far: as the ray's own test decides.
RAYWALK_LANE_TARGET inline unsigned rays_that_meet(const RayPacket& packet, const WideNode& node, unsigned box,
                                                   unsigned rays) {
  const RaysAbreast& of = packet.rays;
  unsigned bits = 0;
  for (unsigned first = 0; first < RayPacket::most; first += group_lanes) {
    if ((rays >> first & ((1U << group_lanes) - 1)) == 0) continue;
    Group enters = all_of(0), leaves = loaded(packet.t_far + first);
    for (int axis = 0; axis < 3; ++axis) {
      const Group inverse = loaded(of.inverse[axis] + first);
      const float* const planes = &node.planes[0][box];
      const Group near = in_all(planes, packet.near[axis]), far = in_all(planes, packet.far[axis]);
      enters = max((near - loaded(of.from_in[axis] + first)) * inverse, enters);
      leaves = min((far - loaded(of.from_out[axis] + first)) * inverse, leaves);
    }
    bits |= bits_where(enters <= leaves) << first;
  }
  return bits & rays;
}

RAYWALK_LANE_TARGET inline LaneCorner sheared(const RayPacket& packet, const SiftedRay& rays, const TrianglePack& pack,
                                              unsigned corner, unsigned lane) {
  const float* const of = &pack.corners[corner][0][lane];
  return sheared(rays, in_all(of, packet.axes[0]), in_all(of, packet.axes[1]), in_all(of, packet.axes[2]));
}

/// A bit for each of `rays`, unless it certainly misses the pack's triangle in lane `lane` or reaches it only beyond
/// its t_far: as `sift` decides for the ray alone.
RAYWALK_LANE_TARGET inline unsigned rays_that_may_hit(const RayPacket& packet, const TrianglePack& pack, unsigned lane,
                                                      unsigned rays) {
  const RaysAbreast& of = packet.rays;
  unsigned missed = 0;
  for (unsigned first = 0; first < RayPacket::most; first += group_lanes) {
    const unsigned asked = rays >> first & ((1U << group_lanes) - 1);
    if (asked == 0) continue;
    const SiftedRay terms{{loaded(of.origin[0] + first), loaded(of.origin[1] + first), loaded(of.origin[2] + first)},
                          {loaded(of.shear[0] + first), loaded(of.shear[1] + first)},
                          all_of(packet.forward),
                          loaded(of.grain + first),
                          all_of(0),
                          reach_of(loaded(packet.t_far + first), loaded(of.depth_per_t + first))};
    unsigned certain;
    missed |=
        certainly_missed<false>(terms, sheared(packet, terms, pack, 0, lane), sheared(packet, terms, pack, 1, lane),
                                sheared(packet, terms, pack, 2, lane), asked, certain)
        << first;
  }
  return ~missed & rays;
}

/// A bit for each of the pack's first `count` triangles, unless the `ray`-th certainly misses it or reaches it only
/// beyond its t_far: as `sift` decides for the ray alone.
RAYWALK_LANE_TARGET inline unsigned sift(const RayPacket& packet, unsigned ray, const TrianglePack& pack,
                                         unsigned count) {
  const RaysAbreast& of = packet.rays;
  const Group t_far = all_of(packet.t_far[ray]);
  const SiftedRay terms{{all_of(of.origin[0][ray]), all_of(of.origin[1][ray]), all_of(of.origin[2][ray])},
                        {all_of(of.shear[0][ray]), all_of(of.shear[1][ray])},
                        all_of(packet.forward),
                        all_of(of.grain[ray]),
                        all_of(0),
                        reach_of(t_far, all_of(of.depth_per_t[ray]))};
  unsigned certain;
  return sift<false>(packet.axes, terms, pack, count, certain);
}
