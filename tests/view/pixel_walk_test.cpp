// Pixels of the 3-D picture: walked, drawn as lines in space, and the picture's own camera.
#include "fixtures.h"
#include "render/render.h"
#include "view/plan/painter.h"
#include "view/space/lines_view.h"
#include "view/space/orbit.h"
#include "view/space/outlines.h"
#include "view/tree/tree_panel.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State shipped(const std::string& name) {
  for (const std::string& path : shipped_scenes())
    if (path.ends_with("/" + name + ".toml")) return state_of(read_document(path).scene);
  FAIL("no scene " << name);
  return classic_state();
}

}  // namespace

TEST_CASE("a walked pixel ends in the very colour of the picture, of the scene's camera and of a turned one") {
  State state = shipped("whitted");
  for (const bool turned : {false, true}) {
    if (turned) update(state, action::Orbit{SpaceView::image, {0.4, 0.2}});
    const ImageSize size{63, 47};
    RenderSettings settings;
    settings.size = size;
    const auto rendering = render(*pictured_scene(state), settings);
    REQUIRE(rendering);
    const Film<double>& film = rendering->film_of<double>();
    for (const auto& [column, row] : {std::pair{3, 40}, {30, 20}, {31, 30}, {40, 25}, {62, 0}}) {
      update(state, action::WalkPixel{column, row, size});
      REQUIRE(state.walk.timeline->pixels().size() == 1);
      CHECK(state.walk.timeline->pixels()[0].shade == film.at(column, row));
      CHECK(state.walk.position == state.walk.timeline->steps());
      CHECK(state.walk.mode == Mode::trace);
      CHECK(state.appearance.tab == PictureRoom::tab);
      CHECK_FALSE(tree_panel(state).nodes.empty());
      CHECK(shows_lines(state));
      CHECK(broken_promise(state) == "");
    }
  }
}

TEST_CASE("names in space keep off the rays of a picture's pixel, and stay where they are during its walk") {
  State state = shipped("whitted");
  update(state, action::ResizePlan{{858, 480}});
  update(state, action::WalkPixel{150, 130, {320, 240}});
  REQUIRE(shows_lines(state));
  std::vector<Vec2d> before;
  for (int position = state.walk.timeline->steps(); position > 0; position -= 5) {
    update(state, action::Jump{position});
    const DisplayList list = lines_view(state, state.plan.viewport);
    std::vector<Vec2d> now;
    for (const char* name : {"Glass Sphere", "Mirror Sphere"}) {
      const TextItem* said = text_with(list, name);
      REQUIRE(said != nullptr);
      now.push_back(said->at);
      const Vec2d half(text_width(said->text, said->size) / 2, said->size / 2);
      for (const DisplayItem& item : list)
        if (const auto* ray = std::get_if<LineItem>(&item.shape); ray != nullptr && item.target.kind == TargetKind::ray)
          CHECK_FALSE(PixelRect{said->at - half, said->at + half}.meets(ray->from, ray->to));
    }
    CHECK((before.empty() || before == now));
    before = now;
  }
}

TEST_CASE("by pixels, a walk of the picture goes on with the next one, row by row, and back") {
  State state = shipped("whitted");
  const ImageSize size{5, 4};
  update(state, action::WalkPixel{3, 1, size});
  std::vector<std::pair<int, int>> walked;
  const auto step = [&](bool forward) {
    update(state, action::Step{forward, Grain::pixel});
    walked.emplace_back(state.walk.pixel->column, state.walk.pixel->row);
    CHECK(state.walk.timeline->pixels().size() == 1);
  };
  for (int i = 0; i < 2; ++i) step(true);
  CHECK(walked == std::vector<std::pair<int, int>>{{4, 1}, {0, 2}});
  // Back: first to the beginning of this one.
  walked.clear();
  for (int i = 0; i < 3; ++i) step(false);
  CHECK(walked == std::vector<std::pair<int, int>>{{0, 2}, {4, 1}, {4, 1}});
  // By lines it stays where it is; so it does at the end of the picture, and seen from elsewhere.
  update(state, action::WalkPixel{3, 1, size});
  update(state, action::Step{true, Grain::line});
  CHECK(state.walk.pixel->column == 3);
  update(state, action::WalkPixel{4, 3, size});
  CHECK_FALSE(neighbour(state, true));
  update(state, action::Orbit{SpaceView::image, {0.4, 0.2}});
  update(state, action::Jump{0});
  CHECK_FALSE(neighbour(state, false));
}

