// Ink: its tools above the plan, the field for its words, and its commands.

#include "view/ink/ink.h"
#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace raywalk {

namespace {

/// A disc of the colour, with a ring around the chosen one.
void colour_button(const Ui& ui, InkColour colour, ImVec2 extent) {
  const std::string name = "ink/" + std::string(name_of(colour));
  const ImVec2 least = ImGui::GetCursorScreenPos(), middle{least.x + extent.x / 2, least.y + extent.y / 2};
  if (ImGui::InvisibleButton(name.c_str(), extent)) ui.act(action::ChooseInkColour{colour});
  ui.publish(name);
  const bool chosen = ui.state.ink.colour == colour, hovered = ImGui::IsItemHovered();
  const float edge = std::min(extent.x, extent.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled(middle, edge * 0.3f, to_imgui(ink_colour(colour, ui.state.appearance.theme)));
  if (chosen || hovered)
    draw.AddCircle(middle, edge * 0.42f, to_imgui(chosen ? ui.colours.text : ui.colours.dim_text), 0, ui.px(2));
  tooltip(ui, name, std::string(text(colour, ui.state.appearance.language)));
}

Icon icon_of(InkTool tool) {
  switch (tool) {
    case InkTool::pen:
      return Icon::pen;
    case InkTool::arrow:
      return Icon::arrow;
    case InkTool::text:
      return Icon::letter;
    case InkTool::ruler:
      return Icon::ruler;
    case InkTool::protractor:
      return Icon::protractor;
    case InkTool::eraser:
      return Icon::eraser;
  }
  return Icon::none;
}

float tool_height(const Ui& ui) { return ui.high(30); }

/// The tools, by their words or, where these do not fit into one row, by icons in as many rows as they need; `draw`:
/// else they are only measured. Returns the height.
float ink_rows(const Ui& ui, const Rect& where, bool words, bool draw) {
  const bool by_finger = ui.finger > 0;
  const float height = tool_height(ui), below = by_finger ? 0 : ui.px(4), gap = ui.px(words ? 4 : 2);
  const float left = where.x + ui.px(8), right = where.right() - ui.px(6);
  // A finger presses squares, or what is a little narrower where all then stand in one row.
  constexpr std::size_t colours = std::size(words_of<InkColour>), buttons = std::size(words_of<InkTool>) + colours + 3;
  constexpr float gaps = std::size(words_of<InkTool>) + 5;
  const float in_one_row = std::floor((right - left - gaps * gap) / static_cast<float>(buttons));
  const float square = in_one_row > 0.8f * height ? std::min(in_one_row, height) : height;
  const float icon_width = by_finger ? square : 0.87f * height;
  float x = left, y = where.y + below;
  const auto place = [&](float width) {
    if (x > left && x + width > right) {
      x = left;
      y += height + below;
    }
    if (draw) ImGui::SetCursorScreenPos({x, y});
    x += width + gap;
  };
  const auto add = [&](const Command& each, Look look, Icon icon) {
    const ButtonLook as{.look = look, .icon = words ? Icon::none : icon, .font = ui.fonts.small, .label = words};
    const float width = words ? button_width(ui, each, as) : icon_width;
    place(width);
    if (draw) command_button(ui, each, {width, height}, as);
  };
  for (const auto& [tool, word] : words_of<InkTool>) {
    const std::string name = "ink-" + std::string(word);
    add(command(name), Look::choice, icon_of(tool));
  }
  x += gap;
  // Colours stay together.
  const float apart = words ? height : by_finger ? square : 0.73f * height, all = static_cast<float>(colours) * apart;
  place(all);
  for (std::size_t i = 0; draw && i < colours; ++i) {
    ImGui::SetCursorScreenPos({x - all - gap + static_cast<float>(i) * apart, y});
    colour_button(ui, words_of<InkColour>[i].first, {apart, height});
  }
  x += gap;
  add(command("ink-clear"), Look::plain, Icon::bin);
  add(command("ink-keep"), Look::choice, Icon::keep);
  place(icon_width);
  if (draw)
    command_button(ui, command("ink"), {icon_width, height},
                   {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false});
  return y + height + below - where.y;
}

/// Whether the words of all tools fit into one row.
bool fits_words(const Ui& ui, float width) { return ink_rows(ui, {0, 0, width, 0}, true, false) < 2 * tool_height(ui); }

}  // namespace

float ink_height(const Ui& ui, float width) { return ink_rows(ui, {0, 0, width, 0}, fits_words(ui, width), false); }

void ink_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "ink-tools", where, ui.colours.panel, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (pane) ink_rows(ui, where, fits_words(ui, where.width), true);
}

namespace {

/// A field that gets the keyboard selects its text: what is typed next goes behind it instead.
int go_on(ImGuiInputTextCallbackData* data) {
  bool& begins = *static_cast<bool*>(data->UserData);
  if (std::exchange(begins, false)) data->SelectionStart = data->SelectionEnd = data->CursorPos = data->BufTextLen;
  return 0;
}

}  // namespace

