#pragma once
// An accelerator that records what it does: the same structure as the renderer's, built and searched by the same code.

#include "accel/accelerator.h"
#include "accel/build_record.h"
#include "accel/search_record.h"

#include <memory>
#include <vector>

namespace raywalk {

template <class T>
class WatchedAccelerator {
 public:
  /// Over primitives that outlive it and have been in an Accelerator, which has found the equal ones. `kind`: not
  /// `automatic`. At most `max_steps` steps of the build are kept.
  WatchedAccelerator(const Primitives<T>& primitives, AcceleratorKind kind, std::size_t max_steps,
                     const Stop& stop = {});

  /// Accelerator::closest, recorded. `AnyRay` is a Ray or a NaiveRay.
  template <class AnyRay>
  [[nodiscard]] std::optional<Hit<T>> closest(const AnyRay& ray, T t_max, TestCounts& counts,
                                              SearchRecord& record) const;
  /// Accelerator::occluded_or_filtered, or with empty `roles` Accelerator::occluded, recorded.
  template <class AnyRay>
  [[nodiscard]] bool occluded(const AnyRay& ray, T t_max, TestCounts& counts, const std::vector<ShadowRole>& roles,
                              SearchRecord& record) const;

  [[nodiscard]] const BuildRecord& build() const { return build_; }
  /// The boxes of the structure's nodes or cells, at most `most`: parents before children.
  [[nodiscard]] std::vector<StructureNode> nodes(std::size_t most) const;
  [[nodiscard]] AcceleratorStatistics statistics() const;

 private:
  struct Structure;
  template <class AnyRay, class Query>
  void search(const AnyRay& ray, Query& query) const;

  const Primitives<T>& primitives_;
  std::vector<int> unbounded_;
  BuildRecord build_;
  std::shared_ptr<const Structure> structure_;
};

extern template class WatchedAccelerator<float>;
extern template class WatchedAccelerator<double>;

}  // namespace raywalk
