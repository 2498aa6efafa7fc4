// Coming back: to a step that was answered, to the walk that was left for a pixel of the picture or for a lesson; and
// what Move, where one may go at any time, must not tell.
#include "lesson_state.h"
#include "support/catch.h"
#include "view/lesson/lesson_panel.h"
#include "view/tree/tree_panel.h"

#include <algorithm>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("Move tells no answer of a lesson before it is shown") {
  State state = state_with_lessons();
  update(state, action::SetLessonOptions{false, true});
  int asked = 0, trees = 0;
  for (const LessonEntry& entry : std::vector<LessonEntry>(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    for (int step = 0; step < entry.steps && state.lessons.at() != nullptr; ++step) {
      update(state, action::GoToLessonStep{step});
      const PlayedStep* played = state.lessons.at();
      if (played == nullptr || !played->step->question || std::holds_alternative<LineQuestion>(*played->step->question))
        continue;
      INFO(entry.name << " " << step);
      ++asked;
      update(state, action::SetMode{Mode::move});
      const auto comes = [](const TreePanel& tree) {
        return std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const TreeNode& node) { return node.future; });
      };
      CHECK_FALSE(comes(tree_panel(state)));
      CHECK_FALSE(state.live.shown);
      CHECK(withholds_answer(state));
      // Nor when the scene is another one.
      update(state, action::Select{{TargetKind::eye, 0}});
      update(state, action::Nudge{{1, 0}});
      CHECK_FALSE(comes(tree_panel(state)));
      CHECK_FALSE(state.live.shown);
      update(state, action::Undo{});
      update(state, action::RevealLesson{});
      CHECK_FALSE(withholds_answer(state));
      trees += tree_panel(state).nodes.empty() ? 0 : 1;
    }
  }
  CHECK(asked > 50);
  CHECK(trees > 20);
}

TEST_CASE("who goes back to a step that was answered finds guess and answer; a presenter asks again") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::GoToLessonStep{1});
  REQUIRE(lesson_panel(state).asks == Asks::choice);
  update(state, action::GuessChoice{1});
  update(state, action::RevealLesson{});
  const int position = state.walk.position, judged = state.lessons.judged;
  const std::string verdict = lesson_panel(state).verdict;
  update(state, action::GoToLessonStep{2});
  CHECK_FALSE(state.lessons.revealed);
  update(state, action::GoToLessonStep{1});
  CHECK(state.lessons.revealed);
  CHECK(state.lessons.guess.choice == 1);
  CHECK(state.lessons.judged == judged);
  CHECK(state.walk.position == position);
  CHECK(lesson_panel(state).verdict == verdict);
  update(state, action::SetLessonOptions{true});
  update(state, action::GoToLessonStep{0});
  update(state, action::GoToLessonStep{1});
  CHECK_FALSE(state.lessons.revealed);
}

TEST_CASE("the walk is where it was after a pixel of the picture, and after a lesson") {
  State state = state_with_lessons();
  update(state, action::SetMode{Mode::trace});
  const int steps = state.walk.timeline->steps();
  update(state, action::Jump{steps / 3});
  const int before = state.walk.position;
  update(state, action::WalkPixel{5, 2, {63, 47}});
  REQUIRE(state.walk.pixel);
  update(state, action::WalkPixel{6, 2, {63, 47}});
  update(state, action::WalkStrip{});
  CHECK_FALSE(state.walk.pixel);
  CHECK(state.walk.position == before);
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::LeaveLesson{});
  CHECK(state.walk.timeline->steps() == steps);
  CHECK(state.walk.position == before);
}

TEST_CASE("what a step shows large is exchanged by hand for that step and mode alone") {
  State state = state_with_lessons();
  update(state, action::SetLessonOptions{true, true});
  update(state, action::OpenLesson{"11-noise"});
  update(state, action::GoToLessonStep{2});
  REQUIRE(lesson_enlarges(state));
  const auto is_large = [&] { return exchanged_by_hand(state) != has_plans_place(state); };
  CHECK(is_large());
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(is_large());
  update(state, action::ExchangePanes{});
  CHECK(is_large());
  update(state, action::SetMode{Mode::trace});
  CHECK(is_large());
  update(state, action::ExchangePanes{});
  CHECK_FALSE(is_large());
  // Neither for the next step, nor by what was exchanged elsewhere.
  update(state, action::GoToLessonStep{3});
  CHECK(is_large());
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(is_large());
  update(state, action::LeaveLesson{});
  update(state, action::SetTab{PictureRoom::tab});
  CHECK_FALSE(is_large());
  update(state, action::ExchangePanes{});
  CHECK(is_large());
  update(state, action::OpenLesson{"11-noise"});
  update(state, action::GoToLessonStep{1});
  CHECK(is_large());
}

TEST_CASE("a changed scene leaves the walk at the same ray, however many steps come before it now") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"03-shadows"});
  update(state, action::GoToLessonStep{1});
  update(state, action::RevealLesson{});
  const auto light_now = [&] {
    const Timeline& timeline = *state.walk.timeline;
    return timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))].light;
  };
  const int light = light_now();
  REQUIRE(light >= 0);
  const int steps = state.walk.timeline->steps();
  bool shorter = false;
  // All about the plan: where the light's rays are formed, and where they are not.
  for (const double x : {-6.0, -3.0, 0.0, 3.0, 6.0, 9.0})
    for (const double y : {-5.0, 0.0, 5.0}) {
      Light moved = state.scene().lights[static_cast<std::size_t>(light)];
      std::get<PointLight>(moved.kind).position = {x, y, 0};
      update(state, action::SetLight{light, moved});
      INFO(x << " " << y);
      CHECK(light_now() == light);
      shorter = shorter || state.walk.timeline->steps() < steps;
    }
  CHECK(shorter);
}
