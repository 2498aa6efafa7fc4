#include "view/space/orbit.h"

#include "scene/transform_step.h"
#include "view/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace raywalk {

namespace {

/// `v` turned about the unit vector `axis` (O. Rodrigues, 1840).
Vec3d turned(const Vec3d& v, const Vec3d& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
}

void add_corners(const Bounds<double>& box, const Affine<double>& place, std::vector<Vec3d>& points) {
  for (int corner = 0; corner < 8; ++corner)
    points.push_back(place.point({(corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                                  (corner & 4) != 0 ? box.max.z : box.min.z}));
}

/// Around what EYE looks at: where nothing in a scene is finite, that is what there is to see.
Bounds<double> looked_at(const Camera& camera) {
  const Vec3d half(length(camera.look_at - camera.eye) / 2);
  Bounds<double> box;
  box.include(camera.look_at - half);
  box.include(camera.look_at + half);
  return box;
}

/// The corners of everything finite, and EYE.
std::vector<Vec3d> bodies_and_eye(const Scene& scene) {
  std::vector<Vec3d> points{scene.camera.eye};
  for (const Object& object : scene.objects) {
    const Bounds<double> own = bounds(object.shape);
    if (!own.empty() && own.bounded()) add_corners(own, affine_of(object.transform), points);
  }
  if (points.size() < 2) add_corners(looked_at(scene.camera), {}, points);
  return points;
}

Bounds<double> box_of(const std::vector<Vec3d>& points) {
  Bounds<double> box;
  for (const Vec3d& point : points) box.include(point);
  return box;
}

/// The same, neither empty nor flat.
Bounds<double> thick(Bounds<double> box) {
  const double size = std::max(length(box.max - box.min), 1e-3);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.max[axis] - box.min[axis] >= 0.01 * size) continue;
    box.min[axis] -= 0.05 * size;
    box.max[axis] += 0.05 * size;
  }
  return box;
}

/// For very many things, the extreme corners in several directions. Their bounding box would not do: with EYE far from
/// the others most of it is empty, and the view would be of its middle.
std::vector<Vec3d> outermost(const Scene& scene) {
  struct Furthest {
    Vec3d way, corner;
    double reach = -std::numeric_limits<double>::infinity();
  };
  std::vector<Furthest> all;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back({normalize(Vec3d(x, y, z)), Vec3d(0.0)});
  for (const Object& object : scene.objects) {
    const std::optional<Bounds<double>> box = footprint_of(object);
    if (!box) continue;
    for (Furthest& one : all) {
      const Vec3d corner(one.way.x > 0 ? box->max.x : box->min.x, one.way.y > 0 ? box->max.y : box->min.y,
                         one.way.z > 0 ? box->max.z : box->min.z);
      const double reach = dot(one.way, corner);
      if (reach > one.reach) one = {one.way, corner, reach};
    }
  }
  std::vector<Vec3d> points{scene.camera.eye};
  for (const Furthest& one : all)
    if (std::isfinite(one.reach)) points.push_back(one.corner);
  return points;
}

/// Half the width of the image at distance 1.
double half_width(const Camera& camera) { return camera.half_extent(); }

}  // namespace

std::vector<Vec3d> seen_at_first(const Scene& scene) {
  constexpr std::size_t most = 1 << 11;
  // A light far away would make everything else small.
  std::vector<Vec3d> points = scene.objects.size() > most ? outermost(scene) : bodies_and_eye(scene);
  const Bounds<double> things = thick(box_of(points));
  if (points.size() < 2) add_corners(things, {}, points);
  const Vec3d middle = things.min + (things.max - things.min) / 2.0;
  for (const Light& light : scene.lights)
    if (const std::optional<Vec3d> at = middle_of(light); at && length(*at - middle) < length(things.max - things.min))
      points.push_back(*at);
  return points;
}

