#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_geometry.h"
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

bool exists(const State& state, const Target& target) {
  const Scene& scene = state.scene();
  const auto within = [&](std::size_t size) {
    return target.index >= 0 && static_cast<std::size_t>(target.index) < size;
  };
  const auto shape = [&]<class S>(std::in_place_type_t<S>) -> const S* {
    if (!within(scene.objects.size())) return nullptr;
    const Object& object = scene.objects[static_cast<std::size_t>(target.index)];
    return object.transform.empty() ? std::get_if<S>(&object.shape) : nullptr;  // transformed shapes have no handles
  };
  switch (target.kind) {
    case TargetKind::nothing:
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_distance:
      return true;
    case TargetKind::screen_height:
      return target.part == 0 || target.part == 1;
    case TargetKind::cell:
      return target.index >= 0 && target.index < scene.camera.screen.cells;
    case TargetKind::object:
      return within(scene.objects.size());
    case TargetKind::radius:
      return shape(std::in_place_type<Sphere<double>>) != nullptr;
    case TargetKind::corner:
    case TargetKind::edge: {
      const auto* prism = shape(std::in_place_type<Prism<double>>);
      return prism != nullptr && target.part >= 0 && target.part < prism->sides();
    }
    case TargetKind::rotation:
      return shape(std::in_place_type<Prism<double>>) != nullptr;
    case TargetKind::light:
      return within(scene.lights.size());
    case TargetKind::light_radius:
      return within(scene.lights.size()) && has_radius(scene.lights[static_cast<std::size_t>(target.index)]);
    case TargetKind::ray:
      return within(state.walk.timeline->rays().size());
  }
  return false;
}

}  // namespace raywalk
