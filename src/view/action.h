#pragma once
// User actions. A window turns clicks and keys into actions; a demo file and tests pass them directly. An action is one
// struct, in the room that it belongs to: view/fields.h says what it is made of.

#include "view/state.h"

#include <variant>

namespace raywalk {

namespace rooms {

template <class Room>
struct ActionsOf {
  using Type = Types<>;
};
template <class Room>
  requires requires { typename Room::Actions; }
struct ActionsOf<Room> {
  using Type = typename Room::Actions;
};
template <class... As, class... Bs>
Types<As..., Bs...> operator+(Types<As...>, Types<Bs...>);
template <class... As>
std::variant<As...> one_of(Types<As...>);
template <class... Rs>
decltype(one_of((typename ActionsOf<Rs>::Type() + ...))) actions_of(Types<Rs...>);

}  // namespace rooms

using Action = decltype(rooms::actions_of(Rooms()));

/// Applies an action. Any action in any state leads to a valid state (view/state.h), with a scene that could be saved.
/// An action with a number that is not finite is ignored. While a question or a path prompt is open, only answers,
/// appearance, ticks and resizing have an effect.
void update(State& state, const Action& action);

/// Whether `target` exists in the state's scene and timeline.
[[nodiscard]] bool exists(const State& state, const Target& target);

}  // namespace raywalk
