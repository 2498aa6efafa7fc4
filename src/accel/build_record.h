#pragma once
// How an accelerator was built and what it consists of, as plain values for display.

#include "math/bounds.h"
#include "math/stop.h"
#include "math/words.h"
#include "shape/mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace raywalk {

/// A node or cell of a finished structure.
struct StructureNode {
  Bounds<double> box;
  int depth = 0;  ///< 0 at the top
  bool leaf = false;
  int items = 0;  ///< primitives listed, or children
};

/// Size and cost of a built structure.
struct AcceleratorStatistics {
  std::size_t nodes = 0;       ///< inner nodes, leaves and cells
  std::size_t references = 0;  ///< entries of primitives in leaves or cells
  int depth = 0;               ///< of the deepest leaf; 0 for a single one
  std::size_t bytes = 0;       ///< of the structure, without the primitives
  /// What a ray is expected to cost that meets the box of all, or begins in it, in tests of one primitive: what a tree
  /// was built to make least (MeetingChance). 0 for what is no tree over meshes.
  double expected_cost = 0;
  double build_seconds = 0;  ///< from the primitives to a searchable structure
};

/// Why a node was not split.
enum class LeafReason {
  single,            ///< at most one primitive is left
  few,               ///< few enough primitives
  split_costs_more,  ///< every split would cost more than a leaf
  no_gain,           ///< splitting would copy most primitives into most parts
  too_deep,          ///< the maximum depth is reached
  same_place,        ///< no plane separates the remaining primitives
  too_many_listed,   ///< the halves would list more primitives than the structure has room for
};

/// One decision of a build, in build order.
struct BuildStep {
  enum class Kind {
    split,   ///< a node is split in two by a plane
    eight,   ///< a cube is split into eight, of which the empty ones are dropped
    leaf,    ///< a node becomes a leaf
    joined,  ///< up to eight nodes of a binary tree become one: where they are once subtrees have been moved
    cells,   ///< a grid's cells are laid out
    listed,  ///< a primitive is listed in all cells of a grid that its box overlaps
  };
  Kind kind = Kind::split;
  Bounds<double> box{};
  int depth = 0;
  int items = 0;     ///< primitives in the box; `listed`: cells; `joined`: nodes
  int axis = -1;     ///< split: 0 x, 1 y, 2 z; -1: the list was halved, as no plane separates it
  double plane = 0;  ///< split: where, scene units
  /// The expected cost of a ray that hits the box, in primitive tests: with the best split, and as a leaf. Both 0 where
  /// no split was considered.
  double split_cost = 0, leaf_cost = 0;
  LeafReason why = LeafReason::single;
  std::array<int, 3> cells{1, 1, 1};  ///< cells: along each axis
  int primitive = -1;                 ///< listed
  struct Part {
    Bounds<double> box;
    int items;  ///< primitives in it
  };
  std::vector<Part> parts{};  ///< what it was split into; joined: all of them
};

/// Records a build. Steps beyond `most` are counted, but not kept.
struct BuildRecord {
  std::size_t most = 20000;
  std::size_t steps_made = 0;
  std::vector<BuildStep> steps{};

  void add(BuildStep step) {
    if (++steps_made <= most) steps.push_back(std::move(step));
  }
};

/// How much time a tree over triangles may take to build, for rays that find theirs sooner. The answers are the same.
enum class BuildQuality {
  automatic,  ///< fast where few rays are expected, else good
  fast,       ///< planes are tried along one axis
  good,       ///< along all, and subtrees are then put where they belong (accel/reinsertion.h)
  best        ///< space is split too (accel/spatial_split.h): pays where the boxes of triangles overlap much
};
template <>
inline constexpr Word<BuildQuality> words_of<BuildQuality>[] = {{BuildQuality::automatic, "auto"},
                                                                {BuildQuality::fast, "fast"},
                                                                {BuildQuality::good, "good"},
                                                                {BuildQuality::best, "best"}};

/// What a build is given besides its boxes.
struct BuildOptions {
  Stop stop{};
  BuildRecord* watcher = nullptr;  ///< records the build, if not null
  BuildQuality quality = BuildQuality::automatic;
  double expected_rays = 0;                  ///< 0: not known
  double share_copies_from = shared_copies;  ///< triangles of all copies together

  /// For so many triangles: never automatic.
  [[nodiscard]] BuildQuality quality_for(std::size_t triangles) const;
};

}  // namespace raywalk
