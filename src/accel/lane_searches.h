#pragma once
// The loops of searches over meshes, compiled for each width (accel/width.h).

#include "accel/packet_search.h"
#include "accel/wide_search.h"

namespace raywalk {

/// What `next` of either search calls, by whether nearer boxes come first.
struct LaneSearches {
  bool (*alone[2])(WideSearch<MeshRay>& search, float t_far);
  bool (*together[2])(PacketSearch& search);
};

/// Of the width that searches take now.
[[nodiscard]] const LaneSearches& lane_searches();

/// The loop of a search with a record: of nodes, which are the same at every width.
[[nodiscard]] bool (*watched_search(bool nearest_first))(WideSearch<MeshRay>& search, float t_far);

extern const LaneSearches searches_four, searches_eight, searches_masked;

}  // namespace raywalk
