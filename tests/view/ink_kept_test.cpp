// What becomes of ink: in the file of the scene on request, in the autosave, through lessons and hunts, in exports.
#include "fixtures.h"
#include "lesson_state.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "view/export/slides.h"

#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

const Ink& drawn_in(const State& state) { return state.document.contents.ink; }

/// Places of the plan with nothing near.
constexpr Vec2d here{60, 60}, there{160, 90};

}  // namespace

TEST_CASE("ink goes into the file on request alone, and only then is it missed") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  const std::string path = folder.file("scene.toml"), before = read_file(path, 1 << 20).value();
  update(state, action::SetInk{true});
  drag(state, here, there);
  REQUIRE(drawn_in(state).size() == 1);
  CHECK_FALSE(state.document.dirty);
  update(state, action::Save{});
  CHECK(read_file(path, 1 << 20).value() == before);
  CHECK(drawn_in(state).size() == 1);

  update(state, action::KeepInk{true});
  CHECK(state.document.dirty);
  CHECK(broken_promise(state) == "");
  update(state, action::KeepInk{false});
  CHECK_FALSE(state.document.dirty);
  update(state, action::KeepInk{true});
  update(state, action::Save{});
  CHECK_FALSE(state.document.dirty);
  const SceneDocument read = read_document(path);
  CHECK(read.ink == drawn_in(state));
  CHECK(read.scene == state.scene());
  // Opened again it is there, and kept.
  State other = make_state(read, path);
  CHECK(other.document.contents.keeps_ink);
  CHECK_FALSE(other.document.dirty);
  update(other, action::ClearInk{});
  CHECK(other.document.dirty);
  update(other, action::Undo{});
  CHECK_FALSE(other.document.dirty);
  update(other, action::ClearInk{});
  update(other, action::Save{});
  CHECK(read_document(path).ink.empty());
  CHECK(read_file(path, 1 << 20).value() == before);  // no empty line is left where the ink stood
}

TEST_CASE("a text that is still being written is saved, exported, and asked about before the window closes") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  update(state, action::KeepInk{true});
  update(state, action::SetInk{true});
  update(state, action::ChooseInkTool{InkTool::text});
  const auto write = [&](const std::string& words) {
    update(state, action::PointerPressed{here});
    update(state, action::PointerReleased{here});
    update(state, action::TypeInk{words});
    REQUIRE(text_begun(state) != nullptr);
  };
  write("saved");
  update(state, action::Save{});
  CHECK(read_document(folder.file("scene.toml")).ink.size() == 1);
  write("exported");
  update(state, action::Export{folder.file("plan.svg")});
  CHECK(read_file(folder.file("plan.svg"), 1 << 20).value().find("exported") != std::string::npos);
  update(state, action::Save{});
  write("asked about");
  update(state, action::Quit{});
  REQUIRE(state.document.question);
  update(state, action::AnswerQuestion{action::Answer::save});
  CHECK(state.document.quit);
  CHECK(read_document(folder.file("scene.toml")).ink.size() == 3);
}

TEST_CASE("kept ink is autosaved and recovered") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  update(state, action::KeepInk{true});
  update(state, action::SetInk{true});
  drag(state, here, there);
  CHECK(wants_autosave(state));
  update(state, action::Tick{autosave_every + 1});
  CHECK_FALSE(wants_autosave(state));
  drag(state, {60, 200}, {160, 230});
  CHECK(wants_autosave(state));
  update(state, action::Tick{autosave_every + 1});
  crash(state);
  State next = make_state(read_document(folder.file("scene.toml")), folder.file("scene.toml"), folder.file("state"));
  restore_session(next);
  REQUIRE(next.document.question);
  update(next, action::AnswerQuestion{action::Answer::recover});
  CHECK(drawn_in(next) == drawn_in(state));
  CHECK(next.document.dirty);
  CHECK(broken_promise(next) == "");
}

TEST_CASE("ink stays through the steps of a walk and a hunt, and comes back after a lesson") {
  State state = state_with_lessons();
  update(state, action::SetMode{Mode::trace});
  update(state, action::SetInk{true});
  drag(state, here, there);
  const Ink mine = drawn_in(state);
  update(state, action::Step{});
  CHECK(drawn_in(state) == mine);
  update(state, action::OpenLesson{state.lessons.list.front().name});
  REQUIRE(state.lessons.at() != nullptr);
  CHECK(drawn_in(state).empty());
  drag(state, here, {60, 200});
  CHECK(drawn_in(state).size() == 1);
  CHECK_FALSE(state.document.dirty);
  update(state, action::LeaveLesson{});
  CHECK(drawn_in(state) == mine);
  update(state, action::HuntBug{1});
  CHECK(drawn_in(state).empty());
  drag(state, here, {60, 200});
  update(state, action::LeaveHunt{});
  CHECK(drawn_in(state) == mine);
}

TEST_CASE("exports of the plan show the ink, and Help and lines in space do not draw") {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  const std::size_t items = plan_view(state).size();
  update(state, action::SetInk{true});
  drag(state, here, there);
  update(state, action::PointerLeft{});
  CHECK(plan_view(state).size() == items + 3);  // a line with round ends
  const std::string without = slides_page(state.scene(), state.walk.timeline, in_english, Theme::dark);
  const std::string with = slides_page(state.scene(), state.walk.timeline, in_english, Theme::dark, drawn_in(state));
  CHECK(with.size() > without.size());
  CHECK(with.size() < without.size() + 5000);  // once, not at each step
  update(state, action::SetMode{Mode::help});
  CHECK_FALSE(inks(state));
  update(state, action::SetMode{Mode::trace});
  CHECK(inks(state));
  update(state, action::ShowLines{true});
  CHECK_FALSE(inks(state));
}
