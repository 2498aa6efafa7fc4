#pragma once
// Where the labels of the ray tree stand.

#include "gui/layout.h"

#include <imgui.h>

#include <span>
#include <utility>

namespace raywalk {

/// What a label of the tree keeps off, in ImGui's units.
struct TreeLabelRoom {
  Rect seen;                                              ///< the visible part of the tree
  std::span<const ImVec2> nodes;                          ///< the middles of all nodes
  float radius = 0;                                       ///< of a node
  float gap = 0;                                          ///< between a node and its label
  float beside = 0;                                       ///< more of it, to the left and to the right
  std::span<const std::pair<ImVec2, ImVec2>> links = {};  ///< between nodes
};

/// What of a label of this size stands over nodes or beyond the border, as heights added up, and a little for each link
/// under it; 0: nothing.
[[nodiscard]] float covered_by_label(const Rect& label, const TreeLabelRoom& room);

/// Whether it stands over a node.
[[nodiscard]] bool covers_node(const Rect& label, const TreeLabelRoom& room);

/// The label's place by the node at `at`: below it, unless that covers more than a place beside it, above it, or
/// towards one side.
[[nodiscard]] Rect label_place(ImVec2 at, ImVec2 extent, const TreeLabelRoom& room);

/// Whether all of it is within the border.
[[nodiscard]] bool is_seen(const Rect& label, const TreeLabelRoom& room);

[[nodiscard]] bool labels_cross(const Rect& a, const Rect& b);

}  // namespace raywalk
