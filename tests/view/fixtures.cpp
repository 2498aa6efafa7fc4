#include "fixtures.h"
#include "view/structure/structure.h"
#include "view/tree/tree_panel.h"
#include "view/walk/status.h"

#include "view/plan/plan_geometry.h"
#include "view/space/lines_view.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "support/catch.h"
#include "support/languages.h"

namespace raywalk::test {

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(RAYWALK_SOURCE_DIR) + "/scenes"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  REQUIRE_FALSE(paths.empty());
  return paths;
}

SceneDocument read_document(const std::string& path) {
  Result<SceneDocument> document = read_scene(path);
  INFO(path << ": " << (document ? "" : document.error().text()));
  REQUIRE(document.has_value());
  return *document;
}

State state_of(const Scene& scene) {
  State state = make_state({scene, {}, {}});
  state.appearance.language = in_english;
  update(state, action::ResizePlan{{800, 600}});
  return state;
}

State classic_state() {
  const std::string path = std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml";
  State state = make_state(read_document(path), path);
  state.appearance.language = in_english;
  update(state, action::ResizePlan{{800, 600}});
  return state;
}

Scene busy_scene() {
  Scene scene;
  scene.title = "Busy";
  scene.background = Rgbd(0.1, 0.2, 0.3);
  scene.camera.eye = Vec3d(-6, 0, 0);
  scene.camera.look_at = Vec3d(0.0);
  scene.camera.screen = Screen{2, 2.4, 15};
  scene.limits = {4, 0.02};
  scene.lights.push_back({"Lamp", Rgbd(1.0), PointLight{Vec3d(-1, 4, 0), {}}});
  scene.lights.push_back({"Sun", Rgbd(0.3), DirectionalLight{Vec3d(0.3, -1, 0)}});
  Material mirror;
  mirror.diffuse = Rgbd(0.2);
  mirror.reflection = Rgbd(0.6);
  Material glass;
  glass.diffuse = Rgbd(0.02);
  glass.reflection = Rgbd(0.1);
  glass.transmission = Rgbd(0.8);
  glass.ior = 1.6;
  glass.shadow = ShadowKind::filtered;
  Material dark_glass = glass;
  dark_glass.dielectric = true;
  dark_glass.shadow = ShadowKind::opaque;
  scene.objects.push_back({"Mirror", Sphere<double>{Vec3d(1, 1.5, 0), 1}, mirror});
  scene.objects.push_back({"Glass", Sphere<double>{Vec3d(0, -0.5, 0), 0.8}, glass});
  scene.objects.push_back(
      {"Notch", Prism<double>{{{2.5, -2}, {4.5, -2}, {4.5, 0.8}, {3.5, -0.5}, {2.5, 0.4}}, 2}, dark_glass});
  scene.objects.push_back({"Wall", Plane<double>{Vec3d(6, 0, 0), Vec3d(-1, 0, 0)}, mirror});
  scene.objects.push_back({"Floor", Plane<double>{Vec3d(0, 0, -1), Vec3d(0, 0, 1)}, Material{}});
  return scene;
}

State busy_state() { return state_of(busy_scene()); }

int index_of_object(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].name == name) return static_cast<int>(i);
  FAIL("no object is called " << name);
  return -1;
}

Vec2d to_pixels(const State& state, const Vec2d& point) {
  return raywalk::to_pixels(state.plan.camera, state.plan.viewport, point);
}

Vec2d pixels_of(const State& state, const Target& target) {
  return to_pixels(state, place_of(state, target, state.plan.viewport));
}

const TextItem* text_with(const DisplayList& list, const std::string& part) {
  for (const DisplayItem& item : list)
    if (const auto* text = std::get_if<TextItem>(&item.shape);
        text != nullptr && text->text.find(part) != std::string::npos)
      return text;
  return nullptr;
}

bool has_text(const DisplayList& list, std::string_view words) {
  return std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
    const auto* said = std::get_if<TextItem>(&item.shape);
    return said != nullptr && said->text == words;
  });
}

