// The commands for how the window looks and speaks.

#include "gui/command.h"
#include "gui/layout.h"
#include "gui/panes.h"
#include "view/lesson/lesson_panel.h"

namespace raywalk {

namespace {

constexpr double scale_step = 0.25;

std::string theme_label(const State& state, bool) {
  return fill("command.theme.label", state.appearance.language) + ": " +
         fill(state.appearance.theme == Theme::dark ? "theme.dark" : "theme.projector", state.appearance.language);
}

void change_theme(const Ui& ui) {
  ui.act(action::SetTheme{ui.state.appearance.theme == Theme::dark ? Theme::projector : Theme::dark});
}

std::string language_label(const State& state, bool in_short) {
  if (in_short) return std::string(state.appearance.language.sign());
  return fill("command.language.label", state.appearance.language) + ": " +
         std::string(state.appearance.language.name());
}

}  // namespace

bool panes_exchanged(const State& state) {
  // An upright window has less room in the plan's place than beside or below the code.
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (state.focus.shows_tab()) return true;
  return exchanged_by_hand(state) != (has_plans_place(state) && !is_upright(window.x, window.y));
}

Commands AppearanceRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tweens", .keys = {"Shift+A"}, .section = Section::style,
       .chosen = [](const State& state) { return state.walk.tweens; }, .turn = turn<action::SetTweens>},
      {.name = "theme", .keys = {"P", "D"}, .section = Section::style, .label = theme_label, .run = change_theme},
      {.name = "scale-up", .keys = {"Ctrl++"}, .section = Section::style, .line = "keys.scale",
       .enabled = [](const State& state) { return !state.appearance.is_fitted && state.appearance.ui_scale < max_ui_scale; },
       .run = [](const Ui& ui) { ui.act(action::SetUiScale{ui.state.appearance.ui_scale + scale_step}); }},
      {.name = "scale-down", .keys = {"Ctrl+-"}, .section = Section::style, .line = "keys.scale",
       .enabled = [](const State& state) { return state.appearance.ui_scale > min_ui_scale; },
       .run = [](const Ui& ui) { ui.act(action::SetUiScale{ui.state.appearance.ui_scale - scale_step}); }},
      {.name = "scale-reset", .keys = {"Ctrl+0"}, .section = Section::style, .line = "keys.scale",
       .enabled = [](const State& state) { return state.appearance.ui_scale != 1; }, .run = act<action::SetUiScale, 1>},
      {.name = "language", .keys = {"Ctrl+L"}, .section = Section::style, .label = language_label,
       .run = [](const Ui& ui) { ui.act(action::SetLanguage{std::string(ui.state.appearance.language.next().code())}); }},
      {.name = "english-code", .keys = {"Ctrl+Shift+L"}, .section = Section::style,
       .enabled = [](const State& state) { return state.appearance.language.code() != "en"; },
       .chosen = [](const State& state) { return state.appearance.english_code; }, .turn = turn<action::SetEnglishCode>},
      {.name = "exchange", .keys = {"X"}, .section = Section::window,
       .chosen = [](const State& state) { return state.focus.shows_tab() || exchanged_by_hand(state) != has_plans_place(state); },
       .run = act<action::ExchangePanes>},
      {.name = "menu", .keys = {"F10"}, .line = "keys.menus", .run = wish<WindowWish::menu>},
      {.name = "full-screen", .keys = {"F11"}, .section = Section::window, .line = "keys.menus",
       .run = wish<WindowWish::full_screen>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
