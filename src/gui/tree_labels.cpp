#include "gui/tree_labels.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

float covered_by_label(const Rect& label, const TreeLabelRoom& room) {
  const Rect& seen = room.seen;
  const float across = std::max({seen.x - label.x, label.right() - seen.right(), 0.0f});
  const float down = std::max({seen.y - label.y, label.bottom() - seen.bottom(), 0.0f});
  float covered = 2 * (across + down);  // a letter beyond the border is lost, one over a node is not
  const float half_width = label.width / 2 + room.radius, half_height = label.height / 2 + room.radius;
  for (const ImVec2& node : room.nodes) {
    const float dx = std::abs(node.x - label.x - label.width / 2), dy = std::abs(node.y - label.y - label.height / 2);
    if (dx < half_width && dy < half_height) covered += half_height - dy;
  }
  return covered;
}

Rect label_place(ImVec2 at, ImVec2 extent, const TreeLabelRoom& room) {
  const Rect& seen = room.seen;
  const float beside = room.radius + room.gap,
              middle = std::clamp(at.x - extent.x / 2, seen.x, std::max(seen.x, seen.right() - extent.x));
  const Rect places[]{{middle, at.y + beside, extent.x, extent.y},
                      {at.x + beside, at.y - extent.y / 2, extent.x, extent.y},
                      {at.x - beside - extent.x, at.y - extent.y / 2, extent.x, extent.y},
                      {middle, at.y - beside - extent.y, extent.x, extent.y}};
  return *std::min_element(std::begin(places), std::end(places), [&](const Rect& a, const Rect& b) {
    return covered_by_label(a, room) < covered_by_label(b, room);
  });
}

bool labels_cross(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace raywalk
