#include <GLFW/glfw3.h>

#include <map>
#include <optional>

#include "gui/bench.h"
#include "gui/commands.h"
#include "gui/key_list.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::optional<Command> in(Mode mode, KeyPress press) {
  State state = classic();
  update(state, action::SetMode{mode});
  return command_of(press, state);
}

}  // namespace

TEST_CASE("keys mean what the help says") {
  CHECK(in(Mode::trace, {GLFW_KEY_SPACE}) == Command::step);
  CHECK(in(Mode::trace, {GLFW_KEY_RIGHT}) == Command::step);
  CHECK(in(Mode::trace, {GLFW_KEY_LEFT}) == Command::step_back);
  CHECK(in(Mode::trace, {GLFW_KEY_RIGHT, false, true}) == Command::step_ray);
  CHECK(in(Mode::trace, {GLFW_KEY_LEFT, false, true}) == Command::step_ray_back);
  CHECK(in(Mode::trace, {GLFW_KEY_RIGHT, true}) == Command::step_pixel);
  CHECK(in(Mode::trace, {GLFW_KEY_LEFT, true}) == Command::step_pixel_back);
  CHECK(in(Mode::trace, {GLFW_KEY_A}) == Command::play);
  CHECK(in(Mode::trace, {GLFW_KEY_C}) == Command::clear);
  CHECK(in(Mode::trace, {GLFW_KEY_HOME}) == Command::first);
  CHECK(in(Mode::trace, {GLFW_KEY_END}) == Command::last);
  CHECK(in(Mode::trace, {GLFW_KEY_KP_ADD}) == Command::faster);
  CHECK(in(Mode::trace, {GLFW_KEY_MINUS}) == Command::slower);
  CHECK(in(Mode::trace, {GLFW_KEY_M}) == Command::mode_move);
  CHECK(in(Mode::move, {GLFW_KEY_T}) == Command::mode_trace);
  CHECK(in(Mode::move, {GLFW_KEY_F1}) == Command::mode_help);
  CHECK(in(Mode::move, {GLFW_KEY_TAB}) == Command::select_next);
  CHECK(in(Mode::move, {GLFW_KEY_DELETE}) == Command::remove);
  CHECK(in(Mode::move, {GLFW_KEY_Z, true}) == Command::undo);
  CHECK(in(Mode::move, {GLFW_KEY_Y, true}) == Command::redo);
  CHECK(in(Mode::move, {GLFW_KEY_Z, true, true}) == Command::redo);
  CHECK(in(Mode::move, {GLFW_KEY_S, true}) == Command::save);
  CHECK(in(Mode::move, {GLFW_KEY_S, true, true}) == Command::save_as);
  CHECK(in(Mode::move, {GLFW_KEY_O, true}) == Command::open);
  CHECK(in(Mode::move, {GLFW_KEY_N, true}) == Command::new_scene);
  CHECK(in(Mode::move, {GLFW_KEY_Q, true}) == Command::quit);
  CHECK(in(Mode::move, {GLFW_KEY_P}) == Command::theme);
  CHECK(in(Mode::move, {GLFW_KEY_F}) == Command::fit);
  CHECK(in(Mode::move, {GLFW_KEY_EQUAL, true}) == Command::scale_up);
  CHECK(in(Mode::move, {GLFW_KEY_MINUS, true}) == Command::scale_down);
  CHECK(in(Mode::move, {GLFW_KEY_F11}) == Command::full_screen);
  CHECK(in(Mode::move, {GLFW_KEY_1}) == Command::add_solid_sphere);
  CHECK(in(Mode::trace, {GLFW_KEY_1}) == Command::grain_line);
}

TEST_CASE("a key with other modifiers means something else or nothing") {
  CHECK(in(Mode::trace, {GLFW_KEY_A, true}) == std::nullopt);
  CHECK(in(Mode::trace, {GLFW_KEY_SPACE, false, false, true}) == std::nullopt);
  CHECK(in(Mode::move, {GLFW_KEY_S}) == std::nullopt);
  CHECK(in(Mode::trace, {GLFW_KEY_DELETE}) == std::nullopt);
}

TEST_CASE("every command is on a key, except the cross that closes a panel") {
  for (int i = 0; i < command_count; ++i) {
    const auto command = static_cast<Command>(i);
    CAPTURE(command_name(command));
    CHECK(command_key(command, in_english).empty() == (command == Command::deselect));
  }
}

