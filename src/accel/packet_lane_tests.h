#pragma once
// A packet's rays against boxes, a group of lanes at a time. Included where lane_tests.h is.

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

RAYWALK_LANE_TARGET inline Group plane_in_all(const WideNode& node, std::size_t offset, unsigned box) {
  return all_of(reinterpret_cast<const float*>(reinterpret_cast<const char*>(&node) + offset)[box]);
}

/// A bit for each of `rays` that hits the node's box in lane `box` before its t_far: as the ray's own test decides.
RAYWALK_LANE_TARGET inline unsigned rays_that_meet(const RayPacket& packet, const WideNode& node, unsigned box,
                                                   unsigned rays) {
  unsigned bits = 0;
  for (unsigned first = 0; first < RayPacket::most; first += group_lanes) {
    if ((rays >> first & ((1U << group_lanes) - 1)) == 0) continue;
    Group enters = all_of(0), leaves = loaded(packet.t_far + first);
    for (int axis = 0; axis < 3; ++axis) {
      const Group inverse = loaded(packet.inverse[axis] + first);
      const Group near = plane_in_all(node, packet.near[axis], box), far = plane_in_all(node, packet.far[axis], box);
      enters = max((near - loaded(packet.from_in[axis] + first)) * inverse, enters);
      leaves = min((far - loaded(packet.from_out[axis] + first)) * inverse, leaves);
    }
    bits |= bits_where(enters <= leaves) << first;
  }
  return bits & rays;
}
