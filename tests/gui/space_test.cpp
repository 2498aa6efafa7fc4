// The 3-D picture and the line view under the mouse and the keyboard.

#include "gui/bench.h"
#include "support/catch.h"
#include "view/space/lines_view.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State tracing() {
  State state = classic();
  update(state, action::SetMode{Mode::trace});
  update(state, action::SetTab{PictureRoom::tab});
  return state;
}

void click_at(Bench& bench, const Rect& image, float across, float down) {
  bench.move_to(image.x + across * image.width, image.y + down * image.height);
  bench.press();
  bench.release();
  bench.frames(3);
}

}  // namespace

TEST_CASE("a click in the 3-D picture walks that pixel, on the marked row its cell") {
  Bench bench(tracing());
  bench.frames(3);
  click_at(bench, bench.rect("image"), 0.7f, 0.25f);
  const auto* walk = bench.last<action::WalkPixel>();
  REQUIRE(walk != nullptr);
  CHECK(std::abs(walk->column - 308) <= 2);
  CHECK(std::abs(walk->row - 82) <= 2);
  CHECK(bench.state.walk.pixel);
  // The picture stays, with the tree beside it, so that the next pixel can be clicked.
  CHECK(bench.state.appearance.tab == PictureRoom::tab);
  const Rect image = bench.rect("image"), tree = bench.rect("tree-beside/pane");
  CHECK(image.right() <= tree.x);
  CHECK(bench.has("node-0"));
  CHECK(bench.has("lines"));
  bench.click("walk-strip");
  bench.frames(2);
  CHECK_FALSE(bench.state.walk.pixel);
  CHECK_FALSE(bench.has("lines"));
  // Without rays there is no tree, and the picture has its room.
  CHECK_FALSE(bench.has("tree-beside/pane"));
  CHECK(bench.rect("image").width >= image.width);
  click_at(bench, bench.rect("image"), 0.5f, 0.5f);
  CHECK_FALSE(bench.state.walk.pixel);
  CHECK(current_cell(bench.state) == 10);
}

TEST_CASE("dragging turns the picture, with Shift or the right button it moves, the wheel comes nearer") {
  Bench bench(tracing());
  bench.frames(3);
  const Camera own = bench.state.scene().camera;
  bench.drag("image", 40, 15);
  REQUIRE(bench.last<action::Orbit>() != nullptr);
  CHECK(bench.last<action::WalkPixel>() == nullptr);
  CHECK(bench.state.picture.camera);
  CHECK(bench.state.scene().camera == own);
  const Camera turned = *bench.state.picture.camera;
  CHECK(turned.eye.z > own.eye.z);
  bench.point_at("image");
  bench.wheel(1);
  bench.frames(2);
  REQUIRE(bench.last<action::Approach>() != nullptr);
  CHECK(bench.last<action::Approach>()->factor > 1);
  bench.press(1);
  const Rect image = bench.rect("image");
  bench.move_to(image.x + image.width / 2 + 30, image.y + image.height / 2);
  bench.release(1);
  bench.frames(2);
  REQUIRE(bench.last<action::Shift>() != nullptr);
  CHECK(bench.last<action::Shift>()->view == SpaceView::image);
  bench.key("O");
  bench.frames(2);
  CHECK_FALSE(bench.state.picture.camera);
}

TEST_CASE("the keyboard turns, moves and zooms the picture, and gives its camera to the scene") {
  Bench bench(tracing());
  bench.frames(2);
  const Camera own = bench.state.scene().camera;
  bench.key("Alt+Shift+Right");
  REQUIRE(bench.state.picture.camera);
  bench.key("Alt+Shift+Left");
  CHECK(length(bench.state.picture.camera->eye - own.eye) < 1e-9);
  bench.key("Alt+Shift+Down");
  bench.key("Ctrl+Shift+Left");
  bench.key("Alt+Page Up");
  const Camera turned = *bench.state.picture.camera;
  bench.key("Shift+U");
  CHECK(bench.state.scene().camera == turned);
  bench.key("Ctrl+Z");
  CHECK(bench.state.scene().camera == own);
}

TEST_CASE("the settings of the picture: heat map, accelerator, precision, samples") {
  Bench bench(tracing());
  bench.frames(2);
  bench.click("image-settings");
  bench.frames(3);
  REQUIRE(bench.has("image-settings-popup"));
  bench.click("property/Heat map");
  bench.frames(3);
  bench.click("property/Heat map/rays of each pixel");
  bench.frames(3);
  CHECK(bench.state.picture.settings.heat == Heat::rays);
  CHECK(bench.has("heat-legend"));
  bench.click("property/Precision");
  bench.frames(3);
  bench.click("property/Precision/float");
  bench.frames(3);
  CHECK(bench.state.picture.settings.single_precision);
  CHECK_FALSE(bench.state.document.dirty);
}

TEST_CASE("the line view turns under the mouse, and a click on a ray goes to it") {
  Bench bench(tracing());
  update(bench.state, action::WalkPixel{300, 200, {441, 331}});
  bench.frames(3);
  const Rect pane = bench.rect("lines");
  bench.drag("lines", 60, 20);
  REQUIRE(bench.state.space.lines_camera);
  CHECK_FALSE(bench.state.picture.camera);
  CHECK(bench.state.space.turned_last == SpaceView::lines);
  bench.key("O");
  bench.frames(2);
  CHECK_FALSE(bench.state.space.lines_camera);
  // The middle of the primary ray.
  for (const DisplayItem& item : lines_view(bench.state, bench.state.plan.viewport)) {
    const auto* line = std::get_if<LineItem>(&item.shape);
    if (line == nullptr || item.target != Target{TargetKind::ray, 0} || line->arrow == 0) continue;
    const Vec2d middle = line->from + 0.3 * (line->to - line->from);
    bench.move_to(pane.x + static_cast<float>(middle.x), pane.y + static_cast<float>(middle.y));
    bench.press();
    bench.release();
    bench.frames(3);
  }
  const auto* jump = bench.last<action::JumpToRay>();
  REQUIRE(jump != nullptr);
  CHECK(jump->ray == 0);
  bench.key("V");
  bench.frames(2);
  CHECK_FALSE(bench.has("lines"));
}
