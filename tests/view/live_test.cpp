// Live rays: what follows a drag in Move, and what it costs.
#include <algorithm>

#include "fixtures.h"
#include "support/catch.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Lines in the colour of this kind of ray, from this point: arrows and dashes alike.
int rays_from(const State& state, RayKind kind, const Vec2d& from) {
  const Colour colour = ray_style(state.appearance.theme, kind).colour;
  int count = 0;
  for (const DisplayItem& item : plan_view(state))
    if (const auto* line = std::get_if<LineItem>(&item.shape))
      count += line->stroke.colour.with_alpha(255) == colour && length(line->from - from) < 1e-6 ? 1 : 0;
  return count;
}

int primary_rays(const State& state) {
  return rays_from(state, RayKind::primary, to_pixels(state, plan(state.scene().camera.eye)));
}

/// Takes hold of EYE and moves it, without letting go.
void hold_eye(State& state, const Vec2d& by) {
  const Vec2d from = pixels_of(state, {TargetKind::eye});
  update(state, action::PointerMoved{from});
  update(state, action::PointerPressed{from});
  update(state, action::PointerMoved{from + by});
}

int known_shades(const State& state) {
  const auto shades = shades_shown(state);
  return static_cast<int>(std::count_if(shades.begin(), shades.end(), [](const auto& shade) { return shade; }));
}

}  // namespace

TEST_CASE("in Move the rays of one pixel follow what is dragged, with the shades of SCREEN") {
  State state = classic_state();
  const int cells = state.scene().camera.screen.cells;
  CHECK(primary_rays(state) == 0);
  CHECK(known_shades(state) == 0);
  hold_eye(state, {20, 12});
  REQUIRE(state.plan.drag);
  CHECK(primary_rays(state) == 1);
  CHECK(known_shades(state) == cells);
  // The ray is the middle pixel's, in the scene as it is now.
  const auto& timeline = *state.walk.timeline;
  const int ray = timeline.rays_of_pixel(cells / 2).first;
  const RayRecord& record = timeline.rays()[static_cast<std::size_t>(ray)];
  CHECK(record.origin == state.scene().camera.eye);
  const Vec2d hit = to_pixels(state, plan(record.end));
  const DisplayList list = plan_view(state);
  CHECK(std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
    const auto* line = std::get_if<LineItem>(&item.shape);
    return line != nullptr && length(line->to - hit) < 1e-6;
  }));
  // They stay after the drag, and are gone with Move.
  update(state, action::PointerReleased{{400, 300}, {}});
  CHECK(primary_rays(state) == 1);
  update(state, action::SetMode{Mode::trace});
  CHECK(primary_rays(state) == 0);
  CHECK(known_shades(state) == 0);
  update(state, action::SetMode{Mode::move});
  CHECK(primary_rays(state) == 0);
}

TEST_CASE("live rays are those of the chosen pixel, of the whole strip, or none") {
  State state = classic_state();
  hold_eye(state, {20, 12});
  update(state, action::ChooseLiveCell{2});
  REQUIRE(live_cell(state) == 2);
  CHECK(primary_rays(state) == 1);
  update(state, action::ChooseLiveCell{1000});
  CHECK(live_cell(state) == 2);
  update(state, action::SetLiveRays{LiveRays::strip});
  CHECK(state.plan.drag);
  CHECK(primary_rays(state) == state.scene().camera.screen.cells);
  update(state, action::ShowRays{RayKind::primary, false});
  CHECK(primary_rays(state) == 0);
  update(state, action::ShowRays{RayKind::primary, true});
  update(state, action::SetLiveRays{LiveRays::off});
  CHECK(primary_rays(state) == 0);
  CHECK(known_shades(state) == 0);
  hold_eye(state, {1, 1});
  CHECK(primary_rays(state) == 0);
}

TEST_CASE("the pixel of the walk is the one whose rays follow") {
  State state = classic_state();
  update(state, action::JumpToCell{4});
  update(state, action::Step{true, Grain::line});
  update(state, action::SetMode{Mode::move});
  hold_eye(state, {8, 8});
  CHECK(live_cell(state) == 4);
}

TEST_CASE("what lies below a live ray can still be taken hold of") {
  State state = classic_state();
  hold_eye(state, {10, 6});
  update(state, action::SetLiveRays{LiveRays::strip});
  update(state, action::PointerReleased{pixels_of(state, {TargetKind::eye}), {}});
  for (int x = 0; x < 800; x += 5)
    for (int y = 0; y < 600; y += 5) REQUIRE(pick(state, Vec2d(x, y)).kind != TargetKind::ray);
}

TEST_CASE("a drag traces the strip once for each place of the pointer, and nothing when it rests") {
  State state = classic_state();
  hold_eye(state, {20, 12});
  const auto timeline = state.walk.timeline;
  const auto revision = state.document.revision;
  // A strip is 21 pixels of at most a few dozen rays, each of a few events.
  CHECK(timeline->rays().size() < 400);
  CHECK(timeline->steps() < 2000);
  CHECK(plan_view(state).size() < 400);
  update(state, action::PointerMoved{*state.plan.pointer});
  update(state, action::Tick{0.02});
  CHECK(state.walk.timeline == timeline);
  CHECK(state.document.revision == revision);
  update(state, action::PointerMoved{*state.plan.pointer + Vec2d(1, 0)});
  CHECK(state.document.revision == revision + 1);
}
