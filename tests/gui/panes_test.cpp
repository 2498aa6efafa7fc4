// What the panes make of the pointer.

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "gui/bench.h"
#include "gui/command.h"
#include "support/catch.h"
#include "view/document/question.h"
#include "view/legend/legend.h"
#include "view/plan/plan_view.h"
#include "view/stack/stack_panel.h"
#include "view/tree/tree_panel.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State at(int position, Mode mode = Mode::trace) {
  State state = classic();
  update(state, action::Jump{position});
  update(state, action::SetMode{mode});
  return state;
}

// Where a SHADE that another one called has just formed a ray.
State deep() {
  State state = classic();
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    const Event& event = *state.walk.timeline->just_run(position);
    if (event.depth >= 2 && std::holds_alternative<RayFormed>(event.detail)) return at(position);
  }
  FAIL("the classic scene has no ray of a second SHADE");
  return state;
}

// Where a point of the scene stands in the window.
ImVec2 in_window(const Bench& bench, const Vec2d& point) {
  const Vec2d pixels = to_pixels(bench.state.plan.camera, bench.state.plan.viewport, point);
  const Rect& pane = bench.interface().layout().plan;
  return {pane.x + static_cast<float>(pixels.x) * bench.dpi, pane.y + static_cast<float>(pixels.y) * bench.dpi};
}

Vec2d centre_of(const State& state, std::size_t object) {
  return plan(std::get<Sphere<double>>(state.scene().objects[object].shape).centre);
}

// The first object of the classic scene that is a sphere.
std::size_t first_sphere(const State& state) {
  const auto& objects = state.scene().objects;
  std::size_t i = 0;
  while (!std::holds_alternative<Sphere<double>>(objects.at(i).shape)) ++i;
  return i;
}

}  // namespace

TEST_CASE("the plan learns the size of its pane") {
  Bench bench;
  bench.frames(2);
  CHECK(bench.state.plan.viewport.width == Approx(bench.interface().layout().plan.width));
  CHECK(bench.state.plan.viewport.height == Approx(bench.interface().layout().plan.height));
  bench.resize(900, 600);
  CHECK(bench.state.plan.viewport.width == Approx(bench.interface().layout().plan.width));
}

TEST_CASE("on a dense display the plan is told its size in its own pixels") {
  Bench bench;
  bench.dpi = bench.unit = 2;
  bench.resize(2560, 1440);
  CHECK(bench.state.plan.viewport.width == Approx(bench.interface().layout().plan.width / 2));
}

TEST_CASE("an object is dragged with the mouse, as one entry of undo") {
  Bench bench(at(0, Mode::move));
  bench.frames(2);
  const std::size_t sphere = first_sphere(bench.state);
  const Vec2d before = centre_of(bench.state, sphere);
  const ImVec2 from = in_window(bench, before);
  bench.move_to(from.x, from.y);
  CHECK(bench.state.plan.hovered == Target{TargetKind::object, static_cast<int>(sphere)});
  bench.press();
  bench.move_to(from.x + 20, from.y);
  bench.move_to(from.x + 50, from.y - 30);
  bench.release();
  const Vec2d after = centre_of(bench.state, sphere);
  CHECK((after.x - before.x) * bench.state.plan.camera.pixels_per_unit == Approx(50).margin(0.01));
  CHECK((after.y - before.y) * bench.state.plan.camera.pixels_per_unit == Approx(30).margin(0.01));
  CHECK(bench.state.document.undo.size() == 1);
  CHECK_FALSE(bench.state.plan.drag.has_value());
}

TEST_CASE("a drag goes on outside the pane and ends where the button is released") {
  Bench bench(at(0, Mode::move));
  bench.frames(2);
  const ImVec2 from = in_window(bench, centre_of(bench.state, first_sphere(bench.state)));
  bench.move_to(from.x, from.y);
  bench.press();
  bench.move_to(1270, 700);
  REQUIRE(bench.state.plan.drag.has_value());
  CHECK(bench.state.plan.drag->moved);
  bench.release();
  CHECK_FALSE(bench.state.plan.drag.has_value());
}

TEST_CASE("the wheel zooms about the pointer, and the pointer's leaving is told") {
  Bench bench(at(0, Mode::move));
  bench.frames(2);
  const double before = bench.state.plan.camera.pixels_per_unit;
  bench.point_at("plan");
  bench.wheel(1);
  CHECK(bench.state.plan.camera.pixels_per_unit > before);
  bench.forget();
  bench.point_at("step");
  CHECK(bench.last<action::PointerLeft>() != nullptr);
  CHECK_FALSE(bench.state.plan.pointer.has_value());
}

