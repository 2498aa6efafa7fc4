#pragma once
// The searches of a recorded ray, one in each accelerator, watched; and how each accelerator was built.

#include "accel/watched.h"
#include "timeline/timeline.h"
#include "trace/kernel.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// The accelerators that are watched side by side. `none`, which tests everything, is what the others are measured by.
inline constexpr std::array watched_accelerators{AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree,
                                                 AcceleratorKind::kdtree, AcceleratorKind::none};
inline constexpr std::size_t watched_count = watched_accelerators.size();
/// Its place among them; of those that are not watched the first.
[[nodiscard]] std::size_t watched_index(AcceleratorKind kind);

/// What a search found and how.
struct WatchedSearch {
  std::vector<SearchEvent> events;
  bool complete = true;  ///< all events are there
  TestCounts counts{};
  std::optional<double> t{};  ///< of the nearest hit, or of the blocker that was found; none: nothing
  int primitive = -1;
};

/// All searches of one ray.
struct RaySearches {
  int ray = -1;  ///< index in Timeline::rays()
  RayKind kind = RayKind::primary;
  Vec3d origin{0.0}, direction{0.0};
  std::array<WatchedSearch, watched_count> in;
};

/// How one accelerator was built, and what came of it.
struct WatchedBuild {
  std::vector<BuildStep> steps;
  bool complete = true;  ///< all steps are there
  std::vector<StructureNode> nodes;
  AcceleratorStatistics statistics;
};

/// A recording's scene in all accelerators.
class SearchWalks {
 public:
  static constexpr int most_primitives = 20000;
  static constexpr std::size_t most_nodes = 4000, most_steps = 4000;  ///< of a structure and a build, that are kept

  /// `scene`: as it was walked.
  SearchWalks(const Scene& scene, std::shared_ptr<const Timeline> timeline, Precision precision);

  [[nodiscard]] const std::shared_ptr<const Timeline>& timeline() const { return timeline_; }
  [[nodiscard]] int primitives() const { return primitives_; }
  /// Whether the scene is too large to be searched here.
  [[nodiscard]] bool too_large() const { return primitives_ > most_primitives; }
  /// Those with a box; the others are outside of all accelerators and every ray is tested against them.
  [[nodiscard]] int bounded() const { return bounded_; }
  [[nodiscard]] int unbounded() const { return unbounded_; }
  /// A primitive's box; without end for one that has none.
  [[nodiscard]] Bounds<double> box(int primitive) const;
  [[nodiscard]] const WatchedBuild& build(AcceleratorKind kind) const { return builds_[watched_index(kind)]; }
  /// What a primitive is, for people: the object's name, and which part of it.
  [[nodiscard]] std::string name(int primitive) const;
  /// Of a ray that was formed; none of a stub, or where the ray cannot be formed again.
  [[nodiscard]] std::shared_ptr<const RaySearches> search(int ray) const;

 private:
  template <class T>
  struct Bench;
  template <class T>
  void fill(const Scene& scene);

  std::shared_ptr<const Timeline> timeline_;
  int primitives_ = 0, bounded_ = 0, unbounded_ = 0;
  std::array<WatchedBuild, watched_count> builds_;
  std::vector<std::string> object_names_;
  std::variant<std::shared_ptr<const Bench<float>>, std::shared_ptr<const Bench<double>>> bench_;
};

}  // namespace raywalk
