#include "gui/form.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text.h"

#include <cmath>

#include <algorithm>
#include <utility>

namespace raywalk {

namespace {

constexpr double tiny = 1e-6, huge = 1e6;

void material_rows(const Ui& ui, Form& form, int index, const Object& object) {
  form.heading("property.material");
  Material m = object.material;
  bool now = form.colour("property.ambient", m.ambient, 1);
  now |= form.colour("property.diffuse", m.diffuse, 1);
  now |= form.colour("property.specular", m.specular, 1);
  now |= form.number("property.shininess", m.shininess, 0.5, 0, 1e5);
  now |= form.colour("property.reflection", m.reflection, 1);
  now |= form.colour("property.transmission", m.transmission, 1);
  now |= form.number("property.ior", m.ior, 0.005, 0.01, 100);
  now |= form.flag("property.dielectric", m.dielectric);
  now |= form.number("property.priority", m.priority, 0.05, -1000, 1000);
  bool filtered = m.shadow == ShadowKind::filtered;
  now |= form.flag("property.filtered_shadow", filtered);
  m.shadow = filtered ? ShadowKind::filtered : ShadowKind::opaque;
  now |= form.colour("property.emission", m.emission, huge);
  bool checkered = m.checker.has_value();
  if (form.flag("property.checker", checkered)) {
    now = true;
    m.checker = checkered ? std::optional<Checker>(Checker{}) : std::nullopt;
  }
  if (now) ui.act(action::SetMaterial{index, m, form.continues()});
}

bool shape_rows(Form& form, Sphere<double>& sphere) {
  bool now = form.vector("property.centre", &sphere.centre.x, 3, 0.01);
  now |= form.number("property.radius", sphere.radius, 0.01, tiny, huge);
  return now;
}

bool shape_rows(Form& form, Plane<double>& plane) {
  bool now = form.vector("property.position", &plane.point.x, 3, 0.01);
  now |= form.vector("property.normal", &plane.normal.x, 3, 0.01);
  return now;
}

bool shape_rows(Form& form, Prism<double>& prism) {
  bool now = form.number("property.height", prism.height, 0.01, tiny, huge);
  int number = 0;
  for (Vec2d& corner : prism.corners) now |= form.vector({"property.corner", ++number}, &corner.x, 2, 0.01);
  return now;
}

bool shape_rows(Form& form, Box<double>& box) {
  bool now = form.vector("property.lowest", &box.min.x, 3, 0.01);
  now |= form.vector("property.highest", &box.max.x, 3, 0.01);
  return now;
}

template <QuadricKind Kind>
bool shape_rows(Form& form, Quadric<double, Kind>& quadric) {
  bool now = form.vector("property.radii", &quadric.radii.x, 3, 0.01);
  if (std::isfinite(quadric.z_min)) now |= form.number("property.lowest", quadric.z_min, 0.01, -huge, huge);
  if (std::isfinite(quadric.z_max)) now |= form.number("property.highest", quadric.z_max, 0.01, -huge, huge);
  now |= form.flag("property.capped", quadric.capped);
  return now;
}

bool shape_rows(Form& form, Disk<double>& disk) {
  bool now = form.vector("property.centre", &disk.centre.x, 3, 0.01);
  now |= form.vector("property.normal", &disk.normal.x, 3, 0.01);
  now |= form.number("property.radius", disk.radius, 0.01, tiny, huge);
  return now;
}

bool shape_rows(Form& form, Polygon<double>& polygon) {
  bool now = false;
  int number = 0;
  for (Vec3d& corner : polygon.outline) now |= form.vector({"property.corner", ++number}, &corner.x, 3, 0.01);
  return now;
}

bool shape_rows(Form& form, Triangle<double>& triangle) {
  bool now = false;
  int number = 0;
  for (Vec3d* corner : {&triangle.a, &triangle.b, &triangle.c})
    now |= form.vector({"property.corner", ++number}, &corner->x, 3, 0.01);
  return now;
}

// A mesh's file and a group are chosen in the scene's file.
bool shape_rows(Form& form, MeshShape& mesh) { return form.flag("property.smooth", mesh.smooth); }
bool shape_rows(Form& /*form*/, Instance& /*instance*/) { return false; }

void object_rows(const Ui& ui, Form& form, int index) {
  const Object& object = ui.state.scene().objects[static_cast<std::size_t>(index)];
  std::string name = object.name;
  if (form.text("property.name", name)) ui.act(action::Rename{{TargetKind::object, index}, name});
  ObjectShape shape = object.shape;
  if (std::visit([&](auto& s) { return shape_rows(form, s); }, shape))
    ui.act(action::SetShape{index, shape, form.continues()});
  if (!std::holds_alternative<Instance>(object.shape)) material_rows(ui, form, index, object);
}

void light_rows(const Ui& ui, Form& form, int index) {
  Light light = ui.state.scene().lights[static_cast<std::size_t>(index)];
  std::string name = light.name;
  if (form.text("property.name", name)) ui.act(action::Rename{{TargetKind::light, index}, name});
  bool now = form.colour("property.strength", light.strength, huge);
  if (auto* point = std::get_if<PointLight>(&light.kind)) {
    now |= form.vector("property.position", &point->position.x, 3, 0.01);
    Attenuation& a = point->attenuation;
    std::array<double, 3> terms{a.constant, a.linear, a.quadratic};
    if (form.vector("property.attenuation", terms.data(), 3, 0.005, 0)) {
      a = {terms[0], terms[1], terms[2]};
      now = true;
    }
  } else if (auto* sun = std::get_if<DirectionalLight>(&light.kind)) {
    now |= form.vector("property.direction", &sun->direction.x, 3, 0.01);
  }
  if (now) ui.act(action::SetLight{index, light, form.continues()});
}

void camera_rows(const Ui& ui, Form& form) {
  Camera camera = ui.state.scene().camera;
  bool now = form.vector("property.position", &camera.eye.x, 3, 0.01);
  now |= form.vector("property.look_at", &camera.look_at.x, 3, 0.01);
  now |= form.number("property.screen_distance", camera.screen.distance, 0.01, tiny, huge);
  if (camera.screen.width) now |= form.number("property.screen_width", *camera.screen.width, 0.01, tiny, huge);
  if (camera.fov) now |= form.number("property.view_angle", camera.fov->degrees, 0.2, 0.1, 179.9);
  now |= form.whole("property.screen_cells", camera.screen.cells, 1, 1001);
  if (now) ui.act(action::SetCamera{camera, form.continues()});
}

void scene_rows(const Ui& ui, Form& form) {
  form.heading("scene.settings");
  const Scene& scene = ui.state.scene();
  Rgbd background = scene.background, ambient = scene.ambient;
  bool now = form.colour("property.background", background, huge);
  now |= form.colour("property.ambient_light", ambient, huge);
  if (now) ui.act(action::SetSurroundings{background, ambient, form.continues()});
  TraceLimits limits = scene.limits;
  now = form.whole("property.depth_limit", limits.depth, 1, 50);
  now |= form.number("property.threshold", limits.threshold, 0.0005, 0, 1);
  if (now) ui.act(action::SetLimits{limits, form.continues()});
}

std::string title_of(const Ui& ui, const Target& target) {
  const Scene& scene = ui.state.scene();
  const auto index = static_cast<std::size_t>(std::max(target.index, 0));
  switch (target.kind) {
    case TargetKind::object:
    case TargetKind::radius:
    case TargetKind::corner:
    case TargetKind::edge:
    case TargetKind::rotation:
      return scene.objects[index].name;
    case TargetKind::light:
      return scene.lights[index].name;
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_height:
    case TargetKind::screen_distance:
    case TargetKind::cell:
    case TargetKind::ray:
    case TargetKind::nothing:
      break;
  }
  return ui.say("object.eye") + ", " + ui.say("object.screen");
}

}  // namespace

bool PropertiesPane::shows(const State& state) {
  return state.mode == Mode::move && state.selected && exists(state, state.selected) &&
         state.selected.kind != TargetKind::ray;
}

void PropertiesPane::draw(const Ui& ui, const Rect& where, bool focus) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(14), ui.px(10)});
  const bool visible = begin_pane(ui, "properties", where, ui.colours.panel, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  if (visible) {
    const Target target = ui.state.selected;
    const float width = ImGui::GetContentRegionAvail().x, edge = ui.px(28);
    push_font(ui.fonts.title);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(at, {at.x + width - edge - ui.px(8), at.y + edge}, true);
    label(ui.colours.text, title_of(ui, target));
    ImGui::PopClipRect();
    pop_font();
    ImGui::SetCursorScreenPos({at.x + width - edge, at.y});
    command_button(ui, Command::deselect, {edge, edge},
                   {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false});

    push_font(ui.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(5)});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(6), ui.px(4)});
    // Fields of different things are different fields, although they look alike.
    ImGui::PushID(static_cast<int>(target.kind));
    ImGui::PushID(target.index);
    if (std::exchange(shown_, target) != target) memory_ = {};
    Form form(ui, memory_, width);
    // First the pane, a frame later its field: newer versions of ImGui look for the field only where the focus is.
    if (std::exchange(focus_field_, false)) form.focus_next();
    if (focus) ImGui::SetWindowFocus();
    focus_field_ |= focus;
    switch (target.kind) {
      case TargetKind::object:
      case TargetKind::radius:
      case TargetKind::corner:
      case TargetKind::edge:
      case TargetKind::rotation:
        object_rows(ui, form, target.index);
        break;
      case TargetKind::light:
        light_rows(ui, form, target.index);
        break;
      case TargetKind::eye:
      case TargetKind::view_direction:
      case TargetKind::screen_height:
      case TargetKind::screen_distance:
      case TargetKind::cell:
      case TargetKind::ray:
      case TargetKind::nothing:
        camera_rows(ui, form);
        scene_rows(ui, form);
        break;
    }
    ImGui::PopID();
    ImGui::PopID();
    ImGui::PopStyleVar(2);
    pop_font();
    fade_edges(ui, ui.colours.panel);
  }
  end_pane();
}

}  // namespace raywalk
