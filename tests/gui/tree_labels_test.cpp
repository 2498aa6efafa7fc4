#include "gui/tree_labels.h"

#include <array>
#include <utility>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

namespace {

// A tree that is seen from 0 to 400 and from 0 to 200, with nodes of radius 10.
TreeLabelRoom room_with(const std::vector<ImVec2>& nodes) { return {{0, 0, 400, 200}, nodes, 10, 4}; }

}  // namespace

TEST_CASE("a label of the ray tree stands below its node, where there is room") {
  const std::vector<ImVec2> nodes{{200, 40}, {100, 160}, {300, 160}};
  const Rect place = label_place(nodes[0], {80, 16}, room_with(nodes));
  CHECK(place == Rect{160, 54, 80, 16});
  CHECK(covered_by_label(place, room_with(nodes)) == 0);
}

TEST_CASE("a label of the ray tree stands beside its node, or above it, where nodes stand below") {
  const std::vector<ImVec2> crowd{{200, 40}, {180, 66}, {220, 66}};
  const Rect beside = label_place(crowd[0], {80, 16}, room_with(crowd));
  CHECK(beside == Rect{214, 32, 80, 16});
  CHECK(covered_by_label(beside, room_with(crowd)) == 0);
  // A row of nodes on both sides, and more below.
  const std::vector<ImVec2> rows{{200, 100}, {160, 100}, {240, 100}, {170, 124}, {200, 124}, {230, 124}};
  const Rect above = label_place(rows[0], {60, 16}, room_with(rows));
  CHECK(above == Rect{170, 70, 60, 16});
}

TEST_CASE("a label of the ray tree is moved inside of the pane's border") {
  const std::vector<ImVec2> nodes{{15, 40}, {390, 40}};
  CHECK(label_place(nodes[0], {80, 16}, room_with(nodes)) == Rect{0, 54, 80, 16});
  CHECK(label_place(nodes[1], {80, 16}, room_with(nodes)) == Rect{320, 54, 80, 16});
  // The lowest row has no room below.
  const std::vector<ImVec2> low{{200, 188}};
  const Rect place = label_place(low[0], {80, 16}, room_with(low));
  CHECK(place.bottom() <= 200);
  CHECK(covered_by_label(place, room_with(low)) == 0);
}

TEST_CASE("what a label of the ray tree covers is counted once a node, and twice beyond the border") {
  const std::vector<ImVec2> nodes{{100, 100}, {120, 100}};
  const TreeLabelRoom room = room_with(nodes);
  CHECK(covered_by_label({60, 92, 100, 16}, room) == Approx(2 * 18));
  CHECK(covered_by_label({60, 20, 100, 16}, room) == 0);
  CHECK(covered_by_label({-30, 20, 100, 16}, room) == Approx(2 * 30));
  CHECK(labels_cross({0, 0, 10, 10}, {9, 9, 10, 10}));
  CHECK_FALSE(labels_cross({0, 0, 10, 10}, {10, 0, 10, 10}));
}

TEST_CASE("a label of the ray tree leaves links and the halo of its node free, where there is room") {
  const std::vector<ImVec2> nodes{{200, 40}, {200, 160}};
  const std::vector<std::pair<ImVec2, ImVec2>> links{{nodes[0], nodes[1]}};
  TreeLabelRoom room = room_with(nodes);
  room.links = links;
  room.beside = 3;
  const Rect place = label_place(nodes[0], {80, 16}, room);
  CHECK(place == Rect{217, 32, 80, 16});
  CHECK(covered_by_label(place, room) == 0);
  // Over a link, but not over a node.
  CHECK(covered_by_label({160, 90, 80, 16}, room) == Approx(2));
  CHECK(covered_by_label({201, 90, 80, 16}, room) == 0);
}

TEST_CASE("a label of the ray tree stands towards one side, where links leave its node on the other") {
  // Links to the right, above and below, and the border on the left.
  const std::vector<ImVec2> nodes{{120, 100}, {200, 60}, {200, 140}, {40, 100}};
  const std::vector<std::pair<ImVec2, ImVec2>> links{{nodes[1], nodes[0]}, {nodes[0], nodes[2]}, {nodes[0], nodes[3]}};
  TreeLabelRoom room = room_with(nodes);
  room.links = links;
  const Rect place = label_place(nodes[0], {70, 16}, room);
  CHECK(place == Rect{60, 114, 70, 16});
  CHECK(covered_by_label(place, room) == 0);
}

TEST_CASE("a label of the ray tree that the border would cut is known") {
  const std::vector<ImVec2> nodes{{200, 100}};
  const TreeLabelRoom room = room_with(nodes);
  CHECK(is_seen({0, 0, 400, 200}, room));
  CHECK_FALSE(is_seen({10, -3, 80, 16}, room));
  CHECK_FALSE(is_seen({330, 10, 80, 16}, room));
}

TEST_CASE("whether a label of the ray tree stands over a node is known, whatever else it stands over") {
  const std::vector<ImVec2> nodes{{200, 40}, {100, 160}};
  const TreeLabelRoom room = room_with(nodes);
  CHECK_FALSE(covers_node({180, 54, 40, 16}, room));
  CHECK(covers_node({180, 44, 40, 16}, room));
  CHECK(covers_node({60, 152, 40, 16}, room));
  CHECK_FALSE(covers_node({380, 190, 40, 16}, room));  // beyond the border alone
}
