#pragma once
// A scene's primitives in all accelerators that are observed: how each was built, and searches for a ray in each. Of
// SearchWalks it is the part that takes long, so it takes and gives plain values: a page has it done by a worker
// (gui/structure_workers.h).

#include "accel/watched.h"
#include "render/world_cache.h"
#include "trace/kernel.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// The accelerators that are observed side by side. `none`, which tests everything, is the baseline.
inline constexpr std::array watched_accelerators{AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree,
                                                 AcceleratorKind::kdtree, AcceleratorKind::none};
inline constexpr std::size_t watched_count = watched_accelerators.size();
/// Its index among them; 0 for those that are not observed.
[[nodiscard]] std::size_t watched_index(AcceleratorKind kind);

/// How one accelerator was built, and the result.
struct WatchedBuild {
  std::vector<BuildStep> steps;
  bool complete = true;  ///< all steps are there
  std::vector<StructureNode> nodes;
  AcceleratorStatistics statistics;
};

/// What a search found, and how.
struct WatchedSearch {
  std::vector<SearchEvent> events;
  bool complete = true;  ///< all events are there
  TestCounts counts{};
  std::optional<double> t{};  ///< of the closest hit, or of the blocker found; none: nothing found
  int primitive = -1;
};
using WatchedSearches = std::array<WatchedSearch, watched_count>;

/// A ray that is searched for, in the precision and the numerics of its recording.
template <class T>
struct SearchedRay {
  Ray<T> ray{};
  bool naive = false;   ///< it is searched for as textbooks do: NaiveRay(ray)
  bool shadow = false;  ///< any blocker ends the search, and not the closest
  T t_far = 0;          ///< where the ray ends, in its own t; infinite for most
};
using AnySearchedRay = std::variant<SearchedRay<float>, SearchedRay<double>>;

class WatchedStructures {
 public:
  static constexpr std::size_t max_nodes = 4000, max_steps = 4000;  ///< of a structure and of a build; more are not
                                                                    ///< kept

  /// In this scene, none of them built yet. `worlds`: of the scene.
  WatchedStructures(const Scene& scene, Precision precision, WorldCache& worlds);

  /// Builds that of watched_accelerators[index], after those before it.
  [[nodiscard]] WatchedBuild build(std::size_t index);
  /// In all of them, once they are built. `ray`: of this precision, from one of the scene's primitives or from none.
  [[nodiscard]] WatchedSearches search(const AnySearchedRay& ray) const;

 private:
  template <class T>
  struct InPrecision {
    std::shared_ptr<const World<T>> world;
    std::vector<WatchedAccelerator<T>> accelerators;  ///< by place in watched_accelerators
  };
  std::variant<InPrecision<float>, InPrecision<double>> in_;
};

}  // namespace raywalk
