#pragma once
// What the statements of trace/cones.h do, but for lights (trace/cone_light_steps.h). Included by it alone.

#include "math/elementary.h"
#include "trace/cones.h"
#include "trace/part_steps.h"
#include "trace/pattern_filter.h"
#include "trace/representable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace detail {

/// Farther from the eye than everything that has an end.
[[nodiscard]] double far_from(const Vec3d& eye, const ConeBodies& bodies);

/// How far a cone reaches in a pattern: as a square of its area, for those materials that filter it.
template <class T>
class ConeDifferential {
 public:
  ConeDifferential(const World<T>& world, const ConeWidth& width)
      : world_(world), width_(static_cast<T>(width.radius)) {}

  [[nodiscard]] bool filters(const typename World<T>::Surface& surface) const {
    return world_.filters() && world_.filters(surface);
  }
  void arrive(const Vec3<T>& direction, const Hit<T>& /*hit*/, const SurfacePoint<T>& point, T /*time*/,
              const Vec3<T>& /*shading_normal*/) {
    const Basis<T> about(direction);
    const T side = width_ * std::sqrt(std::numbers::pi_v<T>);
    ray_ = transfer(RayDifferential<T>{{side * about.s, Vec3<T>(0)}, {side * about.t, Vec3<T>(0)}}, direction, T(0),
                    point.normal);
  }
  [[nodiscard]] Rgb<T> pattern(const Hit<T>& hit, const SurfacePoint<T>& point, T time) const {
    return filtered_pattern(world_, hit_differential(ray_), hit, point, time);
  }

 private:
  const World<T>& world_;
  T width_;
  RayDifferential<T> ray_;
};

}  // namespace detail

template <class T, class Watcher, bool with_maps>
ConeTracer<T, Watcher, with_maps>::ConeTracer(const World<T>& world, const ConeBodies& bodies, bool flat,
                                              const RayGenerator<T>& camera, Observer& observer, const Stop& stop)
    : world_(world),
      bodies_(bodies),
      flat_(flat),
      camera_(camera),
      observer_(observer),
      stop_(stop),
      primitives_(detail::first_primitives(world)),
      far_(detail::far_from(Vec3d(camera.eye()), bodies)),
      nested_(world) {}

