#include "fixtures.h"
#include "text/file.h"
#include "view/document/question.h"
#include "view/text/text.h"

#include "support/catch.h"
#include "support/languages.h"
#include "support/working_folder.h"

using namespace raywalk;
using namespace raywalk::test;
using action::Answer;

TEST_CASE("Save as writes the scene, Open reads it back") {
  const TemporaryFolder folder;
  State state = busy_state();
  make_dirty(state);
  update(state, action::SaveAs{folder.file("a")});
  CHECK(state.document.path == folder.file("a.toml"));
  CHECK_FALSE(state.document.dirty);
  CHECK(document_title(state) == "a.toml");
  State other = classic_state();
  update(other, action::Open{folder.file("a.toml")});
  CHECK(other.scene() == state.scene());
  CHECK(other.document.path == folder.file("a.toml"));
  CHECK(other.walk.position == 0);
  CHECK(other.document.undo.empty());
  CHECK(other.plan.camera == fit(other.scene(), other.plan.viewport));
}

TEST_CASE("Save as gives every name the ending that Open lists, whatever dots are in it") {
  const TemporaryFolder folder;
  State state = busy_state();
  update(state, action::SaveAs{folder.file("mirror 0.5")});
  CHECK(state.document.path == folder.file("mirror 0.5.toml"));
  CHECK(read_document(folder.file("mirror 0.5.toml")).scene == state.scene());
}

TEST_CASE("Save without a path asks for one") {
  const TemporaryFolder folder;
  State state = busy_state();
  make_dirty(state);
  CHECK(document_title(state) == "*Untitled");
  update(state, action::Save{});
  CHECK(state.document.prompt == PathPrompt::save_as);
  update(state, action::CancelPrompt{});
  CHECK(state.document.prompt == PathPrompt::none);
  CHECK(state.document.dirty);
  update(state, action::Save{});
  update(state, action::SaveAs{folder.file("b.toml")});
  CHECK(state.document.prompt == PathPrompt::none);
  CHECK_FALSE(state.document.dirty);
  make_dirty(state);
  update(state, action::Save{});
  CHECK_FALSE(state.document.dirty);
  CHECK(read_document(folder.file("b.toml")).scene == state.scene());
}

TEST_CASE("a scene that ships is kept as it is: Save asks for another name, and the same one for a yes") {
  const TemporaryFolder folder;
  State state = saved_state(folder, "shipped.toml");
  state.lessons.scenes_folder = folder.path();
  make_dirty(state);
  update(state, action::Save{});
  CHECK(state.document.prompt == PathPrompt::save_as);
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->text == text("notice.save_elsewhere", in_english));
  update(state, action::SaveAs{folder.file("shipped.toml")});
  REQUIRE(state.document.question);
  CHECK(state.document.question->kind == Question::Kind::overwrite);
  CHECK(read_document(folder.file("shipped.toml")).scene == saved_scene(state));
  update(state, action::AnswerQuestion{action::Answer::cancel});
  const TemporaryFolder own;
  update(state, action::SaveAs{own.file("own.toml")});
  CHECK_FALSE(state.document.dirty);
  make_dirty(state);
  update(state, action::Save{});  // which is one's own now
  CHECK_FALSE(state.document.dirty);
  CHECK(read_document(own.file("own.toml")).scene == state.scene());
}

TEST_CASE("undoing back to what the file holds is not unsaved work") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  update(state, action::Undo{});
  CHECK_FALSE(state.document.dirty);
  update(state, action::Redo{});
  CHECK(state.document.dirty);
}

TEST_CASE("a file that cannot be read or written leaves everything as it was") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  const Scene scene = state.scene();
  update(state, action::SaveAs{folder.file("no/such/folder/x.toml")});
  CHECK(state.document.dirty);
  CHECK(state.document.path == folder.file("scene.toml"));
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  update(state, action::Save{});
  REQUIRE_FALSE(state.document.dirty);
  for (const std::string& name : {folder.file("missing.toml"), folder.path(), std::string()}) {
    INFO(name);
    update(state, action::Open{name});
    CHECK(state.scene() == scene);
    CHECK(state.document.path == folder.file("scene.toml"));
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->kind == Notice::Kind::error);
  }
  REQUIRE(write_file_atomically(folder.file("bad.toml"), "[camera\n"));
  update(state, action::Open{folder.file("bad.toml")});
  CHECK_THAT(state.document.notice->text, contains("bad.toml:1"));
  CHECK(state.scene() == scene);
}

