// Breakpoints and steps by calls, as a person uses them.
#include "fixtures.h"
#include "view/action_text.h"
#include "view/walk/code_panel.h"
#include "view/walk/walk.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State at_start() {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  return state;
}

/// Ticks of a sixtieth of a second, until `seconds` have passed.
void wait(State& state, double seconds) {
  for (int tick = 0; tick < static_cast<int>(seconds * 60); ++tick) update(state, action::Tick{1.0 / 60});
}

}  // namespace

TEST_CASE("over, out and their ways back are steps like the others") {
  State state = at_start();
  while (state.walk.timeline->next(state.walk.position)->line != Line::shade_final) update(state, action::Step{});
  const int before = state.walk.position;
  update(state, action::Step{true, Grain::over});
  CHECK(state.walk.timeline->just_run(state.walk.position)->line == Line::compute_rtnshade);
  CHECK(state.walk.timeline->just_run(state.walk.position)->depth == 1);
  const int after = state.walk.position;
  update(state, action::Step{false, Grain::over});
  CHECK(state.walk.position == before);
  update(state, action::Step{true, Grain::line});
  update(state, action::Step{true, Grain::out});
  CHECK(state.walk.position == after);
  update(state, action::Jump{before + 3});
  update(state, action::Step{false, Grain::out});
  CHECK(state.walk.position == before);
}

TEST_CASE("AUTO, Run on, long steps and a run to a line come to rest before a line with a breakpoint") {
  const Line line = Line::form_reflect_ray;
  const auto rests_there = [&](const State& state) {
    return state.walk.timeline->next(state.walk.position) != nullptr &&
           state.walk.timeline->next(state.walk.position)->line == line;
  };
  State state = at_start();
  update(state, action::ToggleBreakpoint{line});
  for (const CodeBox& box : code_panel(state).boxes)
    for (const CodeRow& row : box.rows) CHECK(row.breakpoint == (row.line == line));
  update(state, action::RunOn{});
  REQUIRE(rests_there(state));
  const int first = state.walk.position;
  update(state, action::RunOn{});
  REQUIRE(rests_there(state));
  CHECK(state.walk.position > first);
  update(state, action::RunOn{false});
  CHECK(state.walk.position == first);
  update(state, action::RunOn{false});
  CHECK(state.walk.position == 0);

  for (const Grain grain : {Grain::ray, Grain::pixel, Grain::over, Grain::out}) {
    update(state, action::Jump{first - 1});
    update(state, action::Step{true, grain});
    CHECK(state.walk.position == first);
  }
  update(state, action::Jump{0});
  update(state, action::RunToLine{Line::put_final_shade});
  while (state.walk.position < first) update(state, action::RunToLine{Line::put_final_shade});
  CHECK(state.walk.position == first);

  update(state, action::Jump{0});
  update(state, action::SetSpeed{1000});
  update(state, action::PlayPause{});
  wait(state, 5);
  CHECK(state.walk.position == first);
  CHECK_FALSE(state.walk.playing);
  // It goes on from there, and the step by hand is not held up.
  update(state, action::Step{});
  CHECK(state.walk.position == first + 1);

  update(state, action::ToggleBreakpoint{line});
  update(state, action::RunOn{});
  CHECK(state.walk.position == state.walk.timeline->steps());
}

TEST_CASE("a condition stops a walk after the line that has brought it about") {
  State state = at_start();
  update(state, action::StopAt{3});
  update(state, action::RunOn{});
  const std::vector<int> calls = state.walk.timeline->stack(state.walk.position);
  REQUIRE_FALSE(calls.empty());
  CHECK(state.walk.timeline->frames()[static_cast<std::size_t>(calls.front())].depth == 3);
  CHECK(state.walk.timeline->frames()[static_cast<std::size_t>(calls.front())].called_at == state.walk.position);
}

