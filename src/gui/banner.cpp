// The banner above the plan: that the tracer has a fault, or what is to be predicted. It stays as long as its reason,
// so that the plan does not jump between steps.

#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/bugs/bug_panel.h"
#include "view/predict/predict.h"

#include <algorithm>

namespace raywalk {

namespace {

int lines_of(const State& state) { return state.walk.bug ? 1 : 2; }

}  // namespace

bool has_banner(const State& state) {
  return (state.walk.bug && state.walk.mode != Mode::help) || (state.predictions.on && state.walk.mode == Mode::trace);
}

float banner_height(const Ui& ui) {
  return static_cast<float>(lines_of(ui.state)) * line_height(ui.fonts, *ui.fonts.strong) + ui.px(10);
}

void banner_pane(const Ui& ui, const Rect& where) {
  const Shades shades(ui.state.appearance.theme);
  const bool alarms = ui.state.walk.bug && !ui.state.walk.bug->mended;
  const Pane pane(ui, "banner", where, alarms ? ui.colours.error : shades.accent, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!pane) return;
  const std::string text = ui.state.walk.bug ? bug_banner(ui.state) : prediction_sentence(ui.state);
  push_font(ui.fonts.strong);
  const float room = where.width - ui.px(16);
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
  ImGui::SetCursorScreenPos({where.x + std::max((where.width - extent.x) / 2, ui.px(8)),
                             where.y + std::max((where.height - extent.y) / 2, ui.px(2))});
  ImGui::PushTextWrapPos(where.width - ui.px(8));
  label(alarms ? ui.colours.panel : shades.on_accent, text);
  ImGui::PopTextWrapPos();
  pop_font();
  ui.publish("banner", where);
}

}  // namespace raywalk
