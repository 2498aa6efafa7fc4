#pragma once
// The searches for a recorded ray in each accelerator, observed; and how each accelerator was built.

#include "accel/watched.h"
#include "text/language.h"
#include "timeline/timeline.h"
#include "trace/kernel.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// The accelerators that are observed side by side. `none`, which tests everything, is the baseline.
inline constexpr std::array watched_accelerators{AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree,
                                                 AcceleratorKind::kdtree, AcceleratorKind::none};
inline constexpr std::size_t watched_count = watched_accelerators.size();
/// Its index among them; 0 for those that are not observed.
[[nodiscard]] std::size_t watched_index(AcceleratorKind kind);

/// What a search found, and how.
struct WatchedSearch {
  std::vector<SearchEvent> events;
  bool complete = true;  ///< all events are there
  TestCounts counts{};
  std::optional<double> t{};  ///< of the closest hit, or of the blocker found; none: nothing found
  int primitive = -1;
};

/// All searches of one ray.
struct RaySearches {
  int ray = -1;  ///< index in Timeline::rays()
  RayKind kind = RayKind::primary;
  Vec3d origin{0.0}, direction{0.0};
  std::array<WatchedSearch, watched_count> in;
};

/// How one accelerator was built, and the result.
struct WatchedBuild {
  std::vector<BuildStep> steps;
  bool complete = true;  ///< all steps are there
  std::vector<StructureNode> nodes;
  AcceleratorStatistics statistics;
};

/// A recording's scene in all accelerators.
class SearchWalks {
 public:
  static constexpr int max_primitives = 20000;
  static constexpr std::size_t max_nodes = 4000, max_steps = 4000;  ///< of a structure and of a build; more are not
                                                                    ///< kept

  /// `scene`: the recorded one.
  SearchWalks(const Scene& scene, std::shared_ptr<const Timeline> timeline, Precision precision);

  [[nodiscard]] const std::shared_ptr<const Timeline>& timeline() const { return timeline_; }
  [[nodiscard]] int primitives() const { return primitives_; }
  /// Whether the scene is too large to be observed.
  [[nodiscard]] bool too_large() const { return primitives_ > max_primitives; }
  /// The number of primitives with a box; the others are outside all accelerators and tested against every ray.
  [[nodiscard]] int bounded() const { return bounded_; }
  [[nodiscard]] int unbounded() const { return unbounded_; }
  /// A primitive's box; infinite for one that has none.
  [[nodiscard]] Bounds<double> box(int primitive) const;
  [[nodiscard]] const WatchedBuild& build(AcceleratorKind kind) const { return builds_[watched_index(kind)]; }
  /// A primitive's readable name: the object's as shown in `language`, and which part of it.
  [[nodiscard]] std::string name(int primitive, Language language) const;
  /// Of a formed ray; null for a stub, or if the ray cannot be retraced.
  [[nodiscard]] std::shared_ptr<const RaySearches> search(int ray) const;

 private:
  template <class T>
  struct PreparedScene;
  template <class T>
  void fill(const Scene& scene);

  std::shared_ptr<const Timeline> timeline_;
  int primitives_ = 0, bounded_ = 0, unbounded_ = 0;
  std::array<WatchedBuild, watched_count> builds_;
  std::vector<std::string> object_names_, translated_names_;
  std::variant<std::shared_ptr<const PreparedScene<float>>, std::shared_ptr<const PreparedScene<double>>> prepared_;
};

}  // namespace raywalk