TEST_CASE("unsaved work is asked about before it is lost, and Cancel keeps it") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  const Scene scene = state.scene();
  for (const Action& action : {Action(action::New{}), Action(action::Open{"other.toml"}), Action(action::Quit{})}) {
    update(state, action);
    REQUIRE(state.document.question);
    CHECK(question_panel(state).choices.size() == 3);
    CHECK_THAT(question_panel(state).text, contains("scene.toml"));
    update(state, action::AddObject{action::ObjectKind::light});
    CHECK(state.scene() == scene);
    update(state, action::AnswerQuestion{Answer::recover});
    CHECK(state.document.question);
    update(state, action::AnswerQuestion{Answer::cancel});
    CHECK_FALSE(state.document.question);
    CHECK(state.scene() == scene);
    CHECK(state.document.dirty);
    CHECK_FALSE(state.document.quit);
  }
}

TEST_CASE("Discard goes on without saving") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  const Scene on_disk = state.scene();
  make_dirty(state);
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::discard});
  CHECK(state.document.quit);
  CHECK(read_document(folder.file("scene.toml")).scene == on_disk);
}

TEST_CASE("Save goes on after saving, also when a path has to be asked for first") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  const Scene scene = state.scene();
  update(state, action::New{});
  update(state, action::AnswerQuestion{Answer::save});
  CHECK(read_document(folder.file("scene.toml")).scene == scene);
  CHECK(state.scene() != scene);
  CHECK(state.document.path.empty());
  CHECK(broken_promise(state) == "");

  make_dirty(state);
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::save});
  CHECK(state.document.prompt == PathPrompt::save_as);
  CHECK_FALSE(state.document.quit);
  update(state, action::SaveAs{folder.file("late.toml")});
  CHECK(state.document.quit);
}

TEST_CASE("taking back the path also takes back what waited for the saving") {
  const TemporaryFolder folder;
  State state = busy_state();
  make_dirty(state);
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::save});
  update(state, action::CancelPrompt{});
  update(state, action::SaveAs{folder.file("x.toml")});
  CHECK_FALSE(state.document.quit);
  CHECK_FALSE(state.document.dirty);
}

TEST_CASE("another file is not replaced without asking") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("precious.toml"), "precious"));
  State state = saved_state(folder);
  update(state, action::SaveAs{folder.file("precious.toml")});
  REQUIRE(state.document.question);
  CHECK(question_panel(state).choices.front().answer == Answer::cancel);
  update(state, action::AnswerQuestion{Answer::cancel});
  CHECK(*read_file(folder.file("precious.toml"), 100) == "precious");
  update(state, action::SaveAs{folder.file("precious.toml")});
  update(state, action::AnswerQuestion{Answer::save});
  CHECK(read_document(folder.file("precious.toml")).scene == state.scene());
  // Its own file needs no question.
  update(state, action::SaveAs{folder.file("precious.toml")});
  CHECK_FALSE(state.document.question);
}

