// What is found at the start of work that was lost.
#include "fixtures.h"
#include "text/file.h"
#include "text/text_file.h"
#include "view/document/question.h"
#include "view/text/text.h"

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;
using action::Answer;

TEST_CASE("what is not saved is autosaved within seconds, and recovered at the next start") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  const Scene scene = state.scene();
  for (int i = 0; i < 8; ++i) update(state, action::Tick{1});
  const std::string autosave = folder.file("state/autosave.toml");
  REQUIRE(std::filesystem::exists(autosave));

  crash(state);
  State next = make_state(read_document(folder.file("scene.toml")), folder.file("scene.toml"), folder.file("state"));
  restore_session(next);
  REQUIRE(next.document.question);
  CHECK(next.document.question->kind == Question::Kind::recover);
  CHECK(next.document.question->path == folder.file("scene.toml"));
  const std::string when = next.document.question->when;
  CHECK_THAT(when, Catch::Matchers::Matches("20[0-9]{2}-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]"));
  CHECK_THAT(question_panel(next).text,
             contains("scene.toml") && contains(when.substr(0, 10) + " at " + when.substr(11)));
  update(next, action::AnswerQuestion{Answer::recover});
  CHECK(next.scene() == scene);
  CHECK(next.document.dirty);
  CHECK(next.document.path == folder.file("scene.toml"));
  CHECK(broken_promise(next) == "");
  update(next, action::Save{});
  CHECK_FALSE(next.document.question);  // the file is as it was
  CHECK(read_document(folder.file("scene.toml")).scene == scene);
  CHECK_FALSE(std::filesystem::exists(autosave));
}

TEST_CASE("what was saved and did not arrive is unsaved work again, and autosaved") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  update(state, action::Save{});
  const std::string path = folder.file("scene.toml"), autosave = folder.file("state/autosave.toml");
  update(state, action::NotSaved{folder.file("another.toml"), "no room"});
  REQUIRE_FALSE(state.document.dirty);
  update(state, action::NotSaved{path, "no room"});
  CHECK(state.document.dirty);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK_THAT(state.document.notice->text, contains("scene.toml") && contains("no room"));
  for (int i = 0; i < 8; ++i) update(state, action::Tick{1});
  CHECK(std::filesystem::exists(autosave));
  update(state, action::New{});
  CHECK(state.document.question);
  update(state, action::AnswerQuestion{Answer::cancel});
  update(state, action::Save{});
  CHECK_FALSE(state.document.dirty);
  update(state, action::NotSaved{path, ""});
  CHECK(state.document.dirty);
}

TEST_CASE("work on a file that begins with a byte order mark is recovered") {
  const TemporaryFolder folder;
  static_cast<void>(saved_state(folder));
  const std::string path = folder.file("scene.toml");
  REQUIRE(write_file_atomically(path, std::string(utf8_mark) + read_file(path, 1 << 20).value()));
  State state = make_state(read_document(path), path, folder.file("state"));
  make_dirty(state);
  const Scene scene = state.scene();
  update(state, action::Tick{autosave_every + 1});
  crash(state);
  State next = make_state(read_document(path), path, folder.file("state"));
  restore_session(next);
  REQUIRE(next.document.question);
  update(next, action::AnswerQuestion{Answer::recover});
  CHECK(next.scene() == scene);
  CHECK(next.document.path == path);
}

TEST_CASE("Later keeps an autosave whatever is done meanwhile, and the next start asks about it again") {
  const TemporaryFolder folder;
  State crashed = saved_state(folder);
  make_dirty(crashed);
  const Scene lost = crashed.scene();
  update(crashed, action::Tick{autosave_every + 1});
  crash(crashed);

  // Another file is opened: the question says which one it is about and which one is open.
  REQUIRE(write_file_atomically(folder.file("other.toml"), read_file(folder.file("scene.toml"), 1 << 20).value()));
  State other = make_state(read_document(folder.file("other.toml")), folder.file("other.toml"), folder.file("state"));
  restore_session(other);
  REQUIRE(other.document.question);
  CHECK_THAT(question_panel(other).text, contains("scene.toml") && contains("other.toml"));
  update(other, action::AnswerQuestion{Answer::cancel});
  CHECK_FALSE(other.document.question);
  make_dirty(other);
  update(other, action::Tick{autosave_every + 1});
  CHECK(std::filesystem::exists(folder.file("state/autosave-2.toml")));
  update(other, action::Save{});
  CHECK_FALSE(std::filesystem::exists(folder.file("state/autosave-2.toml")));

  State next = make_state(read_document(folder.file("scene.toml")), folder.file("scene.toml"), folder.file("state"));
  restore_session(next);
  REQUIRE(next.document.question);
  CHECK(next.document.question->path == folder.file("scene.toml"));
  update(next, action::AnswerQuestion{Answer::recover});
  CHECK(next.scene() == lost);
  update(next, action::Save{});
  CHECK_FALSE(std::filesystem::exists(folder.file("state/autosave.toml")));
}

