#include "gui/tree_labels.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// Whether a part of the line lies inside of the rectangle (Liang and Barsky 1984).
bool crosses(const Rect& box, ImVec2 from, ImVec2 to) {
  float first = 0, last = 1;
  const auto inside = [&](float at, float along, float low, float high) {
    if (along == 0) return at > low && at < high;
    const float a = (low - at) / along, b = (high - at) / along;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
    return first < last;
  };
  return inside(from.x, to.x - from.x, box.x, box.right()) && inside(from.y, to.y - from.y, box.y, box.bottom());
}

/// How high a label covers this node, as a height; 0: it does not.
float covered_of_node(const Rect& label, ImVec2 node, float radius) {
  const float dx = std::abs(node.x - label.x - label.width / 2), dy = std::abs(node.y - label.y - label.height / 2);
  const float half_height = label.height / 2 + radius;
  return dx < label.width / 2 + radius && dy < half_height ? half_height - dy : 0;
}

}  // namespace

bool covers_node(const Rect& label, const TreeLabelRoom& room) {
  return std::any_of(room.nodes.begin(), room.nodes.end(),
                     [&](const ImVec2& node) { return covered_of_node(label, node, room.radius) > 0; });
}

float covered_by_label(const Rect& label, const TreeLabelRoom& room) {
  const Rect& seen = room.seen;
  const float across = std::max({seen.x - label.x, label.right() - seen.right(), 0.0f});
  const float down = std::max({seen.y - label.y, label.bottom() - seen.bottom(), 0.0f});
  float covered = 2 * (across + down);  // a letter beyond the border is lost, one over a node is not
  for (const ImVec2& node : room.nodes) covered += covered_of_node(label, node, room.radius);
  // A line can be followed past a word, a node cannot.
  for (const auto& [from, to] : room.links)
    if (crosses(label, from, to)) covered += label.height / 8;
  return covered;
}

Rect label_place(ImVec2 at, ImVec2 extent, const TreeLabelRoom& room) {
  const Rect& seen = room.seen;
  const float below = room.radius + room.gap, beside = below + room.beside,
              middle = std::clamp(at.x - extent.x / 2, seen.x, std::max(seen.x, seen.right() - extent.x));
  // In its middle, beside the node, or from the node to one side.
  const auto inside = [&](float x) { return std::clamp(x, seen.x, std::max(seen.x, seen.right() - extent.x)); };
  const float left = inside(at.x + room.radius - extent.x), right = inside(at.x - room.radius), under = at.y + below,
              over = at.y - below - extent.y;
  const Rect places[]{{middle, under, extent.x, extent.y},
                      {at.x + beside, at.y - extent.y / 2, extent.x, extent.y},
                      {at.x - beside - extent.x, at.y - extent.y / 2, extent.x, extent.y},
                      {middle, over, extent.x, extent.y},
                      {left, under, extent.x, extent.y},
                      {right, under, extent.x, extent.y},
                      {left, over, extent.x, extent.y},
                      {right, over, extent.x, extent.y}};
  return *std::min_element(std::begin(places), std::end(places), [&](const Rect& a, const Rect& b) {
    return covered_by_label(a, room) < covered_by_label(b, room);
  });
}

bool is_seen(const Rect& label, const TreeLabelRoom& room) {
  constexpr float hair = 1;
  const Rect& seen = room.seen;
  return label.x >= seen.x - hair && label.y >= seen.y - hair && label.right() <= seen.right() + hair &&
         label.bottom() <= seen.bottom() + hair;
}

bool labels_cross(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace raywalk
