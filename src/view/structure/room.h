#pragma once
// The accelerators, stepped (view/structure/structure.h).

#include "accel/accelerator.h"
#include "view/fields.h"
#include "view/room.h"

#include <limits>
#include <memory>
#include <optional>

namespace raywalk {

class SearchWalks;   // inspect/search_walk.h
struct RaySearches;  // inspect/search_walk.h

enum class StructurePage { search, build };
template <>
inline constexpr Word<StructurePage> words_of<StructurePage>[] = {{StructurePage::search, "search"},
                                                                  {StructurePage::build, "build"}};

}  // namespace raywalk

namespace raywalk::action {

/// Its search and its build are at the start, or at the end if the other's was.
struct ChooseStructure {
  static constexpr std::string_view word = "structure";
  AcceleratorKind kind;  ///< one of watched_accelerators
  static void fields(auto& f, auto& a) { f(a.kind); }
  void apply(State& state) const;
};
struct ShowStructurePage {
  static constexpr std::string_view word = "structure-page";
  StructurePage page;
  static void fields(auto& f, auto& a) { f(a.page); }
  void apply(State& state) const;
};
struct GoInStructure {
  static constexpr std::string_view word = "structure-go";
  int step;  ///< of the open page; clamped
  static void fields(auto& f, auto& a) { f(a.step); }
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The Structure tab.
struct StructureRoom {
  using Actions = Types<action::ChooseStructure, action::ShowStructurePage, action::GoInStructure>;
  static constexpr Tab tab{.word = "structure", .in_plan = true};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();
  static constexpr Layer layer = Layer::under_rays;
  static void draw_in_plan(Painter& painter);
  static void follow(State& state, const Before& before);

  AcceleratorKind kind{};  ///< one of watched_accelerators, made so by make_state
  StructurePage page = StructurePage::search;
  int step = 0;        ///< of the search, 0..number of events
  int build_step = 0;  ///< 0..steps of the build
  // For the timeline and its current ray, while the tab is shown; else null.
  std::shared_ptr<const SearchWalks> walks;
  std::shared_ptr<const RaySearches> searches;  ///< also null without a formed current ray
  /// Of more primitives than these, structures are built and searched elsewhere (SearchWalks::elsewhere), and shown
  /// once they are there: show_walks and show_searches.
  int most_here = std::numeric_limits<int>::max();
  struct AwaitedSearches {
    int ray;      ///< the current one
    bool to_end;  ///< they will be shown to their end
  };
  std::optional<AwaitedSearches> awaited;  ///< `searches` are then null
};

}  // namespace raywalk
