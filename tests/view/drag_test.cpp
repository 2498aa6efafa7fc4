#include "fixtures.h"
#include "view/plan/plan_geometry.h"

#include <algorithm>
#include <numbers>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const Sphere<double>& sphere(const State& state, int object) {
  return std::get<Sphere<double>>(state.scene().objects[static_cast<std::size_t>(object)].shape);
}
const Prism<double>& prism(const State& state, int object) {
  return std::get<Prism<double>>(state.scene().objects[static_cast<std::size_t>(object)].shape);
}
double unit(const State& state) { return 1 / state.plan.camera.pixels_per_unit; }

constexpr action::Modifiers shift{true, false, false};
constexpr action::Modifiers control{false, true, false};

}  // namespace

TEST_CASE("dragging a body moves it as far as the pointer") {
  State state = busy_state();
  const Vec3d before = sphere(state, 0).centre;
  drag_by(state, {TargetKind::object, 0}, {40, -25});
  CHECK(sphere(state, 0).centre.x == Approx(before.x + 40 * unit(state)));
  CHECK(sphere(state, 0).centre.y == Approx(before.y + 25 * unit(state)));
  CHECK(sphere(state, 0).centre.z == 0);
  CHECK(state.plan.selected == Target{TargetKind::object, 0});
  CHECK(state.document.undo.size() == 1);
}

TEST_CASE("a drag is one entry of undo, whatever the way") {
  State state = busy_state();
  const Scene before = state.scene();
  const Vec2d from = pixels_of(state, {TargetKind::object, 0});
  update(state, action::PointerPressed{from});
  for (int i = 0; i < 50; ++i) update(state, action::PointerMoved{from + Vec2d(i * 3 % 70, i * 5 % 60)});
  update(state, action::PointerMoved{from + Vec2d(10, 20)});
  update(state, action::PointerReleased{from + Vec2d(10, 20)});
  CHECK(state.document.undo.size() == 1);
  State straight = busy_state();
  drag(straight, from, from + Vec2d(10, 20));
  CHECK(straight.scene() == state.scene());
  update(state, action::Undo{});
  CHECK(state.scene() == before);
}

TEST_CASE("a click without a movement changes nothing and selects") {
  State state = busy_state();
  const Scene before = state.scene();
  drag_by(state, {TargetKind::object, 1}, {1, 1});
  CHECK(state.scene() == before);
  CHECK(state.document.undo.empty());
  CHECK(state.plan.selected == Target{TargetKind::object, 1});
}

TEST_CASE("a drag that is taken back leaves no trace") {
  State state = busy_state();
  update(state, action::SetLimits{{3, 0}});
  update(state, action::Undo{});
  const Scene before = state.scene();
  const Vec2d from = pixels_of(state, {TargetKind::object, 0});
  update(state, action::PointerPressed{from});
  update(state, action::PointerMoved{from + Vec2d(100, 0)});
  CHECK(state.scene() != before);
  update(state, action::CancelDrag{});
  CHECK(state.scene() == before);
  CHECK_FALSE(state.plan.drag);
  CHECK(state.document.undo.empty());
  CHECK(state.document.redo.size() == 1);
}

TEST_CASE("an action in the middle of a drag ends it first") {
  State state = busy_state();
  const Scene before = state.scene();
  const Vec2d from = pixels_of(state, {TargetKind::object, 0});
  update(state, action::PointerPressed{from});
  update(state, action::PointerMoved{from + Vec2d(100, 0)});
  update(state, action::Undo{});
  CHECK_FALSE(state.plan.drag);
  CHECK(state.scene() == before);
  CHECK(state.document.redo.size() == 1);
}

TEST_CASE("Shift keeps a body on one axis, Control puts it on the grid") {
  State state = busy_state();
  const Vec3d before = sphere(state, 0).centre;
  drag_by(state, {TargetKind::object, 0}, {40, -25}, shift);
  CHECK(sphere(state, 0).centre.x == Approx(before.x + 40 * unit(state)));
  CHECK(sphere(state, 0).centre.y == before.y);
  drag_by(state, {TargetKind::object, 0}, {13, 44}, control);
  const double grid = grid_step(state.plan.camera);
  const Vec2d steps = plan(sphere(state, 0).centre) / grid;
  CHECK(steps.x == Approx(std::round(steps.x)).epsilon(0).margin(1e-9));
  CHECK(steps.y == Approx(std::round(steps.y)).epsilon(0).margin(1e-9));
}

