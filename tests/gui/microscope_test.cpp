// The microscope by mouse and keys.

#include "gui/bench.h"
#include "gui/command.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State at_a_hit() {
  State state = classic();
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{3});
  while (state.walk.timeline->current_ray(state.walk.position) < 0 ||
         state.walk.timeline->rays()[static_cast<std::size_t>(state.walk.timeline->current_ray(state.walk.position))]
                 .ending != Ending::hit)
    update(state, action::Step{true});
  update(state, action::RunToLine{Line::if_reflective});
  return state;
}

}  // namespace

TEST_CASE("the microscope's tab has the plan's room, and keys and buttons magnify") {
  Bench bench(at_a_hit());
  bench.frames(2);
  bench.click("tab-microscope");
  REQUIRE(bench.state.appearance.tab == MicroscopeRoom::tab);
  bench.frames(2);
  CHECK(bench.rect("microscope").width > 0.3f * 1280);
  CHECK(bench.has("microscope/row-0"));
  CHECK(bench.has("microscope/sentence"));
  CHECK(bench.has("step"));  // the walk goes on beside it

  CHECK(bench.state.microscope.magnified == 0);
  bench.click("magnify");
  CHECK(bench.state.microscope.magnified > 0);
  bench.click("to-numbers");
  CHECK(bench.state.microscope.magnified == 1);
  bench.key("Shift+Z");
  CHECK(bench.state.microscope.magnified < 1);
  bench.key("Z");
  CHECK(bench.state.microscope.magnified == 1);
  bench.key("Alt+Shift+Z");
  CHECK(bench.state.microscope.magnified == 0);
  bench.key("Alt+Z");
  CHECK(bench.state.microscope.magnified == 1);
  bench.point_at("microscope");
  bench.wheel(-2);
  CHECK(bench.state.microscope.magnified < 1);
  bench.drag("magnification", -300, 0);
  CHECK(bench.state.microscope.magnified == 0);
}

TEST_CASE("numerics and precision are chosen in the microscope, epsilon is typed") {
  Bench bench(at_a_hit());
  update(bench.state, action::SetTab{MicroscopeRoom::tab});
  bench.frames(2);
  bench.click("numerics-naive");
  CHECK(bench.state.scene().render.numerics == Numerics::naive);
  bench.key("Shift+Q");
  CHECK(bench.state.scene().render.numerics == Numerics::robust);
  bench.click("precision-float");
  CHECK(bench.state.picture.settings.single_precision);
  bench.key("Alt+Shift+Q");
  CHECK_FALSE(bench.state.picture.settings.single_precision);
  bench.double_click("property/Epsilon");
  bench.type("0.5");
  bench.enter();
  bench.frames(2);
  CHECK(bench.state.scene().render.epsilon == 0.5);
  bench.key("Ctrl+Z");
  CHECK(bench.state.scene().render.epsilon == default_epsilon);
}

TEST_CASE("before a hit the microscope says what to do") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::trace});
  update(bench.state, action::SetTab{MicroscopeRoom::tab});
  bench.frames(3);
  CHECK_FALSE(bench.has("microscope"));
  CHECK(bench.has("to-numbers"));
}

TEST_CASE("numerics of the scene stand in the settings of the picture") {
  Bench bench;
  bench.frames(2);
  bench.key(",");
  bench.frames(3);
  bench.click("property/Numerics");
  bench.frames(2);
  bench.click("property/Numerics/naive");
  CHECK(bench.state.scene().render.numerics == Numerics::naive);
  CHECK(bench.has("property/Epsilon"));
}