TEST_CASE("Help and lessons/README.md list the keys of all commands") {
  std::string table, all_keys;
  for (const KeyListRow& row : key_list(in_english)) {
    table += "| " + row.keys + " | " + row.does + " |\n";
    all_keys += row.keys + " \u00b7 ";
  }
  for (int i = 0; i < command_count; ++i) {
    const auto command = static_cast<Command>(i);
    CAPTURE(command_name(command));
    CHECK_THAT(all_keys, contains(all_command_keys(command, in_english)));
  }
  const std::string readme = read_file(std::string(RAYWALK_SOURCE_DIR) + "/lessons/README.md", 1 << 20).value();
  INFO("lessons/README.md should have this table:\n" << table);
  CHECK(readme.find(table) != std::string::npos);
}

TEST_CASE("no key means two things in one mode") {
  for (const Mode mode : {Mode::move, Mode::trace, Mode::help}) {
    // Each command's own keys lead to it and to no other that stands before it in the table.
    std::map<std::string, Command> taken;
    State state = classic();
    update(state, action::SetMode{mode});
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key) {
      for (int modifiers = 0; modifiers < 8; ++modifiers) {
        const KeyPress press{key, (modifiers & 1) != 0, (modifiers & 2) != 0, (modifiers & 4) != 0};
        CAPTURE(key, modifiers);
        CHECK(commands_on(press, mode) <= 1);
      }
    }
  }
}

TEST_CASE("arrows nudge what is selected in Move mode, with Shift in larger steps") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::move});
  update(bench.state, action::Select{{TargetKind::object, 0}});
  bench.key(GLFW_KEY_UP);
  const auto* nudge = bench.last<action::Nudge>();
  REQUIRE(nudge != nullptr);
  CHECK(nudge->direction == Vec2d(0, 1));
  CHECK_FALSE(nudge->coarse);
  bench.key(GLFW_KEY_LEFT, false, true);
  CHECK(bench.last<action::Nudge>()->direction == Vec2d(-1, 0));
  CHECK(bench.last<action::Nudge>()->coarse);
  CHECK(bench.state.dirty);
}

TEST_CASE("Tab goes through everything that can be selected, and round again") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::move});
  const Scene& scene = bench.state.scene();
  const std::size_t count = scene.objects.size() + scene.lights.size() + 1;
  std::vector<Target> seen;
  for (std::size_t i = 0; i < count; ++i) {
    bench.key(GLFW_KEY_TAB);
    CHECK(std::find(seen.begin(), seen.end(), bench.state.selected) == seen.end());
    seen.push_back(bench.state.selected);
  }
  bench.key(GLFW_KEY_TAB);
  CHECK(bench.state.selected == seen.front());
  bench.key(GLFW_KEY_TAB, false, true);
  CHECK(bench.state.selected == seen.back());
}

TEST_CASE("Escape takes back one thing at a time") {
  Bench bench;
  update(bench.state, action::SetMode{Mode::move});
  update(bench.state, action::Select{{TargetKind::object, 0}});
  bench.state.notice = Notice{Notice::Kind::error, "something failed"};
  bench.key(GLFW_KEY_ESCAPE);
  CHECK_FALSE(bench.state.notice.has_value());
  CHECK(bench.state.selected);
  bench.key(GLFW_KEY_ESCAPE);
  CHECK_FALSE(bench.state.selected);
  for (const Mode mode : {Mode::move, Mode::trace}) {
    update(bench.state, action::SetMode{mode});
    update(bench.state, action::SetMode{Mode::help});
    bench.key(GLFW_KEY_ESCAPE);
    CHECK(bench.state.mode == mode);
  }
}

TEST_CASE("a question is answered by keys, and no other key does anything meanwhile") {
  Bench bench;
  update(bench.state, action::AddObject{action::ObjectKind::polygon});
  bench.key(GLFW_KEY_Q, true);
  REQUIRE(bench.state.question.has_value());
  const int position = bench.state.position;
  bench.key(GLFW_KEY_SPACE);
  CHECK(bench.state.position == position);
  bench.key(GLFW_KEY_ESCAPE);
  CHECK_FALSE(bench.state.question.has_value());
  CHECK_FALSE(bench.state.quit);
  bench.key(GLFW_KEY_Q, true);
  bench.key(GLFW_KEY_2);
  CHECK(bench.state.quit);
}

TEST_CASE("keys scroll the help text") {
  Bench bench;
  bench.key(GLFW_KEY_F1);
  REQUIRE(bench.state.mode == Mode::help);
  bench.forget();
  for (const int key : {GLFW_KEY_PAGE_DOWN, GLFW_KEY_END, GLFW_KEY_HOME}) {
    bench.key(key);
    CHECK(bench.state.mode == Mode::help);
    CHECK(bench.actions.empty());
  }
  bench.key(GLFW_KEY_ESCAPE);
  CHECK(bench.state.mode == Mode::move);
}
