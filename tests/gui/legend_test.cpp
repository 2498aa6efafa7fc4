// The legend below the plan, the band, and the rays of menus, by mouse and keys.
#include "gui/bench.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State walked_to(int position) {
  State state = classic();
  update(state, action::Jump{position});
  return state;
}

}  // namespace

TEST_CASE("a click on a kind of ray in the legend hides it, and another shows it; so do the menu and a key") {
  Bench bench(walked_to(300));
  bench.frames(2);
  for (const bool in_tab : {false, true}) {
    if (in_tab) bench.key("L");
    bench.frames(2);
    for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::reflect, RayKind::refract}) {
      const std::string name(name_of(kind));
      if (in_tab && kind == RayKind::reflect) {  // the last ones may be below the edge
        bench.point_at("legend/shadow");
        bench.wheel(-1);
        bench.frames(2);
      }
      CAPTURE(name, in_tab);
      bench.click("legend/" + name);
      CHECK_FALSE(bench.state.legend.shows(kind));
      bench.click("legend/" + name);
      CHECK(bench.state.legend.shows(kind));
    }
  }
  bench.key("Alt+2");
  CHECK_FALSE(bench.state.legend.shows(RayKind::shadow));
  bench.click("menu-view");
  bench.click("menu/rays");
  bench.frames(2);
  bench.click("menu/rays-shadow");
  CHECK(bench.state.legend.shows(RayKind::shadow));
}

TEST_CASE("beside the legend stands the switch for rays of earlier pixels") {
  Bench bench(walked_to(300));
  bench.frames(2);
  bench.click("only-pixel");
  CHECK(bench.state.legend.earlier == Earlier::hidden);
  bench.key("Shift+L");
  CHECK(bench.state.legend.earlier == Earlier::faded);
  bench.key("L");
  bench.frames(2);
  bench.click("earlier-shown");
  CHECK(bench.state.legend.earlier == Earlier::shown);
}

TEST_CASE("a click on a cell of the band walks it, and in Move makes its rays follow") {
  Bench bench(walked_to(300));
  bench.key("Shift+S");
  bench.frames(2);
  REQUIRE(bench.has("band"));
  const Rect band = bench.rect("band");
  const auto click_at = [&](float part) {
    bench.move_to(band.x + part * band.width, band.y + 0.3f * band.height);
    bench.press();
    bench.release();
    bench.frames(2);
  };
  click_at(0.25f);
  CHECK(current_cell(bench.state) == 5);
  bench.key("M");
  bench.frames(2);
  click_at(0.75f);
  CHECK(live_cell(bench.state) == 15);
  CHECK(bench.state.live.shown);
  CHECK(bench.state.walk.mode == Mode::move);
  bench.key("Shift+M");
  CHECK(bench.state.live.rays == LiveRays::strip);
  bench.key("Shift+M");
  CHECK(bench.state.live.rays == LiveRays::off);
  CHECK_FALSE(bench.state.live.shown);
}

TEST_CASE("the switches for effects stand below the plan, at any width in as many rows as they need") {
  Bench bench(walked_to(300));
  bench.key("Shift+E");
  bench.frames(2);
  for (const float width : {1280.0f, 720.0f}) {
    bench.resize(width, 720);
    bench.frames(2);
    const Rect pane = bench.rect("effects");
    for (const std::string name : {"shadows", "reflection", "refraction", "depth-less", "depth-more"}) {
      CAPTURE(width, name);
      const Rect item = bench.rect("effect/" + name);
      CHECK(item.x >= pane.x);
      CHECK(item.right() <= pane.right());
      CHECK(item.bottom() <= pane.bottom());
    }
  }
  bench.click("effect/shadows");
  CHECK(bench.state.effects.leaves_out(Effect::shadows));
  bench.click("effect/shadows");
  CHECK_FALSE(bench.state.effects.leaves_out());
  const int depth = bench.state.scene().limits.depth;
  bench.click("effect/depth-less");
  CHECK(bench.state.effects.depth == depth - 1);
  bench.click("effect/depth-more");
  CHECK_FALSE(bench.state.effects.depth);
  bench.key("Shift+E");
  CHECK_FALSE(bench.state.effects.shown);
}
