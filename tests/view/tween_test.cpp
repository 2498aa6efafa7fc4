// Steps in motion: a ray grows when it is formed and shrinks to its end when that is found, and then stands exactly
// where it would have stood at once.
#include "view/walk/tween.h"

#include "fixtures.h"
#include "support/catch.h"
#include "view/action.h"
#include "view/drawing/svg.h"
#include "view/plan/plan_view.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State in_motion() {
  State state = busy_state();
  update(state, action::SetMode{Mode::trace});
  update(state, action::SetTweens{true});
  return state;
}

int current(const State& state) { return state.walk.timeline->current_ray(state.walk.position); }

/// How long the ray under way is drawn; 0 where it is not.
double drawn_length(const State& state) {
  double sum = 0;  // of its pieces
  for (const DisplayItem& item : plan_view(state))
    if (const auto* line = std::get_if<LineItem>(&item.shape);
        line != nullptr && item.target == Target{TargetKind::ray, current(state)})
      sum += length(line->to - line->from);
  return sum;
}

std::string drawn(const State& state) {
  std::string all;
  for (const DisplayItem& item : plan_view(state)) all += svg_element(item.shape);
  return all;
}

/// The same place without any motion.
std::string drawn_at_once(State state) {
  state.walk.tween.reset();
  return drawn(state);
}

/// Goes by lines to where the next ray has just been formed, or its end found.
void step_to(State& state, int RayRecord::* when) {
  do {
    update(state, action::Step{true, Grain::line});
    REQUIRE(state.walk.position < state.walk.timeline->steps());
  } while (current(state) < 0 ||
           state.walk.timeline->rays()[static_cast<std::size_t>(current(state))].*when != state.walk.position);
}

}  // namespace

TEST_CASE("a ray grows when it is formed, faster at first, and then stands as if it had stood there at once") {
  State state = in_motion();
  step_to(state, &RayRecord::formed_at);
  REQUIRE(state.walk.tween);
  CHECK(growth_of(state, current(state))->from_start);
  CHECK(drawn_length(state) == 0);
  const double step = tween_seconds(state) / 5;
  double before = 0, gained = 1e9;
  for (int i = 1; i < 5; ++i) {
    update(state, action::Tick{step});
    const double now = drawn_length(state);
    CHECK(now > before);
    CHECK(now - before < gained);
    gained = now - before, before = now;
    CHECK(drawn(state) != drawn_at_once(state));
  }
  update(state, action::Tick{1.01 * step});
  CHECK_FALSE(state.walk.tween);
  CHECK(drawn_length(state) > before);
}

TEST_CASE("a ray shrinks to the end that is found for it, and what stands there comes after it") {
  State state = in_motion();
  const auto hits_in_sight = [&] {
    const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(current(state))];
    const Vec2d end = to_pixels(state, plan(ray.end));
    return ray.ending == Ending::hit && end.x > 0 && end.x < state.plan.viewport.width && end.y > 0 &&
           end.y < state.plan.viewport.height;
  };
  do step_to(state, &RayRecord::found_at);
  while (!hits_in_sight());
  REQUIRE(state.walk.tween);
  CHECK_FALSE(growth_of(state, current(state))->from_start);
  State whole = state;
  whole.walk.tween.reset();
  CHECK(drawn_length(state) > drawn_length(whole));
  CHECK(plan_view(state).size() < plan_view(whole).size());  // its normal is not there yet
  update(state, action::Tick{tween_seconds(state) / 2});
  CHECK(drawn_length(state) > drawn_length(whole));
  update(state, action::Tick{tween_seconds(state)});
  CHECK(drawn(state) == drawn(whole));
}

TEST_CASE("only a small step forward moves") {
  State state = in_motion();
  update(state, action::Jump{state.walk.timeline->steps()});
  CHECK_FALSE(state.walk.tween);
  update(state, action::Step{false, Grain::line});
  CHECK_FALSE(state.walk.tween);
  update(state, action::Clear{});
  CHECK_FALSE(state.walk.tween);
  update(state, action::Step{true, Grain::pixel});
  CHECK_FALSE(state.walk.tween);
  update(state, action::Clear{});
  update(state, action::Step{true, Grain::ray});
  CHECK(state.walk.tween);
  update(state, action::SetTweens{false});
  CHECK_FALSE(state.walk.tween);
  update(state, action::Step{true, Grain::ray});
  CHECK_FALSE(state.walk.tween);
}

TEST_CASE("whatever is done next finds the step complete, and a pointer that passes by does not hurry it") {
  State state = in_motion();
  step_to(state, &RayRecord::formed_at);
  update(state, action::PointerMoved{{10, 10}});
  CHECK(state.walk.tween);
  update(state, action::Undo{});
  CHECK_FALSE(state.walk.tween);
  step_to(state, &RayRecord::found_at);
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(state.walk.tween);
}

TEST_CASE("AUTO leaves each ray the time to arrive, and moves nothing where there is none") {
  State state = in_motion();
  update(state, action::SetSpeed{4});
  update(state, action::PlayPause{});
  CHECK(tween_seconds(state) < 1 / state.walk.lines_per_second);
  update(state, action::SetSpeed{2});
  CHECK(tween_seconds(state) < 0.4);
  bool moved = false;
  for (int i = 0; i < 200 && state.walk.playing; ++i) {
    update(state, action::Tick{0.05});
    moved |= state.walk.tween.has_value();
  }
  CHECK(moved);
  update(state, action::SetSpeed{100});
  CHECK(tween_seconds(state) == 0);
  for (int i = 0; i < 20 && state.walk.playing; ++i) {
    update(state, action::Tick{0.01});
    CHECK_FALSE(state.walk.tween);
  }
}

TEST_CASE("a picture of the window is taken of what stands still") {
  State state = in_motion();
  step_to(state, &RayRecord::formed_at);
  update(state, action::Export{"walk.png"});
  CHECK(state.exports.window);
  CHECK_FALSE(state.walk.tween);
  update(state, action::Jump{state.walk.position + 1});
  CHECK_FALSE(state.walk.tween);
}