TEST_CASE("of two autosaves the later is asked about first, and after it is thrown away the other") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  std::filesystem::create_directories(folder.file("state"));
  for (const char* name : {"autosave.toml", "autosave-2.toml"}) {
    REQUIRE(write_file_atomically(
        folder.file(std::string("state/") + name),
        "# autosave of: /" + std::string(name) + "\n" + read_file(folder.file("scene.toml"), 1 << 20).value()));
  }
  const auto now = std::filesystem::file_time_type::clock::now();
  std::filesystem::last_write_time(folder.file("state/autosave.toml"), now - std::chrono::hours(1));
  State next = make_state(read_document(folder.file("scene.toml")), folder.file("scene.toml"), folder.file("state"));
  restore_session(next);
  REQUIRE(next.document.question);
  CHECK(next.document.question->path == "/autosave-2.toml");
  update(next, action::AnswerQuestion{Answer::discard});
  REQUIRE(next.document.question);
  CHECK(next.document.question->path == "/autosave.toml");
  CHECK_FALSE(std::filesystem::exists(folder.file("state/autosave-2.toml")));
  update(next, action::AnswerQuestion{Answer::discard});
  CHECK_FALSE(next.document.question);
  CHECK_FALSE(std::filesystem::exists(folder.file("state/autosave.toml")));
}

TEST_CASE("a thrown away autosave is gone, and so is that of a scene that was left on purpose") {
  const TemporaryFolder folder;
  const std::string autosave = folder.file("state/autosave.toml");
  State state = saved_state(folder);
  const auto leave_autosave = [&] {
    make_dirty(state);
    for (int i = 0; i < 8; ++i) update(state, action::Tick{1});
    REQUIRE(std::filesystem::exists(autosave));
    crash(state);
  };
  leave_autosave();
  State next = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(next);
  update(next, action::AnswerQuestion{Answer::discard});
  CHECK_FALSE(std::filesystem::exists(autosave));
  CHECK_FALSE(next.document.question);
  leave_autosave();
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::discard});
  CHECK_FALSE(std::filesystem::exists(autosave));
}

TEST_CASE("a scene that was never saved is recovered without a path") {
  const TemporaryFolder folder;
  State state = busy_state();
  state.document.state_dir = folder.file("state");
  make_dirty(state);
  const Scene scene = state.scene();
  update(state, action::Tick{1});
  crash(state);
  State next = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(next);
  update(next, action::AnswerQuestion{Answer::recover});
  CHECK(next.scene() == scene);
  CHECK(next.document.path.empty());
  CHECK(next.document.dirty);
  CHECK(broken_promise(next) == "");
}

TEST_CASE("leaving while recovery is offered keeps the autosave for the next start") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  update(state, action::Tick{1});
  crash(state);
  State next = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(next);
  update(next, action::Quit{});
  CHECK(next.document.quit);
  CHECK(std::filesystem::exists(folder.file("state/autosave.toml")));
}

TEST_CASE("an autosave that cannot be read is reported and harms nothing") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("state"));
  REQUIRE(write_file_atomically(folder.file("state/autosave.toml"), "# autosave of: /x.toml\nnonsense = ["));
  const auto begun = [&] {
    State state = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
    state.appearance.language = in_english;
    restore_session(state);
    return state;
  };
  State state = begun();
  REQUIRE(state.document.question);
  // It says nothing of when it was written; its file does.
  CHECK_THAT(question_panel(state).text, Catch::Matchers::Matches(".* on 20[0-9]{2}-[01][0-9]-[0-3][0-9] at .*"));
  SECTION("it is kept, and nobody is asked about it again") {
    update(state, action::AnswerQuestion{Answer::recover});
    CHECK_FALSE(state.document.question);
    CHECK(state.scene() == busy_scene());
    CHECK_FALSE(state.document.dirty);
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->kind == Notice::Kind::error);
    CHECK_THAT(state.document.notice->text, contains("autosave.toml:2") && contains("autosave.toml.damaged"));
    CHECK_THAT(read_file(folder.file("state/autosave.toml.damaged"), 1 << 20).value(), contains("nonsense"));
    CHECK_FALSE(begun().document.question);
  }
  SECTION("an earlier one is offered then") {
    REQUIRE(write_file_atomically(folder.file("state/autosave-2.toml"),
                                  "# autosave of: /other.toml\n" + format_scene(busy_scene()).value()));
    std::filesystem::last_write_time(folder.file("state/autosave-2.toml"),
                                     std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    update(state, action::AnswerQuestion{Answer::recover});
    REQUIRE(state.document.question);
    CHECK(state.document.question->path == "/other.toml");
    update(state, action::AnswerQuestion{Answer::recover});
    CHECK_FALSE(state.document.question);
    CHECK(state.document.path == "/other.toml");
  }
}

