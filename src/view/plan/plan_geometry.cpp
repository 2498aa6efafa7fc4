#include "view/plan/plan_geometry.h"

#include "math/overloaded.h"
#include "view/action.h"
#include "view/plan/plan_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raywalk {

ScreenPlace screen_place(const Camera& camera) {
  const Vec3d forward = normalize(camera.look_at - camera.eye);
  const Vec3d left = normalize(cross(camera.up, forward));
  const Vec3d centre = camera.eye + camera.screen.distance * forward;
  const Vec3d half = camera.screen_width() / 2 * left;
  return {plan(forward), plan(left), plan(centre), plan(centre + half), plan(centre - half)};
}

bool meets_plan(const Sphere<double>& sphere) { return std::abs(sphere.centre.z) < sphere.radius; }

double plan_radius(const Sphere<double>& sphere) {
  if (!meets_plan(sphere)) return sphere.radius;
  return std::sqrt((sphere.radius - sphere.centre.z) * (sphere.radius + sphere.centre.z));
}

Vec2d centroid(const Prism<double>& prism) {
  const Vec2d base = prism.corner(0);
  double area = 0;
  Vec2d weighted{0.0}, sum{0.0};
  for (int i = 0; i < prism.sides(); ++i) {
    const Vec2d a = prism.corner(i) - base, b = prism.corner_after(i) - base;
    const double part = cross(a, b);
    area += part;
    weighted += part * (a + b);
    sum += a;
  }
  const Vec2d centre = weighted / (3 * area);
  const bool sound = std::isfinite(centre.x) && std::isfinite(centre.y);
  return base + (sound ? centre : sum / static_cast<double>(prism.sides()));
}

bool belongs_to_object(const Target& target) {
  return target.kind == TargetKind::object || target.kind == TargetKind::radius || target.kind == TargetKind::corner ||
         target.kind == TargetKind::edge || target.kind == TargetKind::rotation;
}

bool belongs_to_light(const Target& target) {
  return target.kind == TargetKind::light || target.kind == TargetKind::light_radius;
}

double* radius_of(Light& light) {
  return std::visit(
      [](auto& kind) -> double* {
        if constexpr (requires { kind.radius; }) return &kind.radius;
        return nullptr;
      },
      light.kind);
}

bool has_radius(const Light& light) {
  return std::visit([](const auto& kind) { return requires { kind.radius; }; }, light.kind);
}

std::optional<Bounds<double>> footprint_of(const Object& object) {
  const Bounds<double> box = image_of(affine_of(object.transform), bounds(object.shape));
  if (box.empty() || !box.bounded()) return std::nullopt;
  return box;
}

std::optional<PlanLine> wall_line(const Object& object) {
  const auto* own = std::get_if<Plane<double>>(&object.shape);
  if (own == nullptr) return std::nullopt;
  const Affine<double> to_world = affine_of(object.transform);
  const Plane<double> plane{to_world.point(own->point), to_world.normal(own->normal)};
  const Vec2d across = plan(plane.normal);
  const double size = length(across);
  if (!(size > 1e-9 * length(plane.normal))) return std::nullopt;
  const Vec2d unit = across / size;
  // n.x x + n.y y = n.point where z = 0; the point of the line nearest to plan(plane.point).
  const double offset = plane.normal.z * plane.point.z / size;
  return PlanLine{plan(plane.point) + offset * unit, {unit.y, -unit.x}};
}

Vec2d light_place(const Scene& scene, const Light& light, const PlanCamera& camera, const Viewport& viewport) {
  return std::visit(Overloaded{
                        [&](const DirectionalLight& sun) {
                          const Vec2d towards = plan(sun.direction);
                          const double size = length(towards);
                          if (!(size > 0)) return camera.centre;
                          // Within the ring of a sky.
                          const double part = scene.sky ? 0.28 : 0.42;
                          const double far = part * std::min(viewport.width, viewport.height) / camera.pixels_per_unit;
                          return camera.centre + far / size * towards;
                        },
                        [&](const auto&) { return plan(*middle_of(light)); },
                    },
                    light.kind);
}

