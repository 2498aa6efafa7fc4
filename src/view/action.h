#pragma once
// User actions. A window turns clicks and keys into actions; a demo file and tests pass them directly. An action is one
// struct, in the room that it belongs to: view/fields.h says what it is made of.

#include "view/appearance/actions.h"
#include "view/bugs/actions.h"
#include "view/cost/actions.h"
#include "view/document/actions.h"
#include "view/export/actions.h"
#include "view/lesson/actions.h"
#include "view/microscope/actions.h"
#include "view/picture/actions.h"
#include "view/plan/actions.h"
#include "view/predict/actions.h"
#include "view/space/actions.h"
#include "view/structure/actions.h"
#include "view/walk/actions.h"

#include <variant>

namespace raywalk {

namespace action {

template <class... As, class... Bs>
Types<As..., Bs...> operator+(Types<As...>, Types<Bs...>);
template <class... As>
std::variant<As...> one_of(Types<As...>);

}  // namespace action

using Action = decltype(action::one_of(action::OfWalk() + action::OfPlan() + action::OfSpace() + action::OfPicture() +
                                       action::OfDocument() + action::OfAppearance() + action::OfLesson() +
                                       action::OfCost() + action::OfBugs() + action::OfMicroscope() +
                                       action::OfPredict() + action::OfExport() + action::OfStructure()));

/// Applies an action. Any action in any state leads to a valid state (view/state.h), with a scene that could be saved.
/// An action with a number that is not finite is ignored. While a question or a path prompt is open, only answers,
/// appearance, ticks and resizing have an effect.
void update(State& state, const Action& action);

/// Whether `target` exists in the state's scene and timeline.
[[nodiscard]] bool exists(const State& state, const Target& target);

}  // namespace raywalk
