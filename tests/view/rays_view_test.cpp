#include "fixtures.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"

#include <algorithm>
#include <set>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The line of a ray in the drawing.
LineItem line_of(const DisplayList& list, int ray) {
  const auto items = items_of(list, {TargetKind::ray, ray});
  INFO("ray " << ray);
  REQUIRE_FALSE(items.empty());
  return std::get<LineItem>(items.front().shape);
}

bool on_border(const State& state, const Vec2d& at) {
  return at.x <= 0 || at.y <= 0 || at.x >= state.plan.viewport.width || at.y >= state.plan.viewport.height;
}

bool in_sight(const State& state, const Vec3d& point) { return !on_border(state, to_pixels(state, plan(point))); }

int first_ray(const State& state, RayKind kind, Ending ending) {
  const auto& rays = state.walk.timeline->rays();
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (rays[i].kind == kind && rays[i].ending == ending && in_sight(state, rays[i].origin) &&
        in_sight(state, rays[i].end))
      return static_cast<int>(i);
  FAIL("no " << name_of(kind) << " ray that ended with " << name_of(ending));
  return -1;
}

}  // namespace

TEST_CASE("a primary ray goes through the middle of its cell") {
  for (const State& state : {classic_state(), busy_state()}) {
    const ScreenPlace screen = screen_place(state.scene().camera);
    for (const RayRecord& ray : state.walk.timeline->rays()) {
      if (ray.kind != RayKind::primary) continue;
      const int column = state.walk.timeline->pixels()[static_cast<std::size_t>(ray.pixel)].column;
      const Vec2d middle = screen.at((column + 0.5) / state.scene().camera.screen.cells);
      CHECK(std::abs(cross(plan(ray.direction), middle - plan(ray.origin))) < 1e-12);
    }
  }
}

TEST_CASE("a ray is drawn when it is formed and cut when its end is found") {
  State state = classic_state();
  const int ray = first_ray(state, RayKind::primary, Ending::hit);
  const RayRecord record = state.walk.timeline->rays()[static_cast<std::size_t>(ray)];
  update(state, action::Jump{record.formed_at - 1});
  CHECK(items_of(plan_view(state), {TargetKind::ray, ray}).empty());
  update(state, action::Step{true, Grain::line});
  // Towards its end, which is not known, it fades in pieces.
  const DisplayList list = plan_view(state);
  const auto pieces = items_of(list, {TargetKind::ray, ray});
  REQUIRE(pieces.size() > 2);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const auto &before = std::get<LineItem>(pieces[i - 1].shape), &piece = std::get<LineItem>(pieces[i].shape);
    CHECK(piece.stroke.colour.a < before.stroke.colour.a);
    CHECK(length(piece.from - before.to) < 1e-6);
    CHECK((before.arrow > 0) == (i == 1));
  }
  CHECK(on_border(state, std::get<LineItem>(pieces.back().shape).to));
  update(state, action::Step{true, Grain::line});
  REQUIRE(state.walk.position == record.found_at);
  CHECK(length(line_of(plan_view(state), ray).to - to_pixels(state, plan(record.end))) < 1e-6);
  CHECK(length(line_of(plan_view(state), ray).from - to_pixels(state, plan(record.origin))) < 1e-6);
}

TEST_CASE("rays stay until CLEAR, a ray that hits nothing leaves through the border") {
  State state = classic_state();
  update(state, action::Jump{1 << 20});
  const DisplayList list = plan_view(state);
  const auto& rays = state.walk.timeline->rays();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!rays[i].formed) continue;
    const LineItem line = line_of(list, static_cast<int>(i));
    if (rays[i].endless) CHECK(on_border(state, line.to));
  }
  update(state, action::Clear{});
  for (const DisplayItem& item : plan_view(state)) CHECK(item.target.kind != TargetKind::ray);
}

TEST_CASE("kinds differ in dashes and colour, all have arrowheads, the current ray stands out") {
  State state = busy_state();
  for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::reflect, RayKind::refract}) {
    const auto& rays = state.walk.timeline->rays();
    const auto found = std::find_if(rays.begin(), rays.end(), [&](const RayRecord& ray) {
      return ray.kind == kind && ray.formed && in_sight(state, ray.origin);
    });
    REQUIRE(found != rays.end());
    const int ray = static_cast<int>(found - rays.begin());
    update(state, action::JumpToRay{ray});
    const LineItem current = line_of(plan_view(state), ray);
    CHECK(current.stroke.colour == ray_style(state.appearance.theme, kind).colour);
    CHECK(current.stroke.dash.count == ray_style(state.appearance.theme, kind).dash.count);
    CHECK(current.arrow > 0);
    update(state, action::Jump{1 << 20});
    const LineItem older = line_of(plan_view(state), ray);
    CHECK(older.stroke.width < current.stroke.width);
    CHECK(older.stroke.colour.a < current.stroke.colour.a);
    CHECK(older.arrow > 0);
  }
}

