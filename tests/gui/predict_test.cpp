// Predictions by mouse and keys, on the bench.

#include "view/predict/predict.h"
#include "gui/bench.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
#include "view/walk/asked.h"

#include <cmath>
#include <filesystem>
#include <numbers>

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

TEST_CASE("predictions by keys alone: up and down turn the arrow, and go from thing to thing") {
  Bench bench;
  bench.frames(2);
  bench.key("Ctrl+P");
  while (!aim_origin(bench.state)) bench.key("Space");
  const auto angle = [&] {
    const Vec2d& arrow = bench.state.predictions.open->arrow;
    return std::atan2(arrow.y, arrow.x) * 180 / std::numbers::pi;
  };
  bench.key("Down");
  REQUIRE(bench.state.predictions.open);
  CHECK(angle() == Approx(90));
  for (const char* key : {"Down", "Down", "Up", "Shift+Up", "Shift+Up"}) bench.key(key);
  CHECK(angle() == Approx(87));
  bench.key("Space");
  CHECK(bench.state.predictions.made.size() == 1);
  const auto asks_for_end = [&] {
    const auto asked = prediction_asked(bench.state);
    return asked && asked->what == PredictionKind::end;
  };
  while (!asks_for_end()) bench.key("Space");
  const auto met = [&] { return bench.state.predictions.open->met; };
  bench.key("Down");
  REQUIRE(bench.state.predictions.open);
  CHECK(met() == Target{TargetKind::object, 0});
  bench.key("Down");
  CHECK(met() == Target{TargetKind::object, 1});
  for (const char* key : {"Up", "Up"}) bench.key(key);
  CHECK(met() == Target{});
  bench.key("Up");
  CHECK(met() == Target{TargetKind::light, static_cast<int>(bench.state.scene().lights.size()) - 1});
  bench.key("Right");  // STEP
  CHECK(bench.state.predictions.made.size() == 2);
  // Nothing is asked any more.
  bench.key("Ctrl+P");
  bench.key("Down");
  CHECK_FALSE(bench.state.predictions.open);
}

TEST_CASE("predictions are saved with an ending, whether it is typed or not") {
  const TemporaryFolder folder;
  for (const char* name : {"mine", "yours.csv", "theirs.txt"}) {
    Bench bench;
    bench.frames(2);
    bench.key("Ctrl+P");
    while (!aim_origin(bench.state)) bench.key("Space");
    for (const char* key : {"Up", "Space", "Ctrl+Shift+P"}) bench.key(key);
    bench.frames(2);
    bench.type(folder.file(name));
    bench.enter();

    const std::string file = folder.file(std::string(name) == "mine" ? "mine.csv" : name);
    CAPTURE(name);
    CHECK(std::filesystem::exists(file));
  }
}
