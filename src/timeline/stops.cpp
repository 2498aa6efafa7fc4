#include "timeline/stops.h"

#include <algorithm>

namespace raywalk {

namespace {

const FrameRecord& frame_of(const Timeline& timeline, int frame) {
  return timeline.frames()[static_cast<std::size_t>(frame)];
}

/// The innermost call that has not returned; null in MAIN ALGORITHM.
const FrameRecord* innermost(const Timeline& timeline, int position) {
  const std::vector<int> calls = timeline.stack(position);
  return calls.empty() ? nullptr : &frame_of(timeline, calls.front());
}

/// DEPTH of the SHADE that has just been called or else executes; for a path, its number of rays.
int reached(const Timeline& timeline, int position) {
  const Event* event = timeline.just_run(position);
  if (event == nullptr) return 0;
  const auto* called = std::get_if<ShadeCalled>(&event->detail);
  if (called != nullptr && !called->missed) return called->depth;
  return depth_after(*event);
}

bool is_total(const EventDetail& detail) {
  const auto* decided = std::get_if<Decided>(&detail);
  return decided != nullptr && decided->why == Ending::total_internal_reflection;
}

}  // namespace

int depth_after(const Event& event) {
  const bool forms_next = event.line == Line::form_next_ray || event.line == Line::photon_form_next_ray ||
                          event.line == Line::gather_form_next_ray;
  return event.depth + (forms_next ? 1 : 0);
}

int step_over(const Timeline& timeline, int position) {
  if (position >= timeline.steps()) return position;
  if (timeline.event(position).line == Line::shoot_light) return timeline.end_of_shot(position);
  const FrameRecord* called = innermost(timeline, position + 1);
  return called != nullptr && called->called_at == position + 1 ? called->returned_at : position + 1;
}

int step_back_over(const Timeline& timeline, int position) {
  if (position <= 0) return position;
  if (timeline.event(position - 1).line == Line::forget_unshot_light) {
    int call = position - 1;
    while (timeline.event(call).line != Line::shoot_light) --call;
    return call;
  }
  const int executed = timeline.current_frame(position);
  const bool returned = executed >= 0 && frame_of(timeline, executed).returned_at == position;
  return returned ? frame_of(timeline, executed).called_at - 1 : position - 1;
}

int step_out(const Timeline& timeline, int position) {
  const FrameRecord* call = innermost(timeline, position);
  return call != nullptr ? call->returned_at : timeline.next_pixel(position);
}

int step_back_out(const Timeline& timeline, int position) {
  const FrameRecord* call = innermost(timeline, position);
  return call != nullptr ? call->called_at - 1 : timeline.previous_pixel(position);
}

bool stops_at(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position) {
  const Event* next = timeline.next(position);
  if (next != nullptr && breakpoints.is_before(next->line)) return true;
  const Event* event = timeline.just_run(position);
  if (event == nullptr) return false;
  if (breakpoints.total_internal_reflection && is_total(event->detail)) return true;
  if (breakpoints.depth && reached(timeline, position) >= *breakpoints.depth &&
      reached(timeline, position - 1) < *breakpoints.depth)
    return true;
  if (const auto* begun = std::get_if<PixelBegun>(&event->detail)) return breakpoints.pixel == begun->column;
  if (breakpoints.object.empty()) return false;
  const auto is_object = [&](int object) {
    return object >= 0 && scene.objects[static_cast<std::size_t>(object)].name == breakpoints.object;
  };
  if (const auto* cut = std::get_if<BeamCut>(&event->detail))
    return std::any_of(cut->pieces.begin(), cut->pieces.end(),
                       [&](const BeamPiece& piece) { return is_object(piece.object); });
  const auto* found = std::get_if<Found>(&event->detail);
  return found != nullptr && found->ending == Ending::hit && is_object(found->object);
}

int next_stop(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position, int last) {
  last = std::min(last, timeline.steps());
  while (++position < last)
    if (stops_at(breakpoints, scene, timeline, position)) return position;
  return last;
}

int previous_stop(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline, int position) {
  while (--position > 0)
    if (stops_at(breakpoints, scene, timeline, position)) return position;
  return 0;
}

}  // namespace raywalk
