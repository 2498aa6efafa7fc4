#include <algorithm>
#include <filesystem>

#include "gui/bench.h"
#include "gui/command.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// The name of the command of this key, empty if it has none.
std::string_view in(Mode mode, std::string_view key) {
  const Command* const found = command_of(key_press(key), mode);
  return found == nullptr ? std::string_view() : found->name;
}

}  // namespace

TEST_CASE("keys mean what the help says") {
  CHECK(in(Mode::trace, "Space") == "step");
  CHECK(in(Mode::trace, "Right") == "step");
  CHECK(in(Mode::trace, "Left") == "step-back");
  CHECK(in(Mode::trace, "Shift+Right") == "step-ray");
  CHECK(in(Mode::trace, "Shift+Left") == "step-ray-back");
  CHECK(in(Mode::trace, "Ctrl+Right") == "step-pixel");
  CHECK(in(Mode::trace, "Ctrl+Left") == "step-pixel-back");
  CHECK(in(Mode::trace, "A") == "play");
  CHECK(in(Mode::trace, "C") == "clear");
  CHECK(in(Mode::trace, "Home") == "first");
  CHECK(in(Mode::trace, "End") == "last");
  CHECK(in(Mode::trace, "+") == "faster");
  CHECK(in(Mode::trace, "-") == "slower");
  CHECK(in(Mode::trace, "M") == "mode-move");
  CHECK(in(Mode::move, "T") == "mode-trace");
  CHECK(in(Mode::move, "F1") == "mode-help");
  CHECK(in(Mode::move, "Tab") == "select-next");
  CHECK(in(Mode::move, "Delete") == "remove");
  CHECK(in(Mode::move, "Ctrl+Z") == "undo");
  CHECK(in(Mode::move, "Ctrl+Y") == "redo");
  CHECK(in(Mode::move, "Ctrl+Shift+Z") == "redo");
  CHECK(in(Mode::move, "Ctrl+S") == "save");
  CHECK(in(Mode::move, "Ctrl+Shift+S") == "save-as");
  CHECK(in(Mode::move, "Ctrl+O") == "open");
  CHECK(in(Mode::move, "Ctrl+N") == "new");
  CHECK(in(Mode::move, "Ctrl+Q") == "quit");
  CHECK(in(Mode::move, "P") == "theme");
  CHECK(in(Mode::move, "F") == "fit");
  CHECK(in(Mode::move, "Ctrl++") == "scale-up");
  CHECK(in(Mode::move, "Ctrl+-") == "scale-down");
  CHECK(in(Mode::move, "F11") == "full-screen");
  CHECK(in(Mode::move, "Shift+1") == "add-solid-sphere");
  CHECK(in(Mode::move, "1").empty());
  CHECK(in(Mode::trace, "1") == "grain-line");
}

TEST_CASE("a key with other modifiers means something else or nothing") {
  CHECK(in(Mode::trace, "Ctrl+A").empty());
  CHECK(in(Mode::trace, "Alt+Space").empty());
  CHECK(in(Mode::move, "S").empty());
  CHECK(in(Mode::trace, "Delete").empty());
}

TEST_CASE("every command is on a key, except the cross that closes a panel") {
  for (const Command* each : commands()) {
    CAPTURE(each->name);
    CHECK(command_key(*each, in_english).empty() == (each->name == "deselect"));
  }
}

TEST_CASE("every command that the sources name is there, and every command does something") {
  std::size_t named = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RAYWALK_SOURCE_DIR) + "/src/gui")) {
    if (!entry.is_regular_file()) continue;
    const std::string code = read_file(entry.path().string(), 1 << 20).value(), call = "command(\"";
    for (std::size_t at = code.find(call); at != std::string::npos; at = code.find(call, at + 1)) {
      const std::size_t begin = at + call.size();
      const std::string name = code.substr(begin, code.find('"', begin) - begin);
      CAPTURE(entry.path(), name);
      CHECK(std::any_of(commands().begin(), commands().end(), [&](const Command* each) { return each->name == name; }));
      ++named;
    }
  }
  CHECK(named > 30);
  for (const Command* each : commands()) {
    CAPTURE(each->name);
    CHECK((each->run != nullptr) != (each->turn != nullptr));
    CHECK(&command(each->name) == each);
  }
}

TEST_CASE("Help and lessons/README.md list the keys of all commands") {
  std::string table, all_keys;
  for (const KeyListRow& row : key_list(in_english)) {
    table += "| " + row.keys + " | " + row.does + " |\n";
    all_keys += row.keys + " \u00b7 ";
  }
  for (const Command* each : commands()) {
    CAPTURE(each->name);
    CHECK_THAT(all_keys, contains(all_command_keys(*each, in_english)));
  }
  const std::string readme = read_file(std::string(RAYWALK_SOURCE_DIR) + "/lessons/README.md", 1 << 20).value();
  INFO("lessons/README.md should have this table:\n" << table);
  CHECK(readme.find(table) != std::string::npos);
}

