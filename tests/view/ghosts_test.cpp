// What the limits cut off: drawn where it was forbidden, and worth what a deeper trace adds.
#include "view/walk/ghosts.h"

#include "fixtures.h"
#include "support/catch.h"
#include "timeline/recorder.h"
#include "view/action.h"
#include "view/plan/plan_view.h"

#include <cmath>

using namespace raywalk;
using namespace raywalk::test;

namespace {

State limited(int depth, double threshold) {
  State state = busy_state();
  update(state, action::SetMode{Mode::trace});
  update(state, action::SetLimits{{depth, threshold}});
  update(state, action::ShowGhosts{true});
  return state;
}

void to_end_of_pixel(State& state, int pixel) {
  update(state, action::Jump{state.walk.timeline->pixels()[static_cast<std::size_t>(pixel)].done_at});
}

// What is drawn more than without ghosts.
std::size_t drawn_for_ghosts(const State& state) {
  State without = state;
  without.walk.ghosts.reset();
  return plan_view(state, state.plan.viewport).size() - plan_view(without, without.plan.viewport).size();
}

}  // namespace

TEST_CASE("a pixel and its ghosts add up to what a deeper trace without a threshold makes of it") {
  const int depth = GENERATE(1, 2, 3);
  const double threshold = GENERATE(0.0, 0.2);
  State state = limited(depth, threshold);
  int with_ghosts = 0;
  for (int pixel = 0; pixel < static_cast<int>(state.walk.timeline->pixels().size()); ++pixel) {
    to_end_of_pixel(state, pixel);
    REQUIRE(state.walk.ghosts);
    CHECK(state.walk.ghosts->pixel == pixel);
    const PixelRecord& record = state.walk.timeline->pixels()[static_cast<std::size_t>(pixel)];
    CHECK(state.walk.ghosts->shade == record.shade);
    if (state.walk.ghosts->rays.empty()) {
      CHECK(state.walk.ghosts->lost == Rgbd(0.0));
      continue;
    }
    ++with_ghosts;
    int deepest = 0;
    for (const GhostRay& ghost : state.walk.ghosts->rays) {
      const RayRecord& stub = state.walk.timeline->rays()[static_cast<std::size_t>(ghost.stub)];
      CHECK_FALSE(stub.formed);
      CHECK(stub.pixel == pixel);
      CHECK((stub.ending == Ending::depth || stub.ending == Ending::threshold));
      if (ghost.record.parent < 0) {
        CHECK(ghost.record.origin == stub.origin);
        CHECK(ghost.record.kind == stub.kind);
        CHECK(ghost.record.throughput == stub.throughput);
      }
      const bool shaded = ghost.record.formed && ghost.record.kind != RayKind::shadow;
      deepest = std::max(deepest, ghost.record.depth + (shaded ? 1 : 0));
    }
    CAPTURE(depth, threshold, pixel, deepest, state.walk.ghosts->levels);
    Scene scene = state.scene();
    scene.limits = {deepest, 0};
    const Timeline deep = record_cell(scene, record.column);
    const Rgbd all = state.walk.ghosts->shade + state.walk.ghosts->lost, expected = deep.pixels().front().shade;
    for (int channel = 0; channel < 3; ++channel)
      CHECK(all[channel] == Approx(expected[channel]).epsilon(0).margin(1e-12));
    CHECK(share_of(state.walk.ghosts->lost, *state.walk.ghosts) <= 1);
  }
  CHECK(with_ghosts > 0);
}

TEST_CASE("ghosts are drawn once their stub stands, and only when asked for") {
  State state = limited(1, 0);
  int pixel = -1;
  do to_end_of_pixel(state, ++pixel);
  while (state.walk.ghosts->rays.empty());
  CHECK(drawn_for_ghosts(state) > 1);
  const int stub = state.walk.ghosts->rays.front().stub;
  update(state, action::Jump{state.walk.timeline->rays()[static_cast<std::size_t>(stub)].formed_at - 1});
  CHECK(drawn_for_ghosts(state) == 1);  // the line below, and nothing else
  CHECK(state.walk.ghosts != nullptr);
  to_end_of_pixel(state, pixel);
  update(state, action::ShowGhosts{false});
  CHECK(state.walk.ghosts == nullptr);
  CHECK(drawn_for_ghosts(state) == 0);
  update(state, action::ShowGhosts{true});
  update(state, action::SetMode{Mode::move});
  CHECK(state.walk.ghosts == nullptr);
}