TEST_CASE("a click on a line of code runs to it, pointing at it lights it up") {
  Bench bench(at(0));
  bench.frames(2);
  const std::string line = "line-" + std::to_string(static_cast<int>(Line::compute_rtnshade));
  bench.point_at(line);
  CHECK(bench.state.plan.hovered_line == Line::compute_rtnshade);
  bench.click(line);
  REQUIRE(bench.last<action::RunToLine>() != nullptr);
  CHECK(bench.last<action::RunToLine>()->line == Line::compute_rtnshade);
  CHECK(bench.state.walk.timeline->just_run(bench.state.walk.position)->line == Line::compute_rtnshade);
  bench.point_at("step");
  CHECK_FALSE(bench.state.plan.hovered_line.has_value());
}

TEST_CASE("the scrub bar goes to any position") {
  Bench bench(at(0));
  bench.frames(2);
  const Rect bar = bench.rect("scrub");
  bench.move_to(bar.x + bar.width / 2, bar.y + bar.height / 2);
  bench.press();
  const int steps = bench.state.walk.timeline->steps();
  CHECK(bench.state.walk.position == Approx(steps / 2.0).margin(2));
  bench.move_to(bar.right() + 200, bar.y);
  CHECK(bench.state.walk.position == steps);
  bench.move_to(bar.x - 200, bar.y);
  CHECK(bench.state.walk.position == 0);
  bench.release();
}

TEST_CASE("the speed slider covers its range and keeps to it") {
  Bench bench(at(0));
  bench.frames(2);
  bench.drag("speed", 500, 0);
  CHECK(bench.state.walk.lines_per_second == max_speed);
  bench.drag("speed", -500, 0);
  CHECK(bench.state.walk.lines_per_second == min_speed);
}

TEST_CASE("the tree's nodes light their rays up and go to their steps") {
  Bench bench(deep());
  update(bench.state, action::SetTab{TreeRoom::tab});
  bench.frames(3);
  const TreePanel tree = tree_panel(bench.state);
  REQUIRE(tree.nodes.size() > 2);
  const int ray = tree.nodes[1].ray;
  const std::string node = "node-" + std::to_string(ray);
  // The tree may have been scrolled to where the walk stands: exchanged with the plan it has room for all.
  bench.click("exchange");
  bench.point_at(node);
  CHECK(bench.state.plan.hovered_ray == ray);
  bench.click(node);
  REQUIRE(bench.last<action::JumpToRay>() != nullptr);
  CHECK(bench.state.walk.position == bench.state.walk.timeline->rays()[static_cast<std::size_t>(ray)].formed_at);
  bench.point_at("step");
  CHECK(bench.state.plan.hovered_ray == -1);
}

TEST_CASE("the tree keeps its current node in sight, and below the picture where that is larger") {
  for (const bool upright : {false, true}) {
    Bench bench(deep());
    if (upright) bench.resize(768, 1024);
    update(bench.state, action::ShowTreeBeside{true});
    const int steps = bench.state.walk.timeline->steps();
    for (int position = steps / 8; position <= steps; position += steps / 8) {
      update(bench.state, action::Jump{position});
      bench.frames(4);
      CAPTURE(upright, position);
      const Rect image = bench.rect("image"), pane = bench.rect("tree-beside/pane");
      if (upright)
        CHECK(pane.y >= image.bottom());
      else
        CHECK(pane.x >= image.right());
      for (const TreeNode& node : tree_panel(bench.state).nodes) {
        if (!node.current) continue;
        const Rect disc = bench.rect("node-" + std::to_string(node.ray));
        CHECK((disc.x >= pane.x && disc.right() <= pane.right()));
        CHECK((disc.y >= pane.y && disc.bottom() <= pane.bottom()));
      }
    }
  }
}

TEST_CASE("a call of the stack lights its ray up") {
  Bench bench(deep());
  update(bench.state, action::SetTab{StackRoom::tab});
  bench.frames(3);
  const StackPanel stack = stack_panel(bench.state);
  REQUIRE(stack.rows.size() > 1);
  bench.point_at("call-0");
  CHECK(bench.state.plan.hovered_ray == stack.rows[0].ray_index);
}

TEST_CASE("plan and tabs change places and back") {
  Bench bench(at(120));
  bench.frames(2);
  const Rect plan_before = bench.rect("plan"), tabs_before = bench.rect("tabs");
  bench.key("X");
  CHECK(bench.rect("plan") == tabs_before);
  CHECK(bench.rect("tabs") == plan_before);
  bench.key("X");
  CHECK(bench.rect("plan") == plan_before);
}

