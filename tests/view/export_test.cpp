// What is exported, by the ending of the file's name, and that nothing is written over unasked.
#include "view/export.h"

#include "fixtures.h"
#include "io/file.h"
#include "support/catch.h"
#include "view/slides.h"
#include "view/text.h"

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

std::string contents(const std::string& path) {
  const auto bytes = read_file(path, 1 << 26);
  REQUIRE(bytes);
  return *bytes;
}

}  // namespace

TEST_CASE("the ending says what is written") {
  const TemporaryFolder folder;
  State state = walked();
  const auto written = [&](const std::string& name) {
    update(state, action::AskExport{});
    CHECK(state.prompt == PathPrompt::export_walk);
    update(state, action::Export{folder.file(name)});
    CHECK(state.prompt == PathPrompt::none);
    REQUIRE(state.notice);
    CHECK(state.notice->kind == Notice::Kind::info);
    return contents(folder.file(name));
  };
  CHECK(written("walk.txt") == transcript(state.scene(), *state.timeline, Language::english));
  CHECK(written("walk.HTML") == slides_page(state.scene(), state.timeline, Language::english, state.theme));
  const std::string plan = written("plan.svg");
  CHECK(plan.find("<svg") != std::string::npos);
  CHECK(plan.find("Solid Sphere") != std::string::npos);
  const auto json = nlohmann::json::parse(written("walk.json"), nullptr, false);
  REQUIRE(json.is_object());
  REQUIRE(json["steps"].size() == static_cast<std::size_t>(state.timeline->steps()));
  CHECK(json["steps"][99]["step"] == 100);
  CHECK(json["steps"][0]["sentence"].get<std::string>().size() > 10);
  CHECK(json["depth"] == state.scene().limits.depth);

  update(state, action::Export{folder.file("walk.doc")});
  CHECK(state.notice->kind == Notice::Kind::error);
  CHECK(state.notice->text.find(".svg") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.file("walk.doc")));
  update(state, action::Export{folder.file("no/folder.svg")});
  CHECK(state.notice->kind == Notice::Kind::error);
}

TEST_CASE("a file that stands there is written over only when that is said") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("mine.txt"), "mine"));
  State state = walked();
  update(state, action::AskExport{});
  update(state, action::Export{folder.file("mine.txt")});
  REQUIRE(state.question);
  CHECK(state.question->kind == Question::Kind::overwrite);
  update(state, action::AnswerQuestion{action::Answer::cancel});
  CHECK(contents(folder.file("mine.txt")) == "mine");
  CHECK(state.prompt == PathPrompt::export_walk);  // for another name
  update(state, action::Export{folder.file("mine.txt")});
  update(state, action::AnswerQuestion{action::Answer::save});
  CHECK(contents(folder.file("mine.txt")) != "mine");
  CHECK(state.prompt == PathPrompt::none);
}

TEST_CASE("what shows the window waits for it") {
  const TemporaryFolder folder;
  State state = walked();
  update(state, action::AskExport{});
  update(state, action::Export{folder.file("a.png")});
  CHECK(state.prompt == PathPrompt::none);
  REQUIRE(state.window_export);
  CHECK(*state.window_export == WindowExport{ExportKind::picture, folder.file("a.png")});
  update(state, action::FinishExport{"no room"});
  CHECK_FALSE(state.window_export);
  CHECK(state.notice->kind == Notice::Kind::error);
  update(state, action::Export{folder.file("a.gif")});
  REQUIRE(state.window_export);
  CHECK(state.window_export->kind == ExportKind::film);
  update(state, action::FinishExport{});
  CHECK(state.notice->kind == Notice::Kind::info);
}

TEST_CASE("a film goes to the end of the pixel, or of the walk, as fast as the grain says") {
  State state = walked();
  const int pixel = state.timeline->current_pixel(100);
  const int end = state.timeline->pixels()[static_cast<std::size_t>(pixel)].done_at;
  const std::vector<int> lines = film_positions(state);
  REQUIRE(lines.size() == static_cast<std::size_t>(end - 100 + 1));
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i] == 100 + static_cast<int>(i));
  update(state, action::SetGrain{Grain::ray});
  const std::vector<int> rays = film_positions(state);
  CHECK(rays.size() < lines.size());
  CHECK(rays.front() == 100);
  CHECK(rays.back() == end);
  update(state, action::SetGrain{Grain::pixel});
  update(state, action::Jump{0});
  const std::vector<int> pixels = film_positions(state);
  CHECK(pixels.size() == state.timeline->pixels().size() + 1);
  CHECK(pixels.back() == state.timeline->steps());
  update(state, action::Jump{state.timeline->steps()});
  CHECK(film_positions(state) == std::vector{state.timeline->steps()});
}
