// What is exported, by the ending of the file's name, and that nothing is written over unasked.
#include "view/export/export.h"

#include "fixtures.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "text/markup.h"
#include "view/export/lesson_script.h"
#include "view/export/slides.h"
#include "view/text/text.h"

#include <nlohmann/json.hpp>

using namespace raywalk;
using namespace raywalk::test;

namespace {

State walked() {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{100});
  return state;
}

}  // namespace

TEST_CASE("the ending says what is written") {
  const TemporaryFolder folder;
  State state = walked();
  const auto written = [&](const std::string& name) {
    update(state, action::AskExport{});
    CHECK(state.document.prompt == PathPrompt::export_walk);
    update(state, action::Export{folder.file(name)});
    CHECK(state.document.prompt == PathPrompt::none);
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->kind == Notice::Kind::info);
    return contents(folder.file(name));
  };
  CHECK(written("walk.txt") == transcript(state.scene(), *state.walk.timeline, in_english));
  CHECK(written("walk.HTML") == slides_page(state.scene(), state.walk.timeline, in_english, state.appearance.theme));
  const std::string plan = written("plan.svg");
  CHECK(plan.find("<svg") != std::string::npos);
  CHECK(plan.find("Solid Sphere") != std::string::npos);
  const auto json = nlohmann::json::parse(written("walk.json"), nullptr, false);
  REQUIRE(json.is_object());
  REQUIRE(json["steps"].size() == static_cast<std::size_t>(state.walk.timeline->steps()));
  CHECK(json["steps"][99]["step"] == 100);
  CHECK(json["steps"][0]["sentence"].get<std::string>().size() > 10);
  CHECK(json["depth"] == state.scene().limits.depth);

  update(state, action::Export{folder.file("walk.doc")});
  CHECK(state.document.notice->kind == Notice::Kind::error);
  CHECK(state.document.notice->text.find(".svg") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.file("walk.doc")));
  update(state, action::Export{folder.file("no/folder.svg")});
  CHECK(state.document.notice->kind == Notice::Kind::error);
}

TEST_CASE("a name that is only begun, up to its folder, gets its ending too") {
  for (const ExportEnding& each : kinds_of_export)
    for (const std::string begun : {"", "/", "folder/", "../", "."})
      CHECK(with_ending(begun, each.kind).ends_with(each.ending));
}

TEST_CASE("whatever a name ends in, with the ending of a kind it is of that kind") {
  for (const ExportEnding& wanted : kinds_of_export) {
    CAPTURE(wanted.ending);
    for (const ExportEnding& typed : kinds_of_export) {
      for (const std::string stem : {"notes", "notes.script", "notes.html", "notes.script.script", "notes.v2", "n"}) {
        CAPTURE(stem, typed.ending);
        const std::string path = with_ending("a.script/" + stem + std::string(typed.ending), wanted.kind);
        CHECK(export_kind_of(path) == wanted.kind);
        CHECK(with_ending(path, wanted.kind) == path);
        CHECK(path.starts_with("a.script/n"));
      }
    }
  }
}

TEST_CASE("the script of the open lesson is written, and without one it is said what is missing") {
  const TemporaryFolder folder;
  State state = walked();
  const std::string path = folder.file("notes.script.html");
  CHECK(export_kind_of(path) == ExportKind::script);
  CHECK(export_kind_of("notes.html") == ExportKind::slides);
  CHECK_FALSE(export_kind_of(".html"));
  CHECK(with_ending("a/notes.script.html", ExportKind::plan) == "a/notes.svg");
  CHECK(with_ending("a/notes.pdf", ExportKind::script) == "a/notes.script.html");
  CHECK(with_ending("a.b/notes", ExportKind::slides) == "a.b/notes.html");
  // What follows a point in a name is not always an ending.
  CHECK(with_ending("a/1. Casting", ExportKind::animation) == "a/1. Casting.gif");
  CHECK(with_ending("lesson 2.5", ExportKind::plan) == "lesson 2.5.svg");
  update(state, action::Export{path});
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->text.find("F2") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(path));

  const std::string root = RAYWALK_SOURCE_DIR;
  state.lessons.folder = root + "/lessons";
  state.lessons.scenes_folder = root + "/scenes";
  update(state, action::SetLessonOptions{true, false});
  update(state, action::OpenLesson{"05-refraction"});
  REQUIRE(state.lessons.open);
  update(state, action::Export{path});
  CHECK(contents(path) == lesson_script(state.lessons.open->played, in_english, ScriptForm::page));
}

TEST_CASE("an export has the code in the language of the window's, and its depth") {
  const TemporaryFolder folder;
  State state = walked();
  state.appearance.language = in_portuguese;
  const auto code = state.walk.timeline->pseudocode().lines.back().line;
  REQUIRE(text(code, in_english) != text(code, in_portuguese));
  for (const bool english : {true, false}) {
    update(state, action::SetEnglishCode{english});
    std::filesystem::remove(folder.file("walk.html"));
    update(state, action::Export{folder.file("walk.html")});
    const std::string page = contents(folder.file("walk.html"));
    CHECK((page.find(">" + escaped(text(code, in_english)) + "</li>") != std::string::npos) == english);
  }
  update(state, action::LimitDepth{2});
  update(state, action::Export{folder.file("walk.json")});
  const auto json = nlohmann::json::parse(contents(folder.file("walk.json")));
  CHECK(json["depth"] == 2);
}

