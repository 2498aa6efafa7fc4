#pragma once
// What a room says of itself, in the struct that is its part of the state (view/state.h has the list of rooms). All of
// it may be left out:
//
//     struct StructureRoom {
//       using Actions = Types<action::ChooseStructure, ...>;     // view/fields.h
//       static constexpr Tab tab{"structure"};                   // beside the plan; drawn by gui/structure.cpp
//       static constexpr Layer layer = Layer::under_rays;        // what it draws in the plan in Trace mode
//       static void draw_in_plan(Painter& painter);
//       static void follow(State& state, const Before& before);  // after every action
//       ... its state
//     };

#include "view/fields.h"

#include <memory>
#include <string_view>
#include <utility>

namespace raywalk {

struct State;
class Timeline;
class Painter;

/// A tab beside the plan, by its word.
struct Tab {
  std::string_view word;
  bool scrolls = false;  ///< by itself, or not at all; else the pane scrolls
  friend bool operator==(const Tab&, const Tab&) = default;
};

/// Where in the plan a room draws, from below.
enum class Layer { under_rays, over_rays, under_labels, on_top };

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
