// The bar with the switches for effects.

#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/choice_text.h"
#include "view/text/text.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

/// What stands in the bar, from left to right.
struct EffectWords {
  std::vector<std::pair<Effect, std::string>> effects;
  std::string depth, all;
};

EffectWords effect_words(const Ui& ui) {
  const EffectsRoom& room = ui.state.effects;
  const auto with_rays = [&](const std::string& name, int rays) {
    return room.rays && room.rays->counted ? name + ": " + ui.say("effects.rays", {{"count", rays}}) : name;
  };
  EffectWords words;
  for (const Effect effect : values_of<Effect>) {
    const std::size_t number = number_of(effect);
    if (!room.rays || !room.rays->offered[number]) continue;
    const std::string name = capitalised(std::string(text(effect, ui.state.appearance.language)));
    words.effects.emplace_back(effect, room.rays->can[number] ? with_rays(name, room.rays->brought[number]) : name);
  }
  const int depth = room.depth.value_or(ui.state.scene().limits.depth);
  words.depth = with_rays(ui.say("effects.depth", {{"depth", depth}}), room.rays ? room.rays->by_depth : 0);
  if (room.rays && room.rays->counted) words.all = ui.say("effects.all_rays", {{"count", room.rays->all}});
  return words;
}

constexpr ButtonLook effect_look(ImFont* font) { return {.look = Look::choice, .icon = Icon::none, .font = font}; }

/// The switches in as many rows as they need; `draw`: else they are only measured. Returns the height.
float effect_rows(const Ui& ui, const Rect& where, bool draw) {
  const EffectWords words = effect_words(ui);
  const ButtonLook look = effect_look(ui.fonts.small);
  // What a finger presses is as high as its row (Ui::unseen).
  const float row = effects_row_height(ui), height = ui.high(30), above = (row - height) / 2;
  const float gap = ui.px(8), left = where.x + ui.px(14);
  float x = left, y = where.y + above - (draw ? ImGui::GetScrollY() : 0);
  const auto place = [&](float width) {
    if (x > left && x + width > where.right() - ui.px(8)) {
      x = left;
      y += row;
    }
    if (draw) ImGui::SetCursorScreenPos({x, y});
    x += width + gap;
  };
  const EffectsRoom& room = ui.state.effects;
  for (const auto& [effect, said] : words.effects) {
    const bool on = !room.leaves_out(effect);
    const float width = button_width(ui, said, look);
    place(width);
    const std::string name = "effect/" + std::string(name_of(effect));
    const bool can = room.rays->can[number_of(effect)];
    const std::string_view hint = can                 ? (on ? "effects.leave_out" : "effects.take_in")
                                  : ui.state.walk.bug ? "effects.with_bug"
                                                      : "effects.fixed";
    if (draw && button(ui, name, said, ui.say(hint), {width, height}, look, on, can))
      ui.act(action::SwitchEffect{effect, !on});
  }
  push_font(ui.fonts.small);
  const float level = ImGui::CalcTextSize(words.depth.c_str()).x;
  const int depth = room.depth.value_or(ui.state.scene().limits.depth);
  place(2 * height + level + 2 * gap);
  if (draw) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (button(ui, "effect/depth-less", "", ui.say("effects.shallower"), {height, height},
               {.look = Look::plain, .icon = Icon::minus, .font = nullptr, .label = false}, false, depth > 1))
      ui.act(action::LimitDepth{depth - 1});
    ImGui::SetCursorScreenPos({at.x + height + gap, at.y + (height - ImGui::GetFontSize()) / 2});
    label(ui.colours.text, words.depth);
    ImGui::SetCursorScreenPos({at.x + height + level + 2 * gap, at.y});
    if (button(ui, "effect/depth-more", "", ui.say("effects.deeper"), {height, height},
               {.look = Look::plain, .icon = Icon::plus, .font = nullptr, .label = false}))
      ui.act(action::LimitDepth{depth + 1});
  }
  if (!words.all.empty()) {
    place(ImGui::CalcTextSize(words.all.c_str()).x);
    if (draw) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::SetCursorScreenPos({at.x, at.y + (height - ImGui::GetFontSize()) / 2});
      label(ui.colours.dim_text, words.all);
    }
  }
  pop_font();
  return y - above + row - where.y;
}

}  // namespace

float effects_row_height(const Ui& ui) { return ui.high(34); }

float effects_height(const Ui& ui, float width) { return effect_rows(ui, {0, 0, width, 0}, false); }

void effects_pane(const Ui& ui, const Rect& where) {
  // A low window has no room for the rows of many effects.
  const bool fits = effects_height(ui, where.width) <= where.height + 1;
  const Pane pane(ui, "effects", where, ui.colours.plan, {0, 0}, fits ? ImGuiWindowFlags_NoScrollbar : 0);
  if (pane) effect_rows(ui, where, true);
}

Commands EffectsRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "effects", .keys = {"Shift+E"}, .section = Section::show,
       .chosen = [](const State& state) { return state.effects.shown; }, .turn = turn<action::ShowEffects>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
