#pragma once
// How a ray walks through a WideTree: nearest box first, up to each leaf some of whose primitives it may hit. Compiled
// once for each kind of ray, not for each query: a query only tests what is found here.

#include "accel/mesh_ray.h"
#include "accel/search_record.h"
#include "accel/slabs.h"
#include "accel/wide_tree.h"

#include <array>
#include <bit>
#include <compare>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace raywalk {

/// What boxes are tested with, and a t in its precision: a MeshRay, several at a time; a SlabRay, one by one, for rays
/// outside of float's range; a NaiveSlabRay.
template <class AnyRay>
struct TermsOf;
template <>
struct TermsOf<MeshRay> {
  using Far = float;
};
template <>
struct TermsOf<SlabRay<double>> {
  using Far = double;
};
template <class T>
struct TermsOf<NaiveSlabRay<T>> {
  using Far = T;
};

/// Where a ray enters a box, to within seven ulps below, and the box's lane in its node, as one number by whose order
/// nearer boxes come first: the bits of t, which is not negative, with the lane in place of the last three.
class BoxEntry {
 public:
  BoxEntry() = default;  ///< means nothing
  BoxEntry(float in, unsigned lane) : bits_((std::bit_cast<std::uint32_t>(in) & ~lane_bits) | lane) {}
  explicit BoxEntry(std::uint32_t bits) : bits_(bits) {}

  [[nodiscard]] unsigned lane() const { return bits_ & lane_bits; }
  [[nodiscard]] float t() const { return std::bit_cast<float>(bits_ & ~lane_bits); }
  friend auto operator<=>(const BoxEntry&, const BoxEntry&) = default;

  static constexpr std::uint32_t lane_bits = tree_width - 1;

 private:
  std::uint32_t bits_;
};

/// A leaf that a search has found: its primitives, bits of those that may be hit, of those that are certainly not hit
/// before t_far and, where any hit will do, of those that certainly are, unless the ray departs from them. The ids of a
/// leaf without triangles may all be hit.
struct FoundLeaf {
  const std::int32_t* ids = nullptr;
  const TrianglePack* pack = nullptr;  ///< null for a leaf without triangles
  unsigned candidates = 0, ruled_out = 0, certain = 0;
};

/// One search. Between two calls of `next`, the caller tests what was found and may shorten the ray.
template <class Terms>
class WideSearch {
 public:
  using Far = typename TermsOf<Terms>::Far;

  /// `nearest_first`: whether hits will shorten the ray; then nearer boxes come first. `terms` and the tree outlive
  /// this. With a `record`, the nodes and leaves are recorded.
  WideSearch(const WideTree& tree, const Terms& terms, bool nearest_first, SearchRecord* record = nullptr);

  /// Whether there is a further leaf before `t_far` of which the ray may hit something. `t_far` may only shrink.
  template <class T>
  [[nodiscard]] bool next(T t_far) {
    return advance_(*this, rounded(t_far));
  }

  [[nodiscard]] const FoundLeaf& found() const { return found_; }

  /// Since the beginning: nodes entered, and primitives ruled out in leaves where nothing else was left.
  [[nodiscard]] std::uint64_t nodes() const { return nodes_; }
  [[nodiscard]] std::uint64_t passed_over() const { return passed_over_; }

 private:
  friend struct SearchLoop;
  struct Waiting {
    TreeChild child;
    BoxEntry entry;  ///< into its box
  };

  template <class T>
  static Far rounded(T t_far) {
    if constexpr (std::is_same_v<Terms, MeshRay>)
      return far_in_float(t_far);
    else
      return static_cast<Far>(t_far);
  }

  const WideTree& tree_;
  const Terms& terms_;
  SearchRecord* record_;
  bool (*advance_)(WideSearch&, Far);
  FoundLeaf found_;
  std::uint64_t nodes_ = 0, passed_over_ = 0;
  std::vector<Bounds<float>> boxes_;  ///< of the entries on the stack, with a record
  std::size_t waiting_ = 0;           ///< entries on the stack
  std::array<Waiting, (tree_width - 1) * WideTree::most_levels + tree_width> stack_;
};

extern template class WideSearch<MeshRay>;
extern template class WideSearch<SlabRay<double>>;
extern template class WideSearch<NaiveSlabRay<float>>;
extern template class WideSearch<NaiveSlabRay<double>>;

}  // namespace raywalk