std::vector<DisplayItem> items_of(const DisplayList& list, const Target& target) {
  std::vector<DisplayItem> items;
  std::copy_if(list.begin(), list.end(), std::back_inserter(items),
               [&](const DisplayItem& item) { return item.target == target; });
  return items;
}

void drag(State& state, const Vec2d& from, const Vec2d& to, action::Modifiers modifiers) {
  update(state, action::PointerMoved{from, modifiers});
  update(state, action::PointerPressed{from, action::Button::left, modifiers});
  update(state, action::PointerMoved{(from + to) / 2.0, modifiers});
  update(state, action::PointerMoved{to, modifiers});
  update(state, action::PointerReleased{to, modifiers});
}

void drag_by(State& state, const Target& target, const Vec2d& by, action::Modifiers modifiers) {
  const Vec2d from = pixels_of(state, target);
  const Target found = pick(state, from);
  INFO("target " << static_cast<int>(target.kind) << " " << target.index << " " << target.part << "; under the pointer "
                 << static_cast<int>(found.kind) << " " << found.index << " " << found.part);
  REQUIRE(found == target);
  drag(state, from, from + by, modifiers);
}

std::string broken_promise(const State& state) {
  if (!state.walk.timeline) return "no timeline";
  if (state.walk.position < 0 || state.walk.position > state.walk.timeline->steps())
    return "the position is off the timeline";
  if (state.walk.playing && state.walk.mode != Mode::trace) return "AUTO runs outside of trace mode";
  if (state.walk.playing && state.walk.position == state.walk.timeline->steps()) return "AUTO runs at the end";
  const SceneDocument& document = state.document.contents;
  const Result<std::string> written = format_scene(state.scene(), {}, document.ink);
  if (!written) return "the scene cannot be saved: " + written.error().text();
  if (state.document.dirty !=
      (state.scene() != saved_scene(state) || document.ink_of_file() != state.document.saved_ink))
    return "dirty tells a lie";
  if (state.bugs.hunt && !state.walk.bug) return "a hunt without a bug";
  if (state.walk.bug && !state.walk.bug->other) return "nothing to compare the bug with";
  if (state.bugs.shown && state.lessons.shown) return "two panes in one place";
  if (!exists(state, state.plan.selected)) return "something is selected that is not there";
  if (!exists(state, state.plan.hovered)) return "something is hovered that is not there";
  if (state.plan.hovered_ray >= static_cast<int>(state.walk.timeline->rays().size()))
    return "a ray is hovered that is not there";
  if (!std::isfinite(state.plan.camera.centre.x) || !std::isfinite(state.plan.camera.centre.y))
    return "the plan is nowhere";
  if (!(state.plan.camera.pixels_per_unit > 0) || !std::isfinite(state.plan.camera.pixels_per_unit))
    return "the zoom is broken";
  if (!is_finite(plan_view(state))) return "a number of the plan is not finite";
  if (shows_lines(state) && !is_finite(lines_view(state, state.plan.viewport)))
    return "a number of the lines is not finite";
  for (const TreeNode& node : tree_panel(state).nodes)
    if (!std::isfinite(node.x) || !std::isfinite(node.y)) return "a number of the tree is not finite";
  if (sentence(state).empty()) return "no sentence";
  if (structure_step(state) < 0 || structure_step(state) > structure_steps(state))
    return "a search goes on past its end";
  if (shows_structure(state) && structure_panel(state).sentence.empty()) return "no sentence about the structure";
  return {};
}

void make_dirty(State& state) {
  Material material = state.scene().objects[0].material;
  material.shininess += 1;
  update(state, action::SetMaterial{0, material});
  REQUIRE(state.document.dirty);
}

void crash(State& state) { state.document.autosave_hold.reset(); }

State saved_state(const TemporaryFolder& folder, const std::string& name) {
  State state = state_of(busy_scene());
  state.document.state_dir = folder.file("state");
  update(state, action::SaveAs{folder.file(name)});
  REQUIRE_FALSE(state.document.dirty);
  return state;
}

}  // namespace raywalk::test
