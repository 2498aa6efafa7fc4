// All structures, and how their answers are compared.
#pragma once

#include "accel/accelerator.h"

#include <optional>

namespace raywalk::test {

inline constexpr AcceleratorKind structures[] = {
    AcceleratorKind::spheres, AcceleratorKind::ellipsoids, AcceleratorKind::boxes, AcceleratorKind::bvh,
    AcceleratorKind::grid,    AcceleratorKind::octree,     AcceleratorKind::kdtree};

template <class T>
bool same(const std::optional<Hit<T>>& a, const std::optional<Hit<T>>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->t == b->t && a->primitive == b->primitive && a->part == b->part;
}

}  // namespace raywalk::test
