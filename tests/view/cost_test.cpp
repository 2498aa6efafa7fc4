// The Cost panel without a window.
#include "view/cost/cost.h"

#include "fixtures.h"
#include "support/catch.h"
#include "support/languages.h"

#include <algorithm>
#include <cmath>

using namespace raywalk;
using namespace raywalk::test;

namespace {

study::Attempt attempt(int samples, double rays, double error, bool single = false) {
  study::Attempt one;
  one.setup.samples = samples;
  one.setup.single_precision = single;
  one.cost.rays = static_cast<std::uint64_t>(rays);
  one.cost.tests = 10 * one.cost.rays;
  one.cost.seconds = rays / 1e6;
  one.error = error;
  one.done = 1;
  return one;
}

Image plain(int width, int height, float value) {
  return {width, height, std::vector<Rgb<float>>(static_cast<std::size_t>(width * height), Rgb<float>(value))};
}

}  // namespace

TEST_CASE("knobs start as the scene has them and stay within their limits") {
  State state = busy_state();
  CHECK(cost_knobs(state) == study::setup_of(state.scene()));
  study::Setup wild;
  wild.samples = 1 << 30, wild.light_grid = -4, wild.depth = 0, wild.threshold = 7, wild.tolerance = -1;
  update(state, action::SetCostKnobs{wild});
  const study::Setup tame = cost_knobs(state);
  CHECK(tame.samples == CostRoom::max_samples);
  CHECK(tame.light_grid == 0);
  CHECK(tame.depth == 1);
  CHECK(tame.threshold == 1);
  CHECK(tame.tolerance == 0);
  CHECK(tame.epsilon == default_epsilon);  // of robust numerics there is none to choose
  wild.threshold = std::nan("");
  update(state, action::SetCostKnobs{wild});
  CHECK(cost_knobs(state) == tame);
}

TEST_CASE("what is tried is kept once, and the last try is looked at") {
  State state = busy_state();
  update(state, action::TryCost{});
  REQUIRE(state.cost.tried.size() == 1);
  CHECK(state.cost.chosen == 0);
  update(state, action::TryCost{true});
  REQUIRE(state.cost.tried.size() == 4);  // 1 sample is the scene's own
  CHECK(state.cost.tried[2].samples == 16);
  CHECK(state.cost.chosen == 3);
  update(state, action::TryCost{});
  CHECK(state.cost.tried.size() == 4);
  CHECK(state.cost.chosen == 0);
  update(state, action::ChooseCost{2, true});
  update(state, action::ChooseCost{1, false});
  CHECK(state.cost.against == 2);
  CHECK(state.cost.chosen == 1);
  update(state, action::ChooseCost{9, true});
  update(state, action::ChooseCost{-1, false});
  CHECK(state.cost.against == 2);
  CHECK(state.cost.chosen == 1);
  update(state, action::ChooseCost{-1, true});
  CHECK(state.cost.against == -1);
  for (int i = 1; i < 200; ++i) {
    study::Setup setup;
    setup.samples = i;
    update(state, action::SetCostKnobs{setup});
    update(state, action::TryCost{});
  }
  CHECK(state.cost.tried.size() == CostRoom::max_tries);
  CHECK(state.cost.chosen < CostRoom::max_tries);
  update(state, action::ForgetCosts{});
  CHECK(state.cost.tried.empty());
  CHECK(state.cost.chosen == -1);
  CHECK_FALSE(state.document.dirty);
}

TEST_CASE("small pictures keep the image's shape") {
  CHECK(cost_size({441, 331}) == ImageSize{126, 94});
  CHECK(cost_size({20, 10}) == ImageSize{20, 10});
  CHECK(cost_size({1, 1000000}) == ImageSize{1, 109544});
}