TEST_CASE("what others have written to the scene's file is not replaced without asking") {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.toml");
  State state = saved_state(folder);
  make_dirty(state);
  const std::string before = *read_file(path, 1 << 20), theirs = before + "# by another window\n";
  // The same bytes anew are no change.
  REQUIRE(write_file_atomically(path, before));
  update(state, action::Save{});
  CHECK_FALSE(state.document.question);
  CHECK_FALSE(state.document.dirty);

  make_dirty(state);
  REQUIRE(write_file_atomically(path, theirs));
  for (const Action& save : {Action(action::Save{}), Action(action::SaveAs{path})}) {
    update(state, save);
    REQUIRE(state.document.question);
    CHECK(state.document.question->kind == Question::Kind::overwrite);
    CHECK(question_panel(state).text == fill("question.overwrite_changed", in_english, {{"file", path}}));
    CHECK(question_panel(state).choices.front().answer == Answer::cancel);
    update(state, action::AnswerQuestion{Answer::cancel});
    CHECK(*read_file(path, 1 << 20) == theirs);
    CHECK(state.document.dirty);
  }
  // Nor where it is to be saved before something else, which then waits for the answer.
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::save});
  REQUIRE(state.document.question);
  CHECK_FALSE(state.document.quit);
  CHECK(*read_file(path, 1 << 20) == theirs);
  update(state, action::AnswerQuestion{Answer::save});
  CHECK(state.document.quit);
  CHECK(read_document(path).scene == state.scene());
  // What was written now is known.
  state.document.quit = false;
  make_dirty(state);
  update(state, action::Save{});
  CHECK_FALSE(state.document.question);
  CHECK_FALSE(state.document.dirty);
}

TEST_CASE("a scene's file that is gone is written anew, and one that became something else is asked about") {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.toml");
  State state = saved_state(folder);
  make_dirty(state);
  std::filesystem::remove(path);
  update(state, action::Save{});
  CHECK_FALSE(state.document.question);
  CHECK(read_document(path).scene == state.scene());
  make_dirty(state);
  REQUIRE(write_file_atomically(path, std::string("\0\xff", 2)));  // no text
  update(state, action::Save{});
  CHECK(state.document.question);
}

TEST_CASE("a file that begins with a byte order mark, or has the line ends of another system, is known again") {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.toml");
  static_cast<void>(saved_state(folder));
  std::string text = read_file(path, 1 << 20).value();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  REQUIRE(write_file_atomically(path, "\xef\xbb\xbf" + text));
  State state = make_state(read_document(path), path);
  make_dirty(state);
  update(state, action::Save{});
  CHECK_FALSE(state.document.question);
  CHECK_FALSE(state.document.dirty);
  CHECK(read_file(path, 1 << 20).value().starts_with("\xef\xbb\xbf"));
}

TEST_CASE("the dialog for a path stays until the file is read or written") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  update(state, action::AskSaveAs{});
  update(state, action::SaveAs{folder.file("no/such/folder/x.toml")});
  CHECK(state.document.prompt == PathPrompt::save_as);
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  update(state, action::SaveAs{folder.file("other.toml")});
  CHECK(state.document.prompt == PathPrompt::none);
  CHECK(state.document.path == folder.file("other.toml"));
  update(state, action::AskOpen{});
  update(state, action::Open{folder.file("missing.toml")});
  CHECK(state.document.prompt == PathPrompt::open);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  update(state, action::Open{folder.file("scene.toml")});
  CHECK(state.document.prompt == PathPrompt::none);
}

TEST_CASE("autosaves are seldom, and none is written while nothing changes") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  make_dirty(state);
  update(state, action::Tick{0.1});
  const std::string autosave = folder.file("state/autosave.toml");
  REQUIRE(std::filesystem::exists(autosave));
  const std::string mark = "as it was";
  const auto is_written = [&] { return read_file(autosave, 1 << 20).value() != mark; };
  REQUIRE(write_file_atomically(autosave, mark));
  make_dirty(state);
  update(state, action::Tick{autosave_every / 2});
  CHECK_FALSE(is_written());
  update(state, action::Tick{autosave_every});
  CHECK(is_written());
  REQUIRE(write_file_atomically(autosave, mark));
  for (int i = 0; i < 10; ++i) update(state, action::Tick{autosave_every});
  CHECK_FALSE(is_written());
}

