// What a lesson gives back.

#include <string>

#include "lesson_state.h"
#include "support/catch.h"
#include "view/action.h"
#include "view/document/question.h"
#include "view/lesson/lesson_panel.h"

using namespace raywalk;
using raywalk::test::make_dirty;
using raywalk::test::TemporaryFolder;

namespace {

const std::string root = RAYWALK_SOURCE_DIR;

}  // namespace

TEST_CASE("leaving a lesson restores the scene that was open before") {
  const TemporaryFolder folder;
  State state = make_state(read_scene(root + "/scenes/classic.toml").value());
  state.lessons.folder = root + "/lessons";
  state.lessons.scenes_folder = root + "/scenes";
  update(state, action::ShowLessons{true});
  update(state, action::New{});
  make_dirty(state);
  update(state, action::SaveAs{folder.file("mine.toml")});
  const Scene mine = state.scene();
  const std::string first = state.lessons.list[0].name;
  update(state, action::OpenLesson{first});
  REQUIRE(state.lessons.at() != nullptr);
  REQUIRE(state.scene() != mine);

  SECTION("as it was") {
    update(state, action::LeaveLesson{});
    CHECK(state.scene() == mine);
    CHECK(state.document.path == folder.file("mine.toml"));
    CHECK_FALSE(state.document.dirty);
    CHECK(state.walk.mode == Mode::move);
  }
  SECTION("after another lesson too") {
    state.lessons.unlocked = true;
    update(state, action::OpenLesson{state.lessons.list[4].name});
    update(state, action::LeaveLesson{});
    CHECK(state.scene() == mine);
  }
  SECTION("without what was given up before the lesson") {
    update(state, action::LeaveLesson{});
    make_dirty(state);
    update(state, action::OpenLesson{first});
    REQUIRE(state.document.question.has_value());
    update(state, action::AnswerQuestion{action::Answer::discard});
    REQUIRE(state.lessons.at() != nullptr);
    update(state, action::LeaveLesson{});
    CHECK(state.scene() == mine);
    CHECK_FALSE(state.document.dirty);
  }
  SECTION("asked first, where the lesson's scene was changed") {
    make_dirty(state);
    const Scene changed = state.scene();
    update(state, action::LeaveLesson{});
    REQUIRE(state.document.question.has_value());
    CHECK(state.scene() == changed);
    update(state, action::AnswerQuestion{action::Answer::cancel});
    CHECK(state.lessons.at() != nullptr);
    update(state, action::LeaveLesson{});
    update(state, action::AnswerQuestion{action::Answer::save});
    update(state, action::SaveAs{folder.file("theirs.toml")});
    CHECK(read_scene(folder.file("theirs.toml"))->scene == changed);
    CHECK(state.lessons.at() == nullptr);
    CHECK(state.scene() == mine);
    CHECK_FALSE(state.document.dirty);
  }
  SECTION("asked first, too, before another lesson takes its place") {
    state.lessons.unlocked = true;
    const std::string second = state.lessons.list[1].name;
    make_dirty(state);
    const Scene changed = state.scene();
    update(state, action::OpenLesson{second});
    REQUIRE(state.document.question.has_value());
    CHECK(question_panel(state).text.find(state.lessons.list[1].title(state.appearance.language)) != std::string::npos);
    update(state, action::AnswerQuestion{action::Answer::cancel});
    CHECK(state.lessons.open->lesson.name == first);
    CHECK(state.scene() == changed);
    update(state, action::OpenLesson{second});
    update(state, action::AnswerQuestion{action::Answer::save});
    update(state, action::SaveAs{folder.file("theirs.toml")});
    CHECK(read_scene(folder.file("theirs.toml"))->scene == changed);
    CHECK(state.lessons.open->lesson.name == second);
    update(state, action::LeaveLesson{});
    CHECK_FALSE(state.document.question);
    CHECK(state.scene() == mine);
  }
  SECTION("unless another scene was opened: that is where one is") {
    update(state, action::New{});
    CHECK(state.lessons.at() == nullptr);
    const Scene other = state.scene();
    update(state, action::LeaveLesson{});
    CHECK(state.scene() == other);
  }
  SECTION("and its questions count once") {
    state.lessons.unlocked = true;
    const auto answer = [&] {
      while (lesson_panel(state).asks != Asks::choice) update(state, action::GoToLessonStep{lesson_panel(state).step});
      update(state, action::GuessChoice{0});
      update(state, action::RevealLesson{});
    };
    answer();
    const int step = state.lessons.step;
    update(state, action::GoToLessonStep{step});
    answer();
    CHECK(state.lessons.step == step);
    CHECK(state.lessons.first_tries[state.lessons.last].judged() == 1);
  }
}

