#include "view/walk/ghosts.h"

#include "timeline/recorder.h"
#include "view/state.h"
#include "view/walk/fault.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <map>

namespace raywalk {

namespace {

bool forbidden_by_limit(const RayRecord& ray) {
  return !ray.formed && (ray.ending == Ending::depth || ray.ending == Ending::threshold);
}

/// A ray's contribution to the pixel: its throughput times what its SHADE returned, or the background or the sky.
Rgbd brought_by(const Timeline& timeline, const RayRecord& ray, const Rgbd& background) {
  if (ray.shade >= 0) return ray.throughput * timeline.frames()[static_cast<std::size_t>(ray.shade)].returned;
  const Event* event = timeline.just_run(ray.found_at);
  const auto* found = event != nullptr ? std::get_if<Found>(&event->detail) : nullptr;
  const auto* sky = found != nullptr ? std::get_if<SkyNumbers>(&found->numbers) : nullptr;
  return ray.throughput * (sky != nullptr ? sky->radiance : background);
}

}  // namespace

Ghosts ghosts_of(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const int pixel = timeline.current_pixel(state.walk.position);
  Ghosts ghosts;
  ghosts.of = state.walk.timeline;
  ghosts.pixel = pixel;
  if (pixel < 0 || timeline.of_paths() || timeline.has_width()) return ghosts;  // whose trees differ
  // If DEPTH is not counted, a deeper limit cuts elsewhere, and rays cannot be matched.
  if (fault_at_work(state) == Fault::depth_not_counted) return ghosts;
  const auto [first, last] = timeline.rays_of_pixel(pixel);
  const auto ray_at = [](const Timeline& of, int i) -> const RayRecord& {
    return of.rays()[static_cast<std::size_t>(i)];
  };
  const auto is_cut = [&](int i) { return forbidden_by_limit(ray_at(timeline, i)); };
  const PixelRecord& record = timeline.pixels()[static_cast<std::size_t>(pixel)];
  ghosts.shade = record.shade;
  int deepest = 0, deepest_cut = 0;  // of a SHADE that formed a ray, that was prevented from it
  for (int i = first; i < last; ++i) {
    deepest = std::max(deepest, ray_at(timeline, i).depth + 1);
    if (is_cut(i)) deepest_cut = std::max(deepest_cut, ray_at(timeline, i).depth);
  }
  if (deepest_cut == 0) return ghosts;

  // Two rays, their shadow rays and the lines between, per ray of the previous level.
  constexpr double worst_growth = 4;
  const int samples = samples_of_pixel(timeline, pixel);
  for (double events = static_cast<double>(record.done_at - record.begun_at) * samples;
       ghosts.levels < Ghosts::max_levels; ++ghosts.levels)
    if ((events *= worst_growth) > max_events) break;
  const Timeline deep =
      record_under(state, record.column, samples, {std::max(deepest, deepest_cut + ghosts.levels), 0});
  // The two trees are equal down to the stubs, in the same order: a stub corresponds to its parent's ray of its kind.
  std::map<int, int> same;  // deep walk's ray -> the state's
  std::map<int, int> ghost_of;
  int next = first;
  const Timeline::Range of_sample = deep.rays_of_pixel(record.sample);
  for (int i = of_sample.first; i < of_sample.last; ++i) {
    const RayRecord& ray = ray_at(deep, i);
    const auto parent = ghost_of.find(ray.parent);
    if (parent == ghost_of.end()) {
      same[i] = next++;
      if (!is_cut(same[i])) continue;
    }
    if (!ray.formed && !forbidden_by_limit(ray)) continue;
    GhostRay ghost{ray};
    ghost.record.parent = parent == ghost_of.end() ? -1 : parent->second;
    ghost.stub = parent == ghost_of.end() ? same[i] : ghosts.rays[static_cast<std::size_t>(parent->second)].stub;
    if (ray.formed && ray.kind != RayKind::shadow) {
      ghost.contribution = brought_by(deep, ray, state.scene().background);
      if (ghost.record.parent < 0) ghosts.lost += ghost.contribution;
    }
    ghost_of[i] = static_cast<int>(ghosts.rays.size());
    ghosts.rays.push_back(ghost);
  }
  return ghosts;
}

void follow_with_ghosts(State& state) {
  if (!state.walk.shows_ghosts || state.walk.mode != Mode::trace) return state.walk.ghosts.reset();
  const int pixel = state.walk.timeline->current_pixel(state.walk.position);
  if (state.walk.ghosts && state.walk.ghosts->of == state.walk.timeline && state.walk.ghosts->pixel == pixel) return;
  state.walk.ghosts = std::make_shared<const Ghosts>(ghosts_of(state));
}

double share_of(const Rgbd& contribution, const Ghosts& ghosts) {
  double most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double all = ghosts.shade[channel] + ghosts.lost[channel];
    if (all > 0) most = std::max(most, contribution[channel] / all);
  }
  return std::min(most, 1.0);
}

}  // namespace raywalk
