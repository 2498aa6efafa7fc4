#include "view/cost/cost.h"

#include "image/srgb.h"
#include "render/heat.h"
#include "study/shot.h"
#include "view/cost/room.h"
#include "view/state.h"
#include "view/text/choice_text.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {

namespace {

using study::Attempt;
using study::Setup;

Setup within_limits(Setup setup) {
  setup.samples = std::clamp(setup.samples, 1, CostRoom::max_samples);
  setup.light_grid = std::clamp(setup.light_grid, 0, CostRoom::max_grid);
  setup.depth = std::clamp(setup.depth, 1, CostRoom::max_depth);
  setup.threshold = std::clamp(setup.threshold, 0.0, 1.0);
  setup.tolerance = std::clamp(setup.tolerance, 0.0, 1.0);
  setup.epsilon = setup.numerics == Numerics::naive ? std::clamp(setup.epsilon, 0.0, 1.0) : default_epsilon;
  return setup;
}

bool was_tried(const CostRoom& cost, int index) { return index >= 0 && index < static_cast<int>(cost.tried.size()); }

/// 1234567 as "1.23 M".
std::string count_text(double count, Language language) {
  if (count >= 1e9) return number_text(count / 1e9, language) + " G";
  if (count >= 1e6) return number_text(count / 1e6, language) + " M";
  if (count >= 1e4) return number_text(count / 1e3, language) + " k";
  return fmt::format("{:.0f}", count);
}

}  // namespace

Setup cost_knobs(const State& state) {
  return within_limits(state.cost.knobs.value_or(study::setup_of(state.scene())));
}

ImageSize cost_size(ImageSize image) { return study::shrunk(image, 12000); }

void action::SetCostKnobs::apply(State& state) const { state.cost.knobs = within_limits(knobs); }

void action::TryCost::apply(State& state) const {
  CostRoom& cost = state.cost;
  std::vector<Setup> wanted;
  if (ladder)
    for (const int samples : {1, 4, 16, 64}) wanted.push_back(cost_knobs(state)), wanted.back().samples = samples;
  else
    wanted.push_back(cost_knobs(state));
  for (const Setup& setup : wanted) {
    const auto known = std::find(cost.tried.begin(), cost.tried.end(), setup);
    cost.chosen = static_cast<int>(known - cost.tried.begin());
    if (known != cost.tried.end()) continue;
    if (cost.tried.size() >= CostRoom::max_tries) {
      cost.chosen = CostRoom::max_tries - 1;
      return;
    }
    cost.tried.push_back(setup);
  }
}

void action::ChooseCost::apply(State& state) const {
  CostRoom& cost = state.cost;
  if (against && (index == -1 || was_tried(cost, index))) cost.against = index;
  if (!against && was_tried(cost, index)) cost.chosen = index;
}

void action::ForgetCosts::apply(State& state) const {
  state.cost.tried.clear();
  state.cost.chosen = state.cost.against = -1;
}

void action::ShowCostPage::apply(State& state) const { state.cost.page = page; }

void action::ShowCosts::apply(State& state) const {
  state.cost.picture = picture;
  state.cost.axis = axis;
  state.cost.split = std::clamp(split, 0.0, 1.0);
}

std::string setup_text(const Setup& setup, const Setup& usual, Language language) {
  std::string all = fill("cost.samples", language, {{"count", setup.samples}});
  const auto add = [&](const std::string& part) { all += ", " + part; };
  if (setup.samples > 1) add(std::string(text(setup.sampler, language)));
  if (setup.tolerance != usual.tolerance)
    add(setup.tolerance > 0 ? fill("cost.tolerance", language, {{"tolerance", number_text(setup.tolerance, language)}})
                            : std::string(text("cost.no_tolerance", language)));
  if (setup.light_grid != usual.light_grid && setup.light_grid > 0)
    add(fill("cost.light_grid", language, {{"grid", setup.light_grid}}));
  if (setup.depth != usual.depth) add(fill("cost.depth", language, {{"depth", setup.depth}}));
  if (setup.threshold != usual.threshold)
    add(setup.threshold > 0 ? fill("cost.threshold", language, {{"threshold", number_text(setup.threshold, language)}})
                            : std::string(text("cost.no_threshold", language)));
  if (setup.single_precision != usual.single_precision)
    add(std::string(text(setup.single_precision ? "cost.float" : "cost.double", language)));
  if (setup.accelerator != usual.accelerator) add(std::string(text(setup.accelerator, language)));
  if (setup.numerics == Numerics::naive)
    add(fill("cost.naive", language, {{"epsilon", number_text(setup.epsilon, language)}}));
  else if (setup.numerics != usual.numerics)
    add(std::string(text("cost.robust", language)));
  return all;
}