TEST_CASE("no key means two things in one mode") {
  for (const Mode mode : {Mode::move, Mode::trace, Mode::help}) {
    for (const Command* each : commands()) {
      for (const Shortcut& key : each->keys) {
        if (key.press.key.empty()) continue;
        CAPTURE(each->name, key.press.key);
        CHECK(commands_on(key.press, mode) <= 1);
      }
    }
  }
}

TEST_CASE("arrows nudge what is selected in Move mode, with Shift in larger steps") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::move});
  update(bench.state, action::Select{{TargetKind::object, 0}});
  bench.key("Up");
  const auto* nudge = bench.last<action::Nudge>();
  REQUIRE(nudge != nullptr);
  CHECK(nudge->direction == Vec2d(0, 1));
  CHECK_FALSE(nudge->coarse);
  bench.key("Shift+Left");
  CHECK(bench.last<action::Nudge>()->direction == Vec2d(-1, 0));
  CHECK(bench.last<action::Nudge>()->coarse);
  CHECK(bench.state.document.dirty);
  bench.repeat("Shift+Left");
  CHECK(bench.last<action::Nudge>()->continues);
  CHECK(bench.state.document.undo.size() == 2);
}

TEST_CASE("Tab goes through everything that can be selected, and round again") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::move});
  const Scene& scene = bench.state.scene();
  const std::size_t count = scene.objects.size() + scene.lights.size() + 1;
  std::vector<Target> seen;
  for (std::size_t i = 0; i < count; ++i) {
    bench.key("Tab");
    CHECK(std::find(seen.begin(), seen.end(), bench.state.plan.selected) == seen.end());
    seen.push_back(bench.state.plan.selected);
  }
  bench.key("Tab");
  CHECK(bench.state.plan.selected == seen.front());
  bench.key("Shift+Tab");
  CHECK(bench.state.plan.selected == seen.back());
}

TEST_CASE("no letter, digit or sign alone changes the scene") {
  for (const Mode mode : {Mode::move, Mode::trace}) {
    for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789,+-")) {
      Bench bench;
      update(bench.state, action::SetMode{mode});
      update(bench.state, action::Select{{TargetKind::object, 0}});
      update(bench.state, action::Orbit{SpaceView::image, {0.3, 0.1}});  // a camera that could be taken
      const Scene before = bench.state.scene();
      CAPTURE(static_cast<int>(mode), c);
      bench.key(std::string(1, c));
      CHECK(bench.state.scene() == before);
      CHECK(bench.state.document.undo.empty());
    }
  }
}

TEST_CASE("Escape takes back one thing at a time") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::move});
  update(bench.state, action::Select{{TargetKind::object, 0}});
  bench.state.document.notice = Notice{Notice::Kind::error, "something failed"};
  bench.key("Escape");
  CHECK_FALSE(bench.state.document.notice.has_value());
  CHECK(bench.state.plan.selected);
  bench.key("Escape");
  CHECK_FALSE(bench.state.plan.selected);
  for (const Mode mode : {Mode::move, Mode::trace}) {
    update(bench.state, action::SetMode{mode});
    update(bench.state, action::SetMode{Mode::help});
    bench.key("Escape");
    CHECK(bench.state.walk.mode == mode);
  }
}

TEST_CASE("a question is answered by keys, and no other key does anything meanwhile") {
  Bench bench;
  update(bench.state, action::AddObject{action::ObjectKind::polygon});
  bench.key("Ctrl+Q");
  REQUIRE(bench.state.document.question.has_value());
  const int position = bench.state.walk.position;
  bench.key("Space");
  CHECK(bench.state.walk.position == position);
  bench.key("Escape");
  CHECK_FALSE(bench.state.document.question.has_value());
  CHECK_FALSE(bench.state.document.quit);
  bench.key("Ctrl+Q");
  bench.key("2");
  CHECK(bench.state.document.quit);
}

TEST_CASE("keys scroll the help text") {
  Bench bench;
  bench.key("F1");
  REQUIRE(bench.state.walk.mode == Mode::help);
  bench.forget();
  for (const std::string key : {"Page Down", "End", "Home"}) {
    bench.key(key);
    CHECK(bench.state.walk.mode == Mode::help);
    CHECK(bench.actions.empty());
  }
  bench.key("Escape");
  CHECK(bench.state.walk.mode == Mode::move);
}