Bounds<double> room_of(const Scene& scene) {
  Bounds<double> box;
  box.include(scene.camera.eye);
  for (const Object& object : scene.objects)
    if (const std::optional<Bounds<double>> own = footprint_of(object)) box.include(*own);
  for (const Light& light : scene.lights)
    if (const std::optional<Vec3d> middle = middle_of(light)) box.include(*middle);
  if (box.min == box.max) box.include(looked_at(scene.camera));
  return thick(box);
}

Vec3d pivot_of(const Scene& scene, const Camera& camera) {
  Bounds<double> things;
  for (const Object& object : scene.objects) {
    const Bounds<double> own = bounds(object.shape);
    if (own.empty() || !own.bounded()) continue;
    const Affine<double> place = affine_of(object.transform);
    things.include(place.point(own.min + (own.max - own.min) / 2.0));
  }
  const Vec3d forward = normalize(camera.look_at - camera.eye);
  if (things.empty()) return camera.look_at;
  const Vec3d middle = things.min + (things.max - things.min) / 2.0;
  const double ahead = dot(middle - camera.eye, forward);
  // The pivot must not be behind the eye.
  return ahead > 1e-3 * length(middle - camera.eye) ? camera.eye + ahead * forward : camera.look_at;
}

Camera orbited(const Camera& camera, const Vec3d& pivot, const Vec2d& angles) {
  if (angles == Vec2d(0.0)) return camera;
  constexpr double steepest = 85 * std::numbers::pi / 180;
  const Vec3d up = normalize(camera.up);
  Vec3d offset = camera.eye - pivot;
  const double distance = length(offset);
  if (!(distance > 0)) return camera;
  offset = turned(offset, up, -angles.x);
  const Vec3d level = offset - dot(offset, up) * up;
  if (!(length(level) > 0)) return camera;
  const Vec3d ahead = normalize(level);
  const double now = std::atan2(dot(offset, up), length(level));
  // A camera that is already steeper may only turn back.
  const double limit = std::max(steepest, std::abs(now));
  const double then = std::clamp(now + angles.y, -limit, limit);
  Camera next = camera;
  next.eye = pivot + distance * (std::cos(then) * ahead + std::sin(then) * up);
  next.look_at = pivot;
  if (!next.focus && camera.aperture > 0) next.focus = camera.focus_distance();
  return next;
}

Camera shifted(const Camera& camera, const Vec3d& pivot, const Vec2d& parts) {
  if (parts == Vec2d(0.0)) return camera;
  const Vec3d forward = normalize(camera.look_at - camera.eye);
  const Vec3d right = normalize(cross(forward, camera.up));
  const double width = 2 * half_width(camera) * std::max(dot(pivot - camera.eye, forward), 1e-9);
  const Vec3d by = width * (parts.y * cross(right, forward) - parts.x * right);
  Camera next = camera;
  next.eye += by;
  next.look_at += by;
  return next;
}

Camera approached(const Camera& camera, const Vec3d& pivot, double factor) {
  if (factor == 1 || !(factor > 0)) return camera;
  const double distance = length(camera.eye - pivot);
  if (!(distance > 0)) return camera;
  Camera next = camera;
  next.eye = pivot + std::clamp(1 / factor, 1e-6 / distance, 1e9 / distance) * (camera.eye - pivot);
  next.look_at = pivot;
  if (!next.focus && camera.aperture > 0) next.focus = camera.focus_distance();
  return next;
}

Camera overlooking(const Scene& scene, const Viewport& viewport) {
  return overlooking(scene, viewport, seen_at_first(scene));
}

