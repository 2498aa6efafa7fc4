#pragma once

#include "accel/packet_search.h"

namespace raywalk {

/// The loop of a PacketSearch, eight lanes at a time: only where `lane_widths` has LaneWidth::eight.
[[nodiscard]] bool (*advance_packet_eight(bool nearest_first))(PacketSearch& search);

}  // namespace raywalk
