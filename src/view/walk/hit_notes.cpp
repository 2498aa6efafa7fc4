#include "view/text/text.h"
#include "view/walk/equation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace raywalk {

HitNotes hit_notes(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const int index = timeline.current_ray(state.walk.position);
  const Event* event = timeline.just_run(state.walk.position);
  // A pixel that is done has been about more than its first ray.
  if (index < 0 || event == nullptr || event->line == Line::put_final_shade) return {};
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
  if (!ray.formed || ray.found_at > state.walk.position || ray.object < 0) return {};
  const auto* found = std::get_if<Found>(&timeline.event(ray.found_at - 1).detail);
  if (found == nullptr) return {};  // of a beam
  HitNotes notes{"t = " + equation_number(found->t, state.appearance.language), {}};
  if (ray.ending != Ending::hit) return notes;
  const double cosine = -dot(ray.shaded.shading, ray.direction) / std::max(length(ray.direction), 1e-300);
  notes.angle =
      "θ = " + typeset_number(fmt::format("{:.1f}", angle_of_cosine(cosine)), state.appearance.language) + "°";
  return notes;
}

std::optional<BendNotes> bend_notes(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  if (state.walk.position == 0) return std::nullopt;
  const EventDetail& detail = timeline.event(state.walk.position - 1).detail;
  const auto* formed = std::get_if<RayFormed>(&detail);
  const auto* stub = std::get_if<RayNotFormed>(&detail);
  const auto* decided = std::get_if<Decided>(&detail);
  const bool is_total = (stub != nullptr && stub->why == Ending::total_internal_reflection) ||
                        (decided != nullptr && decided->why == Ending::total_internal_reflection);
  if (formed == nullptr && !is_total) return std::nullopt;
  if (formed != nullptr && formed->kind != RayKind::reflect && formed->kind != RayKind::refract) return std::nullopt;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))];
  if (ray.parent < 0 || (is_total && ray.formed)) return std::nullopt;
  const RayRecord& in = timeline.rays()[static_cast<std::size_t>(ray.parent)];
  if (in.ending != Ending::hit || !(length(in.direction) > 0) || !(length(in.shaded.shading) > 0)) return std::nullopt;
  BendNotes notes;
  notes.at = in.end;
  notes.back = -normalize(in.direction);
  notes.normal = in.shaded.shading;
  notes.in_length = length(in.end - in.origin);
  notes.out_length = ray.endless ? std::numeric_limits<double>::infinity() : length(ray.end - ray.origin);
  const auto angle = [&](const char* name, double cosine) {
    return name + typeset_number(fmt::format("{:.1f}", angle_of_cosine(cosine)), state.appearance.language) + "°";
  };
  if (formed == nullptr) {
    notes.angle_in = angle("θ₁ = ", dot(notes.normal, notes.back));
    return notes;
  }
  notes.out = formed->direction;
  const double side = formed->kind == RayKind::refract ? -1 : 1;
  // Snell's numbers of rough glass are those of a facet, whose normal is another one.
  const bool by_facet =
      in.object >= 0 && state.scene().objects[static_cast<std::size_t>(in.object)].material.is_rough();
  const SnellNumbers* snell = formed->snell && !by_facet ? &*formed->snell : nullptr;
  notes.angle_in = angle("θ₁ = ", snell != nullptr ? snell->cos_in : dot(notes.normal, notes.back));
  notes.angle_out = angle("θ₂ = ", snell != nullptr ? snell->cos_out : side * dot(notes.normal, notes.out));
  return notes;
}

}  // namespace raywalk