Camera overlooking(const Scene& scene, const Viewport& viewport, const std::vector<Vec3d>& points) {
  constexpr double aside = -0.65, above = 0.5, angle = 40;  // radians, radians, degrees
  constexpr double border = 0.8;                            // filled fraction of the pane
  const Bounds<double> box = thick(box_of(points));
  const Vec3d middle = box.min + (box.max - box.min) / 2.0;
  const double size = length(box.max - box.min);
  Camera camera;
  camera.up = scene.camera.up;
  camera.fov = FieldOfView{angle, FovAxis::x};
  camera.screen.width.reset();
  const Vec3d up = normalize(camera.up);
  const Vec3d view = normalize(scene.camera.look_at - scene.camera.eye);
  Vec3d level = view - dot(view, up) * up;
  if (!(length(level) > 1e-6)) level = cross(up, std::abs(up.x) < 0.9 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
  camera.eye = middle - size * normalize(level);
  camera.look_at = middle;
  camera = orbited(camera, middle, {aside, above});

  // As near as possible with everything in view: from an eye e, |across| <= k ahead for every point p. Along one axis r
  // across the view that is e.r - k e.f >= p.r - k p.f and e.r + k e.f <= p.r + k p.f, with f forward; the nearest
  // place is where the maximum and the minimum of the right sides meet, halfway between them.
  const Vec3d forward = normalize(camera.look_at - camera.eye), right = normalize(cross(forward, up));
  const double smaller = std::min(viewport.width, viewport.height);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3d& p : points) nearest = std::min(nearest, dot(p, forward) - 0.05 * size);
  const auto halfway = [&](const Vec3d& axis, double extent) {
    const double k = border * half_width(camera) * extent / smaller;
    double least = -std::numeric_limits<double>::infinity(), most = -least;
    for (const Vec3d& p : points) {
      least = std::max(least, dot(p, axis) - k * dot(p, forward));
      most = std::min(most, dot(p, axis) + k * dot(p, forward));
    }
    nearest = std::min(nearest, (most - least) / (2 * k));
    return (least + most) / 2 * axis;
  };
  const Vec3d across = halfway(right, viewport.width), upwards = halfway(cross(right, forward), viewport.height);
  camera.eye = across + upwards + nearest * forward;
  camera.look_at = camera.eye + (dot(middle, forward) - nearest) * forward;
  return camera;
}

Projection::Projection(const Camera& camera, const Viewport& viewport)
    : eye_(camera.eye),
      forward_(normalize(camera.look_at - camera.eye)),
      centre_(viewport.width / 2, viewport.height / 2),
      scale_(std::min(viewport.width, viewport.height) / 2 / half_width(camera)),
      nearest_(1e-3 * length(camera.look_at - camera.eye)) {
  right_ = normalize(cross(forward_, camera.up));
  up_ = cross(right_, forward_);
}

Vec3d Projection::seen(const Vec3d& p) const {
  const Vec3d from_eye = p - eye_;
  return {dot(from_eye, right_), dot(from_eye, up_), dot(from_eye, forward_)};
}

Vec2d Projection::flat(const Vec3d& seen) const { return centre_ + scale_ / seen.z * Vec2d(seen.x, -seen.y); }

std::optional<Vec2d> Projection::point(const Vec3d& p) const {
  const Vec3d at = seen(p);
  if (!(at.z >= nearest_)) return std::nullopt;
  return flat(at);
}

std::optional<std::array<Vec2d, 2>> Projection::segment(const Vec3d& from, const Vec3d& to) const {
  Vec3d a = seen(from), b = seen(to);
  if (!(a.z >= nearest_) && !(b.z >= nearest_)) return std::nullopt;
  // Clipped where it is too near.
  const auto cut = [&](Vec3d& behind, const Vec3d& ahead) {
    if (behind.z < nearest_) behind = ahead + (ahead.z - nearest_) / (ahead.z - behind.z) * (behind - ahead);
  };
  cut(a, b);
  cut(b, a);
  a.z = std::max(a.z, nearest_);
  b.z = std::max(b.z, nearest_);
  return std::array{flat(a), flat(b)};
}

Vec2d Projection::towards(const Vec3d& p) const {
  const Vec3d at = seen(p);
  const Vec2d way(at.x, -at.y);
  const double size = length(way);
  return size > 0 ? way / size : Vec2d(0, -1);
}

double Projection::pixels_per_unit(const Vec3d& at) const { return scale_ / std::max(seen(at).z, nearest_); }

}  // namespace raywalk
