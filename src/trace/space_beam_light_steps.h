#pragma once
// What the statements of trace/space_beams.h about lights do, and how their shadows divide what a beam sees. Included
// by it alone.

#include "trace/part_steps.h"
#include "trace/shadow_transmittance.h"
#include "trace/space_beams.h"
#include "trace/spawn_ray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

/// Light from a point or a direction reaches all of a part, or nothing of it; a penumbra has no edge.
template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::divided_by_shadows(const Beam& beam, const Part& whole) -> std::vector<Part> {
  std::vector<Part> pieces{whole};
  if (whole.face >= 0 && shows_shadows(faces_[whole.face])) {
    for (std::size_t index = 0; index < std::min(world_.lights.size(), most_divided); ++index) {
      const Light& light = world_.lights[index];
      if (detail::has_extent(world_, light)) continue;
      const std::uint64_t bit = std::uint64_t{1} << index;
      std::vector<Part> divided;
      for (const Part& piece : pieces)
        for (LitPiece& lit : shadows_on(
                 faces_, beam.view, piece, {Vec3d(light.place), light.is_distant},
                 [&](int primitive) { return role_of(world_.shadow_roles, primitive); }, stop_)) {
          Part part = piece;
          part.window = std::move(lit.window);
          if (lit.stopped) part.stopped |= bit;
          if (lit.weakened || world_.absorbs) part.unsure |= bit;
          divided.push_back(std::move(part));
        }
      pieces = std::move(divided);
    }
  }
  return pieces;
}

template <class T, class Watcher>
bool SpaceBeamTracer<T, Watcher>::shows_shadows(const BeamFace& face) const {
  const auto& surface = world_.surface(face.primitive);
  return world_.occludes && world_.effects.used(Effect::shadows) &&
         (detail::shows_lights(world_, surface) || world_.maps(surface) != nullptr);
}