std::string attempt_text(const State& state, const CostFindings& findings, int index) {
  const Language language = state.appearance.language;
  if (index < 0 || index >= static_cast<int>(findings.attempts.size()))
    return std::string(text("cost.empty", language));
  const Attempt& attempt = findings.attempts[static_cast<std::size_t>(index)];
  const std::string setup = setup_text(attempt.setup, study::setup_of(state.scene()), language);
  if (attempt.done < 1)
    return setup + ": " + fill("cost.under_way", language, {{"percent", percent_text(attempt.done, language)}});
  const bool known = attempt.error > 0 || findings.floor > 0;
  const std::string times =
      findings.floor > 0 ? fill("cost.times_floor", language,
                                {{"times", fmt::format("{:.0f}", std::max(1.0, attempt.error / findings.floor))}})
                         : std::string();
  return fill(
      "cost.attempt", language,
      {{"setup", setup},
       {"rays", count_text(static_cast<double>(attempt.cost.rays), language)},
       {"tests", count_text(static_cast<double>(attempt.cost.nodes + attempt.cost.tests), language)},
       {"seconds", number_text(attempt.cost.seconds, language)},
       {"error", known ? number_text(attempt.error, language) : std::string(text("cost.awaits_reference", language))},
       {"times", times}});
}

std::string reference_text(const CostFindings& findings, Language language) {
  if (findings.reference_samples < 2) return std::string(text("cost.no_reference", language));
  return fill("cost.reference", language,
              {{"samples", findings.reference_samples}, {"error", number_text(findings.floor, language)}});
}

std::string survey_text(const std::optional<study::SceneCost>& survey, double done, Language language) {
  std::string all;
  if (survey) {
    const double rays = static_cast<double>(survey->whole.rays), seconds = survey->whole.seconds;
    const auto times = [&](double everything, double whole) {
      return number_text(whole > 0 ? everything / whole : 1, language);
    };
    all = fill("cost.whole", language,
               {{"rays", count_text(rays, language)}, {"seconds", number_text(seconds, language)}});
    if (const auto& everything = survey->everything)
      all += " " + fill("cost.everything", language,
                        {{"times_rays", times(static_cast<double>(everything->rays), rays)},
                         {"times_time", times(everything->seconds, seconds)}});
    else
      all += " " + fill("cost.everything_too_deep", language, {{"depth", study::deepest_everything}});
  }
  if (done < 1)
    all += (all.empty() ? "" : "  ") + fill("cost.surveying", language, {{"percent", percent_text(done, language)}});
  return all;
}

std::vector<std::uint8_t> cost_picture(const CostRoom& cost, const Image& left, const Image& right, Encoding encoding,
                                       double& largest) {
  const bool both = right.width == left.width && right.height == left.height;
  const std::size_t count = left.pixels.size();
  std::vector<std::uint8_t> rgba(count * 4, 255);
  const auto put = [&](std::size_t i, const Rgb<float>& colour) {
    for (int channel = 0; channel < 3; ++channel)
      rgba[4 * i + static_cast<std::size_t>(channel)] =
          std::isnan(colour[channel]) ? 255 : to_byte(colour[channel], encoding);
  };
  largest = 0;
  if (cost.picture == CostPicture::split || !both) {
    const int border = static_cast<int>(std::lround(cost.split * left.width));
    for (std::size_t i = 0; i < count; ++i) {
      const bool from_right = both && static_cast<int>(i % static_cast<std::size_t>(left.width)) >= border;
      put(i, from_right ? right.pixels[i] : left.pixels[i]);
    }
    return rgba;
  }
  std::vector<double> differences(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Rgbd difference = Rgbd(left.pixels[i]) - Rgbd(right.pixels[i]);
    differences[i] = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
    largest = std::max(largest, differences[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto colour = heat_colour(largest > 0 ? std::sqrt(differences[i] / largest) : 0);
    std::copy(colour.begin(), colour.end(), rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return rgba;
}

}  // namespace raywalk