TEST_CASE("dashes are counted from the ray's origin, wherever the pane begins") {
  State state = busy_state();
  update(state, action::Jump{1 << 20});
  const int ray = first_ray(state, RayKind::reflect, Ending::hit);
  const RayRecord& record = state.walk.timeline->rays()[static_cast<std::size_t>(ray)];
  // Zoom to the far part of the ray, so that its origin is out of sight.
  update(state, action::Zoom{to_pixels(state, plan(record.origin + 0.8 * (record.end - record.origin))), 40});
  const Vec2d middle = to_pixels(state, plan(record.origin + 0.8 * (record.end - record.origin)));
  update(state, action::Pan{Vec2d(400, 300) - middle});
  const LineItem line = line_of(plan_view(state), ray);
  const Vec2d origin = to_pixels(state, plan(record.origin));
  CHECK(line.stroke.phase > 10);
  CHECK(line.stroke.phase == Approx(length(line.from - origin)).epsilon(1e-6));
}

TEST_CASE("a blocked shadow ray ends at its blocker with a cross") {
  State state = busy_state();
  const int ray = first_ray(state, RayKind::shadow, Ending::blocked);
  const RayRecord& record = state.walk.timeline->rays()[static_cast<std::size_t>(ray)];
  const auto crosses = [&] {
    int strokes = 0;
    const Vec2d end = to_pixels(state, plan(record.end));
    for (const DisplayItem& item : plan_view(state))
      if (const auto* line = std::get_if<LineItem>(&item.shape))
        if (length((line->from + line->to) / 2.0 - end) < 1e-6 && length(line->to - line->from) < 40) ++strokes;
    return strokes;
  };
  update(state, action::Jump{record.formed_at});
  CHECK(crosses() == 0);
  update(state, action::Jump{record.found_at});
  CHECK(crosses() == 2);
}

TEST_CASE("where a limit forbids a ray there is a stub") {
  State state = busy_state();
  for (const Ending ending : {Ending::depth, Ending::threshold, Ending::facing_away}) {
    const auto& rays = state.walk.timeline->rays();
    const auto found = std::find_if(rays.begin(), rays.end(),
                                    [&](const RayRecord& ray) { return !ray.formed && ray.ending == ending; });
    INFO(name_of(ending));
    REQUIRE(found != rays.end());
    const int ray = static_cast<int>(found - rays.begin());
    update(state, action::Jump{found->formed_at});
    const auto items = items_of(plan_view(state), {TargetKind::ray, ray});
    CHECK(items.size() == 2);
    for (const DisplayItem& item : items) {
      const auto& line = std::get<LineItem>(item.shape);
      CHECK(length(line.to - line.from) < 60);
    }
  }
}

TEST_CASE("the pixel's hits show their normals") {
  State state = classic_state();
  const int ray = first_ray(state, RayKind::primary, Ending::hit);
  const RayRecord& record = state.walk.timeline->rays()[static_cast<std::size_t>(ray)];
  const auto normals = [&] {
    int found = 0;
    const Vec2d end = to_pixels(state, plan(record.end));
    for (const DisplayItem& item : plan_view(state)) {
      const auto* line = std::get_if<LineItem>(&item.shape);
      if (line == nullptr || length(line->from - end) > 1e-6) continue;
      if (line->stroke.colour != palette(state.appearance.theme).normal) continue;
      const Vec2d along = (line->to - line->from) / length(line->to - line->from);
      CHECK(length(along - Vec2d(record.normal.x, -record.normal.y)) < 1e-9);
      ++found;
    }
    return found;
  };
  update(state, action::Jump{record.formed_at});
  CHECK(normals() == 0);
  update(state, action::Jump{record.found_at});
  CHECK(normals() == 1);
}

TEST_CASE("a ray pointed at in the tree lights up in the plan, and one in the plan becomes the one pointed at") {
  State state = busy_state();
  update(state, action::Jump{1 << 20});
  const int ray = first_ray(state, RayKind::reflect, Ending::hit);
  const LineItem before = line_of(plan_view(state), ray);
  update(state, action::HoverRay{ray});
  const LineItem after = line_of(plan_view(state), ray);
  CHECK(after.stroke.width > before.stroke.width);
  update(state, action::HoverRay{-1});
  const RayRecord& record = state.walk.timeline->rays()[static_cast<std::size_t>(ray)];
  update(state, action::PointerMoved{to_pixels(state, plan(record.origin + record.end) / 2.0)});
  CHECK(state.plan.hovered.kind == TargetKind::ray);
  CHECK(state.plan.hovered_ray == state.plan.hovered.index);
  CHECK_FALSE(target_text(state, state.plan.hovered).empty());
}