TEST_CASE("a pixel on the row of a planar scene's strip goes to its cell, in the plan") {
  State state = classic_state();
  REQUIRE(state.walk.planar);
  update(state, action::WalkPixel{220, 100, {441, 331}});
  CHECK(shows_lines(state));
  CHECK(current_cell(state) == -1);
  update(state, action::WalkPixel{220, 165, {441, 331}});
  CHECK_FALSE(state.walk.pixel);
  CHECK_FALSE(shows_lines(state));
  CHECK(current_cell(state) == 10);
  CHECK(state.walk.timeline->pixels().size() == 21);
  // Turned, that row is the strip's no more.
  update(state, action::Orbit{SpaceView::image, {0.3, 0}});
  update(state, action::WalkPixel{220, 165, {441, 331}});
  REQUIRE(state.walk.pixel);
  CHECK(state.walk.pixel->camera == state.picture.camera);
}

TEST_CASE("turning the picture changes neither the scene nor its file, until it is asked for, and that is undone") {
  State state = classic_state();
  const Scene scene = state.scene();
  const std::uint64_t before = state.picture.revision;
  update(state, action::Orbit{SpaceView::image, {0.3, 0.2}});
  update(state, action::Shift{SpaceView::image, {0.1, 0}});
  update(state, action::Approach{SpaceView::image, 1.5});
  CHECK(state.scene() == scene);
  CHECK_FALSE(state.document.dirty);
  CHECK(state.document.undo.empty());
  CHECK(state.picture.revision > before);
  const Camera turned = image_camera(state);
  CHECK(turned != scene.camera);

  update(state, action::UseImageCamera{});
  CHECK(state.scene().camera == turned);
  CHECK(state.document.dirty);
  CHECK_FALSE(state.picture.camera);
  CHECK_FALSE(state.walk.planar);
  update(state, action::Undo{});
  CHECK(state.scene() == scene);

  update(state, action::Orbit{SpaceView::image, {0.3, 0.2}});
  update(state, action::ResetView{SpaceView::image});
  CHECK(image_camera(state) == scene.camera);
}

TEST_CASE("a walked pixel is recorded again when the scene changes, and left when SCREEN is asked for") {
  State state = classic_state();
  update(state, action::WalkPixel{130, 140, {441, 331}});
  const Rgbd before = state.walk.timeline->pixels()[0].shade;
  Material material = state.scene().objects[0].material;
  material.diffuse = material.diffuse * 0.5;
  update(state, action::SetMaterial{0, material});
  REQUIRE(state.walk.pixel);
  CHECK(state.walk.timeline->pixels()[0].shade != before);
  CHECK(state.walk.position == state.walk.timeline->steps());
  update(state, action::WalkStrip{});
  CHECK(state.walk.timeline->of_strip());
  CHECK(broken_promise(state) == "");
}

