#pragma once

#include "accel/wide_search.h"

namespace raywalk {

/// The loop of a WideSearch, eight lanes at a time: only where `lane_widths` has LaneWidth::eight.
[[nodiscard]] bool (*advance_eight(bool nearest_first))(WideSearch<MeshRay>& search, float t_far);

}  // namespace raywalk
