#include "gui/live_costs.h"

#include "view/cost/cost.h"

#include <algorithm>
#include <chrono>

namespace raywalk {

bool LiveCosts::follows(const State& state) const {
  if (!begun_) return state.cost.tried.empty();
  return scene_revision_ == state.document.revision && shown_ == state.cost && bench_revision_ == bench_.revision();
}

bool LiveCosts::rests(const State& state) const {
  if (state.appearance.tab != CostRoom::tab || state.plan.drag) return true;
  if (state.cost.page == CostPage::effects) return surveyed(state);
  return follows(state) && bench_.finished();
}

bool LiveCosts::waits(const State& state) const { return state.cost.page == CostPage::tries && workers_.waits(); }

bool LiveCosts::work(const State& state, double milliseconds, const Stop& stop) {
  if (rests(state)) return false;
  if (state.cost.page == CostPage::effects) {
    take_survey(state, milliseconds, stop);
    return !rests(state);
  }
  const std::vector<study::Setup>& wanted = state.cost.tried;
  const auto& had = bench_.attempts();
  const auto is_wanted = [](const study::Attempt& attempt, const study::Setup& setup) {
    return attempt.setup == setup;
  };
  // Cleared, and maybe others tried since.
  const bool forgotten = had.size() > wanted.size() || !std::equal(had.begin(), had.end(), wanted.begin(), is_wanted);
  if (!begun_ || scene_revision_ != state.document.revision || forgotten) {
    const ImageSize size = cost_size(state.scene().image);
    bench_.reset(state.scene(), size, wanted);
    static_cast<void>(workers_.begin(state.scene(), state.document.contents.path, size, wanted));
    scene_revision_ = state.document.revision;
    begun_ = true;
  }
  for (std::size_t i = bench_.attempts().size(); i < wanted.size(); ++i) {
    bench_.try_out(wanted[i]);
    workers_.try_out(wanted[i]);
  }
  if (workers_.at_work()) {
    if (workers_.serve(bench_, true)) {
      if (!follows(state)) show(state);
      return !rests(state);
    }
    bench_.reset(state.scene(), cost_size(state.scene().image), wanted);
  }
  try {
    bench_.work(milliseconds, stop);
  } catch (const Stopped&) {  // it goes on at the next call
  }
  if (!follows(state)) show(state);
  return !rests(state);
}

bool LiveCosts::surveyed(const State& state) const {
  return survey_ && survey_revision_ == state.document.revision && survey_->done() >= 1;
}

void LiveCosts::take_survey(const State& state, double milliseconds, const Stop& stop) {
  // Small pictures, so that the window stays responsive.
  constexpr int samples = 4000, repetitions = 11;
  if (!survey_ || survey_revision_ != state.document.revision) {
    survey_.emplace(state.scene(), samples, repetitions);
    survey_result_.reset();
    survey_revision_ = state.document.revision;
  }
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  try {
    while (survey_->work(stop) && std::chrono::steady_clock::now() < deadline) {
    }
  } catch (const Stopped&) {
    return;  // the picture begins anew at the next call
  }
  survey_result_ = survey_->result();
  ++revision_;
}

void LiveCosts::show(const State& state) {
  const auto attempt = [&](int index) -> const Image* {
    const auto& all = bench_.attempts();
    return index >= 0 && index < static_cast<int>(all.size()) ? &all[static_cast<std::size_t>(index)].image : nullptr;
  };
  const Image* left = attempt(state.cost.chosen);
  const Image* right = state.cost.against < 0 ? &bench_.reference() : attempt(state.cost.against);
  static const Image nothing;
  if (left != nullptr && !left->pixels.empty()) {
    rgba_ = cost_picture(state.cost, *left, right != nullptr ? *right : nothing, state.scene().encoding, largest_);
    size_ = {left->width, left->height};
  } else if (state.cost.tried.empty()) {
    rgba_.clear();
    size_ = {0, 0};
  }
  shown_ = state.cost;
  bench_revision_ = bench_.revision();
  ++revision_;
}

}  // namespace raywalk
