#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"
#include "view/text/shown.h"

#include <algorithm>

namespace raywalk {

namespace {

// The objects to choose from, after "nowhere".
std::vector<std::string> object_names(const Ui& ui) {
  std::vector<std::string> names{ui.say("breakpoints.nowhere")};
  for (const Object& object : ui.state.scene().objects) names.push_back(shown_name(ui.state, object.name));
  return names;
}

// An optional number: if absent, the field shows `none`.
void optional_whole(Form& form, std::string_view label, std::optional<int>& value, int none, int most) {
  int shown = value.value_or(none);
  if (form.whole(label, shown, none, most)) value = shown == none ? std::nullopt : std::optional(shown);
}

}  // namespace

void BreakpointsPopup::draw(const Ui& ui, const Rect& code, bool open) {
  if (open) ImGui::OpenPopup("breakpoints");
  const float width = ui.px(330);
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
  if (breakpoints_in_force(state) != state.walk.breakpoints) label(ui.colours.error, ui.say("breakpoints.off"));
  ImGui::PopTextWrapPos();
  Breakpoints next = state.walk.breakpoints;
  optional_whole(form, "breakpoints.at_depth", next.depth, 0, 99);
  optional_whole(form, "breakpoints.at_pixel", next.pixel, -1, std::max(state.scene().camera.screen.cells - 1, 0));
  form.flag("breakpoints.at_total", next.total_internal_reflection);
  const std::vector<std::string> names = object_names(ui);
  const std::vector<Object>& objects = state.scene().objects;
  const auto at = std::find_if(objects.begin(), objects.end(), [&](const Object& o) { return o.name == next.object; });
  int chosen = at == objects.end() ? 0 : static_cast<int>(at - objects.begin()) + 1;
  if (form.pick("breakpoints.at_object", names, chosen))
    next.object = chosen == 0 ? std::string() : objects[static_cast<std::size_t>(chosen) - 1].name;
  if (next != state.walk.breakpoints) ui.act(action::SetBreakpoints{next});

  const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  const ImVec2 extent{(width - ui.px(12)) / 3, ui.px(32)};
  command_button(ui, command("run-back"), extent, look);
  ImGui::SameLine();
  command_button(ui, command("run-on"), extent, look);
  ImGui::SameLine();
  if (button(ui, "remove-breakpoints", ui.say("breakpoints.remove"), "", extent, look, false,
             state.walk.breakpoints.any()))
    ui.act(action::SetBreakpoints{});
}

}  // namespace raywalk