namespace {

Vec2d place_of_object(const Object& object) {
  if (object.transform.empty()) {
    if (const auto* sphere = std::get_if<Sphere<double>>(&object.shape)) return plan(sphere->centre);
    if (const auto* prism = std::get_if<Prism<double>>(&object.shape)) return centroid(*prism);
  }
  if (const auto* plane = std::get_if<Plane<double>>(&object.shape))
    return plan(affine_of(object.transform).point(plane->point));
  const std::optional<Bounds<double>> footprint = footprint_of(object);
  return footprint ? plan(footprint->min + footprint->max) / 2.0 : plan(affine_of(object.transform).move);
}

/// A polygon's extent from a point in a unit direction; 0 if none.
double reach_of(const Prism<double>& prism, const Vec2d& from, const Vec2d& direction) {
  double farthest = 0;
  for (int i = 0; i < prism.sides(); ++i) {
    const Vec2d a = prism.corner(i) - from, edge = prism.corner_after(i) - prism.corner(i);
    const double across = cross(direction, edge);
    if (across == 0) continue;
    const double along_edge = cross(a, direction) / across;
    if (along_edge >= 0 && along_edge <= 1) farthest = std::max(farthest, cross(a, edge) / across);
  }
  return farthest;
}

/// The distance from `at` to the nearest handle of another object, or light.
double clearance(const State& state, int own, const Vec2d& at, const Viewport& viewport) {
  const Scene& scene = state.scene();
  double least = std::numeric_limits<double>::infinity();
  const auto keep_off = [&](const Vec2d& handle) { least = std::min(least, length(handle - at)); };
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    const Object& object = scene.objects[static_cast<std::size_t>(i)];
    if (i == own || !object.transform.empty()) continue;
    if (std::holds_alternative<Sphere<double>>(object.shape))
      keep_off(place_of(state, {TargetKind::radius, i}, viewport));
    if (const auto* prism = std::get_if<Prism<double>>(&object.shape))
      for (int corner = 0; corner < prism->sides(); ++corner) keep_off(prism->corner(corner));
  }
  for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
    keep_off(place_of(state, {TargetKind::light, i}, viewport));
    if (has_radius(scene.lights[static_cast<std::size_t>(i)]))
      keep_off(place_of(state, {TargetKind::light_radius, i}, viewport));
  }
  return least;
}

/// Above the polygon, clear of its outline, or where no other handle is below it; under the pointer while rotating.
Vec2d rotation_place(const State& state, const Target& target, const Prism<double>& prism, const Viewport& viewport) {
  const Vec2d centre = centroid(prism);
  Vec2d direction(0, 1);
  if (state.plan.drag && state.plan.drag->target == target && state.plan.pointer) {
    const Vec2d towards = to_scene(state.plan.camera, viewport, *state.plan.pointer) - centre;
    const double size = length(towards);
    if (size > 0) direction = towards / size;
  }
  const double clear = 26 * state.appearance.ui_scale / state.plan.camera.pixels_per_unit;
  const auto place = [&](const Vec2d& towards) {
    return centre + (reach_of(prism, centre, towards) + clear) * towards;
  };
  if (state.plan.drag || state.scene().objects.size() > few_handled) return place(direction);
  constexpr int ways = 12;
  Vec2d best = place(direction);
  double most = clearance(state, target.index, best, viewport);
  for (int i = 1; i < ways && most < clear; ++i) {
    // Alternately to the right and to the left of the top.
    const double angle = std::numbers::pi * ((i % 2 == 1 ? 1 : -1) * ((i + 1) / 2)) / (ways / 2);
    const Vec2d at = place({std::sin(angle), std::cos(angle)});
    const double free = clearance(state, target.index, at, viewport);
    if (free <= most) continue;
    most = free;
    best = at;
  }
  return best;
}

}  // namespace

