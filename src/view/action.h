#pragma once
// User actions. A window turns clicks and keys into actions; a demo file and tests pass them directly. An action is one
// struct, in the room that it belongs to: view/fields.h says what it is made of.

#include "view/state.h"

#include <any>
#include <cstddef>
#include <type_traits>
#include <utility>

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
template <class... Rs>
decltype((typename ActionsOf<Rs>::Type() + ...)) actions_of(Types<Rs...>);

/// The place of a type in a list of types; as many as there are if it is not among them.
template <class T, class... Ts>
[[nodiscard]] constexpr std::size_t place_of(Types<Ts...>) {
  std::size_t place = 0;
  static_cast<void>(((std::is_same_v<T, Ts> ? false : (++place, true)) && ...));
  return place;
}
template <class... Ts>
[[nodiscard]] constexpr std::size_t count_of(Types<Ts...>) {
  return sizeof...(Ts);
}

}  // namespace rooms

/// The actions of all rooms.
using AllActions = decltype(rooms::actions_of(Rooms()));
inline constexpr std::size_t action_kinds = rooms::count_of(AllActions());

/// Any of them. No std::variant: whoever passed an action on compiled what a hundred kinds need to be copied, and names
/// that list them all.
class Action {
 public:
  template <class A>
    requires(rooms::place_of<A>(AllActions()) < action_kinds)
  Action(A action) : kind_(rooms::place_of<A>(AllActions())), value_(std::move(action)) {}

  /// Its place among all actions.
  [[nodiscard]] std::size_t kind() const { return kind_; }
  /// The action, if it is an A.
  template <class A>
  [[nodiscard]] const A* as() const {
    return std::any_cast<A>(&value_);
  }
  template <class A>
  [[nodiscard]] bool is() const {
    return kind_ == rooms::place_of<A>(AllActions());
  }

 private:
  std::size_t kind_;
  std::any value_;
};

/// Applies an action. Any action in any state leads to a valid state (view/state.h), with a scene that could be saved.
/// An action with a number that is not finite is ignored. While a question or a path prompt is open, only answers,
/// appearance, ticks and resizing have an effect.
void update(State& state, const Action& action);

/// Whether `target` exists in the state's scene and timeline.
[[nodiscard]] bool exists(const State& state, const Target& target);

}  // namespace raywalk
