#pragma once
// The accelerators, stepped: how the search for the ray in hand goes through the boxes of one of them, what each of
// them spares, and how it was built. All of it is the renderer's own search and its own structures, watched.

#include "math/bounds.h"

#include <memory>
#include <string>
#include <vector>

namespace raywalk {

enum class AcceleratorKind;  // accel/accelerator.h
class SearchWalks;           // timeline/search_walk.h
struct RaySearches;          // timeline/search_walk.h
struct State;

enum class StructurePage { search, build };

/// What the Structure tab shows.
struct StructureSitting {
  AcceleratorKind kind{};  ///< one of watched_accelerators, made so by make_state
  StructurePage page = StructurePage::search;
  int step = 0;        ///< of the search, 0..its events
  int build_step = 0;  ///< 0..steps of the build
  // Made while the tab is shown, of the timeline and its ray in hand; null else.
  std::shared_ptr<const SearchWalks> walks;
  std::shared_ptr<const RaySearches> searches;  ///< null also where no ray is in hand that was formed
};

inline constexpr std::size_t most_boxes_drawn = 600;

/// Whether structures are shown: the tab is open in Trace mode.
[[nodiscard]] bool shows_structure(const State& state);
/// How many steps the page that is open has.
[[nodiscard]] int structure_steps(const State& state);
/// Which of them it has come to.
[[nodiscard]] int structure_step(const State& state);

/// Whether a box lies above or below the plan of a planar scene, where no ray of its walk goes.
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
  std::string sentence;              ///< what the step did; or why there is nothing to step through
  std::string so_far;                ///< counts; empty before the first step
  std::string counter;               ///< "3 / 17"
  std::vector<std::string> columns;  ///< heads of the numbers
  std::vector<StructureRow> rows;    ///< empty where nothing can be compared
  std::string summary;               ///< what the chosen one spares
  std::vector<std::string> notes;
};
[[nodiscard]] StructurePanel structure_panel(const State& state);

}  // namespace raywalk
