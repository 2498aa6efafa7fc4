#include "gui/command_table.h"
#include "view/lesson_panel.h"
#include "view/panels.h"
#include "view/text.h"

#include <algorithm>

namespace raywalk {

namespace {

std::string key_name(int key, Language language) {
  if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9))
    return {static_cast<char>(key)};
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  switch (key) {
    case GLFW_KEY_SPACE:
      return fill("keys.name_space", language);
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return fill("keys.name_enter", language);
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_DELETE:
      return fill("keys.name_delete", language);
    case GLFW_KEY_BACKSPACE:
      return fill("keys.name_backspace", language);
    case GLFW_KEY_COMMA:
      return ",";
    case GLFW_KEY_PAGE_UP:
      return fill("keys.name_page_up", language);
    case GLFW_KEY_PAGE_DOWN:
      return fill("keys.name_page_down", language);
    case GLFW_KEY_HOME:
      return fill("keys.name_home", language);
    case GLFW_KEY_END:
      return fill("keys.name_end", language);
    case GLFW_KEY_LEFT:
      return "\u2190";
    case GLFW_KEY_RIGHT:
      return "\u2192";
    case GLFW_KEY_UP:
      return "\u2191";
    case GLFW_KEY_DOWN:
      return "\u2193";
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      return "\u2212";
    case GLFW_KEY_KP_ADD:
    case GLFW_KEY_EQUAL:  // the key of the plus on many keyboards
      return "+";
    case GLFW_KEY_KP_0:
      return "0";
    default:
      return fill("keys.name_other", language, {{"number", key}});
  }
}

bool means(const Key& key, const KeyPress& press, Mode mode) {
  if (key.key == 0 || key.key != press.key) return false;
  if (key.ctrl != press.ctrl || key.shift != press.shift || key.alt != press.alt) return false;
  switch (key.when) {
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

// The direction of an arrow key, x right and y up; nothing for other keys.
std::optional<Vec2d> arrow(int key) {
  if (key == GLFW_KEY_LEFT) return Vec2d{-1, 0};
  if (key == GLFW_KEY_RIGHT) return Vec2d{1, 0};
  if (key == GLFW_KEY_UP) return Vec2d{0, 1};
  if (key == GLFW_KEY_DOWN) return Vec2d{0, -1};
  return std::nullopt;
}

// Scrolling of the help text by keys.
std::optional<WindowWish> scrolling(int key) {
  if (key == GLFW_KEY_UP) return WindowWish::line_up;
  if (key == GLFW_KEY_DOWN) return WindowWish::line_down;
  if (key == GLFW_KEY_PAGE_UP) return WindowWish::page_up;
  if (key == GLFW_KEY_PAGE_DOWN) return WindowWish::page_down;
  if (key == GLFW_KEY_HOME) return WindowWish::top;
  if (key == GLFW_KEY_END) return WindowWish::bottom;
  return std::nullopt;
}

// Enter gives the first answer, which is safe; Escape cancels if possible; a digit picks.
bool answer_by_key(const KeyPress& press, const Ui& ui) {
  const QuestionPanel question = question_panel(ui.state);
  const auto answer = [&](std::size_t i) {
    if (i >= question.choices.size()) return false;
    ui.act(action::AnswerQuestion{question.choices[i].answer});
    return true;
  };
  if (press.key == GLFW_KEY_ENTER || press.key == GLFW_KEY_KP_ENTER) return answer(0);
  if (press.key >= GLFW_KEY_1 && press.key <= GLFW_KEY_9)
    return answer(static_cast<std::size_t>(press.key - GLFW_KEY_1));
  if (press.key != GLFW_KEY_ESCAPE) return false;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    if (question.choices[i].answer == action::Answer::cancel) return answer(i);
  }
  return false;
}

}  // namespace

namespace {

std::string whole_name(const Key& key, Language language) {
  if (key.key == 0) return {};
  const bool plus_by_shift = key.key == GLFW_KEY_EQUAL;
  return std::string(key.ctrl ? "Ctrl+" : "") + (key.alt ? "Alt+" : "") +
         (key.shift && !plus_by_shift ? fill("keys.name_shift", language) + "+" : "") + key_name(key.key, language);
}

}  // namespace

std::string command_key(Command command, Language language) {
  return whole_name(command_table[static_cast<std::size_t>(command)].keys[0], language);
}

