#include "gui/command.h"
#include "gui/dialogs.h"
#include "gui/panes.h"
#include "view/text/text.h"

#include <algorithm>
#include <map>

namespace raywalk {

namespace {

/// The names that are signs or words of a language; the others are written as they are.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> shown_as{{{"Space", "keys.name_space"},
                                                                                  {"Enter", "keys.name_enter"},
                                                                                  {"Delete", "keys.name_delete"},
                                                                                  {"Backspace", "keys.name_backspace"},
                                                                                  {"Page Up", "keys.name_page_up"},
                                                                                  {"Page Down", "keys.name_page_down"},
                                                                                  {"Home", "keys.name_home"},
                                                                                  {"End", "keys.name_end"},
                                                                                  {"Left", "\u2190"},
                                                                                  {"Right", "\u2192"},
                                                                                  {"Up", "\u2191"},
                                                                                  {"Down", "\u2193"},
                                                                                  {"-", "\u2212"}}};

std::string shown(const KeyPress& press, Language language) {
  if (press.key.empty()) return {};
  const auto other =
      std::find_if(shown_as.begin(), shown_as.end(), [&](const auto& each) { return each.first == press.key; });
  return (press.ctrl ? "Ctrl+" : "") + std::string(press.alt ? "Alt+" : "") +
         (press.shift ? fill("keys.name_shift", language) + "+" : "") +
         std::string(other == shown_as.end() ? press.key : text(other->second, language));
}

bool applies(When when, Mode mode) {
  switch (when) {
    case When::always:
      return true;
    case When::move:
      return mode == Mode::move;
    case When::not_move:
      return mode != Mode::move;
    case When::trace:
      return mode == Mode::trace;
  }
  return false;
}

bool is_bound(const Command& command, const KeyPress& press, Mode mode) {
  return std::any_of(std::begin(command.keys), std::end(command.keys),
                     [&](const Shortcut& key) { return key.press.is(press) && applies(key.when, mode); });
}

// The direction of an arrow key, x right and y up; nothing for other keys.
std::optional<Vec2d> arrow(std::string_view key) {
  if (key == "Left") return Vec2d{-1, 0};
  if (key == "Right") return Vec2d{1, 0};
  if (key == "Up") return Vec2d{0, 1};
  if (key == "Down") return Vec2d{0, -1};
  return std::nullopt;
}

// Scrolling of the help text by keys.
std::optional<WindowWish> scrolling(std::string_view key) {
  if (key == "Up") return WindowWish::line_up;
  if (key == "Down") return WindowWish::line_down;
  if (key == "Page Up") return WindowWish::page_up;
  if (key == "Page Down") return WindowWish::page_down;
  if (key == "Home") return WindowWish::top;
  if (key == "End") return WindowWish::bottom;
  return std::nullopt;
}

// "Theme: dark, or light and large for a projector"
std::string own_line(const Command& command, Language language) {
  return std::string(family_text("command", std::string(command.name) + ".label", language)) + ": " +
         command_hint(command, language);
}

// Takes back one thing at a time, the most transient first.
bool escape(const Ui& ui) {
  const State& state = ui.state;
  if (state.plan.drag) {
    ui.act(action::CancelDrag{});
  } else if (state.document.notice) {
    ui.act(action::DismissNotice{});
  } else if (inks(state)) {
    ui.act(action::LeaveInk{});
  } else if (state.walk.playing) {
    ui.act(action::PlayPause{});
  } else if (state.walk.mode == Mode::help) {
    ui.act(action::SetMode{state.walk.before_help});
  } else if (state.plan.selected) {
    ui.act(action::Select{});
  } else if (state.walk.pixel) {
    ui.act(action::WalkStrip{});
  } else if (state.bugs.hunt) {
    ui.act(action::LeaveHunt{});
  } else if (state.bugs.shown) {
    ui.act(action::ShowBugs{false});
  } else if (state.lessons.shown) {
    ui.act(action::ShowLessons{false});
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::string command_key(const Command& command, Language language) { return shown(command.keys[0].press, language); }

std::string all_command_keys(const Command& command, Language language) {
  std::string all;
  for (const Shortcut& key : command.keys)
    if (!key.press.key.empty()) all += (all.empty() ? "" : ", ") + shown(key.press, language);
  return all;
}

std::vector<KeyListRow> key_list(Language language) {
  const auto say = [&](std::string_view id) { return std::string(text(id, language)); };
  std::vector<KeyListRow> list;
  std::map<std::string_view, std::size_t> shared;  // lines by id
  for (const Command* each : commands()) {
    const std::string keys = all_command_keys(*each, language);
    if (keys.empty()) continue;
    if (each->line.empty()) {
      list.push_back({keys, own_line(*each, language)});
    } else if (const auto [at, is_new] = shared.emplace(each->line, list.size()); is_new) {
      list.push_back({keys, say(each->line)});
    } else {
      list[at->second].keys += " \u00b7 " + keys;
    }
  }
  list.push_back({"\u2190, \u2192, \u2191, \u2193", say("keys.arrows")});
  list.push_back({"\u2191, \u2193", say("keys.up_down")});
  list.push_back({say("keys.name_while_dragging"), say("keys.while_dragging")});
  list.push_back({say("keys.name_wheel"), say("keys.wheel")});
  list.push_back({say("keys.name_mouse"), say("keys.mouse")});
  list.push_back({"Esc", say("keys.escape")});
  return list;
}

const Command* command_of(const KeyPress& press, Mode mode) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command* each) { return is_bound(*each, press, mode); });
  return found == commands().end() ? nullptr : *found;
}

int commands_on(const KeyPress& press, Mode mode) {
  return static_cast<int>(std::count_if(commands().begin(), commands().end(),
                                        [&](const Command* each) { return is_bound(*each, press, mode); }));
}

bool press_key(const KeyPress& press, const Ui& ui) {
  const State& state = ui.state;
  if (state.document.question) return answer_by_key(press, ui);
  if (state.document.prompt != PathPrompt::none) {
    // Enter takes the first card of the gallery, a new scene, unless it belongs to a field or to the card chosen by
    // arrows.
    const ImGuiIO& io = ImGui::GetIO();
    const bool begins =
        state.document.prompt == PathPrompt::start && press.key == "Enter" && !io.WantTextInput && !io.NavVisible;
    if (press.key != "Escape" && !begins) return false;
    ui.act(begins ? Action(action::New{}) : Action(action::CancelPrompt{}));
    return true;
  }
  if (link_by_key(press, ui)) return true;
  if (press.key == "Escape") return escape(ui);
  if (const auto direction = arrow(press.key);
      direction && state.walk.mode == Mode::move && !chooses_from_list(state) && !press.ctrl && !press.alt) {
    ui.act(action::Nudge{*direction, press.shift, press.repeated});
    return true;
  }
  if (const auto way = scrolling(press.key); way && state.walk.mode == Mode::help) {
    ui.wish(*way);
    return true;
  }
  if (lesson_by_key(press, ui) || bug_by_key(press, ui) || guess_by_key(press, ui)) return true;
  const Command* const command = command_of(press, state.walk.mode);
  if (command == nullptr) return false;
  if (press.repeated && command->held != nullptr) {
    command->held(ui);
  } else {
    perform(*command, ui);
  }
  return true;
}

}  // namespace raywalk
