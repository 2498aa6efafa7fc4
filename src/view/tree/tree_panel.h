#pragma once
// The ray tree, as data.

#include "view/state.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// A ray of the tree, or the stub of one that was not formed.
struct TreeNode {
  int ray;      ///< index in Timeline::rays()
  int parent;   ///< index in TreePanel::nodes, always smaller; -1 for the primary ray
  double x, y;  ///< column (leaves are 1 apart) and level (0: the primary ray)
  RayKind kind;
  bool formed;   ///< false: a stub
  bool known;    ///< its end has been found at this position
  bool future;   ///< not yet formed at this position: drawn as an outline, its texts are empty
  bool current;  ///< the ray of the line that has just run
  bool hovered;
  bool returned;                 ///< its SHADE has returned
  std::optional<Ending> ending;  ///< where `known`
  std::string symbol;            ///< one or two characters for how it ended
  std::string label;             ///< what it hit: the object's or light's name, or why it ended
  std::string throughput;        ///< at most this fraction of the pixel: "100%"
  Colour colour;                 ///< of its kind
  Colour shade;                  ///< its returned radiance, if `returned`; else the colour of an empty cell
};

struct TreePanel {
  std::string empty;            ///< what to do where there are no nodes
  int cell = -1;                ///< column of the pixel whose tree this is; -1: no pixel yet, no nodes
  double columns = 0;           ///< extent: x in 0..columns - 1
  int levels = 0;               ///< y in 0..levels - 1
  std::vector<TreeNode> nodes;  ///< parents before children
};

/// The tooltip of a node, in a line or two.
[[nodiscard]] std::string node_text(const State& state, const TreeNode& node);

/// The tree of the current pixel, as far as it is known. It is laid out as the whole tree from the start, so that
/// nothing moves during the walk.
[[nodiscard]] TreePanel tree_panel(const State& state);

}  // namespace raywalk
