// Changes the scene by dragging a thing or one of its handles.

#include "math/overloaded.h"
#include "view/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

constexpr double fifteen_degrees = std::numbers::pi / 12;

double to_grid(double value, double grid) { return std::round(value / grid) * grid; }

double clamped_length(double value, const Grip& grip) {
  return std::max(grip.constrain ? to_grid(value, grip.grid) : value, grip.smallest);
}

/// The displacement of a thing placed at `anchor`.
Vec2d shift_of(const Grip& grip, const Vec2d& anchor) {
  Vec2d by = grip.to - grip.from;
  if (grip.constrain) (std::abs(by.x) >= std::abs(by.y) ? by.y : by.x) = 0;
  if (!grip.snap) return by;
  const Vec2d there = anchor + by;
  return Vec2d(to_grid(there.x, grip.grid), to_grid(there.y, grip.grid)) - anchor;
}

double angle_of(const Vec2d& v) { return std::atan2(v.y, v.x); }

/// Angle of the drag about a pivot. With Shift, the angle `present` is snapped to a multiple of 15 degrees.
double turn_of(const Grip& grip, const Vec2d& pivot, double present) {
  const Vec2d from = grip.from - pivot, to = grip.to - pivot;
  if (!(length(from) > 0) || !(length(to) > 0)) return 0;
  const double angle = angle_of(to) - angle_of(from);
  return grip.constrain ? to_grid(present + angle, fifteen_degrees) - present : angle;
}

void shift(Vec3d& point, const Vec2d& by) {
  point.x += by.x;
  point.y += by.y;
}

void turn(Vec3d& direction, double angle) {
  const Vec2d there = turned(plan(direction), Vec2d(0.0), angle);
  direction.x = there.x;
  direction.y = there.y;
}

/// A shape with a position is moved; any other gets a final transform step.
void move_object(Object& object, const Grip& grip) {
  const auto by_transform = [&] {
    const std::optional<Bounds<double>> footprint = footprint_of(object);
    const Vec2d by = shift_of(grip, footprint ? plan(footprint->min) : Vec2d(0.0));
    if (object.transform.empty() || !std::holds_alternative<Translate>(object.transform.back().kind))
      object.transform.push_back({Translate{}});
    std::get<Translate>(object.transform.back().kind).by += Vec3d(by, 0);
  };
  if (!object.transform.empty()) return by_transform();
  std::visit(Overloaded{
                 [&](Sphere<double>& sphere) { shift(sphere.centre, shift_of(grip, plan(sphere.centre))); },
                 [&](Plane<double>& plane) { shift(plane.point, shift_of(grip, plan(plane.point))); },
                 [&](Prism<double>& prism) {
                   const Vec2d by = shift_of(grip, prism.corner(0));
                   for (Vec2d& corner : prism.corners) corner += by;
                 },
                 [&](auto&) { by_transform(); },
             },
             object.shape);
}

void move_light(Light& light, const Grip& grip) {
  std::visit(Overloaded{
                 [&](DirectionalLight& sun) {
                   turn(sun.direction, turn_of(grip, grip.sun_pivot, angle_of(plan(sun.direction))));
                 },
                 [&](auto&) {
                   const Vec2d by = shift_of(grip, plan(*middle_of(light)));
                   if (by != Vec2d(0.0)) move_by(light, Vec3d(by, 0));
                 },
             },
             light.kind);
}

void move_eye(Camera& camera, const Grip& grip) {
  const Vec2d by = shift_of(grip, plan(camera.eye));
  shift(camera.eye, by);
  shift(camera.look_at, by);
}

void turn_view(Camera& camera, const Grip& grip) {
  Vec3d view = camera.look_at - camera.eye;
  turn(view, turn_of(grip, plan(camera.eye), angle_of(plan(view))));
  camera.look_at = camera.eye + view;
}

void set_screen_width(Camera& camera, const Grip& grip) {
  const ScreenPlace screen = screen_place(camera);
  const double outwards = grip.target.part == 0 ? 1 : -1;
  const double grown = 2 * outwards * dot(grip.to - grip.from, screen.left);
  const double width = clamped_length(camera.screen_width() + grown, grip);
  if (!camera.fov) {
    camera.screen.width = width;
    return;
  }
  const double degrees = 2 * std::atan(width / 2 / camera.screen.distance) * 180 / std::numbers::pi;
  camera.fov->degrees = std::clamp(degrees, 0.01, 179.0);
}

void set_screen_distance(Camera& camera, const Grip& grip) {
  const Vec2d forward = screen_place(camera).forward;
  // From above, a tilted view is foreshortened.
  const double scale = std::max(dot(forward, forward), 0.01);
  const double by = dot(grip.to - grip.from, forward) / scale;
  camera.screen.distance = clamped_length(camera.screen.distance + by, grip);
}

void set_radius(double& radius, const Vec2d& centre, const Grip& grip) {
  radius = clamped_length(radius + length(grip.to - centre) - length(grip.from - centre), grip);
}

void turn_prism(Prism<double>& prism, const Grip& grip) {
  const Vec2d pivot = centroid(prism);
  const double angle = turn_of(grip, pivot, 0);
  for (Vec2d& corner : prism.corners) corner = turned(corner, pivot, angle);
}

}  // namespace

std::optional<Scene> dragged(const Grip& grip) {
  Scene scene = grip.scene;
  const auto index = static_cast<std::size_t>(grip.target.index);
  switch (grip.target.kind) {
    case TargetKind::nothing:
    case TargetKind::ray:
      return std::nullopt;
    case TargetKind::eye:
      move_eye(scene.camera, grip);
      return scene;
    case TargetKind::view_direction:
      turn_view(scene.camera, grip);
      return scene;
    case TargetKind::screen_height:
      set_screen_width(scene.camera, grip);
      return scene;
    case TargetKind::screen_distance:
    case TargetKind::cell:
      set_screen_distance(scene.camera, grip);
      return scene;
    case TargetKind::object:
    case TargetKind::edge:  // an edge is for adding corners; dragging it takes the whole body along
      move_object(scene.objects[index], grip);
      return scene;
    case TargetKind::radius: {
      auto& sphere = std::get<Sphere<double>>(scene.objects[index].shape);
      set_radius(sphere.radius, plan(sphere.centre), grip);
      return scene;
    }
    case TargetKind::light_radius: {
      Light& light = scene.lights[index];
      set_radius(*radius_of(light), plan(*middle_of(light)), grip);
      return scene;
    }
    case TargetKind::corner: {
      Vec2d& corner =
          std::get<Prism<double>>(scene.objects[index].shape).corners[static_cast<std::size_t>(grip.target.part)];
      corner += shift_of(grip, corner);
      return scene;
    }
    case TargetKind::rotation:
      turn_prism(std::get<Prism<double>>(scene.objects[index].shape), grip);
      return scene;
    case TargetKind::light:
      move_light(scene.lights[index], grip);
      return scene;
  }
  return std::nullopt;
}

}  // namespace raywalk
