#include "render/world_cache.h"
#include "scene/cone_limits.h"
#include "timeline/recorder.h"
#include "trace/outlines.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/text/text.h"
#include "view/walk/fault.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

struct Recorded {
  Timeline timeline;
  int depth;        ///< of the recording; less than the scene's if that would be too long
  int samples = 1;  ///< per pixel; possibly fewer for the same reason
};

void limit_depth(SceneSeen& scene, int depth) {
  TraceLimits limits = scene->limits;
  limits.depth = depth;
  scene.set(limits);
}

/// Records the current walk in this scene; all cells of the strip or one.
Timeline record(const State& state, const Scene& scene, std::optional<Fault> fault, int samples,
                std::optional<int> cell = {}) {
  Recording how{state.picture.settings.single_precision ? Precision::float_ : Precision::double_,
                {},
                fault,
                state.document.worlds.get()};
  how.sampling.per_pixel = samples;
  how.stop = state.document.stop;
  if (!state.walk.pixel) return cell ? record_cell(scene, *cell, how) : record_strip(scene, how);
  return record_pixel(scene, state.walk.pixel->size, state.walk.pixel->column, state.walk.pixel->row, how);
}

/// The strip or the pixel to the scene's depth, or the deepest that is not too long. A tree can double with every
/// level, so a deep limit is approached in steps allowed by the growth so far.
Recorded record_to_depth(const State& state) {
  constexpr int harmless_depth = 6;
  constexpr double worst_growth = 4;  // two rays, their shadow rays and the lines between, per ray of the previous
                                      // level
  SceneSeen limited = walked_scene(state);
  const int wanted = limited->limits.depth;
  limit_depth(limited, std::min(wanted, harmless_depth));
  const std::optional<Fault> fault = fault_at_work(state);
  Recorded recorded{record(state, *limited, fault, 1), limited->limits.depth};
  double growth = worst_growth;
  while (recorded.depth < wanted) {
    if (!recorded.timeline.is_cut_off_by_depth()) return {std::move(recorded.timeline), wanted};
    const double events = recorded.timeline.steps_of_all_rays();
    const double room = std::log(max_events / events) / std::log(std::min(worst_growth, 1.2 * growth));
    if (!(room >= 1)) return recorded;
    const int levels = std::min({static_cast<int>(std::min(room, 64.0)), wanted - recorded.depth});
    limit_depth(limited, recorded.depth + levels);
    recorded = {record(state, *limited, fault, 1), limited->limits.depth};
    growth = std::max(1.0, std::pow(recorded.timeline.steps_of_all_rays() / events, 1.0 / levels));
  }
  return recorded;
}

/// The same with the requested samples, or as many as are not too long.
Recorded record_within(const State& state) {
  Recorded recorded = record_to_depth(state);
  const double room = max_events / std::max(1, recorded.timeline.steps());
  const int asked = samples_seen(state, state.picture.settings.walk_samples);
  recorded.samples = static_cast<int>(std::clamp(room, 1.0, static_cast<double>(asked)));
  if (recorded.samples == 1) return recorded;
  SceneSeen limited = walked_scene(state);
  limit_depth(limited, recorded.depth);
  recorded.timeline = record(state, *limited, fault_at_work(state), recorded.samples);
  return recorded;
}

/// The same walk without the bug, or with it once fixed.
std::shared_ptr<const Timeline> record_other(const State& state, int depth, int samples) {
  SceneSeen limited = walked_scene(state);
  limit_depth(limited, depth);
  const std::optional<Fault> other = state.walk.bug->mended ? std::optional(state.walk.bug->fault) : std::nullopt;
  return std::make_shared<const Timeline>(record(state, *limited, other, samples));
}

/// Whose ray it is: of a parent, of a kind, to a light; of several the n-th.
bool alike(const RayRecord& a, const RayRecord& b) {
  return a.parent == b.parent && a.kind == b.kind && a.light == b.light;
}

/// Of a walk: one sample of a pixel, from its begin until it is done; -1: what comes before the first.
struct Stretch {
  int begin, end;
  Timeline::Range rays;
};
Stretch stretch(const Timeline& timeline, int pixel) {
  if (pixel >= 0) {
    const PixelRecord& record = timeline.pixels()[static_cast<std::size_t>(pixel)];
    return {record.begun_at, record.done_at, timeline.rays_of_pixel(pixel)};
  }
  const int end = timeline.pixels().empty() ? timeline.steps() : timeline.pixels().front().begun_at - 1;
  return {0, end, {0, static_cast<int>(timeline.rays_at(end).size())}};
}