TEST_CASE("where else a walk stops leaves its lines, and is removed with them") {
  State state = at_start();
  update(state, action::ToggleBreakpoint{Line::compute_rtnshade});
  const action::StopAt chosen{2, 4, true, 1};
  update(state, chosen);
  CHECK(state.walk.breakpoints.is_before(Line::compute_rtnshade));
  CHECK(state.walk.breakpoints.object == state.scene().objects[1].name);
  CHECK(write_action(stops_chosen(state)) == write_action(chosen));
  update(state, action::StopAt{0, -1, false, 99});
  CHECK(write_action(stops_chosen(state)) == write_action(action::StopAt{}));
  CHECK(state.walk.breakpoints.any());
  update(state, action::RemoveBreakpoints{});
  CHECK_FALSE(state.walk.breakpoints.any());
}

TEST_CASE("a stop at an object follows it when it is renamed, and when that is undone or done again") {
  State state = at_start();
  const Scene before = state.scene();
  update(state, action::StopAt{0, -1, false, 1});
  update(state, action::RunOn{});
  const int stop = state.walk.position;
  REQUIRE(stop < state.walk.timeline->steps());
  const auto check_it_stops = [&](const std::string& name) {
    CHECK(state.walk.breakpoints.object == name);
    CHECK(stops_chosen(state).object == 1);
    update(state, action::Jump{0});
    update(state, action::RunOn{});
    CHECK(state.walk.position == stop);
  };
  update(state, action::Rename{{TargetKind::object, 1}, "Marble"});
  check_it_stops("Marble");
  update(state, action::Undo{});
  check_it_stops(before.objects[1].name);
  update(state, action::Redo{});
  check_it_stops("Marble");
  // Another's new name is none of its.
  update(state, action::Rename{{TargetKind::object, 0}, "Pebble"});
  check_it_stops("Marble");
}

TEST_CASE("a stop at an object that is gone is told nowhere, and comes back with the object") {
  State state = at_start();
  update(state, action::StopAt{0, -1, false, 1});
  state.plan.selected = {TargetKind::object, 1};
  update(state, action::RemoveSelected{});
  CHECK(stops_chosen(state).object == -1);
  CHECK_FALSE(breakpoints_here(state).any());
  CHECK_FALSE(breakpoints_in_force(state).any());
  update(state, action::Undo{});
  CHECK(stops_chosen(state).object == 1);
  CHECK(breakpoints_here(state).any());
  // Where another is gone it is the same object as before.
  state.plan.selected = {TargetKind::object, 0};
  update(state, action::RemoveSelected{});
  CHECK(stops_chosen(state).object == 0);
}

TEST_CASE("STEP goes faster the longer it is held, and stops when it is let go") {
  State state = at_start();
  update(state, action::Hold{true});
  wait(state, 1);
  const int one = state.walk.position;
  wait(state, 1);
  const int two = state.walk.position - one;
  CHECK(one >= 5);
  CHECK(two > one * 3 / 2);
  // The click with which the button is let go is no step more.
  const int held = state.walk.position;
  update(state, action::Step{});
  CHECK(state.walk.position == held);
  CHECK_FALSE(state.walk.hold);
  update(state, action::Hold{false});
  wait(state, 0.5);
  CHECK(state.walk.position < held);
  update(state, action::Release{});
  const int released = state.walk.position;
  wait(state, 1);
  CHECK(state.walk.position == released);
  update(state, action::Hold{true});
  wait(state, 60);
  CHECK(state.walk.position == state.walk.timeline->steps());
  CHECK_FALSE(state.walk.hold);
}

TEST_CASE("a breakpoint ends a hold, and so does leaving Trace") {
  State state = at_start();
  update(state, action::ToggleBreakpoint{Line::compute_rtnshade});
  update(state, action::Hold{true});
  wait(state, 20);
  REQUIRE(state.walk.timeline->next(state.walk.position) != nullptr);
  CHECK(state.walk.timeline->next(state.walk.position)->line == Line::compute_rtnshade);
  CHECK_FALSE(state.walk.hold);
  const int rest = state.walk.position;
  update(state, action::Hold{true});
  update(state, action::SetMode{Mode::move});
  wait(state, 2);
  CHECK(state.walk.position == rest);
}
