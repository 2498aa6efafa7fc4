#pragma once
// What the statements of trace/beams.h do, but for lights (trace/beam_light_steps.h). Included by it alone.

#include "trace/beams.h"
#include "trace/flat_refraction.h"
#include "trace/part_steps.h"
#include "trace/representable.h"
#include "trace/shadow_transmittance.h"
#include "trace/spawn_ray.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace detail {

/// Farther from the eye than everything that has an end.
[[nodiscard]] double far_from(const Vec2d& eye, const std::vector<Outline>& outlines);

/// Of an angle to a normal: what is less runs along the face.
inline constexpr double least_cosine = 1e-6;

}  // namespace detail

template <class Watcher>
BeamTracer<Watcher>::BeamTracer(const World<double>& world, const std::vector<Outline>& outlines,
                                const RayGenerator<double>& camera, Observer& observer, const Stop& stop)
    : world_(world),
      outlines_(outlines),
      camera_(camera),
      observer_(observer),
      stop_(stop),
      plan_(std::make_shared<const UnfoldedPlan>(outlines, plan(camera.eye()))),
      primitives_(detail::first_primitives(world)),
      far_(detail::far_from(plan(camera.eye()), outlines)),
      nested_(world),
      tracer_(world, camera, no_observer_, stop) {}

