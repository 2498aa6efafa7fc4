// Photons in the plan: a dot for each as it is stored, then all of them, and the circle of an estimate.

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "support/catch.h"
#include "support/thread_time.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"
#include "view/walk/code_panel.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene with_photons(int count) {
  Scene scene = classic_state().scene();
  scene.background = Rgbd(0.0);
  scene.render.integrator = Integrator::photons;
  scene.render.photons.count = count;
  scene.render.photons.nearest = 20;
  return scene;
}

/// Small filled circles that cannot be pointed at.
int dots_of(const State& state) {
  int dots = 0;
  for (const DisplayItem& item : plan_view(state)) {
    const auto* circle = std::get_if<CircleItem>(&item.shape);
    dots += circle != nullptr && !item.target && circle->fill && !circle->stroke && circle->radius < 3;
  }
  return dots;
}

}  // namespace

TEST_CASE("a dot appears where a photon is stored, and all of them once the others have gone their ways") {
  State state = state_of(with_photons(5000));
  update(state, action::SetMode{Mode::trace});
  const Timeline& timeline = *state.walk.timeline;
  REQUIRE(timeline.of_photons());
  const int first = position_after<PhotonStored>(timeline);
  REQUIRE(first > 0);
  update(state, action::Jump{first - 1});
  const int before = dots_of(state);
  update(state, action::Jump{first});
  CHECK(dots_of(state) == before + 1);
  update(state, action::Jump{timeline.all_photons_at()});
  CHECK(dots_of(state) > before + 30);
  CHECK(is_finite(plan_view(state)));
}

TEST_CASE("the circle of an estimate has its radius in the plan, and the plan says that the world is flat") {
  State state = state_of(with_photons(20000));
  update(state, action::SetMode{Mode::trace});
  const Timeline& timeline = *state.walk.timeline;
  int found = 0;
  for (int at = position_after<PhotonsFound>(timeline); at > 0 && found < 3;
       at = position_after<PhotonsFound>(timeline, at)) {
    const auto& photons = std::get<PhotonsFound>(timeline.event(at - 1).detail);
    if (!(photons.other.radius > 0)) continue;
    ++found;
    update(state, action::Jump{at});
    const Vec2d centre = to_pixels(state.plan.camera, state.plan.viewport, Vec2d(photons.position));
    const double radius = photons.other.radius * state.plan.camera.pixels_per_unit;
    const DisplayList list = plan_view(state);
    CHECK(std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
      const auto* circle = std::get_if<CircleItem>(&item.shape);
      return circle != nullptr && circle->stroke && length(circle->centre - centre) < 1e-6 &&
             std::abs(circle->radius - radius) < 1e-6;
    }));
    const std::string_view words = text("plan.flat", state.appearance.language);
    CHECK(std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
      const auto* said = std::get_if<TextItem>(&item.shape);
      return said != nullptr && said->text == words;
    }));
  }
  CHECK(found == 3);
}

TEST_CASE("the code shows the procedure that is under way beside the one that calls it") {
  State state = state_of(with_photons(1000));
  const Timeline& timeline = *state.walk.timeline;
  update(state, action::Jump{0});
  CHECK(code_panel(state).boxes[1].procedure == Procedure::follow_photon);
  for (int position = 1; position <= timeline.steps(); position += 7) {
    state.walk.position = position;
    const Procedure running = pseudocode_of(timeline.just_run(position)->line).procedure;
    const CodePanel panel = code_panel(state);
    CHECK(panel.boxes[0].procedure == Procedure::photon_mapping);
    if (running != Procedure::photon_mapping) CHECK(panel.boxes[1].procedure == running);
    int lit = 0;
    for (const CodeBox& box : panel.boxes)
      for (const CodeRow& row : box.rows) lit += row.just_run;
    CHECK(lit == 1);
  }
}

TEST_CASE("with 100,000 photons in the plan a step is drawn within 16 ms") {
  State state = state_of(with_photons(100000));
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{state.walk.timeline->all_photons_at()});
  double best = 1e9;
  for (int i = 0; i < 10; ++i) {
    const double begun = thread_milliseconds();
    update(state, action::Step{});
    const DisplayList list = plan_view(state);
    best = std::min(best, thread_milliseconds() - begun);
    CHECK(list.size() < 20000);
  }
  INFO(best << " ms");
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  CHECK(best < 16);
#endif
}