TEST_CASE("the radius handle changes the radius and nothing goes below zero") {
  State state = busy_state();
  const double before = sphere(state, 0).radius;
  const Vec2d outwards(std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2);
  drag_by(state, {TargetKind::radius, 0}, 30.0 * outwards);
  CHECK(sphere(state, 0).radius == Approx(before + 30 * unit(state)));
  const Vec2d centre = pixels_of(state, {TargetKind::object, 0});
  drag(state, pixels_of(state, {TargetKind::radius, 0}), centre);
  CHECK(sphere(state, 0).radius > 0);
  CHECK(sphere(state, 0).radius < before);
  CHECK(broken_promise(state) == "");
}

TEST_CASE("a light with a radius has a handle for it, and no other light has") {
  Scene scene = busy_scene();
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{Vec3d(1, 2, 0), {}}},
                  {"Bulb", Rgbd(1.0), SphereLight{Vec3d(-2, 1, 0), 0.4, 3, {}}}};
  State state = state_of(scene);
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(exists(state, {TargetKind::light_radius, 0}));
  const Target handle{TargetKind::light_radius, 1};
  REQUIRE(exists(state, handle));
  CHECK(items_of(plan_view(state, state.plan.viewport), handle).size() == 1);
  const auto radius = [&] { return std::get<SphereLight>(state.scene().lights[1].kind).radius; };
  drag_by(state, handle, {30, -30});
  CHECK(radius() == Approx(0.4 + std::sqrt(2.0) * 30 * unit(state)));
  CHECK(state.plan.selected == Target{TargetKind::light, 1});
  CHECK(std::get<SphereLight>(state.scene().lights[1].kind).position == Vec3d(-2, 1, 0));
  drag_by(state, handle, {-500, 500});
  CHECK(radius() > 0);
  update(state, action::Undo{});
  update(state, action::Undo{});
  CHECK(radius() == 0.4);
}

TEST_CASE("a polygon as small as its handles is taken hold of itself; seen larger, by its corners") {
  State state = busy_state();
  update(state, action::SetMode{Mode::move});
  const Target corner{TargetKind::corner, 2, 0};
  const Vec2d middle = pixels_of(state, {TargetKind::object, 2});
  REQUIRE(items_of(plan_view(state, state.plan.viewport), corner).size() == 1);
  update(state, action::Zoom{middle, 0.05});
  CHECK(items_of(plan_view(state, state.plan.viewport), corner).empty());
  CHECK(pick(state, state.plan.viewport, pixels_of(state, {TargetKind::object, 2})).kind != TargetKind::corner);
  update(state, action::Zoom{pixels_of(state, {TargetKind::object, 2}), 20});
  CHECK(items_of(plan_view(state, state.plan.viewport), corner).size() == 1);
}

TEST_CASE("a corner follows the pointer until edges would cross") {
  State state = busy_state();
  const Vec2d before = prism(state, 2).corner(1);
  drag_by(state, {TargetKind::corner, 2, 1}, {20, 10});
  CHECK(prism(state, 2).corner(1).x == Approx(before.x + 20 * unit(state)));
  CHECK(state.plan.selected == Target{TargetKind::corner, 2, 1});
  // Straight through the opposite edge.
  const Vec2d from = pixels_of(state, {TargetKind::corner, 2, 1});
  drag(state, from, to_pixels(state, Vec2d(3.5, 0.5)));
  CHECK(why_not_polygon(prism(state, 2).corners).empty());
  CHECK(broken_promise(state) == "");
}

TEST_CASE("a refused corner says why") {
  State state = busy_state();
  const Vec2d from = pixels_of(state, {TargetKind::corner, 2, 1});
  update(state, action::PointerPressed{from});
  update(state, action::PointerMoved{to_pixels(state, Vec2d(3.5, 0.5))});
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->kind == Notice::Kind::error);
  update(state, action::PointerMoved{from + Vec2d(20, 0)});
  CHECK_FALSE(state.document.notice);
}

