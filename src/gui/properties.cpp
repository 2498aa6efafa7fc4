#include "gui/command.h"
#include "gui/form.h"
#include "gui/panes.h"
#include "gui/schema_form.h"
#include "gui/widgets.h"
#include "view/document/keys.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raywalk {

namespace {

void object_rows(const Ui& ui, Form& form, int index) {
  const Object& object = ui.state.scene().objects[static_cast<std::size_t>(index)];
  std::string name = shown_name(ui.state, object.name);
  if (form.text("property.name", name)) ui.act(action::Rename{{TargetKind::object, index}, name});
  ObjectShape shape = object.shape;
  if (std::visit([&](auto& s) { return SchemaForm::draw(form, schema::type_name(s), s); }, shape))
    ui.act(action::SetShape{index, shape, form.continues()});
  if (std::holds_alternative<Instance>(object.shape)) return;
  form.heading("property.material");
  Material material = object.material;
  if (SchemaForm::draw(form, "material", material)) ui.act(action::SetMaterial{index, material, form.continues()});
}

void light_rows(const Ui& ui, Form& form, int index) {
  Light light = ui.state.scene().lights[static_cast<std::size_t>(index)];
  std::string name = shown_name(ui.state, light.name);
  if (form.text("property.name", name)) ui.act(action::Rename{{TargetKind::light, index}, name});
  if (SchemaForm::draw(form, "light", light)) ui.act(action::SetLight{index, light, form.continues()});
}

void camera_rows(const Ui& ui, Form& form) {
  const Camera& before = ui.state.scene().camera;
  Camera camera = before;
  const bool changed = SchemaForm::draw(form, "camera", camera),
             resized = SchemaForm::draw(form, "screen", camera.screen);
  if (!changed && !resized) return;
  // What is now stated begins as it was without; the picture's width is stated by the angle or by the screen.
  if (camera.focus && !before.focus) camera.focus = before.focus_distance();
  if (camera.screen.width && !before.screen.width) {
    camera.screen.width = before.screen_width();
    camera.fov.reset();
  } else if (!camera.screen.width && before.screen.width) {
    camera.fov = FieldOfView{2 * std::atan(before.half_extent()) * 180 / std::numbers::pi};
  }
  ui.act(action::SetCamera{camera, form.continues()});
}

void scene_rows(const Ui& ui, Form& form) {
  form.heading("scene.settings");
  Scene scene;  // of its own keys those that have fields; the rest may be large
  scene.background = ui.state.scene().background;
  scene.ambient = ui.state.scene().ambient;
  scene.sky = ui.state.scene().sky;
  if (SchemaForm::draw(form, "scene", scene))
    ui.act(action::SetSurroundings{scene.background, scene.ambient, scene.sky, form.continues()});
  TraceLimits limits = ui.state.scene().limits;
  if (SchemaForm::draw(form, "limits", limits)) ui.act(action::SetLimits{limits, form.continues()});
}

}  // namespace

void PropertiesPane::draw(const Ui& ui, const Rect& where, bool focus) {
  const Pane pane(ui, "properties", where, ui.colours.panel, {ui.px(14), ui.px(10)});
  if (!pane) return;
  const Target target = ui.state.plan.selected;
  const float width = ImGui::GetContentRegionAvail().x, edge = ui.px(28);
  push_font(ui.fonts.title);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(at, {at.x + width - edge - ui.px(8), at.y + edge}, true);
  label(ui.colours.text, properties_title(ui.state));
  ImGui::PopClipRect();
  pop_font();
  ImGui::SetCursorScreenPos({at.x + width - edge, at.y});
  command_button(ui, command("deselect"), {edge, edge},
                 {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false});

  push_font(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(5)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(6), ui.px(4)});
  // Fields of different things need different ids.
  ImGui::PushID(static_cast<int>(target.kind));
  ImGui::PushID(target.index);
  if (std::exchange(shown_, target) != target) memory_ = {};
  Form form(ui, memory_, width);
  // First the pane, a frame later its field: newer versions of ImGui search only the focused window.
  if (std::exchange(focus_field_, false)) form.focus_next();
  if (focus) ImGui::SetWindowFocus();
  focus_field_ |= focus;
  switch (owner_of(target)) {
    case Owner::object:
      object_rows(ui, form, target.index);
      break;
    case Owner::light:
      light_rows(ui, form, target.index);
      break;
    case Owner::camera_and_scene:
      camera_rows(ui, form);
      scene_rows(ui, form);
      break;
  }
  ImGui::PopID();
  ImGui::PopID();
  ImGui::PopStyleVar(2);
  pop_font();
  close_edges(ui, ui.colours.panel);
}

}  // namespace raywalk
