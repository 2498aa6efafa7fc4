#pragma once
// What the panels beside the plan show, as data.

#include "view/action.h"
#include "view/state.h"

#include <array>
#include <string>
#include <vector>

namespace raywalk {

// ---- Code -----------------------------------------------------------------------------------------------------------

/// The suspicion on a line while a faulty one is searched.
enum class Blame { none, marked, at_fault };

struct CodeRow {
  Line line;
  int indent;  ///< levels
  std::string text;
  bool just_run = false;    ///< highlighted: this line has just run
  bool next = false;        ///< outlined: this line runs next
  bool breakpoint = false;  ///< the walk pauses before it
  bool hovered = false;     ///< hovered here, or formed or found the ray hovered elsewhere
  Blame blame = Blame::none;
};

struct CodeBox {
  Procedure procedure;
  std::string title;  ///< "MAIN ALGORITHM" or "SHADE (DEPTH, RTNSHADE)", or path tracing's
  /// DEPTH of the executing call, or the number of rays of the path so far, for its box; 0 in the first procedure.
  /// Absent in the other box.
  std::optional<int> depth;
  std::string badge;  ///< the same as text; empty if absent or 0
  std::vector<CodeRow> rows;
};

struct CodePanel {
  std::array<CodeBox, 2> boxes;
};

[[nodiscard]] CodePanel code_panel(const State& state);

/// Whether the line forms, follows or shades rays of this kind.
[[nodiscard]] bool concerns(Line line, RayKind kind);
/// Whether a ray is highlighted in plan and tree: it is hovered, or it is of the current pixel and the hovered line
/// concerns it.
[[nodiscard]] bool is_lit(const State& state, int ray);

// ---- Ray tree -------------------------------------------------------------------------------------------------------

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

// ---- Stack ----------------------------------------------------------------------------------------------------------

struct StackRow {
  std::string title;    ///< "SHADE (DEPTH 2)" or "MAIN ALGORITHM"
  std::string ray;      ///< "reflect ray from Polygon"
  std::string object;   ///< whose surface is shaded; empty for MAIN ALGORITHM
  std::string waiting;  ///< what it waits for, or what it does
  int ray_index = -1;   ///< for hovering; -1 for MAIN ALGORITHM
  /// Colours already returned by calls from this one: "REFLSHADE" and its colour.
  struct Returned {
    std::string name;
    Rgbd linear;
    Colour colour;
  };
  std::vector<Returned> returned;
};

struct StackPanel {
  std::vector<StackRow> rows;  ///< innermost call first, MAIN ALGORITHM last
};

[[nodiscard]] StackPanel stack_panel(const State& state);

// ---- Sentence, legend, counts ---------------------------------------------------------------------------------------

/// One plain sentence on what the step did and, if a ray ended, why. At position 0, and in other modes: what to do
/// first.
[[nodiscard]] std::string sentence(const State& state);

struct LegendRow {
  RayKind kind;
  RayStyle style;  ///< dash lengths in pixels at scale 1
  std::string name;
  std::string short_name;  ///< if there is little room
  std::string meaning;     ///< one clause
};
/// Signs in the plan besides the rays.
struct LegendSign {
  std::string symbol;
  std::string meaning;
};
struct Legend {
  std::vector<LegendRow> rays;
  std::vector<LegendSign> signs;
};
[[nodiscard]] Legend legend(const State& state);

/// What has happened up to this position.
struct Counts {
  int position = 0, steps = 0;
  int pixel = 0, pixels = 0;  ///< pixels begun, and all of them
  std::array<int, ray_kind_count> formed{};
  std::array<int, ending_count> ended{};
  int depth = 0;  ///< of the line just run
};
[[nodiscard]] Counts counts(const State& state);
/// Counts in one line: "step 12 of 840 · pixel 3 · rays 5". Pixels are counted from 0, as everywhere.
[[nodiscard]] std::string status_line(const State& state);
/// The same in few letters: "12 / 840".
[[nodiscard]] std::string short_status_line(const State& state);
/// A line as wide as the widest of these in this walk, or in a slightly longer one.
[[nodiscard]] std::string widest_status_line(const State& state, bool in_short);

/// Buttons and text of an open question.
struct QuestionPanel {
  std::string text;
  struct Choice {
    action::Answer answer;
    std::string label;
  };
  std::vector<Choice> choices;  ///< the safest first
};
[[nodiscard]] QuestionPanel question_panel(const State& state);

}  // namespace raywalk