TEST_CASE("a panel opens where it was last, by tab and by key, and sentence, buttons and code stay") {
  Bench bench(at(120));
  bench.frames(2);
  const Rect large = bench.rect("plan"), small = bench.rect("tabs"), code = bench.rect("code"),
             transport = bench.rect("transport");
  const std::vector<std::pair<std::string, std::string>> tabs{
      {"tab-image", "I"}, {"tab-tree", "R"}, {"tab-cost", "F3"}, {"tab-microscope", "Y"}, {"tab-structure", "Ctrl+T"}};
  std::map<std::string, Rect> place;
  for (const int round : {0, 1, 2}) {
    for (const auto& [tab, key] : tabs) {
      CAPTURE(round, tab);
      if (round == 1)
        bench.key(key);
      else
        bench.click(tab);
      bench.frames(2);
      const Rect here = bench.rect("tabs");
      CHECK((here == large || here == small));
      CHECK(bench.rect("plan") == (here == large ? small : large));
      if (round > 0) CHECK(place[tab] == here);
      CHECK(bench.rect("code") == code);
      CHECK(bench.rect("transport") == transport);
      for (const char* always : {"sentence", "step", "play", "clear"}) CHECK(bench.has(always));
      if (round == 1) continue;
      bench.key("X");
      CHECK(bench.rect("tabs") == (here == large ? small : large));
      place[tab] = bench.rect("tabs");
    }
  }
  CHECK(place["tab-cost"] == large);  // exchanged twice
  bench.key("F1");
  for (const char* always : {"sentence", "step", "play", "clear"}) CHECK(bench.has(always));
}

TEST_CASE("a tooltip comes late, covers no button, and goes with a click") {
  for (const auto& [width, height] : {std::pair{1280.0f, 720.0f}, {1024.0f, 600.0f}}) {
    for (const Tab tab : {PictureRoom::tab, CostRoom::tab}) {
      Bench bench(at(120));
      update(bench.state, action::SetTab{tab});
      bench.resize(width, height);
      std::vector<std::string> buttons;
      for (const Command* each : commands())
        if (bench.has(std::string(each->name))) buttons.emplace_back(each->name);
      REQUIRE(buttons.size() > 20);
      for (const std::string& button : buttons) {
        CAPTURE(width, button);
        bench.point_at(button);
        CHECK_FALSE(bench.has("tooltip"));
        bench.frames(60);
        REQUIRE(bench.has("tooltip"));
        const Rect tip = bench.rect("tooltip");
        CHECK((tip.x >= 0 && tip.y >= 0 && tip.right() <= width && tip.bottom() <= height));
        for (const std::string& other : buttons) {
          const Rect at = bench.rect(other);
          CAPTURE(other);
          CHECK((tip.right() <= at.x || tip.x >= at.right() || tip.bottom() <= at.y || tip.y >= at.bottom()));
        }
      }
      bench.click("step");
      bench.frames(60);
      CHECK_FALSE(bench.has("tooltip"));
      bench.click("step");
      bench.frames(60);
      CHECK_FALSE(bench.has("tooltip"));
      bench.point_at("play");
      bench.frames(60);
      CHECK(bench.has("tooltip"));
    }
  }
}

TEST_CASE("the tooltip of the picture does not cover it, whichever place it has") {
  for (const float unit : {1.0f, 1.25f})
    for (const bool large : {false, true}) {
      Bench bench(at(120));
      bench.unit = unit;
      update(bench.state, action::SetTab{PictureRoom::tab});
      if (large) update(bench.state, action::ExchangePanes{});
      bench.resize(1280, 720);
      bench.frames(2);
      CAPTURE(unit, large);
      bench.point_at("image");
      bench.frames(60);
      REQUIRE(bench.has("tooltip"));
      const Rect tip = bench.rect("tooltip"), picture = bench.rect("image");
      CHECK((tip.right() <= picture.x || tip.x >= picture.right() || tip.bottom() <= picture.y ||
             tip.y >= picture.bottom()));
    }
}

TEST_CASE("a dialog that opens in the frame of a tooltip goes without it") {
  const auto at_rest = [](Bench& bench) {
    bench.state.document.dirty = true;
    bench.point_at("step");
  };
  int frames = 0;
  {
    Bench bench(at(120));
    at_rest(bench);
    for (; !bench.has("tooltip"); ++frames) {
      REQUIRE(frames < 100);
      bench.frames(1);
    }
  }
  Bench bench(at(120));
  at_rest(bench);
  bench.frames(frames - 1);
  REQUIRE_FALSE(bench.has("tooltip"));
  update(bench.state, action::Quit{});
  REQUIRE(bench.state.document.question);
  bench.frames(1);
  CHECK_FALSE(bench.has("tooltip"));
  bench.frames(5);
  CHECK(bench.has("answer-0"));
}

