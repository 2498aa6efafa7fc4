// Ink in the window: its tools, the pen in the plan, and the field for words.
#include "gui/bench.h"
#include "gui/command.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/plan/plan_view.h"

#include <string>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

State in_trace() {
  State state = classic();
  update(state, action::SetMode{Mode::trace});
  return state;
}

std::vector<std::string> tools() {
  std::vector<std::string> names{"ink", "ink-clear", "ink-keep"};
  for (const auto& [tool, name] : words_of<InkTool>) names.push_back("ink-" + std::string(name));
  for (const auto& [colour, name] : words_of<InkColour>) names.push_back("ink/" + std::string(name));
  return names;
}

const Ink& ink_of(const Bench& bench) { return bench.state.document.contents.ink; }

// The upper left corner of the plan, where nothing is.
ImVec2 corner_of_plan(const Bench& bench) {
  const Rect plan = bench.interface().layout().plan;
  return {plan.x + 30, plan.y + 30};
}

void draw_line(Bench& bench, ImVec2 from, float dx, float dy) {
  bench.move_to(from.x, from.y);
  bench.press();
  bench.move_to(from.x + dx / 2, from.y + dy / 2);
  bench.move_to(from.x + dx, from.y + dy);
  bench.release();
}

}  // namespace

TEST_CASE("a key brings the tools of ink and Escape takes them away, in Move and in Trace") {
  for (const Mode mode : {Mode::move, Mode::trace}) {
    Bench bench(in_trace());
    update(bench.state, action::SetMode{mode});
    bench.frames(2);
    for (const std::string& name : tools()) CHECK_FALSE(bench.has(name));
    const Rect before = bench.interface().layout().plan;
    bench.key("Q");
    bench.frames(2);
    CHECK(bench.state.ink.on);
    for (const std::string& name : tools()) CHECK(bench.has(name));
    // They stand above the plan, not on it.
    const Rect plan = bench.interface().layout().plan;
    CHECK(plan.bottom() == before.bottom());
    CHECK(bench.rect("ink-pen").bottom() <= plan.y);
    draw_line(bench, corner_of_plan(bench), 80, 40);
    CHECK(ink_of(bench).size() == 1);
    CHECK(bench.state.walk.mode == mode);
    bench.key("Ctrl+Z");
    CHECK(ink_of(bench).empty());
    bench.key("Ctrl+Y");
    CHECK(ink_of(bench).size() == 1);
    bench.key("Shift+C");
    CHECK(ink_of(bench).empty());
    bench.key("Escape");
    CHECK_FALSE(bench.state.ink.on);
    bench.frames(2);
    CHECK_FALSE(bench.has("ink-pen"));
    CHECK(bench.interface().layout().plan == before);
  }
}

TEST_CASE("every tool has its key and its button, and the menu has them all") {
  Bench bench(in_trace());
  const std::vector<std::pair<std::string, InkTool>> keys{
      {"Shift+P", InkTool::pen},   {"Shift+V", InkTool::arrow},      {"Shift+T", InkTool::text},
      {"Shift+D", InkTool::ruler}, {"Shift+G", InkTool::protractor}, {"Shift+X", InkTool::eraser}};
  for (const auto& [key, tool] : keys) {
    bench.state.ink.on = false;
    bench.key(key);
    CHECK(bench.state.ink.on);
    CHECK(bench.state.ink.tool == tool);
  }
  bench.frames(2);
  for (const auto& [tool, name] : words_of<InkTool>) {
    bench.click("ink-" + std::string(name));
    CHECK(bench.state.ink.tool == tool);
  }
  bench.click("ink/green");
  CHECK(bench.state.ink.colour == InkColour::green);
  bench.key("Shift+K");
  CHECK(bench.state.ink.colour == InkColour::yellow);
  bench.click("ink-keep");
  CHECK(bench.state.document.contents.keeps_ink);
  bench.click("ink");
  CHECK_FALSE(bench.state.ink.on);
  bench.click("menu-edit");
  for (const Command* each : commands_in(Section::ink)) CHECK(bench.has("menu/" + std::string(each->name)));
  bench.click("menu/ink-ruler");
  CHECK(bench.state.ink.on);
  CHECK(bench.state.ink.tool == InkTool::ruler);
}

