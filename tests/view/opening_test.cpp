// What opens what a person names or drops.
#include "view/opening.h"
#include "fixtures.h"
#include "lesson_state.h"
#include "text/file.h"

#include "support/catch.h"

#include <filesystem>
#include <string>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

void put(const std::string& path) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  REQUIRE(write_file_atomically(path, "").has_value());
}

/// The path that is opened for these; empty if something else is done.
std::string opened(const std::vector<std::string>& paths) {
  const std::vector<Action> actions = opening_among(state_with_lessons(), paths);
  const auto* open = actions.size() == 1 ? actions.front().as<action::Open>() : nullptr;
  return open == nullptr ? std::string() : open->path;
}

}  // namespace

TEST_CASE("of several files the first scene is opened, of meshes the first, else what is first") {
  CHECK(opened({"/a/ball.ply", "/a/one.toml", "/a/two.toml"}) == "/a/one.toml");
  CHECK(opened({"/a/words.txt", "/a/ball.ply", "/a/cube.obj"}) == "/a/ball.ply");
  CHECK(opened({"/a/words.txt", "/a/picture.png"}) == "/a/words.txt");
  CHECK(opening_among(state_with_lessons(), {}).empty());
}

TEST_CASE("of a folder its scene is opened, and one without is told by the reader") {
  const TemporaryFolder folder;
  for (const char* name : {"course/ball.ply", "course/ball.toml", "course/words.txt", "empty/words.txt"})
    put(folder.file(name));
  CHECK(opened({folder.file("course")}) == folder.file("course/ball.toml"));
  CHECK(opened({folder.file("course/"), folder.file("empty/words.txt")}) == folder.file("course/ball.toml"));
  CHECK(opened({folder.file("empty")}) == folder.file("empty"));
  State state = classic_state();
  const Scene before = state.scene();
  for (const Action& action : opening_among(state, {folder.file("empty")})) update(state, action);
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK(state.scene() == before);
}

TEST_CASE("the folder of a lesson opens it, also in place of a dialog, but asks before work is lost") {
  State state = state_with_lessons();
  make_dirty(state);
  for (const char* end : {"", "/"}) {
    update(state, action::AskOpen{});
    for (const Action& action : opening_of(state, state.lessons.folder + "/05-refraction" + end)) update(state, action);
    CHECK(state.document.prompt == PathPrompt::none);
    REQUIRE(state.document.question);
    CHECK(state.document.question->path == "05-refraction");
    update(state, action::AnswerQuestion{action::Answer::cancel});
  }
  const TemporaryFolder elsewhere;
  put(elsewhere.file("05-refraction/lesson.toml"));  // is of another's lessons, which this window does not list
  CHECK(opening_of(state, elsewhere.file("05-refraction")).front().is<action::Open>());
}

TEST_CASE("what is dropped is opened once unsaved work is settled") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  const Scene mine = state.scene();
  const std::string other = std::string(RAYWALK_SOURCE_DIR) + "/scenes/glass.toml";
  for (const Action& action : opening_among(state, {other})) update(state, action);
  REQUIRE(state.document.question);
  CHECK(state.scene() == mine);
  update(state, action::AnswerQuestion{action::Answer::discard});
  CHECK(state.document.path == other);
}