/// The ray of a stretch in `after` that corresponds to `ray` in `before`; -1: none.
int same_ray(const Timeline& before, int ray, const Timeline& after, int pixel) {
  const std::vector<RayRecord>&rays = before.rays(), &others = after.rays();
  RayRecord sought = rays[static_cast<std::size_t>(ray)];
  const int first = stretch(before, pixel).rays.first;
  const auto ahead = std::count_if(rays.begin() + first, rays.begin() + ray,
                                   [&](const RayRecord& other) { return alike(other, sought); });
  if (sought.parent >= 0) sought.parent = sought.parent < first ? -1 : same_ray(before, sought.parent, after, pixel);
  const Timeline::Range range = stretch(after, pixel).rays;
  int found = 0;
  for (int i = range.first; i < range.last; ++i)
    if (alike(others[static_cast<std::size_t>(i)], sought) && found++ == ahead) return i;
  return -1;
}

/// The position in `after` that corresponds to `position` in `before`: as far from where the same ray was formed.
int same_place(const Timeline& before, int position, const Timeline& after) {
  if (position <= 0) return 0;
  if (position >= before.steps()) return after.steps();
  const int pixel = before.current_pixel(position);
  if (pixel >= static_cast<int>(after.pixels().size())) return after.steps();
  const Stretch old = stretch(before, pixel), now = stretch(after, pixel);
  if (position == old.end) return now.end;
  const int ray = before.current_ray(position);
  const int other = ray < old.rays.first ? -1 : same_ray(before, ray, after, pixel);
  if (other < 0) return std::min(now.begin + (position - old.begin), now.end);
  const int since = position - before.rays()[static_cast<std::size_t>(ray)].formed_at;
  const int last =
      other + 1 < now.rays.last ? after.rays()[static_cast<std::size_t>(other) + 1].formed_at - 1 : now.end;
  return std::min(after.rays()[static_cast<std::size_t>(other)].formed_at + std::max(since, 0), last);
}

}  // namespace

Timeline record_under(const State& state, int column, int samples, const TraceLimits& limits) {
  SceneSeen limited = walked_scene(state);
  limited.set(limits);
  return record(state, *limited, fault_at_work(state), samples, column);
}

Timeline record_alone(const State& state) {
  State alone = state;
  alone.document.worlds = std::make_shared<WorldCache>();
  return record_within(alone).timeline;
}

void record_again(State& state) {
  state.walk.planar = is_planar(state.scene());
  Recorded recorded = record_within(state);
  if (recorded.depth < walked_scene(state)->limits.depth)
    inform(state, fill("notice.too_many_steps", state.appearance.language, {{"depth", recorded.depth}}));
  if (recorded.samples < samples_seen(state, state.picture.settings.walk_samples) && !recorded.timeline.of_beams())
    inform(state, fill("notice.too_many_samples", state.appearance.language, {{"samples", recorded.samples}}));
  RenderChoices wished = state.scene().render;
  choose(state, wished);
  if (wished.integrator == Integrator::beams && !state.walk.pixel && !recorded.timeline.of_beams())
    inform(state,
           fill("notice.no_beams", state.appearance.language, {{"object", object_against_beams(state.scene())}}));
  if (wished.integrator == Integrator::cones && !recorded.timeline.of_cones())
    inform(state,
           fill("notice.no_cones", state.appearance.language, {{"object", object_against_cones(state.scene())}}));
  if (state.walk.bug) state.walk.bug->other = record_other(state, recorded.depth, recorded.samples);
  const auto after = std::make_shared<const Timeline>(std::move(recorded.timeline));
  state.walk.position = same_place(*state.walk.timeline, state.walk.position, *after);
  state.walk.timeline = after;
  state.plan.hovered_ray = -1;
  if (!exists(state, state.plan.selected)) state.plan.selected = {};
  if (!exists(state, state.plan.hovered)) state.plan.hovered = {};
  if (state.plan.hovered.kind == TargetKind::ray) state.plan.hovered = {};
  if (state.walk.position == state.walk.timeline->steps()) state.walk.playing = false;
}

}  // namespace raywalk