TEST_CASE("the plot has a mark for each finished try, better further down and dearer to the right") {
  State state = busy_state();
  state.cost.chosen = 0;
  state.cost.against = 2;
  std::vector<study::Attempt> attempts{attempt(1, 1e4, 0.1), attempt(4, 4e4, 0.05), attempt(16, 1.6e5, 0.025),
                                       attempt(16, 1.6e5, 0.03, true), attempt(64, 6.4e5, 0)};
  attempts.push_back(attempt(256, 1e7, 1));
  attempts.back().done = 0.5;
  for (const auto axis : {study::CostAxis::rays, study::CostAxis::tests, study::CostAxis::seconds}) {
    state.cost.axis = axis;
    const CostPlot plot = cost_plot(state, {attempts, 0.001, 256}, 420, 260, 1);
    REQUIRE(plot.marks.size() == 5);
    CHECK(is_finite(plot.list));
    for (const CostPlot::Mark& mark : plot.marks) {
      CHECK((mark.at.x > 0 && mark.at.x < 420));
      CHECK((mark.at.y > 0 && mark.at.y < 260));
    }
    for (int i = 1; i < 3; ++i) {
      CHECK(plot.marks[static_cast<std::size_t>(i)].at.x > plot.marks[static_cast<std::size_t>(i) - 1].at.x);
      CHECK(plot.marks[static_cast<std::size_t>(i)].at.y > plot.marks[static_cast<std::size_t>(i) - 1].at.y);
    }
    // What is below the floor cannot be told from it.
    CHECK(plot.marks[4].at.y > plot.marks[3].at.y);
  }
}

TEST_CASE("nothing is drawn where there is no room, and axes alone before the first try") {
  const State state = busy_state();
  CHECK(cost_plot(state, {{}, 0, 0}, 10, 10, 1).list.empty());
  const CostPlot plot = cost_plot(state, {{}, 0, 0}, 400, 300, 2);
  CHECK(plot.marks.empty());
  CHECK_FALSE(plot.list.empty());
  const std::vector<study::Attempt> same(3, attempt(1, 1000, 0.5));
  CHECK(is_finite(cost_plot(state, {same, 0, 0}, 400, 300, 1).list));
}

TEST_CASE("each effect has a bar as long as its share of the rays, and one of the time with its interval") {
  State state = busy_state();
  study::SceneCost survey;
  survey.whole.rays = 1000, survey.whole.seconds = 0.5, survey.shadow_rays = 250;
  survey.everything = study::Cost{.rays = 9000, .seconds = 2};
  survey.effects = {{Effect::penumbra, {}, 0.5, 0.25, 0.2, 0.3}, {Effect::textures, {}, 0, -0.01, -0.02, 0.01}};
  const DisplayList list = effect_bars(state, survey, 800, 300, 1);
  CHECK(is_finite(list));
  std::vector<double> widths;
  std::vector<std::string> texts;
  for (const DisplayItem& item : list) {
    if (const auto* bar = std::get_if<PolygonItem>(&item.shape)) widths.push_back(bar->points[1].x - bar->points[0].x);
    if (const auto* words = std::get_if<TextItem>(&item.shape)) {
      texts.push_back(words->text);
      CHECK(words->at.y < 300);
    }
  }
  REQUIRE(widths.size() == 5);  // rays and time of both, and the shadow rays
  CHECK(widths[1] == Approx(widths[0] / 2));
  CHECK(widths[2] == 0);
  CHECK(widths[3] == 0);
  CHECK(widths[4] == Approx(widths[0] / 2));
  for (const char* expected : {"penumbra", "50% of the rays", "25% of the time (20% to 30%)", "textures",
                               "0% of the rays", "\u22121% of the time (\u22122% to 1%)", "25% of the rays"})
    CHECK(std::find(texts.begin(), texts.end(), expected) != texts.end());
  CHECK(effect_texts(survey, in_english) ==
        std::vector<std::string>{"What each effect adds to this scene: the image with it, minus the image without it",
                                 "penumbra: 50% of the rays, 25% of the time (20% to 30%)",
                                 "textures: 0% of the rays, \u22121% of the time (\u22122% to 1%)",
                                 "all shadow rays: 25% of the rays"});
  CHECK(survey_text(survey, 1, in_english) ==
        "All together: 1000 rays in 0.5 s. Every effect, used or not: 9 times the rays, 4 times the time.");
  study::SceneCost deep = survey;
  deep.everything.reset();
  CHECK(survey_text(deep, 1, in_english) ==
        "All together: 1000 rays in 0.5 s. Every effect, used or not, is not measured deeper than 10: its rays "
        "double at every depth.");
  CHECK(survey_text({}, 0.25, in_english) == "measuring: 25%");
  CHECK(effect_bars(state, {}, 800, 300, 1).empty());
  // However small.
  CHECK(is_finite(effect_bars(state, survey, 10, 5, 2)));
  update(state, action::ShowCostPage{CostPage::effects});
  CHECK(state.cost.page == CostPage::effects);
}

