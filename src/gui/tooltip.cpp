// Tooltips: beside what they explain, and over nothing that can be clicked.

#include "gui/broken_lines.h"
#include "gui/widgets.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

namespace {

// In units at scale 1: what is higher is no button and no line of text.
constexpr float highest = 64;

float overlap(const Rect& a, const Rect& b) {
  return std::max(std::min(a.right(), b.right()) - std::max(a.x, b.x), 0.0f) *
         std::max(std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y), 0.0f);
}

// A place of this size near `item`: below, above, to the right or the left of it, somewhat higher or lower there, where
// it covers the least of what was drawn in this frame and is no higher than a button or a few lines.
Rect beside(const Ui& ui, const Rect& item, ImVec2 size) {
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const float gap = ui.px(6), step = ui.px(14), high = ui.px(highest), dear = ui.px(40);
  constexpr float grave = 200, touched = 100;  // rather far away than over a button, however little of it
  std::vector<Rect> others;
  for (const auto& [name, rect] : ui.items)
    if (rect.height <= high && !rect.empty()) others.push_back(rect);
  Rect best{item.x, item.bottom() + gap, size.x, size.y};
  float least = 1e30f;
  const auto try_at = [&](float x, float y, float away) {
    const Rect place{std::clamp(x, 0.0f, std::max(whole.x - size.x, 0.0f)),
                     std::clamp(y, 0.0f, std::max(whole.y - size.y, 0.0f)), size.x, size.y};
    float covered = dear * away + 1e6f * std::min(overlap(place, item), 1.0f);
    for (const Rect& other : others)
      if (const float shared = overlap(place, other); shared > 0) covered += grave * (touched + shared);
    if (covered >= least) return;
    least = covered;
    best = place;
  };
  constexpr int farthest = 40;  // steps
  for (int i = 0; i <= farthest; ++i) {
    const float away = gap + step * static_cast<float>(i);
    for (const float part : {0.5f, 0.0f, 1.0f}) {
      const float x = item.x + part * (item.width - size.x), y = item.y + part * (item.height - size.y);
      try_at(x, item.bottom() + away, away);
      try_at(x, item.y - away - size.y, away);
      for (const float rows : {0.0f, -1.0f, 1.0f, -2.0f, 2.0f}) {
        const float down = rows * (size.y + gap), far = away + std::abs(down);
        try_at(item.right() + away, y + down, far);
        try_at(item.x - away - size.x, y + down, far);
      }
    }
  }
  return best;
}

}  // namespace

void tooltip(const Ui& ui, std::string_view name, const std::string& text, TipOf of) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const bool pressed = ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1) || ImGui::GetIO().MouseWheel != 0;
  if (!ui.rest.rested_on(name, ImGui::GetTime(), pressed)) return;
  const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax(), mouse = ImGui::GetIO().MousePos;
  Rect item{least.x, least.y, most.x - least.x, most.y - least.y};
  if (of == TipOf::point) item = {mouse.x - ui.px(8), mouse.y - ui.px(8), ui.px(16), ui.px(24)};
  ui.rest.show({item, text});
}

void show_tooltip(const Ui& ui) {
  const std::optional<Tip> tip = ui.rest.take_tip();
  if (!tip) return;
  const ImVec2 pad{ui.px(10), ui.px(7)};
  push_font(ui.fonts.small);
  const std::string text = broken_lines(tip->text, ui.px(340));
  const ImVec2 words = ImGui::CalcTextSize(text.c_str());
  const Rect where = beside(ui, tip->item, {words.x + 2 * pad.x, words.y + 2 * pad.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
  ImGui::SetNextWindowPos(corner(where));
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(text.c_str());
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
  pop_font();
  ui.publish("tooltip", where);
}

void tooltip_now(const Ui& ui, const std::string& text, const Rect& within) {
  if (ui.rest.hushed()) return;
  const ImVec2 pad{ui.px(9), ui.px(5)}, mouse = ImGui::GetIO().MousePos;
  push_font(ui.fonts.small);
  const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * pad.x, aside = ui.px(16), below = ui.px(10);
  pop_font();
  if (!within.empty() && mouse.x + aside + width > within.right())
    ImGui::SetNextWindowPos({std::max(std::min(mouse.x - below, within.right()) - width, within.x), mouse.y + below});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
  ImGui::BeginTooltip();
  push_font(ui.fonts.small);
  ImGui::TextUnformatted(text.c_str());
  pop_font();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace raywalk
