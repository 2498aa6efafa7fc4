#pragma once
// What the statements of trace/space_beams.h do, but for lights (trace/space_beam_light_steps.h). Included by it alone.

#include "trace/part_steps.h"
#include "trace/representable.h"
#include "trace/space_beams.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

template <class T, class Watcher>
SpaceBeamTracer<T, Watcher>::SpaceBeamTracer(const World<T>& world, const BeamFaces& faces,
                                             const RayGenerator<T>& camera, Observer& observer, const Stop& stop)
    : world_(world),
      faces_(faces),
      camera_(camera),
      observer_(observer),
      stop_(stop),
      far_(faces.far_from(Vec3d(camera.eye()))),
      nested_(world),
      tracer_(world, camera, no_observer_, stop) {}

template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::begin(const Pixel& pixel) {
  stop_.check();
  note(Line::beam_for_each_pixel, 0, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

/// Each sample is the beam of one of the pixel's cells, whose rows and columns are as nearly as many as can be.
template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::form_beam(const Pixel& pixel) -> Beam {
  const int samples = camera_.sampling().per_pixel;
  int rows = 1;
  for (int k = 2; k * k <= samples; ++k)
    if (samples % k == 0) rows = k;
  const int columns = samples / rows, sample = pixel.sample % samples;
  const int cell = rows == columns ? cell_of_sample(sample, rows) : sample;
  const Vec2d size(1.0 / columns, 1.0 / rows);
  const Vec2d from{pixel.column + size.x * (cell % columns), pixel.row + size.y * (cell / columns)};
  Beam beam = beam_between(from, from + size);
  note(Line::form_beam, 0, [&] {
    return BeamFormed{beam.number, -1, beam.view.eye, 0, 1, drawn_area(beam, {beam.window}), Rgbd(beam.throughput)};
  });
  return beam;
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::beam_between(const Vec2d& from, const Vec2d& to) -> Beam {
  const auto window = camera_.window(Vec2<T>(from));
  const Vec2d size = to - from;
  Beam beam;
  beam.view = {Vec3d(camera_.eye()), Vec3d(window.corner), Vec3d(window.right), Vec3d(window.down),
               std::max({size.x, size.y, 1.0})};
  beam.window = {{0, 0}, {size.x, 0}, size, {0, size.y}};
  beam.pixel = size.x * size.y;
  beam.number = rays_formed_++;
  if (nested_.any_around_eye()) {
    const Vec3<T> middle(normalize(beam.view.direction(size / 2.0)));
    beam.medium = nested_.at_eye(Ray<T>{camera_.eye(), middle, {}, camera_.shutter_open()}, statistics_.tests);
  }
  ++statistics_.formed(RayKind::primary);
  return beam;
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::parts_of(const Vec2d& from, const Vec2d& to) -> std::vector<ShadedPiece<T>> {
  const Beam beam = beam_between(from, to);
  std::vector<ShadedPiece<T>> pieces = shade_parts(1, beam, cut(Line::cut_beam, 0, beam)).pieces;
  for (ShadedPiece<T>& piece : pieces)
    for (Vec2d& corner : piece.window) corner += from;
  return pieces;
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::cut(Line line, int depth, const Beam& beam) -> std::vector<Part> {
  stop_.check();
  const BeamPlane* mirror = nullptr;
  BeamPlane towards;
  if (beam.mirror != nullptr) {
    // The image of the eye lies behind it.
    const bool front = beam.mirror->plane.above(beam.view.eye) < 0;
    towards = front ? beam.mirror->plane : BeamPlane{-beam.mirror->plane.normal, -beam.mirror->plane.offset};
    mirror = &towards;
  }
  std::vector<Part> parts;
  for (SeenFace& seen : faces_seen(faces_, beam.view, beam.window, mirror, stop_)) {
    Part whole;
    static_cast<SeenFace&>(whole) = std::move(seen);
    for (Part& piece : divided_by_shadows(beam, whole)) divide_by_squares(parts, beam, std::move(piece));
  }
  for (Part& part : parts) {
    part.number = rays_formed_++;
    meet(part, beam, middle_of(part.window));
    ++statistics_.formed(RayKind::beam);
    ++statistics_.ends(part.at ? Ending::hit : Ending::missed);
  }
  note(line, depth, [&] {
    BeamCut cut{beam.number, {}};
    for (const Part& part : parts) {
      const double coverage = area_of(part.window) / beam.pixel;
      const Vec3d origin(part.ray.origin);
      BeamPiece piece{part.number, part.face < 0 ? -1 : faces_[part.face].object,
                      0,           coverage,
                      coverage,    drawn_area(beam, part),
                      origin,      origin + Vec3d(part.ray.direction),
                      Vec3d(0.0)};
      if (part.at) detail::tell_of(piece, *part.at);
      cut.pieces.push_back(std::move(piece));
    }
    return cut;
  });
  return parts;
}

/// The places of a checker's lines are linear in what a flat face is seen at.
template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::divide_by_squares(std::vector<Part>& parts, const Beam& beam, Part&& whole) const {
  if (whole.face < 0 || !faces_[whole.face].is_flat) return parts.push_back(std::move(whole));
  const BeamFace& face = faces_[whole.face];
  const auto& surface = world_.surface(face.primitive);
  if (!surface.checker || surface.texture || world_.maps(surface)) return parts.push_back(std::move(whole));
  const double size = static_cast<double>(surface.checker->size);
  const auto on_face = [&](const Vec2d& place) {
    return beam.view.eye + beam.view.direction(place) / whole.nearness.at(place);
  };
  const auto uv = [&](const Vec3d& at) {
    return Vec2d(world_.accelerator.primitives().uv_at(
        face.primitive, SurfacePoint<T>{Vec3<T>(at), Vec3<T>(face.plane.normal)}, face.part, camera_.shutter_open()));
  };
  const Vec3d origin = on_face(middle_of(whole.window));
  const Vec2d start = uv(origin);
  const PlaneAxes<double> axes = plane_axes(face.plane.normal);
  const Vec2d along_u = (uv(origin + size * axes.u) - start) / size,
              along_v = (uv(origin + size * axes.v) - start) / size;
  std::vector<WindowLine> lines;
  for (const int axis : {0, 1}) {
    const Vec3d growth = along_u[axis] * axes.u + along_v[axis] * axes.v;
    double low = infinity<double>, high = -infinity<double>;
    for (const Vec2d& place : whole.window) {
      const bool endless = !(whole.nearness.at(place) > whole.nearness.slack);
      const double at = endless ? infinity<double> : (start[axis] + dot(growth, on_face(place) - origin)) / size;
      low = std::min(low, at), high = std::max(high, at);
    }
    constexpr double countable = 0x1p52;  // each whole number has a next one
    if (!(high - low < most_squares && std::abs(low) < countable && std::abs(high) < countable)) {
      whole.has_mean = true;
      return parts.push_back(std::move(whole));
    }
    for (double line = std::ceil(low); line <= high; ++line)
      lines.push_back(beam.view.above({growth, dot(growth, origin) + line * size - start[axis]}, face.plane));
  }
  std::vector<Part> pieces{std::move(whole)};
  for (const WindowLine& line : lines)
    for (std::size_t i = 0, before = pieces.size(); i < before; ++i) {
      WindowHalves halves = halves_of(pieces[i].window, line);
      if (halves.inside.empty() || halves.outside.empty()) continue;
      pieces.push_back(pieces[i]);
      pieces.back().window = std::move(halves.outside);
      pieces[i].window = std::move(halves.inside);
    }
  for (Part& piece : pieces) parts.push_back(std::move(piece));
}

/// The ray at a place of a part, and what it meets. That in its middle is taken for all of the part.
template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::meet(Part& part, const Beam& beam, const Vec2d& place) {
  const Vec3d direction = beam.view.direction(place);
  const double size = length(direction);
  double start = 0;
  if (beam.mirror != nullptr) start = 1 / beam.view.nearness(beam.mirror->plane).at(place);
  part.ray = {Vec3<T>(beam.view.eye + start * direction), Vec3<T>(direction / size), beam.departure,
              camera_.shutter_open()};
  if (part.face < 0) return;
  const BeamFace& face = faces_[part.face];
  const Hit<T> hit{static_cast<T>((1 / part.nearness.nearness(place) - start) * size), face.primitive, face.part};
  const detail::MiddleOfPart<T> ray{part.ray, part.number, beam.medium};
  detail::PatternOfPart<T> pattern{world_, part.has_mean};
  part.at = prepare_vertex<AllEffects>(world_, nested_, ray, hit, statistics_, pattern);
  part.ambient = part.at->values().ambient;
  if (part.at->mapped) return;
  if (part.has_mean)
    part.ambient *= pattern.pattern(hit, {}, part.ray.time);
  else
    apply_pattern(part.ambient, *part.at->surface, world_.accelerator.primitives(), hit.primitive,
                  SurfacePoint<T>{part.at->position, part.at->outward_normal}, hit.part, part.ray.time);
}

template <class T, class Watcher>
BeamArea SpaceBeamTracer<T, Watcher>::drawn_area(const Beam& beam, const SeenFace& part) const {
  const Vec3d middle = beam.view.direction(middle_of(part.window));
  // Seen from above, to the side; where the view goes straight down, along the window.
  const Vec3d up(0, 0, 1), level = cross(middle, up);
  const Vec3d aside = length(level) > 1e-6 * length(middle) ? level : beam.view.right;
  const auto off = [&](const Vec2d& place) {
    const Vec3d direction = beam.view.direction(place);
    return dot(direction, aside) / dot(direction, middle);
  };
  const auto [left, right] = std::minmax_element(part.window.begin(), part.window.end(),
                                                 [&](const Vec2d& a, const Vec2d& b) { return off(a) < off(b); });
  BeamArea area;
  const auto add = [&](const Vec2d& place, std::vector<Vec3d>& starts, std::vector<Vec3d>& ends) {
    const Vec3d direction = beam.view.direction(place);
    const double reach = far_ / length(direction);
    const auto reached = [&](double nearness) { return nearness > 0 ? std::min(1 / nearness, reach) : reach; };
    const double start = beam.mirror == nullptr ? 0 : reached(beam.view.nearness(beam.mirror->plane).at(place));
    const double end = part.face < 0 ? start + reach : reached(part.nearness.at(place));
    starts.push_back(beam.view.eye + start * direction);
    ends.push_back(beam.view.eye + end * direction);
  };
  for (const Vec2d& place : {*left, *right}) add(place, area.starts, area.ends);
  for (const Vec2d& place : part.window) add(place, area.corner_starts, area.corner_ends);
  return area;
}

template <class T, class Watcher>
int SpaceBeamTracer<T, Watcher>::call_shade_parts(Line line, int depth, const Beam& beam) {
  note(line, depth, [&] { return ShadeCalled{beam.number, false, depth + 1}; });
  return depth + 1;
}

template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::begin(int depth, const Beam& beam, const std::vector<Part>& parts, const Part& part) {
  note(Line::for_each_part, depth, [&] {
    return PartBegun{part.number, static_cast<int>(&part - parts.data()), static_cast<int>(parts.size()),
                     area_of(part.window) / beam.pixel, !part.at};
  });
}

template <class T, class Watcher>
Rgb<T> SpaceBeamTracer<T, Watcher>::shade_middle(int depth, const Part& part, const DirectLighting& direct) {
  const detail::MiddleShade<T> shade = detail::shade_of_middle(world_, part, direct.sum);
  note(Line::shade_middle, depth, [&] {
    return PartShaded{part.number, Rgbd(shade.ambient), Rgbd(shade.emission), direct.terms, Rgbd(shade.total)};
  });
  return shade.total;
}

template <class T, class Watcher>
bool SpaceBeamTracer<T, Watcher>::is_flat(const Part& part) const {
  return faces_[part.face].is_flat && part.at->bsdf.shading_normal == part.at->bsdf.geometric_normal;
}

template <class T, class Watcher>
bool SpaceBeamTracer<T, Watcher>::decide_flat_mirror(int depth, const Part& part) {
  const bool holds = part.at && is_flat(part) && !is_black(part.at->bsdf.mirror);
  note(Line::if_flat_mirror, depth, [&] { return Decided{holds, part.at ? Rgbd(part.at->bsdf.mirror) : Rgbd(0.0)}; });
  return holds;
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::form_mirrored_beam(int depth, const Part& part, const Beam& beam)
    -> std::optional<Beam> {
  const Vertex& at = *part.at;
  const Rgb<T> throughput = beam.throughput * at.throughput * at.bsdf.mirror * share_of(part, beam);
  if (const auto why = detail::why_not_followed(world_, depth, throughput)) {
    ++statistics_.ends(*why);
    note(Line::form_mirrored_beam, depth, [&] {
      return RayNotFormed{part.number,     RayKind::beam, *why, Vec3d(at.position), Vec3d(at.bsdf.mirror_axis),
                          Rgbd(throughput)};
    });
    return std::nullopt;
  }
  const BeamFace& face = faces_[part.face];
  Beam mirrored{beam.view.mirrored(face.plane),
                part.window,
                beam.pixel,
                throughput,
                rays_formed_++,
                &face,
                at.departure,
                at.medium};
  note(Line::form_mirrored_beam, depth, [&] {
    return BeamFormed{mirrored.number,
                      part.number,
                      mirrored.view.eye,
                      0,
                      area_of(part.window) / beam.pixel,
                      drawn_area(mirrored, {part.window}),
                      Rgbd(throughput)};
  });
  return mirrored;
}

template <class T, class Watcher>
bool SpaceBeamTracer<T, Watcher>::sends(const Part& part, RayKind kind) const {
  if (!part.at || is_black(detail::weight_of(*part.at, kind))) return false;
  return kind == RayKind::refract || !is_flat(part);
}

template <class T, class Watcher>
bool SpaceBeamTracer<T, Watcher>::decide_curved_or_glass(int depth, const Part& part) {
  const bool reflects = sends(part, RayKind::reflect), refracts = sends(part, RayKind::refract);
  note(Line::if_curved_or_glass, depth, [&] {
    Decided decided{reflects || refracts};
    if (reflects) decided.weight += Rgbd(part.at->bsdf.mirror);
    if (refracts) decided.weight += Rgbd(part.at->bsdf.transparent);
    return decided;
  });
  return reflects || refracts;
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::form_middle_ray(int depth, const Part& part, const Beam& beam, RayKind kind)
    -> std::optional<MiddleRay> {
  const Vertex& at = *part.at;
  const auto [sent, medium] = detail::sent_ray(world_, at, kind);
  const Rgb<T> throughput = beam.throughput * at.throughput * detail::weight_of(at, kind) * share_of(part, beam);
  if (const auto why = detail::why_not_followed(world_, depth, throughput)) {
    ++statistics_.ends(*why);
    note(Line::form_middle_ray, depth, [&] {
      return RayNotFormed{part.number, kind, *why, Vec3d(at.position), Vec3d(sent.direction), Rgbd(throughput)};
    });
    return std::nullopt;
  }
  const MiddleRay ray{sent, kind, rays_formed_++, medium};
  ++statistics_.formed(kind);
  note(Line::form_middle_ray, depth, [&] {
    RayFormed formed{ray.number, part.number, kind, Vec3d(ray.ray.origin), Vec3d(ray.ray.direction), Rgbd(throughput)};
    if (kind == RayKind::refract) formed.snell = snell_numbers(at.refraction);
    return formed;
  });
  return ray;
}

template <class T, class Watcher>
Rgb<T> SpaceBeamTracer<T, Watcher>::follow_middle_ray(int depth, const MiddleRay& ray) {
  note(Line::follow_middle_ray, depth, [&] {
    TestCounts uncounted;
    const auto nearest = world_.accelerator.closest(ray.ray, infinity<T>, uncounted);
    return nearest ? detail::describe(ray.number, Ending::hit, world_, ray.ray, *nearest)
                   : detail::describe_missed(ray.number, Ending::missed, world_, ray.ray);
  });
  const Rgb<T> brought = tracer_.radiance_along(ray.ray, depth + 1, ray.medium);
  statistics_ += tracer_.take_statistics();
  return brought;
}

/// Of the shades near the corners of a part, a sixteenth of the way from there to its middle, which has `shade`. What a
/// flat mirror shows is left out: its own parts tell.
template <class T, class Watcher>
double SpaceBeamTracer<T, Watcher>::off_near_border(int depth, const Beam& beam, const Part& part,
                                                    const Rgb<T>& shade) {
  const Statistics counted = statistics_;
  const Vec2d middle = middle_of(part.window);
  double off = 0;
  for (const Vec2d& corner : part.window) {
    Part beside = part;
    beside.has_mean = false;
    meet(beside, beam, corner + (middle - corner) / 16.0);
    const Rgbd more(unmirrored_shade(depth, beside) - shade);
    off = std::max({off, std::abs(more.x), std::abs(more.y), std::abs(more.z)});
  }
  statistics_ = counted;
  static_cast<void>(tracer_.take_statistics());
  return off;
}

template <class T, class Watcher>
Rgb<T> SpaceBeamTracer<T, Watcher>::unmirrored_shade(int depth, const Part& part) {
  DirectLighting direct;
  for (const Light& light : detail::lights_on(world_, part))
    if (faces(*part.at, light) && light.shines_along(light.direction_to(light.place, part.at->position)))
      add_light(direct, part, light, arriving_from(part, light));
  const Rgb<T> local = detail::shade_of_middle(world_, part, direct.sum).total;
  if (!part.at) return local;
  return part.at->throughput *
         (local + detail::brought_by_rays(world_, tracer_, depth, *part.at, [&](RayKind k) { return sends(part, k); }));
}

/// A running mean: where all parts have one shade, it is that shade, whatever their areas. What a mirror shows is cut
/// as it is seen there.
template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::add_part(Shades& shades, int depth, const Beam& beam, const std::vector<Part>& parts,
                                           const Part& part, const Rgb<T>& local, std::optional<Shades>& reflected,
                                           const Rgb<T>& curved, const Rgb<T>& refracted) {
  const Rgb<T> left = part.at ? part.at->throughput : Rgb<T>(1), own = local + curved + refracted;
  const Rgb<T> mirrored = reflected ? part.at->bsdf.mirror * reflected->mean : Rgb<T>(0);
  const Rgb<T> shade = left * (own + mirrored);
  const int object = part.face < 0 ? -1 : faces_[part.face].object;
  if (reflected)
    for (ShadedPiece<T>& piece : reflected->pieces)
      shades.pieces.push_back({std::move(piece.window), left * (own + part.at->bsdf.mirror * piece.shade), object,
                               part.has_mean || piece.has_mean});
  else
    shades.pieces.push_back({part.window, shade, object, part.has_mean});
  const double area = area_of(part.window);
  shades.area += area;
  if (shades.area > 0) shades.mean += (shade - shades.mean) * static_cast<T>(area / shades.area);
  note(Line::add_part, depth, [&] {
    return PartAdded{part.number,
                     Rgbd(local),
                     Rgbd(curved + mirrored),
                     Rgbd(refracted),
                     Rgbd(shade),
                     area / area_of(beam.window),
                     Rgbd(shades.mean),
                     &part == &parts.back(),
                     off_near_border(depth, beam, part, left * own)};
  });
}

template <class T, class Watcher>
template <class Put>
void SpaceBeamTracer<T, Watcher>::put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::beam_put_final_shade, 0, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, Rgbd(final)}; });
}

}  // namespace raywalk
