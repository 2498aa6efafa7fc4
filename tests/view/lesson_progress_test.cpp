// What is finished of lessons: kept in a file, between sittings and windows.
#include "lesson_state.h"

#include <filesystem>

#include "support/catch.h"
#include "text/file.h"
#include "view/action.h"

using namespace raywalk;
using raywalk::test::before_lessons;
using raywalk::test::with_lessons;

TEST_CASE("progress is kept between sittings") {
  const test::TemporaryFolder folder;
  {
    State state = with_lessons(folder.path());
    update(state, action::OpenLesson{state.lessons.list[0].name});
    update(state, action::GoToLessonStep{1});
    update(state, action::SetLessonOptions{false, true});
  }
  State state = with_lessons(folder.path());
  CHECK(state.lessons.unlocked);
  CHECK(lesson_panel(state).rows[0].done == 1);
  update(state, action::OpenLesson{state.lessons.list[0].name});
  CHECK(state.lessons.step == 1);
}

TEST_CASE("two windows keep what either has finished") {
  const test::TemporaryFolder folder;
  State first = with_lessons(folder.path()), second = with_lessons(folder.path());
  update(first, action::OpenLesson{first.lessons.list[0].name});
  update(first, action::GoToLessonStep{1});
  update(second, action::SetLessonOptions{false, true});
  update(second, action::OpenLesson{second.lessons.list[1].name});
  update(second, action::GoToLessonStep{1});
  const State later = with_lessons(folder.path());
  CHECK(lesson_panel(later).rows[0].done == 1);
  CHECK(lesson_panel(later).rows[1].done == 1);
}

TEST_CASE("a damaged file of what is finished is kept beside the new one, and told of") {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("lessons.json"), kept = file + ".damaged";
  const std::string cut = "{\"done\": {\"01-ray-casting\": 5";
  REQUIRE(write_file_atomically(file, cut));
  State state = before_lessons(folder.path());
  const auto is_told = [&](const std::string& name) {
    const auto& said = state.document.notice;
    return said && said->kind == Notice::Kind::error && said->text.find(name) != std::string::npos;
  };
  SECTION("as the list is shown") { update(state, action::ShowLessons{true}); }
  SECTION("as a lesson is opened, which shows another scene") { update(state, action::OpenLesson{"01-ray-casting"}); }
  CHECK(is_told(kept));
  CHECK(read_file(kept, 1 << 20).value() == cut);
  update(state, action::DismissNotice{});
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::GoToLessonStep{1});
  CHECK_FALSE(state.document.notice);
  CHECK(with_lessons(folder.path()).lessons.done["01-ray-casting"] == 1);
  // Another one does not replace the first.
  REQUIRE(write_file_atomically(file, ""));
  update(state, action::GoToLessonStep{0});
  CHECK(is_told(kept + "-2"));
  CHECK(read_file(kept, 1 << 20).value() == cut);
}

TEST_CASE("that what is finished cannot be written is said once") {
  const test::TemporaryFolder folder;
  const std::string blocked = folder.file("blocked");
  REQUIRE(write_file_atomically(blocked, "a file where a folder is wanted"));
  State state = with_lessons(blocked);
  REQUIRE_FALSE(state.document.notice);
  update(state, action::OpenLesson{"01-ray-casting"});
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK_THAT(state.document.notice->text, test::contains("next start"));
  update(state, action::DismissNotice{});
  update(state, action::GoToLessonStep{1});
  CHECK_FALSE(state.document.notice);
  // Once it was written, a failure is news again.
  std::filesystem::remove(blocked);
  update(state, action::GoToLessonStep{0});
  CHECK(std::filesystem::exists(folder.file("blocked/lessons.json")));
  std::filesystem::remove_all(blocked);
  REQUIRE(write_file_atomically(blocked, ""));
  update(state, action::GoToLessonStep{1});
  CHECK(state.document.notice);
}

TEST_CASE("lessons that were unlocked stay so where other options change before the list is read") {
  const test::TemporaryFolder folder;
  State first = with_lessons(folder.path());
  update(first, action::SetLessonOptions{false, true});
  State demo = before_lessons(folder.path());
  update(demo, action::SetLessonOptions{true, false});
  CHECK(demo.lessons.presenter);
  CHECK(demo.lessons.unlocked);
  CHECK(with_lessons(folder.path()).lessons.unlocked);
  update(demo, action::SetLessonOptions{true, false});
  CHECK_FALSE(with_lessons(folder.path()).lessons.unlocked);
}

TEST_CASE("lessons that were unlocked in one window stay so where another one goes on") {
  const test::TemporaryFolder folder;
  State one = with_lessons(folder.path()), other = with_lessons(folder.path());
  update(one, action::SetLessonOptions{false, true});
  update(other, action::OpenLesson{"01-ray-casting"});
  update(other, action::GoToLessonStep{1});
  CHECK(other.lessons.unlocked);
  State next = with_lessons(folder.path());
  CHECK(next.lessons.unlocked);
  CHECK(next.lessons.done["01-ray-casting"] == 1);
  // What is chosen last counts, in whichever window.
  update(other, action::SetLessonOptions{});
  update(one, action::SetLessonOptions{true, true});
  CHECK_FALSE(with_lessons(folder.path()).lessons.unlocked);
}
