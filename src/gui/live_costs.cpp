#include "gui/live_costs.h"

#include <algorithm>

namespace raywalk {

bool LiveCosts::follows(const State& state) const {
  if (!begun_) return state.cost.tried.empty();
  return scene_revision_ == state.revision && shown_ == state.cost && bench_revision_ == bench_.revision();
}

bool LiveCosts::rests(const State& state) const {
  if (state.tab != Tab::cost || state.drag) return true;
  return follows(state) && bench_.finished();
}

bool LiveCosts::work(const State& state, double milliseconds) {
  if (rests(state)) return false;
  const std::vector<study::Setup>& wanted = state.cost.tried;
  const bool forgotten = wanted.size() < shown_.tried.size();
  if (!begun_ || scene_revision_ != state.revision || forgotten) {
    bench_.reset(state.scene(), cost_size(state.scene().image), wanted);
    scene_revision_ = state.revision;
    begun_ = true;
  }
  for (std::size_t i = bench_.attempts().size(); i < wanted.size(); ++i) bench_.try_out(wanted[i]);
  bench_.work(milliseconds);
  if (!follows(state)) show(state);
  return !rests(state);
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
