#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/pointer.h"
#include "view/walk/walk.h"

#include <array>
#include <cmath>

namespace raywalk {

namespace {

/// Whether the numbers of an action are what its fields ask for. Whole values (a material, a shape) are checked by the
/// rules of the scene format.
struct NumberCheck {
  bool passed = true;

  void operator()(double value, Number rule = Number::finite) {
    passed = passed && (rule == Number::any || (std::isfinite(value) && (rule != Number::positive || value > 0) &&
                                                (rule != Number::not_negative || value >= 0)));
  }
  void operator()(int) {}
  void operator()(const std::string&) {}
  void operator()(const std::string&, FilePath) {}
  void operator()(bool, Either) {}
  void operator()(bool, Flag) {}
  template <class Value>
  void operator()(const Value&, Unwritten) {}
  template <class Value>
  void operator()(const Value& value) {
    each_field(*this, value);
  }
};

/// Whether the action has an effect while a question or a path prompt is open.
bool is_heard(const State& state, const Traits& traits) {
  if (traits.always) return true;
  if (state.document.question)
    return traits.answers_question ||
           (traits.postpones_recovery && state.document.question->kind == Question::Kind::recover);
  return state.document.prompt == PathPrompt::none || traits.answers_prompt;
}

/// What `update` asks of a kind of action.
struct Kind {
  bool (*has_good_numbers)(const Action& action);
  Traits (*traits)(const Action& action);
  void (*apply)(const Action& action, State& state);
};
template <class A>
constexpr Kind kind_of{[](const Action& action) {
                         NumberCheck numbers;
                         each_field(numbers, *action.as<A>());
                         return numbers.passed;
                       },
                       [](const Action& action) { return traits_of(*action.as<A>()); },
                       [](const Action& action, State& state) { action.as<A>()->apply(state); }};
constexpr auto kinds = []<class... As>(Types<As...>) {
  return std::array<Kind, sizeof...(As)>{kind_of<As>...};
}(AllActions());

}  // namespace

void update(State& state, const Action& action) {
  const Kind& kind = kinds[action.kind()];
  const Traits traits = kind.traits(action);
  if (!kind.has_good_numbers(action) || !is_heard(state, traits)) return;
  if (state.plan.drag && !traits.keeps_drag) end_drag(state);
  if (state.bugs.hunt && traits.of_own_scene) action::LeaveHunt{}.apply(state);
  if (!traits.keeps_tween) state.walk.tween.reset();
  const Before before{state.walk.timeline, state.walk.position};
  kind.apply(action, state);
  for_each_room(Rooms(), [&]<class Room>() {
    if constexpr (requires { Room::follow(state, before); }) Room::follow(state, before);
  });
}

}  // namespace raywalk