TEST_CASE("an autosave that cannot be written is reported until that is dismissed, and tried again") {
  const TemporaryFolder folder;
  State state = saved_state(folder);
  const auto block = [&] { REQUIRE(write_file_atomically(folder.file("blocked"), "a file where a folder is wanted")); };
  const auto is_reported = [&] {
    const auto& said = state.document.notice;
    return said && said->kind == Notice::Kind::error && said->text.find("could not be autosaved") != std::string::npos;
  };
  block();
  state.document.state_dir = folder.file("blocked");
  make_dirty(state);
  update(state, action::Tick{1});
  CHECK(is_reported());
  // A drag, in which it may have failed first, and other edits do not end it.
  drag_by(state, {TargetKind::object, 0}, {40, -25});
  CHECK(is_reported());
  make_dirty(state);
  CHECK(is_reported());
  // What is said meanwhile stands alone, and it is told again after that.
  update(state, action::Redo{});
  CHECK_FALSE(is_reported());
  update(state, action::Tick{autosave_every + 1});
  CHECK_FALSE(is_reported());
  update(state, action::DismissNotice{});
  update(state, action::Tick{autosave_every + 1});
  CHECK(is_reported());
  // Who has dismissed it, hears it no more.
  update(state, action::DismissNotice{});
  for (int i = 0; i < 3; ++i) {
    make_dirty(state);
    update(state, action::Tick{autosave_every + 1});
    CHECK_FALSE(is_reported());
  }
  std::filesystem::remove(folder.file("blocked"));
  update(state, action::Tick{autosave_every / 2});
  CHECK_FALSE(std::filesystem::exists(folder.file("blocked/autosave.toml")));
  update(state, action::Tick{autosave_every});
  CHECK(std::filesystem::exists(folder.file("blocked/autosave.toml")));
  CHECK_FALSE(is_reported());
  // Once it was written, a failure is news again.
  std::filesystem::remove_all(folder.file("blocked"));
  block();
  update(state, action::Tick{autosave_every + 1});
  CHECK(is_reported());
  SECTION("it ends once one is written") {
    std::filesystem::remove(folder.file("blocked"));
    update(state, action::Tick{autosave_every + 1});
    CHECK_FALSE(state.document.notice);
  }
  SECTION("it ends with the work that it is about") {
    while (state.document.dirty) update(state, action::Undo{});
    CHECK_FALSE(state.document.notice);
  }
}

TEST_CASE("recent files are remembered, the latest first, each once") {
  const TemporaryFolder folder;
  State state = saved_state(folder, "one.toml");
  update(state, action::SaveAs{folder.file("two.toml")});
  update(state, action::Open{folder.file("one.toml")});
  CHECK(state.document.recent == std::vector<std::string>{folder.file("one.toml"), folder.file("two.toml")});
  for (int i = 0; i < 20; ++i) update(state, action::SaveAs{folder.file(std::to_string(i) + ".toml")});
  CHECK(state.document.recent.size() == 10);
  State next = make_state({busy_scene(), {}, {}}, {}, folder.file("state"));
  restore_session(next);
  CHECK(next.document.recent == state.document.recent);
  // One that is gone cannot be opened.
  std::filesystem::rename(folder.file("19.toml"), folder.file("moved.toml"));
  restore_session(next);
  CHECK(next.document.recent.size() == 9);
  std::filesystem::rename(folder.file("moved.toml"), folder.file("19.toml"));
  restore_session(next);
  // In two windows.
  update(next, action::SaveAs{folder.file("next.toml")});
  update(state, action::SaveAs{folder.file("last.toml")});
  CHECK(state.document.recent[0] == folder.file("last.toml"));
  CHECK(state.document.recent[1] == folder.file("next.toml"));
}

TEST_CASE("of a scene without any object the window says how one is added, in its language") {
  const TemporaryFolder folder;
  const std::string camera = "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n";
  const std::string empty = folder.file("empty.toml"), sky = folder.file("sky.toml");
  REQUIRE(write_file_atomically(empty, camera));
  REQUIRE(write_file_atomically(sky, camera + "[sky]\ntype = \"clear\"\nsun = [1, 0, 1]\n"));
  State state = busy_state();
  for (const Language language : all_languages()) {
    state.appearance.language = language;
    update(state, action::Open{empty});
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->text == fill("notice.no_object", language, {{"file", empty}}));
    CHECK_THAT(state.document.notice->text, Catch::Contains(std::string(text("command.mode_move.label", language))));
  }
  update(state, action::Open{sky});
  REQUIRE(state.document.notice);
  CHECK_THAT(state.document.notice->text,
             !Catch::Contains(std::string(text("command.mode_move.label", state.appearance.language))));
}