TEST_CASE("an empty autosave holds no work: it is removed without a word") {
  const TemporaryFolder folder;
  State crashed = saved_state(folder);
  make_dirty(crashed);
  update(crashed, action::Tick{1});
  const std::string whole = folder.file("state/autosave.toml"), empty = folder.file("state/autosave-2.toml");
  REQUIRE(std::filesystem::exists(whole));
  crash(crashed);
  REQUIRE(write_file_atomically(empty, ""));
  State state = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(state);
  CHECK_FALSE(std::filesystem::exists(empty));
  REQUIRE(state.document.question);
  CHECK(state.document.question->path == folder.file("scene.toml"));
  state.document.question.reset();
  REQUIRE(write_file_atomically(whole, ""));
  restore_session(state);
  CHECK_FALSE(state.document.question);
  CHECK_FALSE(state.document.notice);
  CHECK_FALSE(std::filesystem::exists(whole));
}

TEST_CASE("an autosave whose scene lacks a file is asked about again, and recovered once that is there") {
  const TemporaryFolder folder;
  const std::string scenes = RAYWALK_SOURCE_DIR "/scenes", ball = folder.file("ball.ply"),
                    scene = folder.file("a.toml");
  std::filesystem::copy_file(scenes + "/ball.ply", ball);
  std::filesystem::copy_file(scenes + "/mesh.toml", scene);
  State crashed = make_state(read_document(scene), scene, folder.file("state"));
  make_dirty(crashed);
  const Scene lost = crashed.scene();
  update(crashed, action::Tick{1});
  crash(crashed);
  std::filesystem::rename(ball, ball + ".away");
  State state = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(state);
  update(state, action::AnswerQuestion{Answer::recover});
  REQUIRE(state.document.question);
  CHECK_THAT(question_panel(state).text, contains("ball.ply"));
  std::filesystem::rename(ball + ".away", ball);
  update(state, action::AnswerQuestion{Answer::recover});
  CHECK_FALSE(state.document.question);
  CHECK(state.scene() == lost);
  CHECK(state.document.path == scene);
}

TEST_CASE("work is recovered out of the hunt and out of the lesson that a link has opened before the question") {
  const TemporaryFolder folder;
  State crashed = saved_state(folder);
  make_dirty(crashed);
  const Scene lost = crashed.scene();
  update(crashed, action::Tick{1});
  crash(crashed);

  State next = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  next.lessons.folder = RAYWALK_SOURCE_DIR "/lessons";
  next.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  restore_session(next);
  // As the window starts: the link first, and then what an earlier sitting has left.
  const auto asked = std::exchange(next.document.question, std::nullopt);
  REQUIRE(asked);
  SECTION("a hunt") {
    update(next, action::ShowBugs{true});
    update(next, action::HuntBug{1});
    REQUIRE(next.bugs.hunt);
  }
  SECTION("a lesson") {
    update(next, action::OpenLesson{"01-ray-casting"});
    REQUIRE(next.lessons.open);
  }
  next.document.question = asked;
  update(next, action::AnswerQuestion{Answer::recover});
  CHECK_FALSE(next.bugs.hunt);
  CHECK_FALSE(next.lessons.open);
  CHECK(broken_promise(next) == "");
  update(next, action::GoToLessonStep{1});
  update(next, action::LeaveHunt{});
  CHECK(next.scene() == lost);
  CHECK(next.document.dirty);
  CHECK(next.document.path == folder.file("scene.toml"));
  // Its autosave is this session's now.
  CHECK(std::filesystem::exists(folder.file("state/autosave.toml")));
  update(next, action::Save{});
  CHECK_FALSE(std::filesystem::exists(folder.file("state/autosave.toml")));
}

