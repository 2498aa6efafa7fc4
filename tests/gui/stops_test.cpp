// Breakpoints, steps by calls and holding STEP, by mouse and keys.

#include "gui/bench.h"
#include "gui/command.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State tracing_classic(int position = 0) {
  State state = classic();
  update(state, action::Jump{position});
  return state;
}

}  // namespace

TEST_CASE("a click left of a line sets its breakpoint, a click on the line runs to it") {
  Bench bench(tracing_classic());
  bench.frames(2);
  const std::string number = std::to_string(static_cast<int>(Line::form_reflect_ray));
  bench.click("break-" + number);
  CHECK(bench.state.walk.breakpoints.is_before(Line::form_reflect_ray));
  CHECK(bench.state.walk.position == 0);
  bench.key("W");
  CHECK(bench.state.walk.timeline->next(bench.state.walk.position)->line == Line::form_reflect_ray);
  bench.click("break-" + number);
  CHECK_FALSE(bench.state.walk.breakpoints.any());
  bench.click("line-" + number);
  CHECK(bench.state.walk.timeline->just_run(bench.state.walk.position)->line == Line::form_reflect_ray);
}

TEST_CASE("the arrows up and down step over and out of SHADE") {
  Bench bench(tracing_classic(5));
  bench.obedient = false;
  const auto asked = [&](const std::string& key) {
    bench.forget();
    bench.key(key);
    REQUIRE(bench.last<action::Step>() != nullptr);
    return *bench.last<action::Step>();
  };
  CHECK(asked("Down").grain == Grain::over);
  CHECK(asked("Down").forward);
  CHECK_FALSE(asked("Shift+Down").forward);
  CHECK(asked("Up").grain == Grain::out);
  CHECK_FALSE(asked("Shift+Up").forward);
}

TEST_CASE("STEP that is held down holds, and is let go") {
  Bench bench(tracing_classic(20));
  bench.frames(2);
  bench.point_at("step");
  bench.press();
  bench.frames(40);
  REQUIRE(bench.state.walk.hold);
  CHECK(bench.state.walk.hold->forward);
  update(bench.state, action::Tick{0.5});
  const int held = bench.state.walk.position;
  CHECK(held > 20);
  bench.release();
  CHECK_FALSE(bench.state.walk.hold);
  CHECK(bench.state.walk.position == held);
  // A short click is one step.
  bench.click("step");
  CHECK(bench.state.walk.position == held + 1);
  bench.point_at("step-back");
  bench.press();
  bench.frames(40);
  REQUIRE(bench.state.walk.hold);
  CHECK_FALSE(bench.state.walk.hold->forward);
  bench.release();
}

TEST_CASE("a key that repeats holds STEP") {
  Bench bench(tracing_classic(20));
  bench.key("Right");
  CHECK(bench.state.walk.position == 21);
  bench.repeat("Right");
  REQUIRE(bench.state.walk.hold);
  CHECK(bench.state.walk.hold->forward);
  CHECK(bench.state.walk.position == 21);
}

TEST_CASE("the popup goes to a step and sets conditions") {
  Bench bench(tracing_classic(20));
  bench.frames(2);
  bench.click("status");
  REQUIRE(bench.has("breakpoints-popup"));
  // It stands beside the code, inside the window.
  const Rect popup = bench.rect("breakpoints-popup");
  CHECK(popup.x >= 0);
  CHECK(popup.right() <= bench.interface().layout().side.x + 1);
  CHECK(popup.bottom() <= 720);
  bench.click("property/Total internal reflection");
  CHECK(bench.state.walk.breakpoints.total_internal_reflection);
  bench.click("remove-breakpoints");
  CHECK_FALSE(bench.state.walk.breakpoints.any());
}

TEST_CASE("the popup's key puts the keyboard into the step to go to") {
  Bench bench(tracing_classic(20));
  bench.frames(2);
  bench.key("J");
  bench.frames(4);
  REQUIRE(bench.has("breakpoints-popup"));
  bench.type("100");
  CHECK(bench.state.walk.position == 20);
  bench.enter();
  CHECK(bench.state.walk.position == 100);
}
