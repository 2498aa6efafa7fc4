#include "gui/report.h"

#include "view/link/link.h"
#include "view/plan/plan_view.h"
#include "view/predict/predict.h"
#include "view/structure/structure.h"
#include "view/walk/asked.h"
#include "view/walk/status.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace raywalk {

namespace {

using Json = nlohmann::ordered_json;

std::string selected_name(const State& state) {
  const Target& target = state.plan.selected;
  const auto index = static_cast<std::size_t>(std::max(target.index, 0));
  if (target.kind == TargetKind::light && index < state.scene().lights.size()) return state.scene().lights[index].name;
  if (target.kind == TargetKind::eye) return "EYE";
  const bool body = target.kind == TargetKind::object || target.kind == TargetKind::corner;
  if (body && index < state.scene().objects.size()) return state.scene().objects[index].name;
  return {};
}

Json cost_report(const CostRoom& cost, const LiveCosts& costs) {
  const auto& attempts = costs.bench().attempts();
  const auto done = std::count_if(attempts.begin(), attempts.end(), [](const auto& one) { return one.done >= 1; });
  return {{"page", cost.page == CostPage::tries ? "tries" : "effects"},
          {"tried", cost.tried.size()},
          {"done", done},
          {"reference_samples", costs.bench().reference_samples()},
          {"chosen", cost.chosen},
          {"against", cost.against},
          {"difference", cost.picture == CostPicture::difference},
          {"split", cost.split},
          {"surveyed", costs.surveyed()}};
}

// The middle of a body in the plan.
Vec2d middle(const ObjectShape& shape) {
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) return plan(sphere->centre);
  if (const auto* plane = std::get_if<Plane<double>>(&shape)) return plan(plane->point);
  if (const auto* prism = std::get_if<Prism<double>>(&shape)) {
    Vec2d sum{0.0};
    for (const Vec2d& corner : prism->corners) sum += corner / static_cast<double>(prism->corners.size());
    return sum;
  }
  const Bounds<double> box = bounds(shape);
  return box.empty() || !box.bounded() ? Vec2d(0.0) : plan((box.min + box.max) / 2.0);
}

// FNV-1a, for tests that compare pictures.
std::uint64_t hash_of(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 1099511628211u;
  return hash;
}

}  // namespace

std::string report(const State& state, const Interface& interface, const Preview& preview, const LiveCosts& costs,
                   float dpi, const WindowReport& window) {
  const Rect& pane = interface.layout().plan;
  const auto place = [&](const Vec2d& at) {
    const Vec2d pixels = to_pixels(state.plan.camera, state.plan.viewport, at);
    return Json{{"plan", {at.x, at.y}},
                {"window", {pane.x + static_cast<float>(pixels.x) * dpi, pane.y + static_cast<float>(pixels.y) * dpi}}};
  };
  Json json{{"mode", name_of(state.walk.mode)},
            {"position", state.walk.position},
            {"steps", state.walk.timeline->steps()},
            {"playing", state.walk.playing},
            {"grain", name_of(state.walk.grain)},
            {"speed", state.walk.lines_per_second},
            {"tab", name_of(state.appearance.tab)},
            {"theme", name_of(state.appearance.theme)},
            {"ui_scale", state.appearance.ui_scale},
            {"path", state.document.path},
            {"dirty", state.document.dirty},
            {"undo", state.document.undo.size()},
            {"redo", state.document.redo.size()},
            {"selected", selected_name(state)},
            {"hovered_ray", state.plan.hovered_ray},
            {"question", state.document.question ? name_of(state.document.question->kind) : std::string_view()},
            {"prompt", name_of(state.document.prompt)},
            {"link", state.link.shown ? address_shown(state) : state.link.copied},
            {"link_shown", state.link.shown},
            {"notice", state.document.notice ? state.document.notice->text : ""},
            {"sentence", sentence(state)},
            {"revision", state.document.revision},
            {"cell", current_cell(state)},
            {"language", state.appearance.language.code()},
            {"lines", shows_lines(state)},
            {"turned", state.picture.camera.has_value()},
            {"rays", state.walk.timeline->rays_at(state.walk.position).size()},
            {"stops", std::count(state.walk.breakpoints.before.begin(), state.walk.breakpoints.before.end(), true)},
            {"magnified", state.microscope.magnified},
            {"naive", state.scene().render.numerics == Numerics::naive}};
  if (state.appearance.tab == CostRoom::tab) json["cost"] = cost_report(state.cost, costs);
  if (shows_structure(state))
    json["structure"] = {{"kind", name_of(state.structure.kind)},
                         {"build", state.structure.page == StructurePage::build},
                         {"step", structure_step(state)},
                         {"steps", structure_steps(state)}};
  if (state.walk.pixel) json["walk"] = {state.walk.pixel->column, state.walk.pixel->row};
  if (const LessonRoom& sitting = state.lessons; sitting.shown)
    json["lesson"] = {{"open", sitting.open ? sitting.open->lesson.name : ""},
                      {"step", sitting.step + 1},
                      {"revealed", sitting.revealed},
                      {"aimed", sitting.guess.arrow.has_value()},
                      {"presenter", sitting.presenter},
                      {"notes", sitting.notes},
                      {"notes_window", sitting.notes_window},
                      {"hands", sitting.hands},
                      {"right", sitting.right()},
                      {"judged", sitting.judged()}};
  if (state.walk.bug)
    json["bug"] = {
        {"mended", state.walk.bug->mended}, {"known", state.walk.bug->known}, {"hunted", state.bugs.hunt.has_value()}};
  json["predictions"] = {{"on", state.predictions.on},
                         {"asks", aim_origin(state).has_value()},
                         {"open", state.predictions.open.has_value()},
                         {"made", state.predictions.made.size()}};
  json["image"] = {
      {"done", preview.done()}, {"finished", preview.finished()}, {"hash", std::to_string(hash_of(preview.rgba()))}};
  json["window"] = {{"width", window.width},   {"height", window.height},
                    {"frames", window.frames}, {"first_frame", window.first_frame},
                    {"idle", window.idle},     {"typing", window.typing}};
  Json objects = Json::object(), lights = Json::object(), items = Json::object();
  for (const Object& object : state.scene().objects) objects[object.name] = place(middle(object.shape));
  for (const Light& light : state.scene().lights) {
    if (const auto middle = middle_of(light)) lights[light.name] = place(plan(*middle));
  }
  for (const auto& [name, rect] : interface.items()) items[name] = {rect.x, rect.y, rect.width, rect.height};
  json["objects"] = std::move(objects);
  json["lights"] = std::move(lights);
  json["eye"] = place(plan(state.scene().camera.eye));
  json["items"] = std::move(items);
  // Paths need not be UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace raywalk