TEST_CASE("a script has all that its presenter needs, with the answers of the trace") {
  const std::string root = RAYWALK_SOURCE_DIR;
  for (const std::string& name : lesson_names(root + "/lessons")) {
    CAPTURE(name);
    const auto lesson = read_lesson(root + "/lessons/" + name);
    REQUIRE(lesson);
    const PlayedLesson played = play_lesson(*lesson, root + "/scenes");
    REQUIRE(played.errors.empty());
    for (const Language language : all_languages()) {
      const std::string text = lesson_script(played, language, ScriptForm::markdown);
      const std::string page = lesson_script(played, language, ScriptForm::page);
      std::size_t answers = 0, asked = 0;
      for (std::size_t at = text.find(" \u2713"); at != std::string::npos; at = text.find(" \u2713", at + 1)) ++answers;
      for (const LessonStep& step : lesson->steps)
        asked += step.question && !std::holds_alternative<ArrowQuestion>(*step.question) ? 1U : 0U;
      CHECK(answers == asked);
      CHECK(text.find('{') == std::string::npos);
      const LessonWords& words = lesson->told(language);
      for (const StepWords& step : words.steps) {
        CHECK(text.find(step.heading) != std::string::npos);
        CHECK(page.find(escaped(step.heading)) != std::string::npos);
      }
      const auto count = [&](std::string_view what) {
        std::size_t times = 0;
        for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++times;
        return times;
      };
      for (const std::string tag : {"div", "span", "p", "ul", "ol", "li", "code", "em", "h2", "section"})
        CHECK(count("<" + tag + ">") + count("<" + tag + " ") == count("</" + tag + ">"));
      CHECK(page.find('*') == std::string::npos);
    }
  }
  const auto lesson = read_lesson(root + "/lessons/05-refraction");
  const PlayedLesson played = play_lesson(*lesson, root + "/scenes");
  const std::string text = lesson_script(played, in_english, ScriptForm::markdown);
  CHECK(text.find("3. larger \u2713") != std::string::npos);
  CHECK(text.find("\n24.6\u00b0 \u2713") != std::string::npos);
  CHECK(text.find("\nForm refract ray \u2713") != std::string::npos);
  CHECK(text.find("## 1. Into the glass (0:00\u2013") != std::string::npos);
  CHECK(text.find("(if time allows)") != std::string::npos);
}

TEST_CASE("a file that stands there is written over only when that is said") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("mine.txt"), "mine"));
  State state = walked();
  update(state, action::AskExport{});
  update(state, action::Export{folder.file("mine.txt")});
  REQUIRE(state.document.question);
  CHECK(state.document.question->kind == Question::Kind::overwrite);
  update(state, action::AnswerQuestion{action::Answer::cancel});
  CHECK(contents(folder.file("mine.txt")) == "mine");
  CHECK(state.document.prompt == PathPrompt::export_walk);  // for another name
  update(state, action::Export{folder.file("mine.txt")});
  update(state, action::AnswerQuestion{action::Answer::save});
  CHECK(contents(folder.file("mine.txt")) != "mine");
  CHECK(state.document.prompt == PathPrompt::none);
}

TEST_CASE("what shows the window waits for it") {
  const TemporaryFolder folder;
  State state = walked();
  update(state, action::AskExport{});
  update(state, action::Export{folder.file("a.png")});
  CHECK(state.document.prompt == PathPrompt::none);
  REQUIRE(state.exports.window);
  CHECK(*state.exports.window == WindowExport{ExportKind::picture, folder.file("a.png")});
  update(state, action::FinishExport{"no room"});
  CHECK_FALSE(state.exports.window);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  update(state, action::Export{folder.file("a.gif")});
  REQUIRE(state.exports.window);
  CHECK(state.exports.window->kind == ExportKind::animation);
  update(state, action::FinishExport{});
  CHECK(state.document.notice->kind == Notice::Kind::info);
}

TEST_CASE("an animation goes to the end of the pixel, or of the walk, as fast as the grain says") {
  State state = walked();
  const int pixel = state.walk.timeline->current_pixel(100);
  const int end = state.walk.timeline->pixels()[static_cast<std::size_t>(pixel)].done_at;
  const std::vector<int> lines = animation_positions(state);
  REQUIRE(lines.size() == static_cast<std::size_t>(end - 100 + 1));
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i] == 100 + static_cast<int>(i));
  update(state, action::SetGrain{Grain::ray});
  const std::vector<int> rays = animation_positions(state);
  CHECK(rays.size() < lines.size());
  CHECK(rays.front() == 100);
  CHECK(rays.back() == end);
  update(state, action::SetGrain{Grain::pixel});
  update(state, action::Jump{0});
  const std::vector<int> pixels = animation_positions(state);
  CHECK(pixels.size() == state.walk.timeline->pixels().size() + 1);
  CHECK(pixels.back() == state.walk.timeline->steps());
  update(state, action::Jump{state.walk.timeline->steps()});
  CHECK(animation_positions(state) == std::vector{state.walk.timeline->steps()});
}

TEST_CASE("slides of a shipped scene have its title in the language of the window") {
  const TemporaryFolder folder;
  const std::string scenes = RAYWALK_SOURCE_DIR "/scenes";
  State state = make_state(read_document(scenes + "/classic.toml"), scenes + "/classic.toml");
  state.lessons.scenes_folder = scenes;
  update(state, action::Export{folder.file("english.html")});
  CHECK(contents(folder.file("english.html")).find("<h1>" + state.scene().title) != std::string::npos);
  state.appearance.language = in_portuguese;
  update(state, action::Export{folder.file("portuguese.html")});
  CHECK(contents(folder.file("portuguese.html")).find("<h1>A clássica</h1>") != std::string::npos);
}
