// Names that are typed into the properties, and what happens to what is still being typed.
#include <cmath>
#include <string>

#include "gui/folder.h"
#include "gui/properties_bench.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/text/text.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("an object is renamed when the typing has ended, not letter by letter") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const std::string before = bench.state.scene().objects[0].name;
  bench.double_click(field("property.name"));
  bench.type("Moon");
  CHECK(bench.state.scene().objects[0].name == before);
  bench.enter();
  const std::string after = bench.state.scene().objects[0].name;
  CHECK(after != before);
  CHECK_THAT(after, contains("Moon"));
  CHECK(bench.state.document.undo.size() == 1);
}

TEST_CASE("a name keeps its characters when it is edited, as long as it may be and whatever they are") {
  std::string accents = "x";
  for (int i = 0; i < 49; ++i) accents += "\u00e9";
  for (const std::string& name : {accents, std::string("Luna \U0001F319")}) {
    CAPTURE(name);
    Bench bench(selected({TargetKind::object, 0}));
    update(bench.state, action::Rename{{TargetKind::object, 0}, name});
    REQUIRE(bench.state.scene().objects[0].name == name);
    bench.frames(2);
    bench.double_click(field("property.name"));
    bench.hold(ImGuiKey_End, true);
    bench.frames(1);
    bench.hold(ImGuiKey_End, false);
    bench.type("!");
    bench.enter();
    const std::string now = bench.state.scene().objects[0].name;
    // A field that cannot hold them takes no edit.
    CHECK((now == name + "!" || (name != accents && now == name)));
    if (name == accents) CHECK(now == name + "!");
  }
}

TEST_CASE("a name that is pasted and too long is told to be so, and the old one stays") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const std::string before = bench.state.scene().objects[0].name;
  bench.double_click(field("property.name"));
  ImGui::SetClipboardText(std::string(300, 'a').c_str());
#if IMGUI_VERSION_NUM < 18700
  const auto hold_ctrl = [](bool down) { ImGui::GetIO().KeyCtrl = down; };
#else
  const auto hold_ctrl = [](bool down) { ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, down); };
#endif
  hold_ctrl(true);
  bench.frames(1);
  for (const ImGuiKey_ key : {ImGuiKey_A, ImGuiKey_V}) {  // in place of all that stands there
    bench.hold(key, true);
    bench.frames(1);
    bench.hold(key, false);
    bench.frames(1);
  }
  hold_ctrl(false);
  bench.frames(1);
  bench.enter();
  REQUIRE(bench.last<action::Rename>() != nullptr);
  CHECK(bench.last<action::Rename>()->name == std::string(300, 'a'));
  CHECK(bench.state.scene().objects[0].name == before);
  REQUIRE(bench.state.document.notice);
  CHECK_THAT(bench.state.document.notice->text, contains("300"));
}

TEST_CASE("a name with characters that the field cannot hold is not taken without them") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const std::string before = bench.state.scene().objects[0].name;
  bench.double_click(field("property.name"));
  bench.type("\U0001F319");
  bench.enter();
  const std::string now = bench.state.scene().objects[0].name;
  CHECK((now == before || now.find("\U0001F319") != std::string::npos));
  if (now == before) {
    REQUIRE(bench.state.document.notice);
    CHECK(bench.state.document.notice->text == text("notice.refused_name_letters", in_english));
  }
}

TEST_CASE("commands that no field has a use for take over what was typed, and then act") {
  Bench bench(selected({TargetKind::object, 0}));
  bench.frames(2);
  const auto name = [&] { return bench.state.scene().objects[0].name; };
  bench.double_click(field("property.name"));
  bench.type("Moo");
  bench.forget();
  // Its last letter comes with the same frame as the key.
  ImGui::GetIO().AddInputCharactersUTF8("n");
  bench.key("Ctrl+S");
  CHECK_THAT(name(), contains("Moon"));
  REQUIRE(bench.actions.size() >= 2);
  CHECK(bench.actions[0].is<action::Rename>());
  CHECK(bench.actions[1].is<action::Save>());
  CHECK(bench.state.document.prompt == PathPrompt::save_as);
  update(bench.state, action::CancelPrompt{});
  bench.frames(3);

  bench.double_click(field("property.radius"));
  bench.type("0.75");
  bench.key("Ctrl+O");
  CHECK(sphere(bench).radius == 0.75);
  CHECK(bench.state.document.prompt == PathPrompt::open);
  update(bench.state, action::CancelPrompt{});
  bench.frames(3);

  // What edits text stays the field's.
  bench.double_click(field("property.name"));
  bench.type("Mars");
  bench.forget();
  for (const char* const key : {"Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+Shift+Left", "Shift+K"}) bench.key(key);
  CHECK(bench.actions.empty());
  CHECK(ImGui::GetIO().WantTextInput);
}

TEST_CASE("a name that is being typed when the window is closed is asked about, and saved") {
  const Folder folder;
  Bench bench(selected({TargetKind::object, 0}));
  update(bench.state, action::SaveAs{folder / "mine.toml"});
  REQUIRE_FALSE(bench.state.document.dirty);
  bench.frames(2);
  bench.double_click(field("property.name"));
  bench.type("Moon");
  bench.interface().act_after_typing(action::Quit{});
  bench.frames(3);
  CHECK_FALSE(bench.state.document.quit);
  REQUIRE(bench.state.document.question);
  CHECK(bench.state.document.question->kind == Question::Kind::unsaved);
  update(bench.state, action::AnswerQuestion{action::Answer::save});
  CHECK(bench.state.document.quit);
  CHECK_THAT(read_scene(folder / "mine.toml")->scene.objects[0].name, contains("Moon"));
}

TEST_CASE("where nothing is typed the window is closed at once") {
  Bench bench;
  bench.frames(2);
  bench.interface().act_after_typing(action::Quit{});
  bench.frames(1);
  CHECK(bench.state.document.quit);
}