TEST_CASE("the rotation handle turns the polygon about its middle, with Shift by multiples of 15 degrees") {
  State state = busy_state();
  const Vec2d centre = centroid(prism(state, 2));
  const Prism<double> before = prism(state, 2);
  const Vec2d from = pixels_of(state, {TargetKind::rotation, 2});
  const Vec2d pivot = to_pixels(state, centre);
  const double arm = length(from - pivot);
  // A quarter turn clockwise, not quite hit.
  drag(state, from, pivot + Vec2d(arm, 0.04 * arm), shift);
  CHECK(length(centroid(prism(state, 2)) - centre) < 1e-9);
  for (int i = 0; i < before.sides(); ++i) {
    const Vec2d there = turned(before.corner(i), centre, -std::numbers::pi / 2);
    CHECK(length(prism(state, 2).corner(i) - there) < 1e-9);
  }
}

TEST_CASE("EYE takes the view along; the direction handle turns it") {
  State state = busy_state();
  const Camera before = state.scene().camera;
  drag_by(state, {TargetKind::eye}, {15, 30});
  const Camera moved = state.scene().camera;
  CHECK(moved.eye.y == Approx(before.eye.y - 30 * unit(state)));
  CHECK(length((moved.look_at - moved.eye) - (before.look_at - before.eye)) < 1e-12);
  drag_by(state, {TargetKind::view_direction}, {0, -40});
  const Camera turned = state.scene().camera;
  CHECK(turned.eye == moved.eye);
  CHECK(length(turned.look_at - turned.eye) == Approx(length(moved.look_at - moved.eye)));
  CHECK(turned.look_at.y > moved.look_at.y);
  CHECK(is_planar(state.scene()));
}

TEST_CASE("SCREEN's handles set its length and its distance") {
  State state = busy_state();
  const Screen before = state.scene().camera.screen;
  drag_by(state, {TargetKind::screen_height, -1, 0}, {0, -20});
  CHECK(*state.scene().camera.screen.width == Approx(*before.width + 40 * unit(state)));
  drag_by(state, {TargetKind::screen_height, -1, 1}, {0, -20});
  CHECK(*state.scene().camera.screen.width == Approx(*before.width));
  drag_by(state, {TargetKind::screen_distance}, {25, 0});
  CHECK(state.scene().camera.screen.distance == Approx(before.distance + 25 * unit(state)));
  // Behind EYE and folded over: both stay above zero.
  drag_by(state, {TargetKind::screen_distance}, {-600, 0});
  CHECK(state.scene().camera.screen.distance > 0);
  CHECK(broken_promise(state) == "");
}

TEST_CASE("SCREEN's height sets the angle of a camera that states one") {
  Scene scene = busy_scene();
  scene.camera.screen.width.reset();
  scene.camera.fov = FieldOfView{50, FovAxis::x};
  State state = state_of(scene);
  drag_by(state, {TargetKind::screen_height, -1, 0}, {0, -20});
  CHECK(state.scene().camera.fov->degrees > 50);
  CHECK_FALSE(state.scene().camera.screen.width);
  drag_by(state, {TargetKind::screen_height, -1, 1}, {0, -2000});
  CHECK(state.scene().camera.fov->degrees > 0);
  CHECK(broken_promise(state) == "");
}

TEST_CASE("lights are dragged: a point light moves, a directional one turns") {
  State state = busy_state();
  drag_by(state, {TargetKind::light, 0}, {-30, 12});
  CHECK(std::get<PointLight>(state.scene().lights[0].kind).position.x == Approx(-1 - 30 * unit(state)));
  const Vec3d before = std::get<DirectionalLight>(state.scene().lights[1].kind).direction;
  drag_by(state, {TargetKind::light, 1}, {60, 0});
  const Vec3d after = std::get<DirectionalLight>(state.scene().lights[1].kind).direction;
  CHECK(length(after) == Approx(length(before)));
  CHECK(after.x > before.x);
}

TEST_CASE("objects dragged onto the eye, into another, onto the light, or out of the view break nothing") {
  for (const Target& place : {Target{TargetKind::eye}, Target{TargetKind::object, 1}, Target{TargetKind::light, 0},
                              Target{TargetKind::screen_distance}, Target{TargetKind::object, 2}}) {
    State state = busy_state();
    const Vec2d to = pixels_of(state, place);
    drag(state, pixels_of(state, {TargetKind::object, 0}), to);
    CHECK(length(plan(sphere(state, 0).centre) - to_scene(state.plan.camera, state.plan.viewport, to)) < 1e-9);
    CHECK(broken_promise(state) == "");
    update(state, action::Jump{1 << 20});
    CHECK(broken_promise(state) == "");
  }
  State state = busy_state();
  drag(state, pixels_of(state, {TargetKind::object, 0}), {-1e9, 1e9});
  CHECK(broken_promise(state) == "");
  drag(state, pixels_of(state, {TargetKind::eye}), {1e300, 1e300});
  CHECK(broken_promise(state) == "");
  update(state, action::FitView{});
  CHECK(broken_promise(state) == "");
}

