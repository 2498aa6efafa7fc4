// A scene may hold a million objects: it is copied, and made ready for tracing, only where that cannot be helped.

#include "view/action.h"
#include "view/fixtures.h"
#include "view/state.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a scene is walked and pictured as it stands, without a copy") {
  State state = classic_state();
  CHECK(&*walked_scene(state) == &state.scene());
  CHECK(&*pictured_scene(state) == &state.scene());
  CHECK_FALSE(state.document.saved);
  CHECK(&saved_scene(state) == &state.scene());
  update(state, action::Orbit{SpaceView::image, {0.4, 0.2}});
  CHECK(&*walked_scene(state) == &state.scene());
  const SceneSeen turned = pictured_scene(state);
  CHECK(&*turned != &state.scene());
  CHECK(turned->camera == image_camera(state));
  CHECK(turned->objects == state.scene().objects);
}

TEST_CASE("what is chosen for a scene that is seen stands in a copy, and the scene stays") {
  const Scene scene = busy_scene();
  SceneSeen seen(scene);
  seen.set(scene.camera);
  seen.set(scene.limits);
  seen.set(scene.render);
  CHECK(&*seen == &scene);
  TraceLimits limits = scene.limits;
  limits.depth += 1;
  seen.set(limits);
  const SceneSeen moved = std::move(seen);
  CHECK(moved->limits == limits);
  Scene expected = scene;
  expected.limits = limits;
  CHECK(*moved == expected);
  CHECK(scene.limits.depth == limits.depth - 1);
}

TEST_CASE("the scene as it was saved is kept beside the edited one, for as long as they differ") {
  State state = classic_state();
  const Scene before = state.scene();
  make_dirty(state);
  REQUIRE(state.document.dirty);
  CHECK(saved_scene(state) == before);
  CHECK(state.scene() != before);
  update(state, action::Undo{});
  CHECK_FALSE(state.document.dirty);
  CHECK_FALSE(state.document.saved);
  CHECK(saved_scene(state) == before);
}

TEST_CASE("walks of one scene share its world, until it is edited") {
  State state = classic_state();
  REQUIRE(state.document.worlds);
  const auto world = state.document.worlds->of<double>(*walked_scene(state));
  update(state, action::WalkPixel{30, 40, {63, 47}});
  REQUIRE(state.walk.pixel);
  CHECK(state.document.worlds->of<double>(*walked_scene(state)) == world);
  const State copy = state;
  const auto worlds = state.document.worlds;
  make_dirty(state);
  CHECK(state.document.worlds != worlds);
  CHECK(copy.document.worlds == worlds);
  CHECK(state.document.worlds->of<double>(*walked_scene(state)) != world);
}

TEST_CASE("a press copies no scene, only the first movement of something does") {
  State state = busy_state();
  const Scene before = state.scene();
  const Vec2d from = pixels_of(state, {TargetKind::object, 0});
  update(state, action::PointerPressed{from});
  REQUIRE(state.plan.drag);
  CHECK(state.plan.drag->scene == nullptr);
  update(state, action::PointerMoved{from + Vec2d(50, 0)});
  REQUIRE(state.plan.drag->scene);
  CHECK(*state.plan.drag->scene == before);
  update(state, action::PointerReleased{from + Vec2d(50, 0)});
  REQUIRE(state.document.undo.size() == 1);
  CHECK(std::get<Scene>(*state.document.undo.back()) == before);
}
