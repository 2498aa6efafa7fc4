#pragma once
// How rays of one RayPacket walk through a WideTree together, see accel/wide_search.h for one ray.

#include "accel/ray_packet.h"
#include "accel/wide_search.h"

namespace raywalk {

/// One search for several rays. The boxes of a node are tested once for all of them; one that passes is tested by each
/// ray, all at a time, when its turn comes; and the triangles of a leaf by each ray that meets its box. Between two
/// calls of `next`, the caller tests what was found for each ray.
class PacketSearch {
 public:
  /// `members`: a bit for each of the rays, which outlive this, as the tree does; they are coherent. `nearest_first`:
  /// whether hits will shorten rays.
  PacketSearch(const WideTree& tree, const RaysAbreast& rays, unsigned members, bool nearest_first);

  /// To be called for each member before the first `next`. t_far may only shrink.
  template <class T>
  void set_far(unsigned ray, T t_far) {
    packet_.t_far[ray] = far_in_float(t_far);
  }
  void finish(unsigned ray) { packet_.t_far[ray] = -1; }  ///< it needs nothing any more

  /// Whether there is a further leaf of which some ray may hit something.
  [[nodiscard]] bool next() { return advance_(*this); }

  /// A bit for each ray that may hit something of the leaf, and what such a ray has found.
  [[nodiscard]] unsigned rays() const { return rays_; }
  [[nodiscard]] FoundLeaf found(unsigned ray) const {
    return {ids_, pack_, candidates_[ray], all_ & ~unsigned{candidates_[ray]}, 0};
  }

  /// Since the beginning, each as often as there were rays that met its box.
  [[nodiscard]] std::uint64_t nodes() const { return nodes_; }
  [[nodiscard]] std::uint64_t passed_over() const { return passed_over_; }

 private:
  friend struct PacketLoop;
  struct Waiting {
    std::uint32_t node;
    BoxEntry entry;  ///< into one of its boxes, which waits
    unsigned rays;   ///< that may meet it
  };

  const WideTree& tree_;
  RayPacket packet_;
  bool (*advance_)(PacketSearch&);
  const std::int32_t* ids_ = nullptr;
  const TrianglePack* pack_ = nullptr;
  unsigned all_ = 0, rays_ = 0;
  std::array<std::uint8_t, RayPacket::most> candidates_;
  std::uint64_t nodes_ = 0, passed_over_ = 0;
  bool begun_ = false;
  std::size_t waiting_ = 0;  ///< entries on the stack
  std::array<Waiting, (tree_width - 1) * WideTree::most_levels + tree_width> stack_;
};

}  // namespace raywalk
