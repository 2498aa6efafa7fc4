#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"
#include "view/text/shown.h"
#include "view/walk/walk.h"

#include <algorithm>

namespace raywalk {

namespace {

// The objects to choose from, after "nowhere".
std::vector<std::string> object_names(const Ui& ui) {
  std::vector<std::string> names{ui.say("breakpoints.nowhere")};
  for (const Object& object : ui.state.scene().objects) names.push_back(shown_name(ui.state, object.name));
  return names;
}

}  // namespace

void BreakpointsPopup::draw(const Ui& ui, const Rect& code, bool open) {
  if (open) ImGui::OpenPopup("breakpoints");
  const float width = FormPopup::width(ui, 330);
  // Beside the code, so that the lines can be seen, but not out of the window.
  ImGui::SetNextWindowPos({std::max(code.x - ui.px(8), width + ui.px(30)), code.y + ui.px(8)}, ImGuiCond_Appearing,
                          {1, 0});
  const FormPopup popup(ui, "breakpoints");
  if (!popup) return;
  const State& state = ui.state;
  Form form(ui, memory_, width);
  int step = state.walk.position;
  if (open) form.focus_next();
  if (form.whole("breakpoints.go_to_step", step, 0, state.walk.timeline->steps(), true)) ui.act(action::Jump{step});

  form.heading("breakpoints.title");
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  label(ui.colours.dim_text, ui.say("breakpoints.hint"));
  if (breakpoints_in_force(state) != breakpoints_here(state)) label(ui.colours.error, ui.say("breakpoints.off"));
  ImGui::PopTextWrapPos();
  action::StopAt next = stops_chosen(state);
  bool changed = form.whole("breakpoints.at_depth", next.depth, 0, deepest_stop);
  changed |= form.whole("breakpoints.at_pixel", next.pixel, -1, std::max(state.scene().camera.screen.cells - 1, 0));
  changed |= form.flag("breakpoints.at_total", next.total_internal_reflection);
  int chosen = next.object + 1;
  if (form.pick("breakpoints.at_object", object_names(ui), chosen)) {
    next.object = chosen - 1;
    changed = true;
  }
  if (changed) ui.act(next);

  const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  const ImVec2 extent{(width - ui.px(12)) / 3, ui.high(32)};
  command_button(ui, command("run-back"), extent, look);
  ImGui::SameLine();
  command_button(ui, command("run-on"), extent, look);
  ImGui::SameLine();
  if (button(ui, "remove-breakpoints", ui.say("breakpoints.remove"), "", extent, look, false,
             breakpoints_here(state).any()))
    ui.act(action::RemoveBreakpoints{});
}

}  // namespace raywalk