TEST_CASE("what was changed in a step can be redone there, and its scene is shown as the lesson has it") {
  State state = test::state_with_lessons();
  update(state, action::OpenLesson{"01-ray-casting"});
  const Scene written = state.scene();
  make_dirty(state);
  make_dirty(state);
  const Scene changed = state.scene();
  update(state, action::GoToLessonStep{1});
  CHECK_FALSE(state.document.dirty);
  CHECK(state.document.redo.empty());
  REQUIRE(state.document.notice);
  CHECK_THAT(state.document.notice->text, test::contains("step 1") && test::contains("Redo"));
  SECTION("also after changes of another step") {
    make_dirty(state);
    update(state, action::GoToLessonStep{0});
  }
  SECTION("also with a part of it redone before") {
    update(state, action::GoToLessonStep{0});
    update(state, action::Redo{});
    update(state, action::GoToLessonStep{1});
    CHECK_FALSE(state.document.notice);  // it was told
    update(state, action::GoToLessonStep{0});
  }
  CHECK(state.scene() == written);
  CHECK_FALSE(state.document.dirty);
  REQUIRE(state.document.notice);
  CHECK_THAT(state.document.notice->text, test::contains("Redo"));
  update(state, action::Redo{});
  update(state, action::Redo{});
  CHECK(state.scene() == changed);
  CHECK(state.document.redo.empty());
  update(state, action::Undo{});
  update(state, action::Undo{});
  CHECK(state.scene() == written);
  // Another lesson, or the same one anew, knows nothing of them.
  update(state, action::OpenLesson{"01-ray-casting"});
  CHECK(state.document.redo.empty());
}

TEST_CASE("an answer that is shown in the scene that was asked about leaves a student's changes to be redone") {
  State state = test::state_with_lessons();
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::GoToLessonStep{1});
  REQUIRE(lesson_panel(state).asks == Asks::choice);
  const Scene asked = state.scene();
  make_dirty(state);
  const Scene changed = state.scene();
  update(state, action::GuessChoice{0});
  update(state, action::RevealLesson{});
  CHECK(state.scene() == asked);
  update(state, action::Redo{});
  CHECK(state.scene() == changed);
}

TEST_CASE("a step shows beside the plan what the steps before it left there, also to who comes back to it") {
  State state = make_state(read_scene(root + "/scenes/classic.toml").value());
  state.lessons.folder = root + "/lessons";
  state.lessons.scenes_folder = root + "/scenes";
  update(state, action::ShowLessons{true});
  update(state, action::SetLessonOptions{false, true});
  // Its first step names the equation, the last one the tree.
  update(state, action::OpenLesson{"05-refraction"});
  const auto steps = static_cast<int>(state.lessons.open->played.steps.size());
  for (int step = 1; step < steps; ++step) update(state, action::GoToLessonStep{step});
  CHECK(state.appearance.tab == TreeRoom::tab);
  update(state, action::GoToLessonStep{steps - 2});
  CHECK(state.appearance.tab == EquationRoom::tab);
  // Onwards, what a student has opened stays.
  update(state, action::GoToLessonStep{1});
  update(state, action::SetTab{StackRoom::tab});
  update(state, action::GoToLessonStep{2});
  CHECK(state.appearance.tab == StackRoom::tab);
}

TEST_CASE("a scene without objects comes back too") {
  SceneDocument bare = read_scene(root + "/scenes/classic.toml").value();
  bare.scene.objects.clear();
  bare.scene.title = "Bare";
  State state = make_state(bare, "bare.toml");
  state.lessons.folder = root + "/lessons";
  state.lessons.scenes_folder = root + "/scenes";
  update(state, action::ShowLessons{true});
  update(state, action::OpenLesson{state.lessons.list[0].name});
  REQUIRE(state.lessons.at() != nullptr);
  update(state, action::LeaveLesson{});
  CHECK(state.scene() == bare.scene);
  CHECK(state.document.path == "bare.toml");
}