TEST_CASE("the eye dragged into a body, onto the light and onto what it looks at breaks nothing") {
  for (const Target& place :
       {Target{TargetKind::object, 0}, Target{TargetKind::object, 1}, Target{TargetKind::light, 0}}) {
    State state = busy_state();
    drag(state, pixels_of(state, {TargetKind::eye}), pixels_of(state, place));
    update(state, action::Jump{1 << 20});
    CHECK(broken_promise(state) == "");
  }
  State state = busy_state();
  drag(state, pixels_of(state, {TargetKind::view_direction}), pixels_of(state, {TargetKind::eye}));
  CHECK(broken_promise(state) == "");
}

TEST_CASE("a double click on an edge adds a corner") {
  State state = busy_state();
  const Vec2d at = to_pixels(state, Vec2d(3.0, -2));
  REQUIRE(pick(state, at) == Target{TargetKind::edge, 2, 0});
  update(state, action::PointerPressed{at, action::Button::left, {}, true});
  update(state, action::PointerReleased{at});
  CHECK(prism(state, 2).sides() == 6);
  CHECK(length(prism(state, 2).corner(1) - Vec2d(3.0, -2)) < 1e-9);
  update(state, action::RemoveSelected{});
  CHECK(prism(state, 2).sides() == 5);
}

TEST_CASE("dragging the empty plan moves it, zooming keeps the point under the pointer, fitting undoes both") {
  State state = busy_state();
  const PlanCamera fitted = state.plan.camera;
  const Vec2d at(30, 570);
  REQUIRE_FALSE(pick(state, at));
  const Vec2d there = to_scene(state.plan.camera, state.plan.viewport, at);
  drag(state, at, at + Vec2d(50, -40));
  CHECK(length(to_scene(state.plan.camera, state.plan.viewport, at + Vec2d(50, -40)) - there) < 1e-9);
  CHECK(state.document.undo.empty());
  const Vec2d kept = to_scene(state.plan.camera, state.plan.viewport, {200, 100});
  update(state, action::Zoom{{200, 100}, 3});
  CHECK(length(to_scene(state.plan.camera, state.plan.viewport, {200, 100}) - kept) < 1e-9);
  CHECK(state.plan.camera.pixels_per_unit == Approx(3 * fitted.pixels_per_unit));
  for (int i = 0; i < 200; ++i) update(state, action::Zoom{{200, 100}, i < 100 ? 10 : 0.1});
  CHECK(broken_promise(state) == "");
  update(state, action::FitView{});
  CHECK(state.plan.camera == fitted);
}

TEST_CASE("the right button and trace mode only move the plan") {
  State state = busy_state();
  const Scene before = state.scene();
  const Vec2d at = pixels_of(state, {TargetKind::object, 0});
  update(state, action::PointerPressed{at, action::Button::right});
  update(state, action::PointerMoved{at + Vec2d(40, 40)});
  update(state, action::PointerReleased{at + Vec2d(40, 40)});
  CHECK(state.scene() == before);
  CHECK_FALSE(state.plan.camera.fitted);
  update(state, action::SetMode{Mode::trace});
  drag(state, pixels_of(state, {TargetKind::object, 0}), {100, 100});
  CHECK(state.scene() == before);
}

TEST_CASE("a click on a cell or a ray in trace mode goes there") {
  State state = classic_state();
  update(state, action::Jump{state.walk.timeline->steps()});
  const Vec2d cell = pixels_of(state, {TargetKind::cell, 4});
  REQUIRE(pick(state, cell) == Target{TargetKind::cell, 4});
  drag(state, cell, cell);
  CHECK(current_cell(state) == 4);
  CHECK_FALSE(state.plan.selected);
  update(state, action::Jump{state.walk.timeline->steps()});
  const int ray = 3;
  const RayRecord& record = state.walk.timeline->rays()[ray];
  const Vec2d on_ray = to_pixels(state, plan(record.origin + 0.4 * (record.end - record.origin)));
  const Target under = pick(state, on_ray);
  REQUIRE(under.kind == TargetKind::ray);
  drag(state, on_ray, on_ray);
  CHECK(state.walk.timeline->current_ray(state.walk.position) == under.index);
}

