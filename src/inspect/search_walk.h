#pragma once
// The searches for a recorded ray in each accelerator, observed; and how each accelerator was built.

#include "inspect/watched_structures.h"
#include "text/language.h"
#include "timeline/timeline.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// All searches of one ray.
struct RaySearches {
  int ray = -1;  ///< index in Timeline::rays()
  RayKind kind = RayKind::primary;
  Vec3d origin{0.0}, direction{0.0};
  WatchedSearches in;
};

/// A recording's scene in all accelerators.
class SearchWalks {
 public:
  static constexpr int max_primitives = 20000;

  /// `scene`: the recorded one. `worlds`: of it; null: a world is built for this alone. With more than `most_here`
  /// primitives nothing is built here: it waits for `take`.
  SearchWalks(const Scene& scene, std::shared_ptr<const Timeline> timeline, Precision precision,
              WorldCache* worlds = nullptr, int most_here = std::numeric_limits<int>::max());

  [[nodiscard]] const std::shared_ptr<const Timeline>& timeline() const { return timeline_; }
  [[nodiscard]] Precision precision() const;
  [[nodiscard]] int primitives() const { return primitives_; }
  /// Whether the scene is too large to be observed.
  [[nodiscard]] bool too_large() const { return primitives_ > max_primitives; }
  /// Whether its structures stand elsewhere: `search` finds nothing here.
  [[nodiscard]] bool elsewhere() const { return !structures_ && !too_large(); }
  /// Whether its builds are still to be taken.
  [[nodiscard]] bool waits() const { return elsewhere() && !taken_; }
  /// The same with what was built elsewhere, of the same scene.
  [[nodiscard]] std::shared_ptr<const SearchWalks> take(std::array<WatchedBuild, watched_count> builds) const;

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
  /// What to search for elsewhere; none where `search` would be null here, too.
  [[nodiscard]] std::optional<AnySearchedRay> searched(int ray) const;
  /// What was found for it.
  [[nodiscard]] std::shared_ptr<const RaySearches> found(int ray, const AnySearchedRay& asked,
                                                         WatchedSearches searches) const;

 private:
  template <class T>
  struct PreparedScene;
  template <class T>
  void fill(const Scene& scene, WorldCache& worlds);

  std::shared_ptr<const Timeline> timeline_;
  int primitives_ = 0, bounded_ = 0, unbounded_ = 0;
  bool taken_ = false;
  std::array<WatchedBuild, watched_count> builds_;
  std::vector<std::string> object_names_, translated_names_;
  std::variant<std::shared_ptr<const PreparedScene<float>>, std::shared_ptr<const PreparedScene<double>>> prepared_;
  std::shared_ptr<const WatchedStructures> structures_;  ///< null: they stand elsewhere, or are too large
};

}  // namespace raywalk