TEST_CASE("two windows that start together keep an autosave each") {
  const TemporaryFolder folder;
  const auto begun = [&](const std::string& name) {
    State state = saved_state(folder, name);
    restore_session(state);
    REQUIRE_FALSE(state.document.question);
    return state;
  };
  State first = begun("first.toml"), second = begun("second.toml");
  make_dirty(first);
  make_dirty(second);
  update(first, action::Tick{1});
  update(second, action::Tick{1});
  const auto kept = [&](const std::string& name) {
    const auto text = read_file(folder.file("state/" + name), 1 << 20);
    return text ? text->substr(0, text->find('\n')) : std::string();
  };
  CHECK_THAT(kept("autosave.toml"), contains("first.toml"));
  CHECK_THAT(kept("autosave-2.toml"), contains("second.toml"));
  update(first, action::Undo{});
  CHECK(kept("autosave.toml").empty());
  CHECK_THAT(kept("autosave-2.toml"), contains("second.toml"));
  // Nor is another's forgotten by who has none.
  update(second, action::Save{});
  make_dirty(first);
  update(first, action::Tick{autosave_every + 1});
  make_dirty(second);
  update(second, action::Undo{});
  CHECK_THAT(kept("autosave.toml"), contains("first.toml"));
}

TEST_CASE("the work of a window that still runs, or that another asks about, is not offered") {
  const TemporaryFolder folder;
  State running = saved_state(folder);
  const auto begun = [&] {
    State state = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
    restore_session(state);
    return state;
  };
  make_dirty(running);
  update(running, action::Tick{1});
  CHECK_FALSE(begun().document.question);
  crash(running);
  State asked = begun();
  REQUIRE(asked.document.question);
  CHECK_FALSE(begun().document.question);
  SECTION("postponed, it is free again") {
    update(asked, action::AnswerQuestion{Answer::cancel});
    CHECK(begun().document.question);
  }
  SECTION("recovered, it is the work of who recovered it") {
    update(asked, action::AnswerQuestion{Answer::recover});
    CHECK_FALSE(begun().document.question);
    crash(asked);
    CHECK(begun().document.question);
  }
  SECTION("thrown away, nothing is left but what others hold") {
    State other = begun();
    make_dirty(other);
    update(other, action::Tick{1});
    update(asked, action::AnswerQuestion{Answer::discard});
    CHECK_FALSE(asked.document.question);
    CHECK_FALSE(std::filesystem::exists(folder.file("state/autosave.toml")));
    CHECK(std::filesystem::exists(folder.file("state/autosave-2.toml")));
  }
}

TEST_CASE("an autosave that somebody has removed is written again, while there is work that only it holds") {
  const TemporaryFolder folder;
  const std::string autosave = folder.file("state/autosave.toml");
  State state = saved_state(folder);
  make_dirty(state);
  update(state, action::Tick{1});
  std::filesystem::remove_all(folder.file("state"));
  update(state, action::Tick{autosave_every + 1});
  CHECK(std::filesystem::exists(autosave));
  State other = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(other);
  CHECK_FALSE(other.document.question);
  update(state, action::Save{});
  update(state, action::Tick{autosave_every + 1});
  CHECK_FALSE(std::filesystem::exists(autosave));
}

TEST_CASE("the question says when an autosave was written in the language of the window, an older one's too") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("state"));
  for (const char* written : {"2026-11-21T14:05", "2026-11-21 at 14:05"}) {
    CAPTURE(written);
    REQUIRE(write_file_atomically(
        folder.file("state/autosave.toml"),
        "# autosave of: mine.toml\n# written on: " + std::string(written) + "\n" + format_scene(busy_scene()).value()));
    State state = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
    restore_session(state);
    REQUIRE(state.document.question);
    const auto said_in = [&](Language language) {
      state.appearance.language = language;
      return question_panel(state).text;
    };
    CHECK_THAT(said_in(in_english), contains(" 2026-11-21 at 14:05 "));
    CHECK_THAT(said_in(in_portuguese), contains(" 2026-11-21 às 14:05 "));
    // Nobody knows from which folder a relative path led.
    update(state, action::AnswerQuestion{Answer::recover});
    CHECK(state.scene() == busy_scene());
    CHECK(state.document.path.empty());
  }
}