TEST_CASE("a resized pane stays fitted until it is zoomed by hand") {
  State state = busy_state();
  update(state, action::ResizePlan{{400, 300}});
  CHECK(state.plan.camera == fit(state.scene(), state.plan.viewport));
  update(state, action::Zoom{{10, 10}, 2});
  const PlanCamera camera = state.plan.camera;
  update(state, action::ResizePlan{{500, 500}});
  CHECK(state.plan.camera == camera);
  for (const Viewport& tiny : {Viewport{0, 0}, Viewport{1, 1}, Viewport{-5, 3}}) {
    update(state, action::ResizePlan{tiny});
    update(state, action::FitView{});
    CHECK(broken_promise(state) == "");
  }
}

TEST_CASE("what was dropped onto another body can be taken up again") {
  State state = classic_state();
  const int glass = index_of_object(state.scene(), "Transparent Sphere");
  const int polygon = index_of_object(state.scene(), "Polygon");
  const Vec2d onto = pixels_of(state, {TargetKind::object, polygon});
  drag(state, pixels_of(state, {TargetKind::object, glass}), onto);
  CHECK(pick(state, state.plan.viewport, onto) == Target{TargetKind::object, glass});
  const Scene covered = state.scene();
  drag(state, onto, onto - Vec2d(150, 0));
  CHECK(state.scene().objects[static_cast<std::size_t>(polygon)] == covered.objects[static_cast<std::size_t>(polygon)]);
  CHECK(state.scene().objects[static_cast<std::size_t>(glass)] != covered.objects[static_cast<std::size_t>(glass)]);
}

TEST_CASE("a floor and a ceiling leave what stands between them to the pointer, wherever they are in the file") {
  State state = classic_state();
  update(state, action::Open{RAYWALK_SOURCE_DIR "/scenes/radiosity.toml"});
  update(state, action::SetMode{Mode::move});
  for (const char* name : {"Block", "Lamp", "Red wall", "Back wall"}) {
    CAPTURE(name);
    const Target target{TargetKind::object, index_of_object(state.scene(), name)};
    CHECK(pick(state, pixels_of(state, target)) == target);
  }
  const Vec2d nothing_there = pixels_of(state, {TargetKind::object, index_of_object(state.scene(), "Floor")});
  CHECK(pick(state, nothing_there) == Target{TargetKind::object, index_of_object(state.scene(), "Floor")});
}

TEST_CASE("a finger takes a handle within 22 pixels, and a body where its middle is nearer") {
  State state = busy_state();
  const Target handle{TargetKind::radius, 0};
  const Vec2d at = pixels_of(state, handle), middle = pixels_of(state, {TargetKind::object, 0});
  const Vec2d outwards = (at - middle) / length(at - middle);
  REQUIRE(length(at - middle) > 12);
  const auto under = [&](const Vec2d& place) { return pick(state, place); };
  CHECK(under(at + 21.0 * outwards) != handle);
  update(state, action::SetTouch{true});
  CHECK(under(at + 21.0 * outwards) == handle);
  CHECK(under(at + 23.0 * outwards) != handle);
  CHECK(under(at - std::min(21.0, 0.4 * length(at - middle)) * outwards) == handle);
  CHECK(under(middle + 0.4 * (at - middle)) == Target{TargetKind::object, 0});
  CHECK(under(middle) == Target{TargetKind::object, 0});
}

TEST_CASE("that everything is drawn smaller is told by the window, also during a drag and beside a question") {
  State state = busy_state();
  const Vec2d at = pixels_of(state, {TargetKind::object, 0});
  update(state, action::PointerMoved{at, {}});
  update(state, action::PointerPressed{at, action::Button::left, {}});
  update(state, action::SetFitted{true});
  CHECK(state.appearance.is_fitted);
  update(state, action::PointerMoved{at + Vec2d(30, 0), {}});
  update(state, action::PointerReleased{at + Vec2d(30, 0), {}});
  CHECK(length(pixels_of(state, {TargetKind::object, 0}) - at) > 20);
  make_dirty(state);
  update(state, action::New{});
  REQUIRE(state.document.question);
  update(state, action::SetFitted{false});
  CHECK_FALSE(state.appearance.is_fitted);
  CHECK(state.document.question);
}
