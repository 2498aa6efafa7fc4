// A walk through several samples of each pixel.
#include "fixtures.h"
#include "render/render.h"
#include "support/catch.h"
#include "support/languages.h"
#include "timeline/recorder.h"
#include "view/action.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>

using namespace raywalk;
using namespace raywalk::test;

namespace {

State walked(int samples) {
  State state = busy_state();
  update(state, action::SetMode{Mode::trace});
  ImageSettings settings = state.picture.settings;
  settings.walk_samples = samples;
  update(state, action::SetImageSettings{settings});
  return state;
}

std::vector<std::string> texts_in(const DisplayList& list) {
  std::vector<std::string> texts;
  for (const DisplayItem& item : list)
    if (const auto* words = std::get_if<TextItem>(&item.shape)) texts.push_back(words->text);
  return texts;
}

}  // namespace

TEST_CASE("the samples of a pixel are walked one after the other, and their mean is what a render of them gives") {
  const int samples = 5;
  const State state = walked(samples);
  const auto& pixels = state.walk.timeline->pixels();
  const int cells = state.scene().camera.screen.cells;
  REQUIRE(static_cast<int>(pixels.size()) == cells * samples);
  for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
    CHECK(pixels[static_cast<std::size_t>(i)].column == i / samples);
    CHECK(pixels[static_cast<std::size_t>(i)].sample == i % samples);
    if (i % samples == 0) CHECK(pixels[static_cast<std::size_t>(i)].mean == pixels[static_cast<std::size_t>(i)].shade);
  }
  RenderSettings settings;
  settings.sampling.per_pixel = samples;
  const auto strip = render_strip(state.scene(), settings);
  REQUIRE(strip);
  for (int cell = 0; cell < cells; ++cell)
    CHECK(pixels[static_cast<std::size_t>((cell + 1) * samples - 1)].mean == strip->film_of<double>().at(cell, 0));
}

TEST_CASE("one sample is the walk as it always was") {
  const State one = walked(1);
  const Timeline plain = record_strip(one.scene());
  REQUIRE(one.walk.timeline->steps() == plain.steps());
  for (std::size_t i = 0; i < plain.pixels().size(); ++i) {
    CHECK(one.walk.timeline->pixels()[i].shade == plain.pixels()[i].shade);
    CHECK(one.walk.timeline->pixels()[i].mean == plain.pixels()[i].shade);
  }
}

TEST_CASE("a small plot shows the samples so far, their mean and how sure it is") {
  State state = walked(4);
  const auto& pixels = state.walk.timeline->pixels();
  // The third sample of some pixel whose samples differ.
  std::size_t first = 0;
  while (pixels[first].shade == pixels[first + 1].shade) first += 4;
  update(state, action::Jump{pixels[first + 2].done_at});
  double mean = 0, squares = 0;
  const auto grey = [&](std::size_t i) { return (pixels[i].shade.x + pixels[i].shade.y + pixels[i].shade.z) / 3; };
  for (std::size_t i = first; i < first + 3; ++i) mean += grey(i) / 3;
  for (std::size_t i = first; i < first + 3; ++i) squares += (grey(i) - mean) * (grey(i) - mean);
  const double half = 4.303 * std::sqrt(squares / 2 / 3);
  const auto texts = texts_in(plan_view(state, state.plan.viewport));
  const std::string expected =
      fill("plan.samples_mean", in_english,
           {{"samples", "3"}, {"mean", number_text(mean, in_english)}, {"interval", number_text(half, in_english)}});
  CAPTURE(expected);
  CHECK(std::find(texts.begin(), texts.end(), expected) != texts.end());
  CHECK(is_finite(plan_view(state, state.plan.viewport)));
  // Not for one sample, and not in Move.
  update(state, action::SetMode{Mode::move});
  const auto moving = texts_in(plan_view(state, state.plan.viewport));
  CHECK(std::find(moving.begin(), moving.end(), expected) == moving.end());
}

TEST_CASE("no more samples are walked than a recording holds, and that is said") {
  State state = walked(1);
  TraceLimits limits = state.scene().limits;
  limits.depth = 50;
  limits.threshold = 0;
  update(state, action::SetLimits{limits});
  ImageSettings settings = state.picture.settings;
  settings.walk_samples = 1 << 20;
  update(state, action::SetImageSettings{settings});
  CHECK(state.picture.settings.walk_samples == max_walk_samples);
  CHECK(state.walk.timeline->steps() <= 500'000);
  const int walked_samples = state.walk.timeline->pixels().back().sample + 1;
  if (walked_samples < max_walk_samples) {
    REQUIRE(state.document.notice);
    CHECK(state.document.notice->text ==
          fill("notice.too_many_samples", state.appearance.language, {{"samples", std::to_string(walked_samples)}}));
  }
}

TEST_CASE("ghosts are those of the sample under way") {
  State state = walked(3);
  update(state, action::SetLimits{{1, 0}});
  update(state, action::ShowGhosts{true});
  int with_ghosts = 0;
  for (const PixelRecord& pixel : state.walk.timeline->pixels()) {
    update(state, action::Jump{pixel.done_at});
    REQUIRE(state.walk.ghosts);
    for (const GhostRay& ghost : state.walk.ghosts->rays) {
      if (ghost.record.parent >= 0) continue;
      ++with_ghosts;
      const RayRecord& stub = state.walk.timeline->rays()[static_cast<std::size_t>(ghost.stub)];
      CHECK(ghost.record.origin == stub.origin);
      CHECK(ghost.record.direction == stub.direction);
    }
  }
  CHECK(with_ghosts > 0);
}
