#pragma once
// What a room says of itself, in the struct that is its part of the state (view/state.h has the list of rooms). All of
// it may be left out:
//
//     struct StructureRoom {
//       using Actions = Types<action::ChooseStructure, ...>;     // view/fields.h
//       static constexpr Tab tab{"structure"};                   // beside the plan
//       static void draw_tab(const Ui&, const Rect&, TabContext&);  // in gui/structure.cpp
//       static Commands commands();                              // in gui/structure.cpp
//       static constexpr Layer layer = Layer::under_rays;        // what it draws in the plan in Trace mode
//       static void draw_in_plan(Painter& painter);
//       static void follow(State& state, const Before& before);  // after every action
//       static void close(State& state);                         // before another scene is opened
//       ... its state
//     };

#include "view/fields.h"

#include <memory>
#include <span>
#include <string_view>
#include <utility>

namespace raywalk {

struct State;
class Timeline;
class Painter;

// What the window defines of a room.
struct Command;     // gui/command.h
struct Ui;          // gui/ui.h
struct Rect;        // gui/layout.h
struct TabContext;  // gui/panes.h
using Commands = std::span<const Command>;

/// A tab beside the plan, by its word.
struct Tab {
  std::string_view word;
  bool scrolls = false;  ///< by itself, or not at all; else the pane scrolls
  bool large = false;    ///< opens in the plan's place, except in an upright window, until a person exchanges the two
  bool in_plan = false;  ///< shows something in the plan, too
  friend bool operator==(const Tab&, const Tab&) = default;
};

/// Where in the plan a room draws, from below; `moving`: in Move, in place of the rays of the walk.
enum class Layer { under_rays, over_rays, moving, under_labels, on_top };

/// The walk before an action.
struct Before {
  std::shared_ptr<const Timeline> timeline;
  int position = 0;
};

/// Calls `visit.operator()<Room>()` for each of the rooms.
template <class... Rooms>
void for_each_room(Types<Rooms...>, auto&& visit) {
  (visit.template operator()<Rooms>(), ...);
}

}  // namespace raywalk
