#pragma once
// The Structure tab: how the search for the current ray traverses an accelerator, what each accelerator saves, and how
// it was built. All of it observes the renderer's own searches and structures.

#include "math/bounds.h"
#include "math/words.h"
#include "view/structure/room.h"

#include <memory>
#include <string>
#include <vector>

namespace raywalk {

enum class AcceleratorKind;  // accel/accelerator.h
class SearchWalks;           // inspect/search_walk.h
struct RaySearches;          // inspect/search_walk.h
struct State;

inline constexpr std::size_t max_boxes_drawn = 600;

/// Whether structures are shown: the tab is open in Trace mode.
[[nodiscard]] bool shows_structure(const State& state);
/// The number of steps of the open page.
[[nodiscard]] int structure_steps(const State& state);
/// Its current step.
[[nodiscard]] int structure_step(const State& state);

/// What was built and found elsewhere takes its place. `walks`: the room's, with builds; `searches`: of the awaited
/// ray, or null if it cannot be searched for.
void show_walks(State& state, std::shared_ptr<const SearchWalks> walks);
void show_searches(State& state, std::shared_ptr<const RaySearches> searches);

/// Whether a box is above or below the plan of a planar scene, where no ray of its walk goes.
[[nodiscard]] bool is_off_plan(const State& state, const Bounds<double>& box);

/// A line of the comparison.
struct StructureRow {
  AcceleratorKind kind;
  std::string name;
  std::vector<std::string> numbers;  ///< as many as StructurePanel::columns
};

/// The tab, as data.
struct StructurePanel {
  std::string title;
  std::string sentence;              ///< what the step did, or why there are no steps
  std::string so_far;                ///< counts; empty before the first step
  std::string counter;               ///< "3 / 17"
  std::vector<std::string> columns;  ///< headings of the numbers
  std::vector<StructureRow> rows;    ///< empty if nothing can be compared
  std::string summary;               ///< what the chosen one saves
  std::vector<std::string> notes;
};
[[nodiscard]] StructurePanel structure_panel(const State& state);

}  // namespace raywalk
