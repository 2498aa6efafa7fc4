#include "view/stack/stack_panel.h"
#include "timeline/stops.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <algorithm>
#include <vector>

namespace raywalk {

namespace {

template <class Id>
std::string str(const State& state, Id id) {
  return std::string(text(id, state.appearance.language));
}

const RayRecord& ray_of(const Timeline& timeline, int index) {
  return timeline.rays()[static_cast<std::size_t>(index)];
}

/// The return value of a call for this kind of ray, and what its caller does meanwhile.
struct ReturnName {
  std::string_view name, waiting;
};
ReturnName returns(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
    case RayKind::shadow:
    case RayKind::photon:
    case RayKind::beam:
      return {"stack.name_final", "stack.waits_final"};
    case RayKind::reflect:
      return {"stack.name_refl", "stack.waits_refl"};
    case RayKind::refract:
      return {"stack.name_refr", "stack.waits_refr"};
  }
  return {"stack.name_final", "stack.waits_final"};
}

std::string ray_text(const State& state, const RayRecord& ray) {
  const Timeline& timeline = *state.walk.timeline;
  if (ray.parent < 0)
    return fill(ray.beam < 0          ? "stack.primary_ray"
                : timeline.of_beams() ? "stack.beam"
                                      : "stack.cone",
                state.appearance.language, {{"pixel", timeline.pixels()[static_cast<std::size_t>(ray.pixel)].column}});
  const int from = ray_of(timeline, ray.parent).object;
  const std::string name = from < 0 ? std::string() : object_name(state, from);
  return fill("stack.ray_from", state.appearance.language, {{"ray", kind_name(state, ray.kind)}, {"object", name}});
}

/// Adds the returned colour of the SHADE of `ray`'s hit.
void add_returned(const State& state, int ray_index, std::vector<StackRow::Returned>& returned) {
  const Timeline& timeline = *state.walk.timeline;
  const RayRecord& ray = ray_of(timeline, ray_index);
  if (ray.shade < 0) return;
  const FrameRecord& frame = timeline.frames()[static_cast<std::size_t>(ray.shade)];
  const bool done = frame.returned_at > frame.called_at && frame.returned_at <= state.walk.position;
  if (done)
    returned.push_back(
        {str(state, returns(ray.kind).name), frame.returned, display_colour(frame.returned, state.scene().encoding)});
}

/// The current ray of FOLLOW PATH: shadow rays start at its end.
int on_path(const Timeline& timeline, int position) {
  const int current = timeline.current_ray(position);
  const RayRecord& ray = ray_of(timeline, current);
  return ray.kind == RayKind::shadow || !ray.formed ? ray.parent : current;
}

}  // namespace

StackPanel stack_panel(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  StackPanel panel;
  const int pixel = timeline.current_pixel(state.walk.position);
  if (pixel < 0) {
    panel.empty = text_without_pixel(state, "stack.empty");
    return panel;
  }
  const Timeline::Range range = timeline.rays_of_pixel(pixel);
  const auto formed = static_cast<int>(timeline.rays_at(state.walk.position).size());
  const Event* next = timeline.next(state.walk.position);
  const bool running = next != nullptr && !timeline.pixel_done(pixel, state.walk.position);
  const std::string at = running ? fill("stack.works_on", state.appearance.language,
                                        {{"line", std::string(text(next->line, state.appearance.code_language()))}})
                                 : "";

  // What the row below the current one waits for; the innermost call is executing.
  std::optional<RayKind> waits_for;
  const auto waiting = [&] { return waits_for ? str(state, returns(*waits_for).waiting) : at; };
  // A call that has just computed its shade is still shown while returning.
  std::vector<int> calls = timeline.stack(state.walk.position);
  const Event* ran = timeline.just_run(state.walk.position);
  const bool returning = ran != nullptr && without_pencil(ran->line) == Line::compute_rtnshade;
  if (returning) calls.insert(calls.begin(), timeline.current_frame(state.walk.position));
  const int rays_of_path = ran == nullptr ? 1 : std::max(depth_after(*ran), 1);  // it is called with its first
  for (const int call : calls) {
    const FrameRecord& frame = timeline.frames()[static_cast<std::size_t>(call)];
    const int ray_index = timeline.of_paths() ? on_path(timeline, state.walk.position) : frame.ray;
    const RayRecord& ray = ray_of(timeline, ray_index);
    StackRow row;
    row.title = timeline.of_paths() ? fill("stack.path", state.appearance.language, {{"ray", rays_of_path}})
                                    : fill(timeline.of_beams()     ? "stack.shade_parts"
                                           : timeline.of_cones()   ? "stack.shade_cone"
                                           : timeline.of_pencils() ? "stack.shade_pencil"
                                                                   : "stack.shade",
                                           state.appearance.language, {{"depth", frame.depth}});
    row.ray = ray_text(state, ray);
    row.ray_index = ray_index;
    if (ray.object >= 0 && ray.found_at <= state.walk.position) row.object = object_name(state, ray.object);
    const bool returns_now = returning && call == calls.front();
    row.waiting = returns_now ? fill("stack.returns", state.appearance.language,
                                     {{"colour", colour_text(frame.returned, state.appearance.language)}})
                              : waiting();
    for (int i = range.first; i < std::min(range.last, formed); ++i)
      if (ray_of(timeline, i).parent == frame.ray) add_returned(state, i, row.returned);
    if (!returns_now) waits_for = timeline.of_paths() ? RayKind::primary : ray.kind;
    panel.rows.push_back(std::move(row));
  }
  StackRow main;
  main.title = text(timeline.pseudocode().lines.front().procedure, state.appearance.code_language());
  main.waiting = waiting();
  if (range.first < formed && range.first < range.last) add_returned(state, range.first, main.returned);
  panel.rows.push_back(std::move(main));
  return panel;
}

}  // namespace raywalk
