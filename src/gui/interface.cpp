#include "gui/interface.h"

#include "gui/command.h"
#include "gui/dialogs.h"
#include "gui/style.h"
#include "gui/widgets.h"
#include "view/band/band.h"
#include "view/document/properties.h"
#include "view/lesson/lesson_panel.h"
#include "view/walk/asked.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

namespace raywalk {

Ui Interface::ui(const State& state, const Fonts& fonts, float unit, float dpi) {
  return {.state = state,
          .fonts = fonts,
          .colours = palette(state.appearance.theme),
          .unit = unit,
          .dpi = dpi,
          .actions = actions_,
          .wishes = wishes_,
          .items = items_,
          .rest = rest_};
}

void Interface::grant(const Ui& ui) {
  constexpr float beyond = 1e6f;  // beyond either end of the help text
  // What is asked for lies in a pane that the plan has folded away.
  const auto unfold = [&] {
    if (ui.state.focus.on) ui.act(action::SetFocus{false});
  };
  for (const WindowWish wish : std::exchange(wishes_, {})) {
    switch (wish) {
      case WindowWish::full_screen:
        full_screen_ = true;
        break;
      case WindowWish::menu:
        wanted_menu_ = (shown_menu_ + 1) % menu_count;
        break;
      case WindowWish::image_settings:
        unfold();
        ui.act(action::SetTab{PictureRoom::tab});
        open_settings_ = true;
        break;
      case WindowWish::cost_knobs:
        unfold();
        ui.act(action::SetTab{CostRoom::tab});
        open_knobs_ = true;
        break;
      case WindowWish::breakpoints:
        open_breakpoints_ = true;
        break;
      case WindowWish::lesson_number:
        lesson_.ask_for_number(false);
        break;
      case WindowWish::missing_lesson_number:
        lesson_.ask_for_number(true);
        break;
      case WindowWish::properties:
        unfold();
        focus_properties_ = true;
        break;
      case WindowWish::line_up:
        scroll_help_ -= ui.px(40);
        break;
      case WindowWish::line_down:
        scroll_help_ += ui.px(40);
        break;
      case WindowWish::page_up:
        scroll_help_ -= layout_.plan.height * 0.8f;
        break;
      case WindowWish::page_down:
        scroll_help_ += layout_.plan.height * 0.8f;
        break;
      case WindowWish::top:
        scroll_help_ -= beyond;
        break;
      case WindowWish::bottom:
        scroll_help_ += beyond;
        break;
    }
  }
}

void Interface::after_typing(std::function<void(const Ui& ui)> what) {
  constexpr int once_typed = 2;  // frames: the next may bring letters that were typed before this was asked for
  if (after_typing_.empty()) left_in_ = once_typed;
  after_typing_.push_back(std::move(what));
}

void Interface::act_after_typing(const Action& action) {
  if (ImGui::GetIO().WantTextInput) return after_typing([action](const Ui& ui) { ui.act(action); });
  actions_.push_back(action);
}

namespace {

/// Whether ImGui's fields have no use for the key, which types nothing either.
bool is_for_no_field(const KeyPress& key) {
  constexpr std::string_view edits = "ACVXYZ";  // select all, copy, paste, cut, redo and undo, also with Shift
  if (!key.ctrl || key.alt) return false;
  return key.key.size() == 1 ? edits.find(key.key) == std::string_view::npos : key.key.starts_with('F');
}

}  // namespace

void Interface::press(const State& state, const Fonts& fonts, float unit, float dpi, const KeyPress& key) {
  rest_.hush();
  const bool asks = state.document.question || state.document.prompt != PathPrompt::none || state.link.shown;
  const bool menu_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  const Ui with = ui(state, fonts, unit, dpi);
  if (menu_open && shown_menu_ >= 0 && command_of(key, state.walk.mode) == &command("menu")) {
    perform(command("menu"), with);
    return grant(with);
  }
  if (shown_menu_ >= 0 && !key.ctrl && !key.alt && (key.key == "Left" || key.key == "Right")) {
    constexpr int until_closed = 3;  // frames
    aside_ = {(shown_menu_ + (key.key == "Left" ? menu_count - 1 : 1)) % menu_count, until_closed};
  }
#if IMGUI_VERSION_NUM < 18700
  // This ImGui accepts only Space to press the item chosen with the arrows.
  if (shown_menu_ >= 0 && key.key == "Enter") ImGui::GetIO().NavInputs[ImGuiNavInput_Activate] = 1;
#endif
  // In a lesson's field for a number, capitals are commands.
  const bool is_capital = key.key.size() == 1 && key.key[0] >= 'A' && key.key[0] <= 'Z' && key.shift && !key.ctrl;
  const bool types = ImGui::GetIO().WantTextInput && !(lesson_.types() && is_capital);
  if (!asks && (menu_open || (types && !is_for_no_field(key)))) return;
  if (!asks && types) {
    const Command* const command = command_of(key, state.walk.mode);
    if (command != nullptr) after_typing([command](const Ui& ui) { perform(*command, ui); });
    return;
  }
  press_key(key, with);
  grant(with);
}

void Interface::run(const State& state, const Fonts& fonts, float unit, float dpi, const Command& command) {
  const Ui with = ui(state, fonts, unit, dpi);
  perform(command, with);
  grant(with);
}

void Interface::draw(const State& state, const Fonts& fonts, float unit, float dpi, const PictureView& picture) {
  items_.clear();
  Ui with = ui(state, fonts, unit, dpi);
  const bool leaves = left_in_ > 0 && --left_in_ == 0;
  if (leaves && text_begun(state) != nullptr) {
    with.act(action::FinishInk{});          // a field that is merely left drops its text
  } else if (leaves && !lesson_.types()) {  // where a guess is taken over letter by letter
    ImGui::ClearActiveID();
  }
  ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) rest_.pointer_moved();
  // Arrows and Enter work inside menus and dialogs; outside they are commands.
  const bool popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (popup || wanted_menu_ >= 0) {
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  } else {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  }

  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushFont(fonts.text);
  // The background is visible only between the panes, as hairlines.
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_imgui4(Shades(state.appearance.theme).line));
  ImGui::Begin("raywalk", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(4);

  const bool embedded = state.appearance.embedded;
  LayoutWishes wishes{.width = io.DisplaySize.x,
                      .height = io.DisplaySize.y,
                      .unit = unit,
                      .bare = embedded,
                      .touch = state.appearance.touch};
  wishes.code = code_height(with);
  wishes.code_part = static_cast<float>(state.appearance.code_part);
  wishes.code_width = code_width(with);
  with.finger = finger_of(wishes);
  wishes.bar_width = bar_width(with);
  const bool helps = state.walk.mode == Mode::help;
  // A line that a lesson asks for is clicked in the code, and marked there with the answer.
  const bool needs_code = !state.bugs.hunt && asks_about_code(state);
  wishes.focus = state.focus.on && !helps && !embedded && !needs_code;
  const bool asks = state.bugs.shown || has_question(state);
  if ((state.lessons.shown || state.bugs.shown) && !helps)
    wishes.lesson = with.px(wishes.focus && !asks ? folded_width : 330);
  wishes.front = state.appearance.front;
  if (wishes.front == Front::lesson && wishes.lesson == 0) wishes.front = Front::code;
  if (embedded && wishes.front == Front::tabs) wishes.front = Front::code;
  wishes.effects_row = effects_row_height(with);
  if (state.effects.shown && !helps && !embedded) wishes.effects = effects_height(with, lay_out(wishes).plan.width);
  if (state.band.shown && !helps && !embedded) wishes.band = with.px(static_cast<float>(band_height));
  // Heights that depend on a width, which does not depend on them. The strip is as high in Move, too: the plan stays.
  wishes.transport = transport_height(with, lay_out(wishes).plan.width);
  if (!helps) wishes.strip = legend_height(with, lay_out(wishes).strip.width);
  if (const Layout before = lay_out(wishes); !embedded && (before.fronts.empty() || wishes.front == Front::tabs))
    wishes.choice = tab_choice_height(with, (before.tabs.empty() ? before.plan : before.tabs).width);
  wishes.help = helps;
  wishes.exchanged = panes_exchanged(state);
  wishes.enlarged = lesson_enlarges(state);
  wishes.large_tab = state.appearance.tab.large;
  layout_ = lay_out(wishes);
  const bool folds = wishes.focus;

  if (folds && !asks && state.lessons.shown)
    folded_pane(with, "folded-lesson", layout_.lesson);
  else if (!layout_.lesson.empty() && state.lessons.shown)
    lesson_.draw(with, layout_.lesson);
  if (!layout_.lesson.empty() && state.bugs.shown) bug_pane(with, layout_.lesson);
  if (has_banner(state)) {
    Rect banner = layout_.plan;
    banner.height = std::min(banner_height(with), layout_.plan.height);
    layout_.plan.y += banner.height;
    layout_.plan.height -= banner.height;
    banner_pane(with, banner);
  }
  if (inks(state)) {
    Rect tools = layout_.plan;
    // Where there is little room they scroll.
    const float most = std::max(0.4f * layout_.plan.height, layout_.plan.height - with.px(70));
    tools.height = std::min(ink_height(with, tools.width), most);
    layout_.plan.y += tools.height;
    layout_.plan.height -= tools.height;
    ink_pane(with, tools);
  }
  const int menu = std::exchange(wanted_menu_, -1);
  shown_menu_ = embedded ? -1 : bar_pane(with, layout_.bar, menu);
  if (aside_.frames > 0 && shown_menu_ < 0) wanted_menu_ = std::exchange(aside_, {}).neighbour;
  if (aside_.frames > 0) --aside_.frames;
  if (helps) {
    help_pane(with, layout_.help, std::exchange(scroll_help_, 0.0f));
  } else {
    const bool keeps_tab = folds && !layout_.tabs.empty();
    if (!layout_.plan.empty()) {
      if (shows_lines(state)) {
        lines_pane(with, layout_.plan);
      } else {
        plan_pane(with, layout_.plan);
      }
    }
    if (!layout_.plan.empty() || keeps_tab) {
      // One strip for both modes, so that the plan does not move.
      if (!embedded && state.walk.mode == Mode::move) palette_pane(with, layout_.strip);
      if (!embedded && state.walk.mode == Mode::trace) legend_pane(with, layout_.strip);
      if (!embedded) focus_button(with, layout_.corner);
    }
    if (wishes.band > 0) band_pane(with, layout_.band);
    if (wishes.effects > 0) effects_pane(with, layout_.effects);
  }
  transport_pane(with, layout_.transport);
  fronts_pane(with, layout_.fronts, wishes.front, wishes.lesson > 0);
  if (folds) {
    folded_pane(with, "folded", layout_.folded);
  } else if (shows_properties(state)) {
    properties_.draw(with, layout_.side, std::exchange(focus_properties_, false));
  } else {
    code_pane(with, layout_.side);
  }
  tab_choice(with, layout_.choice);
  if (!embedded && (!folds || !layout_.tabs.empty()))
    tabs_.draw(with, layout_.tabs, layout_.choice, picture, std::exchange(open_settings_, false),
               std::exchange(open_knobs_, false));
  divider_pane(with, layout_);
  breakpoints_.draw(with, layout_.side, std::exchange(open_breakpoints_, false));
  ImGui::End();

  ink_field_.draw(with, layout_.plan);
  // What lies below a dialog is not hovered over, though the pointer still rests there in the dialog's first frame.
  if (state.document.question || state.document.prompt != PathPrompt::none || state.link.shown)
    static_cast<void>(rest_.take_tip());
  notice_bar(with, layout_.plan.empty() ? layout_.tabs : layout_.plan, layout_.strip);
  browser_.draw(with, home_, picture.gallery);
  link_dialog(with);
  question_dialog(with);
  show_tooltip(with);
  ImGui::PopFont();
  if (leaves)
    for (const auto& what : std::exchange(after_typing_, {})) what(with);
  grant(with);
  next_frame_in_ = rest_.end_frame();
}

}  // namespace raywalk