std::string all_command_keys(Command command, Language language) {
  std::vector<std::string> names;
  for (const Key& key : command_table[static_cast<std::size_t>(command)].keys) {
    const std::string name = whole_name(key, language);
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

namespace {

bool asks_for(const CommandRow& row, const KeyPress& press, Mode mode) {
  return std::any_of(row.keys.begin(), row.keys.end(), [&](const Key& key) { return means(key, press, mode); });
}

}  // namespace

std::optional<Command> command_of(const KeyPress& press, const State& state) {
  for (const CommandRow& row : command_table) {
    if (asks_for(row, press, state.mode)) return row.command;
  }
  return std::nullopt;
}

int commands_on(const KeyPress& press, Mode mode) {
  return static_cast<int>(std::count_if(command_table.begin(), command_table.end(),
                                        [&](const CommandRow& row) { return asks_for(row, press, mode); }));
}

// In a lesson's question, digits are for choices (with a presenter, for hands of the class), and Enter for the answer
// and the next step.
bool lesson_by_key(const KeyPress& press, const Ui& ui) {
  const State& state = ui.state;
  if (!state.lessons.shown || state.mode != Mode::trace || press.ctrl || press.alt) return false;
  const LessonPanel panel = lesson_panel(state);
  const int digit = press.key - GLFW_KEY_1;
  const bool picks = panel.asks == Asks::choice && !state.lessons.revealed && digit >= 0 &&
                     digit < static_cast<int>(panel.choices.size());
  if (picks && state.lessons.presenter) {
    ui.act(action::ShowHands{digit, press.shift ? -1 : 1});
    return true;
  }
  if (press.shift) return false;
  if (picks) {
    ui.act(action::GuessChoice{digit});
    return true;
  }
  if (panel.asks == Asks::choice && !state.lessons.revealed && !panel.astray &&
      (press.key == GLFW_KEY_UP || press.key == GLFW_KEY_DOWN)) {
    const int last = static_cast<int>(panel.choices.size()) - 1, by = press.key == GLFW_KEY_UP ? -1 : 1;
    const std::optional<int>& now = state.lessons.guess.choice;
    ui.act(action::GuessChoice{now ? std::clamp(*now + by, 0, last) : by > 0 ? 0 : last});
    return true;
  }
  if (press.key != GLFW_KEY_ENTER && press.key != GLFW_KEY_KP_ENTER) return false;
  if (panel.can_reveal) {
    ui.act(action::RevealLesson{});
  } else if (panel.can_go_on) {
    ui.act(action::GoToLessonStep{panel.step});
  } else {
    return false;
  }
  return true;
}

bool press_key(const KeyPress& press, const Ui& ui) {
  const State& state = ui.state;
  if (state.question) return answer_by_key(press, ui);
  if (state.prompt != PathPrompt::none) {
    if (press.key == GLFW_KEY_ESCAPE) ui.act(action::CancelPrompt{});
    return press.key == GLFW_KEY_ESCAPE;
  }
  if (press.key == GLFW_KEY_ESCAPE) {
    // One thing at a time, the most transient first.
    if (state.drag) {
      ui.act(action::CancelDrag{});
    } else if (state.notice) {
      ui.act(action::DismissNotice{});
    } else if (state.playing) {
      ui.act(action::PlayPause{});
    } else if (state.mode == Mode::help) {
      ui.act(action::SetMode{state.before_help});
    } else if (state.selected) {
      ui.act(action::Select{});
    } else if (state.walk) {
      ui.act(action::WalkStrip{});
    } else if (state.bugs.hunt) {
      ui.act(action::LeaveHunt{});
    } else if (state.bugs.shown) {
      ui.act(action::ShowBugs{false});
    } else {
      return false;
    }
    return true;
  }
  if (const auto direction = arrow(press.key); direction && state.mode == Mode::move && !press.ctrl && !press.alt) {
    ui.act(action::Nudge{*direction, press.shift});
    return true;
  }
  if (const auto way = scrolling(press.key); way && state.mode == Mode::help) {
    ui.wish(*way);
    return true;
  }
  if (lesson_by_key(press, ui)) return true;
  const auto command = command_of(press, state);
  // A held key steps faster and faster.
  if (press.repeated && (command == Command::step || command == Command::step_back)) {
    ui.act(action::Hold{command == Command::step});
    return true;
  }
  if (command) perform(*command, ui);
  return command.has_value();
}

}  // namespace raywalk