void InkField::draw(const Ui& ui, const Rect& plan) {
  const InkText* const note = text_begun(ui.state);
  if (note == nullptr || !inks(ui.state)) return;
  const Vec2d pixels = to_pixels(ui.state.plan.camera, ui.state.plan.viewport, note->at);
  const ImVec2 padding{ui.px(6), ui.px(4)};
  const float height = ImGui::GetFontSize() + 2 * padding.y;
  const float wanted = std::max(ImGui::CalcTextSize(note->text.c_str()).x + ui.px(40), ui.px(160));
  const float width = std::min(wanted, std::max(plan.width - ui.px(8), 1.0f));
  const auto within = [](float at, float low, float high) { return std::clamp(at, low, std::max(low, high)); };
  ImGui::SetNextWindowPos(
      {within(plan.x + static_cast<float>(pixels.x) * ui.dpi - padding.x, plan.x, plan.right() - width),
       within(plan.y + static_cast<float>(pixels.y) * ui.dpi - height / 2, plan.y, plan.bottom() - height)});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui4(ink_colour(ui.state.ink.colour, ui.state.appearance.theme)));
  ImGui::Begin("ink-field", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav);
  if (typed_ != note->text) ++number_, typed_ = note->text;
  std::array<char, longest_ink_text + 1> typed{};
  std::memcpy(typed.data(), note->text.data(), std::min(note->text.size(), longest_ink_text));
  // It has the keyboard whenever nothing else wants it.
  if (!ImGui::IsAnyItemActive() &&
      !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) {
    ImGui::SetKeyboardFocusHere();
    begins_ = true;
  }
  ImGui::SetNextItemWidth(width);
  const std::string name = "##words" + std::to_string(number_);
  const bool entered = ImGui::InputTextWithHint(
      name.c_str(), ui.say("ink.type").c_str(), typed.data(), typed.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, go_on, &begins_);
  ui.publish("ink-field");
  const bool left = ImGui::IsItemDeactivated() && !ImGui::IsMouseDown(0) && !ImGui::IsMouseDown(1);
  if (typed_ != typed.data()) ui.act(action::TypeInk{typed_ = typed.data()});
  if (entered)
    ui.act(action::FinishInk{});
  else if (left)  // by Escape
    ui.act(action::LeaveInk{});
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

namespace {

bool can_ink(const State& state) { return state.walk.mode != Mode::help && !shows_lines(state); }
bool is_inked(const State& state) { return !state.document.contents.ink.empty() || state.ink.begun; }
template <InkTool tool>
bool inks_with(const State& state) {
  return state.ink.on && state.ink.tool == tool;
}
template <InkTool tool>
void ink_with(const Ui& ui) {
  ui.act(action::ChooseInkTool{tool});
  if (!ui.state.ink.on) ui.act(action::SetInk{true});
}
void next_colour(const Ui& ui) {
  const int next = (static_cast<int>(ui.state.ink.colour) + 1) % static_cast<int>(std::size(words_of<InkColour>));
  ui.act(action::ChooseInkColour{static_cast<InkColour>(next)});
}
std::string colour_label(const State& state, bool /*in_short*/) {
  const Language language = state.appearance.language;
  return fill("ink.colour", language, {{"colour", std::string(text(state.ink.colour, language))}});
}

}  // namespace

Commands InkRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "ink", .keys = {"Q"}, .section = Section::ink, .line = "keys.ink", .enabled = can_ink,
       .chosen = [](const State& state) { return state.ink.on; }, .turn = turn<action::SetInk>},
      {.name = "ink-pen", .keys = {"Shift+P"}, .section = Section::ink, .line = "keys.ink_tools", .enabled = can_ink,
       .chosen = inks_with<InkTool::pen>, .run = ink_with<InkTool::pen>},
      {.name = "ink-arrow", .keys = {"Shift+V"}, .section = Section::ink, .line = "keys.ink_tools", .enabled = can_ink,
       .chosen = inks_with<InkTool::arrow>, .run = ink_with<InkTool::arrow>},
      {.name = "ink-text", .keys = {"Shift+T"}, .section = Section::ink, .line = "keys.ink_tools", .enabled = can_ink,
       .chosen = inks_with<InkTool::text>, .run = ink_with<InkTool::text>},
      {.name = "ink-ruler", .keys = {"Shift+D"}, .section = Section::ink, .line = "keys.ink_tools", .enabled = can_ink,
       .chosen = inks_with<InkTool::ruler>, .run = ink_with<InkTool::ruler>},
      {.name = "ink-protractor", .keys = {"Shift+G"}, .section = Section::ink, .line = "keys.ink_tools",
       .enabled = can_ink, .chosen = inks_with<InkTool::protractor>, .run = ink_with<InkTool::protractor>},
      {.name = "ink-eraser", .keys = {"Shift+X"}, .section = Section::ink, .line = "keys.ink_tools",
       .enabled = can_ink, .chosen = inks_with<InkTool::eraser>, .run = ink_with<InkTool::eraser>},
      {.name = "ink-colour", .keys = {"Shift+K"}, .section = Section::ink, .line = "keys.ink", .label = colour_label,
       .run = next_colour},
      {.name = "ink-clear", .keys = {"Shift+C"}, .section = Section::ink, .line = "keys.ink", .enabled = is_inked,
       .run = act<action::ClearInk>},
      {.name = "ink-keep", .keys = {"Shift+I"}, .section = Section::ink, .line = "keys.ink",
       .chosen = [](const State& state) { return state.document.contents.keeps_ink; }, .turn = turn<action::KeepInk>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
