// Pencils in the plan: rays beside each ray of the pixel, and on demand the true ones.

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"
#include "view/walk/equation.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State traced_classic() {
  State state = classic_state();
  update(state, action::SetMode{Mode::trace});
  update(state, action::Jump{state.walk.timeline->steps()});
  return state;
}

std::size_t straight_lines_in(const State& state) {
  const DisplayList list = plan_view(state);
  return static_cast<std::size_t>(std::count_if(
      list.begin(), list.end(), [](const DisplayItem& item) { return std::holds_alternative<LineItem>(item.shape); }));
}

}  // namespace

TEST_CASE("pencils are shown for the pixel at work, and hidden again") {
  State state = traced_classic();
  const std::size_t before = straight_lines_in(state);
  CHECK(state.pencil.pencils.empty());
  update(state, action::ShowPencils{true});
  CHECK_FALSE(state.pencil.pencils.empty());
  const int pixel = state.walk.timeline->current_pixel(state.walk.position);
  for (const Pencil& pencil : state.pencil.pencils) {
    CHECK(state.walk.timeline->rays()[static_cast<std::size_t>(pencil.ray)].pixel == pixel);
    CHECK(pencil.truly.empty());
  }
  const std::size_t with = straight_lines_in(state);
  CHECK(with > before);
  CHECK(is_finite(plan_view(state)));
  update(state, action::ShowNeighbours{true});
  for (const Pencil& pencil : state.pencil.pencils) CHECK(pencil.truly.size() == std::size(pencil_rays));
  CHECK(straight_lines_in(state) > with);
  update(state, action::ShowNeighbours{false});
  CHECK(straight_lines_in(state) == with);
  update(state, action::ShowPencils{false});
  CHECK(state.pencil.pencils.empty());
  CHECK(straight_lines_in(state) == before);
}

TEST_CASE("a stroke stands where the rays above and below a pencil's meet") {
  State state = traced_classic();
  update(state, action::ShowPencils{true});
  int strokes = 0;
  for (int at = 1; at <= state.walk.timeline->steps(); at += 7) {
    update(state, action::Jump{at});
    State without = state;
    for (Pencil& pencil : without.pencil.pencils) pencil.stages.back().focus_across.reset();
    strokes += straight_lines_in(without) < straight_lines_in(state);
  }
  CHECK(strokes > 3);
}

TEST_CASE("while pencils are shown, the equation of a ray that is formed has its matrix and where that folds") {
  const auto read = read_scene(RAYWALK_SOURCE_DIR "/scenes/pencils.toml");
  REQUIRE(read);
  State state = state_of(read->scene);
  update(state, action::SetMode{Mode::trace});
  const auto rows = [&] { return equation_panel(state).rows; };
  int folds = 0;
  for (int at = position_after<RayFormed>(*state.walk.timeline); at > 0;
       at = position_after<RayFormed>(*state.walk.timeline, at)) {
    update(state, action::ShowPencils{false});
    update(state, action::Jump{at});
    const std::size_t without = rows().size();
    update(state, action::ShowPencils{true});
    const int ray = state.walk.timeline->current_ray(at);
    const auto pencil = std::find_if(state.pencil.pencils.begin(), state.pencil.pencils.end(),
                                     [&](const Pencil& each) { return each.ray == ray; });
    if (pencil == state.pencil.pencils.end()) {
      CHECK(rows().size() == without);
      continue;
    }
    const std::vector<EquationRow> all = rows();
    const bool bent = pencil->stages.size() > 1;
    REQUIRE(all.size() == without + (bent ? 4 : 3));
    const std::vector<double>&first = all[without + 1].values, &second = all[without + 2].values;
    CHECK(std::abs(first[0] * second[1] - first[1] * second[0]) ==
          Approx(pencil->stages.front().n / pencil->stages.back().n).epsilon(1e-9));
    if (bent) CHECK(all.back().values == std::vector<double>{-first[1] / second[1]});
    if (pencil->stages.size() != 3) continue;
    // Beyond the ball rays near the axis meet in EYE's image, those farther off before it.
    const PencilStage& stage = pencil->stages.back();
    const double meets = (stage.origin + all.back().values[0] * stage.direction).x;
    CHECK(meets < 2.25 + 1e-9);
    if (std::abs(stage.origin.y) < 1e-9) CHECK(meets == Approx(2.25).epsilon(1e-9));
    ++folds;
  }
  CHECK(folds == 9);
}

