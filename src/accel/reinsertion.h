#pragma once

#include "accel/binary_tree.h"
#include "math/stop.h"

namespace raywalk {

/// Takes subtrees out of a tree, those first that rays are likeliest to meet, and puts each back where it makes the
/// inner nodes least likely to be met (MeetingChance). Leaves stay as they are.
///
/// J. Bittner, M. Hapala and V. Havran, "Fast Insertion-Based Optimization of Bounding Volume Hierarchies", 2013; what
/// a place costs, and when a search for one may end, as D. Meister and J. Bittner, "Parallel Reinsertion for Bounding
/// Volume Hierarchy Optimization", 2018.
void reinsert_subtrees(BinaryTree& tree, const Stop& stop);

}  // namespace raywalk
