#include "accel/reinsertion.h"

#include "accel/lane_box.h"

#include <algorithm>
#include <utility>

namespace raywalk {

namespace {

class Reinsertion {
 public:
  Reinsertion(BinaryTree& tree, const Stop& stop)
      : nodes_(tree.nodes), chance_(tree.chance), stop_(stop), parents_(nodes_.size()), heights_(nodes_.size()) {
    // Children come after their parents.
    for (std::uint32_t at = 0; at < nodes_.size(); ++at)
      if (!nodes_[at].leaf()) adopt(at);
    for (auto at = static_cast<std::uint32_t>(nodes_.size()); at-- > 0;)
      if (!nodes_[at].leaf()) join(at);
  }

  /// One pass over the `most` nodes that are likeliest to be met.
  void pass(std::size_t most) {
    // The root and its children have no other place.
    std::vector<std::pair<float, std::uint32_t>> likeliest;
    likeliest.reserve(nodes_.size());
    for (std::uint32_t at = 3; at < nodes_.size(); ++at) likeliest.emplace_back(-chance(at), at);
    most = std::min(most, likeliest.size());
    std::nth_element(likeliest.begin(), likeliest.begin() + static_cast<std::ptrdiff_t>(most), likeliest.end());
    likeliest.resize(most);
    std::sort(likeliest.begin(), likeliest.end());
    for (const auto& [less, at] : likeliest) {
      stop_.check();
      if (parents_[at] == 0) continue;
      if (const std::uint32_t to = place_for(at); to != 0) move(at, to);
    }
  }

 private:
  [[nodiscard]] LaneBox box(std::uint32_t at) const { return LaneBox(nodes_[at].box); }
  [[nodiscard]] float chance(std::uint32_t at) const { return chance_(box(at)); }
  static std::uint32_t sibling(std::uint32_t at) { return at % 2 == 0 ? at - 1 : at + 1; }
  void adopt(std::uint32_t at) { parents_[nodes_[at].left] = parents_[nodes_[at].left + 1] = at; }
  /// Makes an inner node what its children are together: where space was split, its box may have been larger.
  void join(std::uint32_t at) {
    BinaryNode& node = nodes_[at];
    LaneBox both = box(node.left);
    both.include(box(node.left + 1));
    node.box = both.bounds();
    node.count = nodes_[node.left].count, node.count += nodes_[node.left + 1].count;
    heights_[at] = static_cast<std::uint8_t>(1 + std::max(heights_[node.left], heights_[node.left + 1]));
  }

  /// The node that `moved` had better be the sibling of; 0 where it stands well.
  [[nodiscard]] std::uint32_t place_for(std::uint32_t moved) {
    const LaneBox own = box(moved);
    const float own_chance = chance_(own);
    std::uint32_t best = 0;
    float most_saved = 0;
    // From the bottom up, the subtrees beside the path to the root; `saved`: by taking `moved` out of what is below.
    LaneBox left_behind;  // without it
    float saved = chance(parents_[moved]);
    for (std::uint32_t at = moved; at != 0; at = parents_[at]) {
      const std::uint32_t beside = sibling(at);
      waiting_.push_back({saved, beside});
      while (!waiting_.empty()) {
        const auto [before, to] = waiting_.back();
        waiting_.pop_back();
        // The new parent will be at least as large as the node.
        if (!(before - own_chance > most_saved)) continue;
        LaneBox both = box(to);
        const float alone = chance_(both);
        both.include(own);
        const float after = before - chance_(both);
        if (after > most_saved) best = to, most_saved = after;
        if (nodes_[to].leaf()) continue;
        waiting_.push_back({after + alone, nodes_[to].left});
        waiting_.push_back({after + alone, nodes_[to].left + 1});
      }
      left_behind.include(box(beside));
      if (at != moved) saved += chance(parents_[at]) - chance_(left_behind);
    }
    return best;
  }

  void move(std::uint32_t moved, std::uint32_t to) {
    std::size_t depth = 1;
    for (std::uint32_t at = to; at != 0; at = parents_[at]) ++depth;
    if (depth + std::max(heights_[moved], heights_[to]) >= BinaryTree::most_levels) return;
    // The sibling takes the parent's place, and what was at `to` the sibling's.
    const std::uint32_t parent = parents_[moved], beside = sibling(moved);
    const auto put = [&](const BinaryNode& node, std::uint8_t height, std::uint32_t at) {
      nodes_[at] = node;
      heights_[at] = height;
      if (!node.leaf()) adopt(at);
    };
    const BinaryNode stays = nodes_[beside], joined = nodes_[to];
    const std::uint8_t height_of_stays = heights_[beside], height_of_joined = heights_[to];
    nodes_[to].left = std::min(moved, beside);
    put(joined, height_of_joined, beside);
    put(stays, height_of_stays, parent);
    adopt(to);
    for (std::uint32_t at : {to, parent})
      for (;; at = parents_[at]) {
        if (!nodes_[at].leaf()) join(at);
        if (at == 0) break;
      }
  }

  std::vector<BinaryNode>& nodes_;
  MeetingChance chance_;
  const Stop& stop_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint8_t> heights_;  ///< levels below
  struct Waiting {
    float saved;  ///< with the boxes above enlarged
    std::uint32_t node;
  };
  std::vector<Waiting> waiting_;
};

}  // namespace

void reinsert_subtrees(BinaryTree& tree, const Stop& stop) {
  Reinsertion reinsertion(tree, stop);
  // Most of what there is to gain, in a few hundredths of the time that the build takes.
  constexpr std::size_t passes = 3, one_in = 20;
  for (std::size_t pass = 0; pass < passes; ++pass) reinsertion.pass(tree.nodes.size() / one_in);
}

}  // namespace raywalk