TEST_CASE("what a pencil says of itself is what the true rays do") {
  State state = traced_classic();
  update(state, action::ShowNeighbours{true});
  CHECK(state.pencil.shown);
  int compared = 0, off = 0;
  for (int at = 1; at <= state.walk.timeline->steps(); at += 7) {
    update(state, action::Jump{at});
    for (const Pencil& pencil : state.pencil.pencils) {
      const PencilStage& last = pencil.stages.back();
      if (!std::isfinite(last.length)) continue;
      // From EYE straight to a surface the pencil errs by the tangent of its angle only.
      if (pencil.stages.size() == 1)
        CHECK(pencil.error < last.length * std::pow(state.pencil.half_angle, 3));
      else
        off += pencil.error > 1e-6;
      ++compared;
    }
  }
  CHECK(compared > 20);
  CHECK(off > 3);
}

TEST_CASE("a pencil says how many of the true rays go another way, and calls no error 0 that it cannot know") {
  Scene scene = classic_state().scene();
  Material chrome;
  chrome.reflection = Rgbd(1.0);
  // Smaller than what the pencil's rays see: all of them pass the bead that its own ray is mirrored by.
  scene.objects = {{"Bead", Sphere<double>{{0, 0, 0}, 0.02}, chrome}, {"Wall", Sphere<double>{{-20, 0, 0}, 5}, {}}};
  State state = state_of(scene);
  update(state, action::SetMode{Mode::trace});
  update(state, action::ShowNeighbours{true});
  std::size_t mirrored = 0;
  for (int at = 1; at <= state.walk.timeline->steps(); ++at) {
    update(state, action::Jump{at});
    for (const Pencil& pencil : state.pencil.pencils) {
      if (pencil.stages.size() != 2 || !std::isfinite(pencil.stages.back().length)) continue;
      ++mirrored;
      CHECK(pencil.parted == static_cast<int>(std::size(pencil_rays)));
    }
  }
  CHECK(mirrored > 0);
}

TEST_CASE("a walk of beams, cones or radiosity, and moving, shows no pencils") {
  State state = traced_classic();
  update(state, action::ShowPencils{true});
  update(state, action::SetMode{Mode::move});
  const std::size_t moving = straight_lines_in(state);
  update(state, action::ShowPencils{false});
  CHECK(straight_lines_in(state) == moving);
  Scene scene = classic_state().scene();
  for (const Integrator integrator : {Integrator::beams, Integrator::cones, Integrator::radiosity}) {
    scene.render.integrator = integrator;
    State other = state_of(scene);
    update(other, action::SetMode{Mode::trace});
    update(other, action::Jump{other.walk.timeline->steps()});
    update(other, action::ShowPencils{true});
    CHECK(other.pencil.pencils.empty() == (other.walk.timeline->has_width() || other.walk.timeline->of_radiosity()));
  }
}

TEST_CASE("where pencils are walked the plan draws them, no sooner than their matrix, and the equation has it") {
  Scene scene = read_scene(RAYWALK_SOURCE_DIR "/scenes/pencils.toml")->scene;
  scene.render.integrator = Integrator::pencils;
  State state = state_of(scene);
  update(state, action::SetMode{Mode::trace});
  const Timeline& timeline = *state.walk.timeline;
  REQUIRE(timeline.of_pencils());
  CHECK_FALSE(state.pencil.shown);
  const auto is_drawn = [&](int ray) {
    return std::any_of(state.pencil.pencils.begin(), state.pencil.pencils.end(),
                       [&](const Pencil& each) { return each.ray == ray; });
  };
  int axes = 0, changed = 0;
  for (int at = 1; at <= timeline.steps(); ++at) {
    update(state, action::Jump{at});
    const int ray = timeline.current_ray(at);
    const EventDetail& detail = timeline.event(at - 1).detail;
    if (const auto* formed = std::get_if<RayFormed>(&detail)) {
      if (formed->kind == RayKind::shadow) continue;
      CHECK(is_drawn(ray) == (formed->parent < 0));
      axes += is_drawn(ray);
    } else if (const auto* matrix = std::get_if<PencilChanged>(&detail)) {
      REQUIRE(matrix->system);
      CHECK(is_drawn(ray));
      bool first = false, second = false;
      for (const EquationRow& row : equation_panel(state).rows) {
        first |= row.values == std::vector<double>{matrix->system->plan.a, matrix->system->plan.b};
        second |= row.values == std::vector<double>{matrix->system->plan.c, matrix->system->plan.d};
      }
      CHECK((first && second));
      ++changed;
    }
    CHECK(is_finite(plan_view(state)));
  }
  CHECK(axes > 8);
  CHECK(changed > 30);
}
