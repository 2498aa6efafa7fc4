// Coming back: to a step that was answered, to the walk that was left for a pixel of the picture or for a lesson; and
// what Move, where one may go at any time, must not tell.
#include "lesson_state.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
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

TEST_CASE("first predictions stay counted in another session, until the lesson is begun anew") {
  const test::TemporaryFolder folder;
  State state = state_with_lessons();
  state.document.state_dir = folder.file("state");
  const auto answer = [](State& in, int step, int choice) {
    update(in, action::GoToLessonStep{step});
    REQUIRE(lesson_panel(in).asks == Asks::choice);
    update(in, action::GuessChoice{choice});
    update(in, action::RevealLesson{});
  };
  update(state, action::OpenLesson{"01-ray-casting"});
  answer(state, 1, 2);
  CHECK_THAT(lesson_panel(state).score, contains("0 of 1"));
  update(state, action::GoToLessonStep{2});

  State later = state_with_lessons();
  later.document.state_dir = folder.file("state");
  later.lessons.list.clear();  // the list is read again, and where lessons were left
  update(later, action::OpenLesson{"01-ray-casting"});
  CHECK(later.lessons.step == 2);
  CHECK_THAT(lesson_panel(later).score, contains("0 of 1"));
  answer(later, 2, 2);
  CHECK_THAT(lesson_panel(later).score, contains("1 of 2"));
  answer(later, 1, 1);  // no longer its first
  CHECK_THAT(lesson_panel(later).score, contains("1 of 2"));
  update(later, action::SetLessonOptions{false, true});
  update(later, action::GoToLessonStep{99});
  CHECK(later.lessons.at() == nullptr);
  CHECK_THAT(lesson_panel(later).score, contains(": 1 of 2"));
  update(later, action::OpenLesson{"01-ray-casting"});
  CHECK(lesson_panel(later).score.empty());
}

TEST_CASE("who goes back to a step that was answered finds guess and answer; a presenter asks again") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::GoToLessonStep{1});
  REQUIRE(lesson_panel(state).asks == Asks::choice);
  update(state, action::GuessChoice{1});
  update(state, action::RevealLesson{});
  const int position = state.walk.position;
  const auto tries = state.lessons.first_tries;
  const std::string verdict = lesson_panel(state).verdict;
  update(state, action::GoToLessonStep{2});
  CHECK_FALSE(state.lessons.revealed);
  update(state, action::GoToLessonStep{1});
  CHECK(state.lessons.revealed);
  CHECK(state.lessons.guess.choice == 1);
  CHECK(state.lessons.first_tries == tries);
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
  // With what was chosen for the picture, and the tab.
  update(state, action::SetTab{StackRoom::tab});
  state.picture.settings.samples = 3;
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::SetTab{TreeRoom::tab});
  update(state, action::LeaveLesson{});
  CHECK(state.walk.timeline->steps() == steps);
  CHECK(state.walk.position == before);
  CHECK(state.appearance.tab == StackRoom::tab);
  CHECK(state.picture.settings.samples == 3);
}

TEST_CASE("what was chosen for the picture of one step is not seen in the next") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"11-noise"});
  for (const int step : {1, 2, 3}) {
    ImageSettings chosen;
    chosen.samples = 1;
    chosen.heat = Heat::rays;
    chosen.accelerator = AcceleratorKind::bvh;
    update(state, action::SetImageSettings{chosen});
    update(state, action::GoToLessonStep{step});
    REQUIRE(state.lessons.step == step);
    CHECK(state.picture.settings.samples == ImageSettings{}.samples);
    CHECK(state.picture.settings.heat == Heat::none);
    CHECK(state.picture.settings.accelerator == AcceleratorKind::bvh);
  }
}

TEST_CASE("another sitting opens a lesson where it was left, a finished one too, and offers the last one") {
  const TemporaryFolder folder;
  const auto sitting = [&] {
    State state = state_with_lessons();
    state.lessons.list.clear();
    state.document.state_dir = folder.file("state");
    update(state, action::ListLessons{});
    return state;
  };
  const std::string lesson = "05-refraction";
  {
    State state = sitting();
    update(state, action::OpenLesson{lesson});
    const int steps = static_cast<int>(state.lessons.open->played.steps.size());
    update(state, action::GoToLessonStep{steps});
    CHECK_FALSE(state.lessons.open);
    CHECK(state.lessons.done[lesson] == steps);
  }
  {
    State state = sitting();
    update(state, action::OpenLesson{lesson});
    CHECK(state.lessons.step == 0);  // it was finished
    update(state, action::GoToLessonStep{3});
    update(state, action::GoToLessonStep{2});
  }
  {
    State state = sitting();
    CHECK(state.lessons.last == lesson);
    update(state, action::OpenLesson{lesson});
    CHECK(state.lessons.step == 2);
  }
}

TEST_CASE("STEP asks for a prediction though all is unlocked; Reveal and presenters need none") {
  for (const bool presents : {false, true}) {
    State state = state_with_lessons();
    update(state, action::SetLessonOptions{presents, true});
    update(state, action::OpenLesson{"01-ray-casting"});
    update(state, action::GoToLessonStep{1});
    REQUIRE(question_waits(state));
    update(state, action::Step{true});
    CHECK(state.lessons.revealed == presents);
    update(state, action::PlayPause{});
    CHECK(state.lessons.revealed == presents);
    if (presents) continue;
    CHECK(state.document.notice);
    update(state, action::RevealLesson{});
    CHECK(state.lessons.revealed);
  }
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