TEST_CASE("no line of code is ever cut, and every line can be reached") {
  for (const float unit : {1.0f, 1.25f, 2.0f}) {
    for (const float height : {480.0f, 600.0f, 720.0f, 1080.0f}) {
      Bench bench(at(40));
      bench.unit = unit;
      bench.resize(1280, height);
      const Rect pane = bench.rect("code");
      std::set<std::string> seen;
      const auto look = [&] {
        for (const auto& [name, rect] : bench.interface().items()) {
          if (!name.starts_with("line-")) continue;
          CAPTURE(unit, height, name);
          CHECK(rect.y >= pane.y);
          CHECK(rect.bottom() <= pane.bottom() + 0.5f);
          seen.insert(name);
        }
      };
      look();
      if (height == 720 && unit < 2) CHECK(seen.size() == 17);  // all, without scrolling
      bench.point_at("code");
      for (const float turn : {1.0f, -1.0f})
        for (int i = 0; i < 20; ++i) {
          bench.wheel(turn);
          bench.frames(2);
          look();
        }
      CAPTURE(unit, height);
      CHECK(seen.size() == 17);
    }
  }
}

TEST_CASE("the knobs of Cost open at their button") {
  Bench bench;
  bench.key("F3");
  bench.frames(2);
  bench.click("cost-knobs");
  bench.frames(2);
  const Rect button = bench.rect("cost-knobs"), popup = bench.rect("cost-knobs-popup");
  CHECK(std::abs(popup.x - button.x) <= 1);
  CHECK(std::abs(popup.y - button.bottom()) <= 1);
}

TEST_CASE("what a key asks for is there, though the plan had all the room") {
  for (const auto& [key, item] : {std::pair("Shift+F3", "cost-knobs-popup"), std::pair(",", "image-settings-popup")}) {
    CAPTURE(key);
    Bench bench;
    update(bench.state, action::SetFocus{true});
    bench.frames(2);
    REQUIRE(bench.state.focus.on);
    bench.key(key);
    bench.frames(2);
    CHECK_FALSE(bench.state.focus.on);
    CHECK(bench.has(item));
  }
}

TEST_CASE("a notice is taken away by its cross") {
  Bench bench(at(0));
  bench.state.document.notice =
      Notice{Notice::Kind::error, "scene.toml:3: there is no such key\n  hint: did you mean radius?"};
  bench.frames(2);
  bench.click("dismiss-notice");
  CHECK_FALSE(bench.state.document.notice.has_value());
}

TEST_CASE("every answer of a question is a button") {
  Bench bench(at(0, Mode::move));
  update(bench.state, action::AddObject{action::ObjectKind::polygon});
  update(bench.state, action::New{});
  bench.frames(3);
  const QuestionPanel question = question_panel(bench.state);
  REQUIRE(question.choices.size() == 3);
  bench.obedient = false;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    bench.forget();
    bench.click("answer-" + std::to_string(i));
    const auto* answer = bench.last<action::AnswerQuestion>();
    REQUIRE(answer != nullptr);
    CHECK(answer->answer == question.choices[i].answer);
  }
}

TEST_CASE("a question shuts out everything behind it") {
  Bench bench(at(40));
  update(bench.state, action::AddObject{action::ObjectKind::polygon});
  update(bench.state, action::Quit{});
  bench.frames(3);
  bench.forget();
  bench.click("step");
  CHECK(bench.last<action::Step>() == nullptr);
}

TEST_CASE("the knobs of Cost stand in the window, also in the projector's letters") {
  for (const float unit : {1.0f, 1.25f}) {
    Bench bench;
    bench.unit = unit;
    bench.key("F3");
    bench.key("Shift+F3");
    const Rect popup = bench.rect("cost-knobs-popup");
    CAPTURE(unit, popup.x, popup.width);
    CHECK(popup.x >= 0);
    CHECK(popup.right() <= 1280);
  }
}

TEST_CASE("no window is too small, no mode or tab fails in it") {
  for (const Mode mode : {Mode::move, Mode::trace, Mode::help}) {
    for (const Tab tab :
         {PictureRoom::tab, TreeRoom::tab, StackRoom::tab, LegendRoom::tab, EquationRoom::tab, CostRoom::tab}) {
      Bench bench(at(120, mode));
      update(bench.state, action::Select{{TargetKind::object, 0}});
      update(bench.state, action::SetTab{tab});
      for (const auto& [width, height] : {std::pair{1.0f, 1.0f}, {30.0f, 900.0f}, {900.0f, 30.0f}, {150.0f, 120.0f}}) {
        CAPTURE(static_cast<int>(mode), tab.word, width, height);
        bench.resize(width, height);
        CHECK(bench.state.plan.viewport.width >= 1);
        CHECK(std::isfinite(bench.state.plan.camera.pixels_per_unit));
      }
      bench.resize(1280, 720);
      CHECK(bench.vertices() > 1000);
    }
  }
}