TEST_CASE("a setup is named by what sets it apart") {
  study::Setup usual, other;
  CHECK(setup_text(usual, usual, in_english) == "16 samples, jittered");
  other.samples = 1, other.depth = 2, other.single_precision = true, other.accelerator = AcceleratorKind::grid;
  CHECK(setup_text(other, usual, in_english) == "1 sample, depth 2, float, grid");
  other = usual;
  other.sampler = Sampler::sobol, other.tolerance = 0.02, other.light_grid = 3, other.threshold = 0.1;
  CHECK(setup_text(other, usual, in_english) ==
        "16 samples, sobol, tolerance 0.02, 3 \u00d7 3 per light, threshold 0.1");
  other = usual;
  other.numerics = Numerics::naive, other.epsilon = 0.01;
  CHECK(setup_text(other, usual, in_english) == "16 samples, jittered, naive, epsilon 0.01");
  CHECK(setup_text(usual, other, in_english) == "16 samples, jittered, robust");
}

TEST_CASE("what an attempt cost is told in one line") {
  const State state = busy_state();
  std::vector<study::Attempt> attempts{attempt(4, 1234567, 0.02)};
  attempts[0].setup.depth = state.scene().limits.depth;
  attempts[0].setup.threshold = state.scene().limits.threshold;
  CHECK(attempt_text(state, {attempts, 0.002, 256}, 0) ==
        "4 samples, jittered: error 0.02 (10 times the reference's own); 1.23 M rays, 12.3 M tests, 1.23 s");
  attempts[0].error = 0;
  CHECK(attempt_text(state, {attempts, 0, 0}, 0) == "4 samples, jittered: error ?; 1.23 M rays, 12.3 M tests, 1.23 s");
  attempts[0].done = 0.25;
  CHECK(attempt_text(state, {attempts, 0, 0}, 0) == "4 samples, jittered: tracing: 25%");
  CHECK(reference_text({attempts, 0.002, 256}, in_english) ==
        "reference image: 256 samples per pixel, its own error about 0.002");
  CHECK(attempt_text(state, {attempts, 0, 0}, 5).size() > 10);
}

TEST_CASE("the split shows A on the left, B on the right; the difference is black where they agree") {
  CostRoom cost;
  cost.split = 0.5;
  double largest = -1;
  const Image a = plain(4, 2, 0.0f);
  Image b = plain(4, 2, 1.0f);
  auto rgba = cost_picture(cost, a, b, Encoding::srgb, largest);
  REQUIRE(rgba.size() == 32);
  CHECK(rgba[0] == 0);
  CHECK(rgba[4] == 0);
  CHECK(rgba[8] == 255);
  CHECK(rgba[16] == 0);
  CHECK(largest == 0);
  cost.picture = CostPicture::difference;
  b = a;
  b.pixels[5] = Rgb<float>(0, 0.25f, 0);
  rgba = cost_picture(cost, a, b, Encoding::srgb, largest);
  CHECK(largest == 0.25);
  CHECK(rgba[20] == 254);  // the scale's lightest
  CHECK(rgba[0] == 0);
  CHECK(rgba[2] == 78);  // and its darkest
  // Without a B there is A alone.
  rgba = cost_picture(cost, a, {}, Encoding::srgb, largest);
  CHECK(rgba[20] == 0);
}