/// Whether some of a light lies in front of a surface, or shows through it.
template <class T, class Watcher>
bool SpaceBeamTracer<T, Watcher>::faces(const Vertex& at, const Light& light) const {
  if (at.surface->lit_from_behind) return true;
  const Vec3<T>& normal = at.bsdf.shading_normal;
  const T height = dot(normal, light.direction_to(light.place, at.position));
  if (!detail::has_extent(world_, light)) return height > 0;
  return height > -light.half_extent(normal);
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::form_shadow_ray(int depth, const Part& part, const Beam& beam, const Light& light)
    -> std::optional<Shadow> {
  const Vertex& at = *part.at;
  const Vec3<T> to_light = light.direction_to(light.place, at.position);
  const bool in_front = faces(at, light);
  const auto throughput = [&] { return Rgbd(beam.throughput * share_of(part, beam)); };
  if (!in_front || !light.shines_along(to_light)) {
    const Ending why = in_front ? Ending::outside_cone : Ending::facing_away;
    ++statistics_.ends(why);
    note(Line::beam_form_shadow_ray, depth, [&] {
      return RayNotFormed{part.number,     RayKind::shadow, why,        Vec3d(at.position),
                          Vec3d(to_light), throughput(),    light.index};
    });
    return std::nullopt;
  }
  const Shadow shadow{spawn_ray<Ray<T>>(world_, at.position, at.bsdf.geometric_normal, at.departure, to_light, at.time),
                      rays_formed_++};
  ++statistics_.formed(RayKind::shadow);
  note(Line::beam_form_shadow_ray, depth, [&] {
    RayFormed formed{shadow.number,   part.number,  RayKind::shadow, Vec3d(shadow.ray.origin),
                     Vec3d(to_light), throughput(), light.index,     !light.is_distant};
    if (detail::has_extent(world_, light))
      formed.end_radius = detail::radius_of_light<T>(light, normalize(Vec3d(to_light)), false);
    return formed;
  });
  return shadow;
}

template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::find_intersection(int depth, const Part& part, const Shadow& shadow,
                                                    const Light& light) -> std::vector<Arriving> {
  std::vector<Arriving> arriving = arriving_from(part, light);
  Rgb<T> sum{0};
  for (const Arriving& from : arriving) sum += from.share;
  const bool reached = !is_black(sum);
  ++statistics_.ends(reached ? Ending::reached_light : Ending::blocked);
  note(Line::beam_find_intersection, depth, [&] {
    if (const auto blocker = reached ? std::nullopt : first_blocker(world_, shadow.ray, light.t_far())) {
      Found found = detail::describe(shadow.number, Ending::blocked, world_, shadow.ray, *blocker);
      found.transmittance = Rgbd(0.0);
      return found;
    }
    Found found{shadow.number, reached ? Ending::reached_light : Ending::blocked};
    found.transmittance = Rgbd(sum);
    if (reached) return found;
    // What stands for something round hides the light, or rounding does: so nearly that the ray does not meet it.
    found.object = faces_[part.face].object;
    found.point = Vec3d(part.at->position), found.normal = Vec3d(part.at->outward_normal);
    return found;
  });
  return arriving;
}

/// Of a ball of light rays tell, to places that are fixed.
template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::arriving_from(const Part& part, const Light& light) -> std::vector<Arriving> {
  if (detail::has_extent(world_, light)) {
    if (const auto* rectangle = std::get_if<RectangleLight::Prepared<T>>(&light.kind))
      return arriving_from(part, light, *rectangle);
    std::vector<Arriving> arriving;
    for (int sample = 0; sample < light.samples(); ++sample) {
      const Vec3<T> to_light = light.direction_to(light.regular(sample, light.grid), part.at->position);
      arriving.push_back({to_light, light.sample_weight * transmittance(part, light, to_light)});
    }
    return arriving;
  }
  const Vec3<T> to_light = light.direction_to(light.place, part.at->position);
  const auto index = static_cast<std::size_t>(&light - world_.lights.data());
  const std::uint64_t bit = std::uint64_t{1} << std::min(index, most_divided - 1);
  if (index < most_divided && (part.stopped & bit) != 0) return {};
  const bool unsure = index >= most_divided || (part.unsure & bit) != 0;
  return {{to_light, unsure ? transmittance(part, light, to_light) : Rgb<T>(1)}};
}

/// What the middle of a part sees of it, cell by cell: the rectangle is a window.
template <class T, class Watcher>
auto SpaceBeamTracer<T, Watcher>::arriving_from(const Part& part, const Light& light,
                                                const RectangleLight::Prepared<T>& rectangle) -> std::vector<Arriving> {
  const Vec3d eye(part.at->position);
  const BeamView view{eye, Vec3d(rectangle.corner) - eye, Vec3d(rectangle.u), Vec3d(rectangle.v)};
  const BeamFace& face = faces_[part.face];
  const double side_up = dot(Vec3d(part.at->bsdf.geometric_normal), face.plane.normal) < 0 ? -1 : 1;
  const auto role = [&](int primitive) { return role_of(world_.shadow_roles, primitive); };
  std::vector<Arriving> arriving;
  const double side = 1.0 / light.grid;
  for (int cell = 0; cell < light.samples(); ++cell) {
    const Vec2d from{side * (cell % light.grid), side * (cell / light.grid)};
    WindowPiece window{from, {from.x + side, from.y}, {from.x + side, from.y + side}, {from.x, from.y + side}};
    if (face.is_flat && !part.at->surface->lit_from_behind)
      window = halves_of(window, view.line(side_up * face.plane.normal, 1)).inside;
    if (window.empty()) continue;
    std::vector<LitPiece> pieces{{window}};
    if (world_.occludes) pieces = open_light(faces_, view, window, face, side_up < 0, role, stop_);
    for (const LitPiece& open : pieces) {
      if (open.stopped) continue;
      const Vec3<T> to_light(view.direction(middle_of(open.window)));
      const bool unsure = open.weakened || world_.absorbs;
      const Rgb<T> through = unsure ? transmittance(part, light, to_light) : Rgb<T>(1);
      arriving.push_back({to_light, static_cast<T>(area_of(open.window)) * through});
    }
  }
  return arriving;
}

template <class T, class Watcher>
Rgb<T> SpaceBeamTracer<T, Watcher>::transmittance(const Part& part, const Light& light, const Vec3<T>& to_light) {
  if (!world_.occludes) return Rgb<T>(1);
  const Vertex& at = *part.at;
  if (!detail::receives(at, to_light)) return Rgb<T>(0);
  const auto ray = spawn_ray<Ray<T>>(world_, at.position, at.bsdf.geometric_normal, at.departure, to_light, at.time);
  return shadow_transmittance(world_, ray, light.t_far(), statistics_.tests, filters_met_, {}, at.medium)
      .value_or(Rgb<T>(0));
}

template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::add_unlit(DirectLighting& direct, const Light& light) {
  if constexpr (Observer::watches) direct.terms.push_back({light.index});
}

template <class T, class Watcher>
void SpaceBeamTracer<T, Watcher>::add_light(DirectLighting& direct, const Part& part, const Light& light,
                                            const std::vector<Arriving>& arriving) {
  detail::PartLight<T> brought;
  const auto mirrors = detail::mirrors_at(world_, *part.at).shown;
  for (const Arriving& from : arriving) {
    if (!detail::receives(*part.at, from.to_light) || is_black(from.share)) continue;
    const auto one = detail::light_on(*part.at, part.ray, light, from.to_light, from.share, mirrors);
    brought.diffuse += one.diffuse, brought.specular += one.specular;
  }
  direct.sum += brought.diffuse + brought.specular;
  if constexpr (Observer::watches) direct.terms.push_back({light.index, Rgbd(brought.diffuse), Rgbd(brought.specular)});
}

}  // namespace raywalk
