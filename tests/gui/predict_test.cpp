// Predictions by mouse and keys, on the bench.

#include "view/predict/predict.h"
#include "gui/bench.h"
#include "support/catch.h"
#include "view/walk/asked.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("predictions by keys and mouse: on, the arrow, STEP, the banner stays where it is, off") {
  Bench bench;
  bench.frames(2);
  CHECK_FALSE(bench.has("banner"));
  bench.key("Ctrl+P");
  CHECK(bench.state.walk.mode == Mode::trace);
  REQUIRE(bench.has("banner"));
  const Rect banner = bench.rect("banner"), plan = bench.interface().layout().plan;
  CHECK(banner.bottom() <= plan.y);
  while (!aim_origin(bench.state)) bench.key("Space");
  CHECK(bench.rect("banner").height == banner.height);
  CHECK(bench.interface().layout().plan.y == plan.y);
  bench.move_to(plan.x + 40, plan.y + 40);
  bench.press();
  bench.move_to(plan.x + 60, plan.y + 60);
  bench.release();
  REQUIRE(bench.state.predictions.open);
  bench.key("Space");
  CHECK(bench.state.predictions.made.size() == 1);
  bench.key("Ctrl+Shift+P");
  CHECK(bench.state.document.prompt == PathPrompt::save_predictions);
  bench.frames(2);
  CHECK(bench.has("browser-accept"));
  bench.key("Escape");
  CHECK(bench.state.document.prompt == PathPrompt::none);
  bench.key("Ctrl+P");
  bench.frames(2);
  CHECK_FALSE(bench.has("banner"));
}