template <class Watcher>
void BeamTracer<Watcher>::begin(const Pixel& pixel) {
  stop_.check();
  note(Line::beam_for_each_pixel, 0, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

template <class Watcher>
auto BeamTracer<Watcher>::form_beam(const Pixel& pixel) -> Beam {
  const PixelFan fan{plan(camera_.edge(pixel.column, pixel.row)), plan(camera_.edge(pixel.column + 1, pixel.row))};
  Beam beam{plan_, fan, {0, 0}, {1, 0}, Rgbd(1.0), rays_formed_++};
  if (nested_.any_around_eye()) {
    const Ray<double> middle{camera_.eye(), normalize(detail::in_plan(fan.at({0.5, 0}))), {}, camera_.shutter_open()};
    beam.medium = nested_.at_eye(middle, statistics_.tests);
  }
  note(Line::form_beam, 0, [&] {
    return BeamFormed{beam.number, -1, camera_.eye(), 0, 1, area_of(beam, {beam.begin, beam.end}), beam.throughput};
  });
  return beam;
}

template <class Watcher>
auto BeamTracer<Watcher>::cut(Line line, int depth, const Beam& beam) -> std::vector<Part> {
  stop_.check();
  std::vector<Part> parts;
  for (const BeamPart& seen : beam.plan->cut(beam.fan, beam.begin, beam.end, stop_)) divide(parts, beam, seen);
  for (Part& part : parts) {
    part.number = rays_formed_++;
    meet(part, beam, part.middle());
    ++statistics_.formed(RayKind::beam);
    ++statistics_.ends(part.at ? Ending::hit : Ending::missed);
  }
  note(line, depth, [&] {
    BeamCut cut{beam.number, {}};
    for (const Part& part : parts) {
      BeamPiece piece{part.number,  part.object,         part.begin.value(), part.end.value(),
                      part.width(), area_of(beam, part), part.ray.origin,    part.ray.origin + part.ray.direction,
                      Vec3d(0.0)};
      if (part.at) detail::tell_of(piece, *part.at);
      cut.pieces.push_back(std::move(piece));
    }
    return cut;
  });
  return parts;
}

/// The ray at a place of a part, and what it meets. That in its middle is taken for all of the part.
template <class Watcher>
void BeamTracer<Watcher>::meet(Part& part, const Beam& beam, const Place& place) {
  const Vec2d direction = beam.fan.at(place);
  part.ray = {detail::in_plan(beam.plan->start(direction)), normalize(detail::in_plan(beam.plan->leaving(direction))),
              beam.departure, camera_.shutter_open()};
  if (part.outline < 0) return;
  const auto index = static_cast<std::size_t>(part.outline);
  part.object = outlines_[index].object;
  const Vec3d end = detail::in_plan(beam.plan->end(beam.fan, part, place));
  const Hit<double> hit{length(end - part.ray.origin), primitives_[static_cast<std::size_t>(part.object)],
                        outlines_[index].part};
  const detail::MiddleOfPart<double> middle{part.ray, part.number, beam.medium};
  detail::PatternOfPart<double> mean{world_, part.has_mean};
  part.at = prepare_vertex<AllEffects>(world_, nested_, middle, hit, statistics_, mean);
  part.ambient = part.at->values().ambient;
  // Neither along the face nor where two bodies touch, of which the beam would meet one.
  const Refraction<double>& bends = part.at->refraction;
  part.keeps_beam = is_straight(part) && !is_black(part.at->bsdf.transparent) && bends.cos_in > detail::least_cosine &&
                    bends.cos_out > detail::least_cosine && !beam.plan->has_another_upon(part.outline);
  if (part.at->mapped) return;
  if (part.has_mean)
    part.ambient *= mean.pattern(hit, {}, part.ray.time);
  else
    apply_pattern(part.ambient, *part.at->surface, world_.accelerator.primitives(), hit.primitive,
                  SurfacePoint<double>{part.at->position, part.at->outward_normal}, hit.part, part.ray.time);
}

template <class Watcher>
BeamArea BeamTracer<Watcher>::area_of(const Beam& beam, const BeamPart& part) const {
  const bool curved = part.outline >= 0 && !outlines_[static_cast<std::size_t>(part.outline)].is_straight();
  const int steps = curved ? 16 : 1;
  BeamArea area;
  for (int i = 0; i <= steps; ++i) {
    // Towards its ends, where a circle is seen aslant, the steps are shorter.
    const double share = static_cast<double>(i) / steps, place = share * share * (3 - 2 * share);
    const Place at = i == 0       ? part.begin
                     : i == steps ? part.end
                                  : Place{part.begin.value() + place * (part.end - part.begin), 0};
    const Vec2d direction = beam.fan.at(at);
    const Vec3d start = detail::in_plan(beam.plan->start(direction));
    area.starts.push_back(start);
    area.ends.push_back(part.outline >= 0 ? detail::in_plan(beam.plan->end(beam.fan, part, at))
                                          : start + far_ * normalize(detail::in_plan(beam.plan->leaving(direction))));
  }
  return area;
}

template <class Watcher>
int BeamTracer<Watcher>::call_shade_parts(Line line, int depth, const Beam& beam) {
  note(line, depth, [&] { return ShadeCalled{beam.number, false, depth + 1}; });
  return depth + 1;
}

template <class Watcher>
void BeamTracer<Watcher>::begin(int depth, const std::vector<Part>& parts, const Part& part) {
  note(Line::for_each_part, depth, [&] {
    return PartBegun{part.number, static_cast<int>(&part - parts.data()), static_cast<int>(parts.size()), part.width(),
                     !part.at};
  });
}

template <class Watcher>
Rgbd BeamTracer<Watcher>::shade_middle(int depth, const Part& part, const DirectLighting& direct) {
  const detail::MiddleShade<double> shade = detail::shade_of_middle(world_, part, direct.sum);
  note(Line::shade_middle, depth,
       [&] { return PartShaded{part.number, shade.ambient, shade.emission, direct.terms, shade.total}; });
  return shade.total;
}

template <class Watcher>
bool BeamTracer<Watcher>::is_straight(const Part& part) const {
  return outlines_[static_cast<std::size_t>(part.outline)].is_straight();
}

template <class Watcher>
bool BeamTracer<Watcher>::decide_flat_mirror(int depth, const Part& part) {
  const bool holds = part.at && is_straight(part) && !is_black(part.at->bsdf.mirror);
  note(Line::if_flat_mirror, depth, [&] { return Decided{holds, part.at ? part.at->bsdf.mirror : Rgbd(0.0)}; });
  return holds;
}

template <class Watcher>
auto BeamTracer<Watcher>::form_mirrored_beam(int depth, const Part& part, const Beam& beam) -> std::optional<Beam> {
  const SurfaceVertex<double>& at = *part.at;
  const Rgbd throughput = beam.throughput * at.throughput * at.bsdf.mirror * (part.width() / (beam.end - beam.begin));
  if (const auto why = detail::why_not_followed(world_, depth, throughput)) {
    ++statistics_.ends(*why);
    note(Line::form_mirrored_beam, depth,
         [&] { return RayNotFormed{part.number, RayKind::beam, *why, at.position, at.bsdf.mirror_axis, throughput}; });
    return std::nullopt;
  }
  Beam mirrored{std::make_shared<const UnfoldedPlan>(beam.plan->mirrored(part.outline)),
                beam.fan,
                part.begin,
                part.end,
                throughput,
                rays_formed_++,
                at.departure,
                at.medium};
  note(Line::form_mirrored_beam, depth, [&] {
    return BeamFormed{mirrored.number,    part.number,      detail::in_plan(mirrored.plan->virtual_eye()),
                      part.begin.value(), part.end.value(), area_of(mirrored, {part.begin, part.end}),
                      throughput};
  });
  return mirrored;
}

template <class Watcher>
bool BeamTracer<Watcher>::decide_flat_glass(int depth, const Part& part) {
  const bool holds = part.at && part.keeps_beam;
  note(Line::if_flat_glass, depth, [&] { return Decided{holds, holds ? part.at->bsdf.transparent : Rgbd(0.0)}; });
  return holds;
}

/// P. Heckbert and P. Hanrahan 1984: its rays seem to come from the eye moved along the normal.
template <class Watcher>
auto BeamTracer<Watcher>::form_refracted_beam(int depth, const Part& part, const Beam& beam) -> std::optional<Beam> {
  const SurfaceVertex<double>& at = *part.at;
  const Rgbd throughput =
      beam.throughput * at.throughput * at.bsdf.transparent * (part.width() / (beam.end - beam.begin));
  if (const auto why = detail::why_not_followed(world_, depth, throughput)) {
    ++statistics_.ends(*why);
    note(Line::form_refracted_beam, depth, [&] {
      return RayNotFormed{part.number, RayKind::beam, *why, at.position, at.bsdf.transparent_axis, throughput};
    });
    return std::nullopt;
  }
  const Refraction<double>& bends = at.refraction;
  const FlatRefraction face(plan(at.bsdf.geometric_normal), bends.n1, bends.n2, bends.cos_in, bends.cos_out);
  const auto arriving = [&](const Vec2d& direction) { return beam.plan->leaving(direction); };
  const Vec2d point = plan(at.position), eye = point - face.bent(point - beam.plan->virtual_eye());
  Beam refracted{std::make_shared<const UnfoldedPlan>(beam.plan->beyond(part.outline, eye)),
                 {face.bent(arriving(beam.fan.begin)), face.bent(arriving(beam.fan.end))},
                 part.begin,
                 part.end,
                 throughput,
                 rays_formed_++,
                 at.departure,
                 at.behind};
  note(Line::form_refracted_beam, depth, [&] {
    BeamFormed formed{refracted.number,   part.number,      detail::in_plan(eye),
                      part.begin.value(), part.end.value(), area_of(refracted, {part.begin, part.end}),
                      throughput};
    formed.snell = snell_numbers(bends);
    for (const Place& end : {part.begin, part.end})
      formed.off = std::max(formed.off, face.off(arriving(beam.fan.at(end))));
    return formed;
  });
  return refracted;
}

template <class Watcher>
bool BeamTracer<Watcher>::sends(const Part& part, RayKind kind) const {
  if (!part.at || is_black(detail::weight_of(*part.at, kind))) return false;
  return kind == RayKind::refract ? !part.keeps_beam : !is_straight(part);
}

template <class Watcher>
bool BeamTracer<Watcher>::decide_curved_or_glass(int depth, const Part& part) {
  const bool reflects = sends(part, RayKind::reflect), refracts = sends(part, RayKind::refract);
  note(Line::if_curved_or_glass, depth, [&] {
    Decided decided{reflects || refracts};
    if (reflects) decided.weight += part.at->bsdf.mirror;
    if (refracts) decided.weight += part.at->bsdf.transparent;
    return decided;
  });
  return reflects || refracts;
}

template <class Watcher>
auto BeamTracer<Watcher>::form_middle_ray(int depth, const Part& part, const Beam& beam, RayKind kind)
    -> std::optional<MiddleRay> {
  const SurfaceVertex<double>& at = *part.at;
  const auto [sent, medium] = detail::sent_ray(world_, at, kind);
  const Rgbd throughput =
      beam.throughput * at.throughput * detail::weight_of(at, kind) * (part.width() / (beam.end - beam.begin));
  if (const auto why = detail::why_not_followed(world_, depth, throughput)) {
    ++statistics_.ends(*why);
    note(Line::form_middle_ray, depth,
         [&] { return RayNotFormed{part.number, kind, *why, at.position, sent.direction, throughput}; });
    return std::nullopt;
  }
  const MiddleRay ray{sent, kind, rays_formed_++, medium};
  ++statistics_.formed(kind);
  note(Line::form_middle_ray, depth, [&] {
    RayFormed formed{ray.number, part.number, kind, sent.origin, sent.direction, throughput};
    if (kind == RayKind::refract) formed.snell = snell_numbers(at.refraction);
    return formed;
  });
  return ray;
}

template <class Watcher>
Rgbd BeamTracer<Watcher>::follow_middle_ray(int depth, const MiddleRay& ray) {
  note(Line::follow_middle_ray, depth, [&] {
    const auto nearest = world_.accelerator.closest(ray.ray, infinity<double>, statistics_.tests);
    return nearest ? detail::describe(ray.number, Ending::hit, world_, ray.ray, *nearest)
                   : detail::describe_missed(ray.number, Ending::missed, world_, ray.ray);
  });
  const Rgbd brought = tracer_.radiance_along(ray.ray, depth + 1, ray.medium);
  statistics_ += tracer_.take_statistics();
  return brought;
}

/// Of rays a sixteenth of a part's width from its ends, beside that in its middle, which brought `shade`. What beams
/// bring, `reflected` and `refracted`, is held to be the same there, but for how much of it the surface sends on.
template <class Watcher>
double BeamTracer<Watcher>::off_near_ends(int depth, const Beam& beam, const Part& part, const Rgbd& shade,
                                          const Rgbd& reflected, const Rgbd& refracted) {
  const auto sent = [&](RayKind kind, const Rgbd& brought) {
    Rgbd light(0.0);
    if (!part.at || sends(part, kind)) return light;
    const Rgbd& weight = detail::weight_of(*part.at, kind);
    for (int i = 0; i < 3; ++i)
      if (weight[i] > 0) light[i] = brought[i] / weight[i];
    return light;
  };
  const Statistics counted = statistics_;
  double off = 0;
  for (const double share : {1.0 / 16, 15.0 / 16}) {
    Part beside = part;
    beside.has_mean = false;
    meet(beside, beam, {part.begin.value() + share * part.width(), 0});
    beside.keeps_beam = part.keeps_beam;
    const Rgbd more =
        shade_beside(depth, beside, sent(RayKind::reflect, reflected), sent(RayKind::refract, refracted)) - shade;
    off = std::max({off, std::abs(more.x), std::abs(more.y), std::abs(more.z)});
  }
  statistics_ = counted;
  static_cast<void>(tracer_.take_statistics());
  return off;
}

/// A running mean, as the film's: where all parts have one shade, it is that shade, whatever their widths.
template <class Watcher>
void BeamTracer<Watcher>::add_part(Rgbd& mean, int depth, const Beam& beam, const Part& part, const Rgbd& local,
                                   const Rgbd& reflected, const Rgbd& refracted) {
  const Rgbd left = part.at ? part.at->throughput : Rgbd(1.0);
  const Rgbd shade = left * (local + reflected + refracted);
  mean += (shade - mean) * (part.width() / (part.end - beam.begin));
  note(Line::add_part, depth, [&] {
    return PartAdded{part.number,
                     local,
                     reflected,
                     refracted,
                     shade,
                     part.width() / (beam.end - beam.begin),
                     mean,
                     part.end == beam.end,
                     off_near_ends(depth, beam, part, shade, reflected, refracted)};
  });
}

template <class Watcher>
template <class Put>
void BeamTracer<Watcher>::put_in_pixel(const Pixel& pixel, const Rgbd& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::beam_put_final_shade, 0, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, final}; });
}

}  // namespace raywalk