template <class T, class Watcher, bool with_maps>
void ConeTracer<T, Watcher, with_maps>::begin(const Pixel& pixel) {
  stop_.check();
  note(Line::cone_for_each_pixel, 0, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

/// In a flat world between the pixel's edges; else of the pixel's area.
template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::form_cone(const Pixel& pixel) -> Cone {
  const Vec3d eye(camera_.eye());
  const Vec3d from(camera_.edge(pixel.column, pixel.row)), to(camera_.edge(pixel.column + 1, pixel.row));
  Vec3d axis;
  double spread = 0;
  if (flat_) {
    const int samples = camera_.sampling().per_pixel;
    const auto edge = [&](int i) { return normalize(from + static_cast<double>(i) / samples * (to - from)); };
    const Vec3d left = edge(pixel.sample), right = edge(pixel.sample + 1);
    axis = normalize(left + right);
    spread = length(left - right) / length(left + right);
  } else {
    axis = Vec3d(camera_.primary_ray(pixel, statistics_).direction);
    // At distance 1 before the eye a pixel is a square; along its ray that is farther away, and seen aslant.
    const Vec3d middle = (from + to) / 2.0;
    const double away = 1 / length(middle), side = length(to - from) * static_cast<double>(camera_.spacing());
    spread = side * std::sqrt(away / std::numbers::pi) * away;
  }
  Cone cone{cone_about(eye, axis, 0, spread, flat_), Rgb<T>(1), rays_formed_++};
  if (nested_.any_around_eye()) {
    const Ray<T> middle{camera_.eye(), Vec3<T>(axis), {}, camera_.shutter_open()};
    cone.medium = nested_.at_eye(middle, statistics_.tests);
  }
  note(Line::form_cone, 0, [&] {
    return BeamFormed{cone.number, -1, eye, 0, 1, area_of(cone.shape, ConePart{}), Rgbd(cone.throughput), 0, spread};
  });
  return cone;
}

template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::find_cover(Line line, int depth, const Cone& cone) -> std::vector<Part> {
  stop_.check();
  std::vector<Part> parts;
  for (const ConePart& piece : cover_cone(bodies_, cone.shape, cone.leaves, statistics_.tests)) {
    Part part;
    static_cast<ConePart&>(part) = piece;
    part.number = rays_formed_++;
    meet(part, cone);
    ++statistics_.formed(RayKind::beam);
    ++statistics_.ends(part.at ? Ending::hit : Ending::missed);
    parts.push_back(std::move(part));
  }
  note(line, depth, [&] {
    BeamCut cut{cone.number, {}};
    for (const Part& part : parts) {
      const Vec3d origin(part.ray.origin);
      BeamPiece piece{part.number, part.object,
                      0,           1,
                      part.share,  area_of(cone.shape, part),
                      origin,      origin + Vec3d(part.ray.direction),
                      Vec3d(0.0)};
      if (part.at) detail::tell_of(piece, *part.at);
      cut.pieces.push_back(std::move(piece));
    }
    return cut;
  });
  return parts;
}

/// The ray in the middle of a part, and what it meets: what all of the part sees.
template <class T, class Watcher, bool with_maps>
void ConeTracer<T, Watcher, with_maps>::meet(Part& part, const Cone& cone) {
  const Vec3d direction = cone.shape.direction(part.place);
  const double size = length(direction);
  part.ray = {Vec3<T>(cone.shape.start(part.place)), normalize(Vec3<T>(direction)), cone.departure,
              camera_.shutter_open()};
  if (part.body < 0) return;
  const RayCone narrow = part_of_cone(cone.shape, part.place, part.size);
  part.width = turned_out({narrow.radius_at(part.t * size), narrow.spread});
  part.object = bodies_[part.body].object;
  const Hit<T> hit{static_cast<T>(part.t * size), primitives_[static_cast<std::size_t>(part.object)], part.part};
  const detail::MiddleOfPart<T> middle{part.ray, part.number, cone.medium};
  detail::ConeDifferential<T> differential(world_, part.width);
  part.at = prepare_vertex<AllEffects>(world_, nested_, middle, hit, statistics_, differential);
  const auto facets = detail::facets_at(world_, *part.at);
  part.slope = static_cast<double>(facets.slope), part.facets = facets.shown;
  const auto& surface = *part.at->surface;
  part.ambient = part.at->values().ambient;
  if constexpr (with_maps)
    if (part.at->mapped) return;
  const SurfacePoint<T> point{part.at->position, part.at->outward_normal};
  if (differential.filters(surface))
    part.ambient *= differential.pattern(hit, point, part.ray.time);
  else
    apply_pattern(part.ambient, surface, world_.accelerator.primitives(), hit.primitive, point, hit.part,
                  part.ray.time);
}

/// As drawn: two sides of a part, or of all of a cone, in the plan or beside the axis; in space its rim, too.
template <class T, class Watcher, bool with_maps>
BeamArea ConeTracer<T, Watcher, with_maps>::area_of(const RayCone& cone, const ConePart& part) const {
  const double t = part.body < 0 ? far_ : part.t;
  BeamArea area;
  const auto add = [&](const Vec2d& side, std::vector<Vec3d>& starts, std::vector<Vec3d>& ends) {
    const Vec2d place = part.place + part.size * side;
    starts.push_back(cone.start(place));
    ends.push_back(cone.start(place) + t * cone.direction(place));
  };
  for (const double side : {1.0, -1.0}) add({side, 0}, area.starts, area.ends);
  constexpr int corners = 24;
  for (int i = 0; i < corners && !flat_; ++i) {
    const auto [sine, cosine] = portable::sin_cos(2 * std::numbers::pi * i / corners);
    add({cosine, sine}, area.corner_starts, area.corner_ends);
  }
  return area;
}

template <class T, class Watcher, bool with_maps>
int ConeTracer<T, Watcher, with_maps>::call_shade_cone(Line line, int depth, const Cone& cone) {
  note(line, depth, [&] { return ShadeCalled{cone.number, false, depth + 1}; });
  return depth + 1;
}

template <class T, class Watcher, bool with_maps>
void ConeTracer<T, Watcher, with_maps>::begin(int depth, const std::vector<Part>& parts, const Part& part) {
  note(Line::cone_for_each_part, depth, [&] {
    return PartBegun{part.number, static_cast<int>(&part - parts.data()), static_cast<int>(parts.size()), part.share,
                     !part.at};
  });
}

template <class T, class Watcher, bool with_maps>
Rgb<T> ConeTracer<T, Watcher, with_maps>::shade_middle(int depth, const Part& part, const DirectLighting& direct) {
  const detail::MiddleShade<T> shade = detail::shade_of_middle(world_, part, direct.sum);
  note(Line::cone_shade_middle, depth, [&] {
    return PartShaded{part.number, Rgbd(shade.ambient), Rgbd(shade.emission), direct.terms, Rgbd(shade.total)};
  });
  return shade.total;
}

template <class T, class Watcher, bool with_maps>
bool ConeTracer<T, Watcher, with_maps>::decide_reflective(int depth, const Part& part) {
  const bool holds = part.at && !is_black(part.at->bsdf.mirror);
  note(Line::cone_if_reflective, depth,
       [&] { return Decided{holds, part.at ? Rgbd(part.at->bsdf.mirror) : Rgbd(0.0)}; });
  return holds;
}

template <class T, class Watcher, bool with_maps>
bool ConeTracer<T, Watcher, with_maps>::decide_transparent(int depth, const Part& part) {
  const bool holds = part.at && !is_black(part.at->bsdf.transparent);
  note(Line::cone_if_transparent, depth, [&] {
    Decided decided{holds, part.at ? Rgbd(part.at->bsdf.transparent) : Rgbd(0.0)};
    if (part.at && part.at->surface->transmits && part.at->refraction.total())
      decided.why = Ending::total_internal_reflection, decided.snell = snell_numbers(part.at->refraction);
    return decided;
  });
  return holds;
}

/// Of spheres alone: 1 / radius, towards the cone.
template <class T, class Watcher, bool with_maps>
double ConeTracer<T, Watcher, with_maps>::curvature_at(const Part& part) const {
  const auto* ball = std::get_if<ConeBall>(&bodies_[part.body].shape);
  return ball == nullptr ? 0 : (part.at->entering ? 1 : -1) / ball->radius;
}

template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::form_reflected_cone(int depth, const Part& part, const Cone& cone)
    -> std::optional<Cone> {
  const auto& bsdf = part.at->bsdf;
  const double cos_in = std::abs(static_cast<double>(dot(bsdf.incident, bsdf.shading_normal)));
  const ConeWidth mirrored = mirrored_cone(part.width, curvature_at(part), cos_in, flat_);
  const ConeWidth width = part.slope > 0 ? widened_by_mirrors(mirrored, part.slope, cos_in, flat_)
                                         : widened(mirrored, static_cast<double>(bsdf.mirror_width));
  return form_next_cone(Line::form_reflected_cone, depth, part, cone, bsdf.mirror_axis, width, bsdf.mirror,
                        part.at->medium);
}

template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::form_refracted_cone(int depth, const Part& part, const Cone& cone)
    -> std::optional<Cone> {
  const Refraction<T>& at = part.at->refraction;
  const auto& bsdf = part.at->bsdf;
  const auto n1 = static_cast<double>(at.n1), n2 = static_cast<double>(at.n2);
  const auto cos_in = static_cast<double>(at.cos_in), cos_out = static_cast<double>(at.cos_out);
  const ConeWidth bent = refracted_cone(part.width, curvature_at(part), n1, n2, cos_in, cos_out, flat_);
  const ConeWidth width = part.slope > 0 ? widened_by_facets(bent, part.slope, n1, n2, cos_in, cos_out, flat_)
                                         : widened(bent, static_cast<double>(bsdf.transparent_width));
  return form_next_cone(Line::form_refracted_cone, depth, part, cone, bsdf.transparent_axis, width, bsdf.transparent,
                        part.at->behind);
}

template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::form_next_cone(Line line, int depth, const Part& part, const Cone& cone,
                                                       const Vec3<T>& axis, const ConeWidth& width,
                                                       const Rgb<T>& weight, const Medium* medium)
    -> std::optional<Cone> {
  const Vertex& at = *part.at;
  const Rgb<T> throughput = cone.throughput * at.throughput * weight * static_cast<T>(part.share);
  if (const auto why = detail::why_not_followed(world_, depth, throughput)) {
    ++statistics_.ends(*why);
    note(line, depth, [&] {
      return RayNotFormed{part.number, RayKind::beam, *why, Vec3d(at.position), Vec3d(axis), Rgbd(throughput)};
    });
    return std::nullopt;
  }
  const Vec3d origin(at.position);
  Vec3d along = normalize(Vec3d(axis));
  if (flat_) along.z = 0;
  const Cone next{cone_about(origin, along, width.radius, width.spread, flat_),
                  throughput,
                  rays_formed_++,
                  at.departure,
                  {part.object, part.part},
                  medium};
  note(line, depth, [&] {
    const Vec3d apex = width.spread != 0 ? origin - width.radius / width.spread * along : origin;
    return BeamFormed{next.number,      part.number,  apex,        0, 1, area_of(next.shape, ConePart{}),
                      Rgbd(throughput), width.radius, width.spread};
  });
  return next;
}

template <class T, class Watcher, bool with_maps>
void ConeTracer<T, Watcher, with_maps>::add_share(Rgb<T>& sum, int depth, const std::vector<Part>& parts,
                                                  const Part& part, const Rgb<T>& local, const Rgb<T>& reflected,
                                                  const Rgb<T>& refracted) {
  const Rgb<T> left = part.at ? part.at->throughput : Rgb<T>(1);
  const Rgb<T> shade = left * (local + reflected + refracted);
  sum += static_cast<T>(part.share) * shade;
  note(Line::add_share, depth, [&] {
    return PartAdded{part.number, Rgbd(local), Rgbd(reflected), Rgbd(refracted),
                     Rgbd(shade), part.share,  Rgbd(sum),       &part == &parts.back()};
  });
}

template <class T, class Watcher, bool with_maps>
template <class Put>
void ConeTracer<T, Watcher, with_maps>::put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::cone_put_final_shade, 0, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, Rgbd(final)}; });
}

}  // namespace raywalk