TEST_CASE("New starts with something that can be walked") {
  State state = busy_state();
  update(state, action::New{});
  CHECK(state.document.path.empty());
  CHECK_FALSE(state.document.dirty);
  CHECK(state.walk.timeline->steps() > 100);
  CHECK(is_planar(state.scene()));
  CHECK(broken_promise(state) == "");
}

TEST_CASE("appearance and talk") {
  State state = busy_state();
  update(state, action::SetTheme{Theme::projector});
  CHECK(state.appearance.theme == Theme::projector);
  update(state, action::SetUiScale{9});
  CHECK(state.appearance.ui_scale == max_ui_scale);
  update(state, action::SetUiScale{0});
  CHECK(state.appearance.ui_scale == min_ui_scale);
  update(state, action::SetTab{StackRoom::tab});
  CHECK(state.appearance.tab == StackRoom::tab);
  update(state, action::Undo{});
  REQUIRE(state.document.notice);
  update(state, action::DismissNotice{});
  CHECK_FALSE(state.document.notice);
  update(state, action::AskOpen{});
  CHECK(state.document.prompt == PathPrompt::open);
  update(state, action::Step{});
  CHECK(state.walk.position == 0);
  update(state, action::CancelPrompt{});
  update(state, action::AskSaveAs{});
  CHECK(state.document.prompt == PathPrompt::save_as);
  update(state, action::Quit{});
  CHECK(state.document.quit);
}

TEST_CASE("what could not be opened is said in the dialog, and no longer once that is closed") {
  State state = classic_state();
  update(state, action::AskOpen{});
  update(state, action::Open{"/nowhere/at_all.toml"});
  CHECK(state.document.prompt == PathPrompt::open);
  REQUIRE(state.document.notice);
  update(state, action::CancelPrompt{});
  CHECK(state.document.prompt == PathPrompt::none);
  CHECK_FALSE(state.document.notice);
}

TEST_CASE("an edit that was undone leaves nothing to recover") {
  TemporaryFolder folder;
  State state = make_state(read_document(shipped_scenes().front()), shipped_scenes().front(), folder.path());
  update(state, action::AddObject{action::ObjectKind::light});
  update(state, action::Tick{autosave_every + 1});
  REQUIRE(std::filesystem::exists(folder.file("autosave.toml")));
  update(state, action::Undo{});
  REQUIRE_FALSE(state.document.dirty);
  CHECK_FALSE(std::filesystem::exists(folder.file("autosave.toml")));
}

TEST_CASE("Help makes way for a scene that is opened") {
  State state = classic_state();
  update(state, action::SetMode{Mode::move});
  update(state, action::SetMode{Mode::help});
  update(state, action::Open{std::string(RAYWALK_SOURCE_DIR) + "/scenes/glass.toml"});
  CHECK(state.walk.mode == Mode::move);
}

TEST_CASE("what waited for a path is dropped where the window is closed instead, and that is cancelled") {
  const TemporaryFolder folder;
  State state = busy_state();
  make_dirty(state);
  const Scene scene = state.scene();
  update(state, action::New{});
  update(state, action::AnswerQuestion{Answer::save});
  REQUIRE(state.document.prompt == PathPrompt::save_as);
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::cancel});
  CHECK(state.document.prompt == PathPrompt::none);
  update(state, action::SaveAs{folder.file("mine.toml")});
  CHECK(state.scene() == scene);
  CHECK(state.document.path == folder.file("mine.toml"));
}

TEST_CASE("a scene remembers its file by a path that leads there from every folder") {
  const TemporaryFolder folder;
  const WorkingFolder there(folder.path());
  State state = busy_state();
  update(state, action::SaveAs{"mine.toml"});
  CHECK(state.document.path == folder.file("mine.toml"));
  CHECK(state.document.notice->text == fill("notice.saved_as", in_english, {{"file", "mine.toml"}}));
  State other = busy_state();
  update(other, action::Open{"mine.toml"});
  CHECK(other.document.path == folder.file("mine.toml"));
  CHECK(other.document.recent.front() == folder.file("mine.toml"));
  CHECK(other.document.notice->text == fill("notice.opened", in_english, {{"file", "mine.toml"}}));
}