bool exists(const State& state, const Target& target) {
  const Scene& scene = state.scene();
  const auto within = [&](std::size_t size) {
    return target.index >= 0 && static_cast<std::size_t>(target.index) < size;
  };
  const auto shape = [&]<class S>(std::in_place_type_t<S>) -> const S* {
    if (!within(scene.objects.size())) return nullptr;
    const Object& object = scene.objects[static_cast<std::size_t>(target.index)];
    return object.transform.empty() ? std::get_if<S>(&object.shape) : nullptr;  // transformed shapes have no handles
  };
  switch (target.kind) {
    case TargetKind::nothing:
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_distance:
      return true;
    case TargetKind::screen_height:
      return target.part == 0 || target.part == 1;
    case TargetKind::cell:
      return target.index >= 0 && target.index < scene.camera.screen.cells;
    case TargetKind::object:
      return within(scene.objects.size());
    case TargetKind::radius:
      return shape(std::in_place_type<Sphere<double>>) != nullptr;
    case TargetKind::corner:
    case TargetKind::edge: {
      const auto* prism = shape(std::in_place_type<Prism<double>>);
      return prism != nullptr && target.part >= 0 && target.part < prism->sides();
    }
    case TargetKind::rotation:
      return shape(std::in_place_type<Prism<double>>) != nullptr;
    case TargetKind::light:
      return within(scene.lights.size());
    case TargetKind::light_radius:
      return within(scene.lights.size()) && has_radius(scene.lights[static_cast<std::size_t>(target.index)]);
    case TargetKind::ray:
      return within(state.walk.timeline->rays().size());
  }
  return false;
}

Vec2d place_of(const State& state, const Target& target, const Viewport& viewport) {
  const Scene& scene = state.scene();
  const auto index = static_cast<std::size_t>(target.index);
  switch (target.kind) {
    case TargetKind::nothing:
      return state.plan.camera.centre;
    case TargetKind::eye:
      return plan(scene.camera.eye);
    case TargetKind::view_direction: {
      const ScreenPlace screen = screen_place(scene.camera);
      const double beyond = 34 * state.appearance.ui_scale / state.plan.camera.pixels_per_unit;
      return screen.centre + beyond * screen.forward;
    }
    case TargetKind::screen_height: {
      const ScreenPlace screen = screen_place(scene.camera);
      return target.part == 0 ? screen.first : screen.last;
    }
    case TargetKind::screen_distance:
      return screen_place(scene.camera).centre;
    case TargetKind::cell:
      return screen_place(scene.camera).at((target.index + 0.5) / scene.camera.screen.cells);
    case TargetKind::object:
      return place_of_object(scene.objects[index]);
    case TargetKind::radius: {
      const auto& sphere = std::get<Sphere<double>>(scene.objects[index].shape);
      return plan(sphere.centre) + plan_radius(sphere) * Vec2d(std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2);
    }
    case TargetKind::corner:
      return std::get<Prism<double>>(scene.objects[index].shape).corner(target.part);
    case TargetKind::edge: {
      const auto& prism = std::get<Prism<double>>(scene.objects[index].shape);
      return (prism.corner(target.part) + prism.corner_after(target.part)) / 2.0;
    }
    case TargetKind::rotation:
      return rotation_place(state, target, std::get<Prism<double>>(scene.objects[index].shape), viewport);
    case TargetKind::light:
      return light_place(scene, scene.lights[index], state.plan.camera, viewport);
    case TargetKind::light_radius: {
      const Light& light = scene.lights[index];
      const double drawn =
          std::max(reach_of(light), 20 * state.appearance.ui_scale / state.plan.camera.pixels_per_unit);
      return plan(*middle_of(light)) + drawn * Vec2d(std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2);
    }
    case TargetKind::ray: {
      const RayRecord& ray = state.walk.timeline->rays()[index];
      return plan(ray.origin + ray.end) / 2.0;
    }
  }
  return state.plan.camera.centre;
}

double grid_step(const PlanCamera& camera) {
  const double least = 10 / camera.pixels_per_unit;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= least) return digit * power;
  return 10 * power;
}

Vec2d turned(const Vec2d& from, const Vec2d& pivot, double angle) {
  const Vec2d arm = from - pivot;
  const double c = std::cos(angle), s = std::sin(angle);
  return pivot + Vec2d(c * arm.x - s * arm.y, s * arm.x + c * arm.y);
}

}  // namespace raywalk
