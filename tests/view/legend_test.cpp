// Which rays are shown: kinds by the legend, and those of earlier pixels.
#include "view/legend/legend.h"

#include <algorithm>

#include "fixtures.h"
#include "support/catch.h"
#include "view/space/lines_view.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Rays of this kind in the drawing, and of other pixels than the current one; their largest alpha.
struct Seen {
  int rays = 0, earlier = 0, alpha = 0;
};
Seen seen(const State& state, RayKind kind) {
  const Timeline& timeline = *state.walk.timeline;
  const int pixel = timeline.current_pixel(state.walk.position);
  Seen seen;
  int last = -1;
  for (const DisplayItem& item : plan_view(state)) {
    if (item.target.kind != TargetKind::ray || item.target.index == last) continue;
    last = item.target.index;
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(last)];
    if (ray.kind != kind) continue;
    ++seen.rays;
    if (ray.pixel == pixel) continue;
    ++seen.earlier;
    if (const auto* line = std::get_if<LineItem>(&item.shape))
      seen.alpha = std::max<int>(seen.alpha, line->stroke.colour.a);
  }
  return seen;
}

State at_cell(int cell) {
  State state = classic_state();
  update(state, action::JumpToCell{cell});
  update(state, action::Step{true, Grain::ray});
  return state;
}

}  // namespace

TEST_CASE("rays of earlier pixels fade once they are those of more than three") {
  const Seen few = seen(at_cell(3), RayKind::primary), many = seen(at_cell(4), RayKind::primary);
  CHECK(few.earlier == 3);
  CHECK(few.alpha == 100);
  CHECK(many.earlier == 4);
  CHECK(many.alpha < 50);
  CHECK(many.alpha > 20);
}

TEST_CASE("rays of earlier pixels can be shown or hidden") {
  State state = at_cell(12);
  update(state, action::ShowEarlier{Earlier::shown});
  CHECK(seen(state, RayKind::primary).earlier == 12);
  CHECK(seen(state, RayKind::primary).alpha == 100);
  update(state, action::ShowEarlier{Earlier::hidden});
  CHECK(seen(state, RayKind::primary).earlier == 0);
  CHECK(seen(state, RayKind::primary).rays == 1);
}

TEST_CASE("a kind of ray can be hidden, in the plan and in space; what is pointed at is shown nevertheless") {
  State state = classic_state();
  update(state, action::Jump{state.walk.timeline->steps()});
  for (const bool in_space : {false, true}) {
    update(state, action::ShowLines{in_space});
    for (const RayKind kind : values_of<RayKind>) {
      if (kind == RayKind::photon || kind == RayKind::beam) continue;  // of other walks
      INFO(name_of(kind));
      const auto count = [&] {
        const DisplayList list = in_space ? lines_view(state, state.plan.viewport) : plan_view(state);
        return static_cast<int>(std::count_if(list.begin(), list.end(), [&](const DisplayItem& item) {
          return item.target.kind == TargetKind::ray &&
                 state.walk.timeline->rays()[static_cast<std::size_t>(item.target.index)].kind == kind;
        }));
      };
      CHECK(count() > 0);
      update(state, action::ShowRays{kind, false});
      CHECK(count() == 0);
      const auto& rays = state.walk.timeline->rays();
      const auto pointed =
          std::find_if(rays.begin(), rays.end(), [&](const RayRecord& ray) { return ray.kind == kind && ray.formed; });
      update(state, action::HoverRay{static_cast<int>(pointed - rays.begin())});
      CHECK(count() > 0);
      update(state, action::HoverRay{-1});
      update(state, action::ShowRays{kind, true});
      CHECK(count() > 0);
    }
  }
}

TEST_CASE("the lobe and the ring of the sky are explained where they are drawn") {
  const auto explains = [](const State& state, std::string_view symbol) {
    const Legend rows = legend(state);
    return std::any_of(rows.signs.begin(), rows.signs.end(),
                       [&](const LegendSign& sign) { return sign.symbol == symbol; });
  };
  State state = classic_state();
  CHECK_FALSE(explains(state, "-<"));
  CHECK_FALSE(explains(state, "( )"));
  Scene scene = state.scene();
  scene.sky = Sky{};
  scene.objects.front().material.roughness = 0.3;
  scene.objects.front().material.reflection = Rgbd(0.5);
  const State other = state_of(scene);
  CHECK(explains(other, "-<"));
  CHECK(explains(other, "( )"));
}
