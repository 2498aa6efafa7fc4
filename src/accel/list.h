#pragma once

#include "accel/build_record.h"
#include "accel/primitives.h"

namespace raywalk {

/// No structure: every ray is tested against every primitive. The oracle for all others.
template <class T>
class List {
 public:
  explicit List(int count) : count_(count) {}

  template <class AnyRay, class Query>
  [[gnu::flatten]] void search(const AnyRay& /*ray*/, const Primitives<T>& primitives, Query& query) const {
    for (int id = 0, end = count_; id < end; ++id)
      if (query.test(primitives, id)) return;
  }

  /// It has none.
  void list_nodes(std::vector<StructureNode>& /*nodes*/, std::size_t /*most*/) const {}

  [[nodiscard]] AcceleratorStatistics statistics() const { return {0, static_cast<std::size_t>(count_), 0, 0}; }

 private:
  int count_;
};

}  // namespace raywalk