TEST_CASE("lines stand for every object, the lights, EYE and every ray of the walk") {
  State state = shipped("quadrics");
  CHECK_FALSE(state.walk.planar);
  update(state, action::WalkPixel{200, 200, {441, 331}});
  const DisplayList list = lines_view(state, {860, 480});
  CHECK(is_finite(list));
  for (int i = 0; i < static_cast<int>(state.scene().objects.size()); ++i) {
    CAPTURE(state.scene().objects[static_cast<std::size_t>(i)].name);
    CHECK_FALSE(items_of(list, {TargetKind::object, i}).empty());
  }
  for (int i = 0; i < static_cast<int>(state.scene().lights.size()); ++i)
    CHECK_FALSE(items_of(list, {TargetKind::light, i}).empty());  // a sun, too
  CHECK_FALSE(items_of(list, {TargetKind::eye}).empty());
  int drawn = 0;
  for (int i = 0; i < static_cast<int>(state.walk.timeline->rays().size()); ++i)
    drawn += items_of(list, {TargetKind::ray, i}).empty() ? 0 : 1;
  CHECK(drawn == static_cast<int>(state.walk.timeline->rays().size()));
  // At the start nothing is drawn of rays.
  update(state, action::Clear{});
  for (const DisplayItem& item : lines_view(state, {860, 480})) CHECK(item.target.kind != TargetKind::ray);
}

TEST_CASE("a ray of the line view is picked where it is drawn, with the kind's own colour and dashes") {
  State state = shipped("whitted");
  update(state, action::WalkPixel{200, 150, {441, 331}});
  const Viewport pane{860, 480};
  std::set<RayKind> kinds;
  for (const DisplayItem& item : lines_view(state, pane)) {
    const auto* line = std::get_if<LineItem>(&item.shape);
    if (line == nullptr || item.target.kind != TargetKind::ray || line->arrow == 0) continue;
    const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(item.target.index)];
    const RayStyle& style = ray_style(state.appearance.theme, ray.kind);
    CHECK(line->stroke.colour.with_alpha(255) == style.colour);
    CHECK(line->stroke.dash.count == style.dash.count);
    kinds.insert(ray.kind);
    const Vec2d middle = line->from + 0.5 * (line->to - line->from);
    const Target picked = pick_in_lines(state, pane, middle);
    CHECK(picked.kind == TargetKind::ray);
  }
  CHECK(kinds.size() == 4);
}

TEST_CASE("the points of an outline lie on the surface") {
  for (const char* name : {"quadrics", "classic", "whitted"}) {
    const Scene scene = shipped(name).scene();
    const Bounds<double> room = room_of(scene);
    for (const Object& object : scene.objects) {
      CAPTURE(name, object.name);
      const std::vector<Polyline> curves = outline_of(object, room);
      REQUIRE_FALSE(curves.empty());
      const auto* sphere = std::get_if<Sphere<double>>(&object.shape);
      const auto* plane = std::get_if<Plane<double>>(&object.shape);
      Bounds<double> drawn;
      for (const Polyline& curve : curves)
        for (const Vec3d& point : curve) {
          drawn.include(point);
          if (sphere != nullptr && object.transform.empty())
            CHECK(length(point - sphere->centre) == Approx(sphere->radius));
          if (plane != nullptr && object.transform.empty())
            CHECK(std::abs(dot(point - plane->point, normalize(plane->normal))) < 1e-9);
        }
      const Bounds<double> box = bounds(object.shape);
      if (!box.bounded() || !object.transform.empty()) continue;
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(drawn.min[axis] == Approx(box.min[axis]).epsilon(0).margin(1e-6));
        CHECK(drawn.max[axis] == Approx(box.max[axis]).epsilon(0).margin(1e-6));
      }
    }
  }
}

TEST_CASE("settings of the picture are kept within their limits, and the walk has its precision") {
  State state = classic_state();
  ImageSettings settings;
  settings.samples = 1 << 30;
  update(state, action::SetImageSettings{settings});
  CHECK(state.picture.settings.samples == max_image_samples);
  const Rgbd in_double = state.walk.timeline->pixels()[10].shade;
  settings.single_precision = true;
  update(state, action::SetImageSettings{settings});
  const Rgbd in_float = state.walk.timeline->pixels()[10].shade;
  CHECK(in_float != in_double);
  CHECK(length(in_float - in_double) < 1e-4);
  CHECK_FALSE(state.document.dirty);
}