TEST_CASE("words are typed in the plan, ended by Enter and dropped by Escape") {
  Bench bench(in_trace());
  bench.key("Shift+T");
  bench.frames(2);
  const ImVec2 at = corner_of_plan(bench);
  const auto click_at = [&](float x, float y) {
    bench.move_to(x, y);
    bench.press();
    bench.release();
    bench.frames(3);
  };
  click_at(at.x, at.y);
  REQUIRE(bench.has("ink-field"));
  const int position = bench.state.walk.position;
  bench.type("mirror");
  CHECK(text_begun(bench.state)->text == "mirror");
  bench.enter();
  bench.frames(2);
  CHECK_FALSE(bench.has("ink-field"));
  REQUIRE(ink_of(bench).size() == 1);
  CHECK(std::get<InkText>(ink_of(bench).front().shape).text == "mirror");
  CHECK(bench.state.walk.position == position);  // no letter was a command

  click_at(at.x, at.y + 60);
  bench.type("gla");
  // Another colour meanwhile, and on behind the letters.
  bench.click("ink/green");
  bench.frames(3);
  bench.type("ss");
  CHECK(text_begun(bench.state)->text == "glass");
  click_at(at.x, at.y + 120);
  REQUIRE(ink_of(bench).size() == 2);
  CHECK(ink_of(bench).back() == InkMark{std::get<InkText>(ink_of(bench).back().shape), InkColour::green});
  REQUIRE(bench.has("ink-field"));
  bench.type("no");
  bench.hold(ImGuiKey_Escape, true);
  bench.frames(1);
  bench.hold(ImGuiKey_Escape, false);
  bench.frames(2);
  CHECK_FALSE(bench.has("ink-field"));
  CHECK(ink_of(bench).size() == 2);
  CHECK(bench.state.ink.on);

  // What opens a dialog leaves the field, too, and drops nothing.
  click_at(at.x, at.y + 180);
  bench.type("len");
  ImGui::GetIO().AddInputCharactersUTF8("s");  // with the same frame
  bench.key("Ctrl+O");
  CHECK(bench.state.document.prompt == PathPrompt::open);
  REQUIRE(ink_of(bench).size() == 3);
  CHECK(std::get<InkText>(ink_of(bench).back().shape).text == "lens");
}

TEST_CASE("the tools of ink are whole in every language, size and theme") {
  struct Size {
    float width, height, wished;
  };
  for (const Size& each : {Size{1280, 720, 1}, {1920, 1080, 2}, {2560, 1440, 3}, {768, 1024, 1}, {414, 896, 1}})
    for (const Language language : all_languages())
      for (const Theme theme : {Theme::dark, Theme::projector}) {
        State state = in_trace();
        state.appearance.language = language;
        update(state, action::SetTheme{theme});
        Bench bench(std::move(state), each.width, each.height);
        const float wished = each.wished * static_cast<float>(theme_scale(theme));
        bench.unit = bench.dpi = wished * shrink_to_fit(each.width, each.height, wished);
        bench.key("Q");
        bench.frames(2);
        const Rect plan = bench.interface().layout().plan;
        for (const std::string& name : tools()) {
          CAPTURE(each.width, each.wished, language.code(), name);
          REQUIRE(bench.has(name));
          const Rect where = bench.rect(name);
          CHECK(where.x >= plan.x);
          CHECK(where.right() <= plan.right());
          CHECK(where.bottom() <= plan.y);
          CHECK_FALSE(bench.has(name + "/clipped"));
        }
        CHECK(plan.height > 100);
      }
}
