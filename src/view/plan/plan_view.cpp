#include "view/plan/plan_view.h"

#include "view/plan/painter.h"
#include "view/plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raywalk {

Vec2d to_pixels(const PlanCamera& camera, const Viewport& viewport, const Vec2d& point) {
  const Vec2d from_centre = (point - camera.centre) * camera.pixels_per_unit;
  return {viewport.width / 2 + from_centre.x, viewport.height / 2 - from_centre.y};
}

Vec2d to_scene(const PlanCamera& camera, const Viewport& viewport, const Vec2d& pixels) {
  const Vec2d from_centre(pixels.x - viewport.width / 2, viewport.height / 2 - pixels.y);
  return camera.centre + from_centre / camera.pixels_per_unit;
}

namespace {

double across(const Bounds<double>& box) { return length(plan(box.max - box.min)); }

/// What an object takes up of the plan, if that has ends.
std::optional<Bounds<double>> extent_of(const Object& object) {
  const auto* sphere = std::get_if<Sphere<double>>(&object.shape);
  if (sphere == nullptr || !object.transform.empty()) return footprint_of(object);
  const Vec3d reach(plan_radius(*sphere), plan_radius(*sphere), 0);
  Bounds<double> box;
  box.include(sphere->centre - reach);
  box.include(sphere->centre + reach);
  return box;
}

/// Adds the objects to a box. A ground or a fence that would make all others tiny counts by its nearest point.
void include_objects(const Scene& scene, Bounds<double>& box) {
  constexpr double vast = 4;           // times all else together
  constexpr double vast_alone = 1000;  // where all else is eye, screen and lights
  constexpr std::size_t most = 4;
  std::vector<Bounds<double>> largest;  // in falling order
  bool others = false;
  for (const Object& object : scene.objects) {
    const auto extent = extent_of(object);
    if (!extent) continue;
    const auto smaller = [&](const Bounds<double>& each) { return across(each) < across(*extent); };
    largest.insert(std::find_if(largest.begin(), largest.end(), smaller), *extent);
    if (largest.size() <= most) continue;
    box.include(largest.back());
    largest.pop_back();
    others = true;
  }
  for (; !largest.empty(); largest.pop_back()) {
    const Bounds<double>& next = largest.back();
    if (across(next) > (others ? vast : vast_alone) * across(box)) break;
    box.include(next);
    others = true;
  }
  for (const Bounds<double>& ground : largest) {
    const Vec3d middle = (box.min + box.max) / 2.0;
    const Vec3d nearest(std::clamp(middle.x, ground.min.x, ground.max.x),
                        std::clamp(middle.y, ground.min.y, ground.max.y), 0);
    if (length(plan(nearest - middle)) < across(box)) box.include(nearest);
  }
}

}  // namespace

PlanCamera fit(const Scene& scene, const Viewport& viewport, double unit) {
  Bounds<double> box;
  const auto include = [&](const Vec2d& p) { box.include(Vec3d(p, 0)); };
  const ScreenPlace screen = screen_place(scene.camera);
  include(plan(scene.camera.eye));
  include(screen.first);
  include(screen.last);
  for (const Light& light : scene.lights)
    if (const auto middle = middle_of(light)) include(plan(*middle));
  include_objects(scene, box);
  // For a wall, its nearest point, unless it is far away from everything.
  const Vec2d middle = plan(box.min + box.max) / 2.0;
  const double near = length(plan(box.max - box.min));
  for (const Object& object : scene.objects)
    if (const auto line = wall_line(object)) {
      const Vec2d nearest = line->nearest_to(middle);
      if (length(nearest - middle) < near) include(nearest);
    }
  const Vec2d size = plan(box.max) - plan(box.min);
  // The margins are for symbols, labels and handles, and these keep off the sky, whose ring has round corners.
  const double margin = (scene.sky ? sky_depth + 50 : 34) * unit;
  const auto room = [&](double pixels) { return pixels - 2 * std::min(std::max(0.07 * pixels, margin), 0.2 * pixels); };
  const double widest = std::max({size.x / room(viewport.width), size.y / room(viewport.height), 1e-9});
  return {plan(box.min) + size / 2.0, std::clamp(1 / widest, 1e-6, 1e9), true};
}

PlanCamera fitted(const State& state) { return fit(state.scene(), state.plan.viewport, Sizes(state).unit); }

bool is_in_view(const State& state, const Target& target) {
  const Viewport& viewport = state.plan.viewport;
  const Vec2d bottom_left = to_scene(state.plan.camera, viewport, Vec2d(0, viewport.height)),
              top_right = to_scene(state.plan.camera, viewport, Vec2d(viewport.width, 0));
  const auto overlaps = [&](const Vec2d& low, const Vec2d& high) {
    return low.x <= top_right.x && low.y <= top_right.y && high.x >= bottom_left.x && high.y >= bottom_left.y;
  };
  if (target.kind == TargetKind::object) {
    const Object& object = state.scene().objects[static_cast<std::size_t>(target.index)];
    if (const auto extent = extent_of(object)) return overlaps(plan(extent->min), plan(extent->max));
    if (const auto line = wall_line(object)) {
      const auto side = [&](double x, double y) { return cross(line->along, Vec2d(x, y) - line->point) > 0; };
      const bool first = side(bottom_left.x, bottom_left.y);
      return side(bottom_left.x, top_right.y) != first || side(top_right.x, bottom_left.y) != first ||
             side(top_right.x, top_right.y) != first;
    }
  }
  const Vec2d at = place_of(state, target, viewport);
  return overlaps(at, at);
}

Sizes::Sizes(const State& state)
    : unit(state.appearance.ui_scale * theme_scale(state.appearance.theme)),
      text(15 * unit),
      line(1.5 * unit),
      handle(4.5 * unit),
      reach(6 * unit),
      finger(22 * unit) {}

namespace {

/// What the rooms draw in this layer.
void draw_layer(Painter& painter, Layer layer) {
  for_each_room(Rooms(), [&]<class Room>() {
    if constexpr (requires { Room::draw_in_plan(painter); })
      if (Room::layer == layer) Room::draw_in_plan(painter);
  });
}

/// What the rooms draw later, but notes keep off before.
void keep_free(Painter& painter) {
  for_each_room(Rooms(), [&]<class Room>() {
    if constexpr (requires { Room::keep_free_in_plan(painter); }) Room::keep_free_in_plan(painter);
  });
}

}  // namespace

DisplayList plan_view(const State& state, const Viewport& viewport) {
  Painter painter(state, viewport);
  const bool moving = state.walk.mode == Mode::move;
  if (moving) draw_grid(painter);
  draw_objects(painter);
  draw_screen(painter);
  // EYE and the lights lie above the rays, but come first, so that notes beside rays keep off them.
  const auto symbols = static_cast<std::ptrdiff_t>(painter.list.size());
  draw_eye(painter);
  draw_lights(painter);
  keep_free(painter);
  const auto rays = static_cast<std::ptrdiff_t>(painter.list.size());
  if (!moving) draw_layer(painter, Layer::under_rays);
  if (!moving) draw_rays(painter, rays_shown(state));
  if (!moving) draw_ghosts(painter);
  if (!moving) draw_samples(painter);
  draw_layer(painter, moving ? Layer::moving : Layer::over_rays);
  std::rotate(painter.list.begin() + symbols, painter.list.begin() + rays, painter.list.end());
  if (moving) draw_handles(painter);
  draw_layer(painter, Layer::under_labels);
  draw_labels(painter);
  draw_layer(painter, Layer::on_top);
  return std::move(painter.list);
}

namespace {

/// Small things take precedence over what surrounds them.
int rank_of(TargetKind kind) {
  switch (kind) {
    case TargetKind::radius:
    case TargetKind::light_radius:
    case TargetKind::corner:
    case TargetKind::rotation:
    case TargetKind::view_direction:
    case TargetKind::screen_height:
    case TargetKind::screen_distance:
      return 5;
    case TargetKind::eye:
    case TargetKind::light:
      return 4;
    case TargetKind::edge:
      return 3;
    case TargetKind::cell:
      return 2;
    case TargetKind::ray:
      return 1;
    case TargetKind::object:
    case TargetKind::nothing:
      return 0;
  }
  return 0;
}

/// The topmost of what `wanted` says yes to.
template <class Wanted>
Target topmost(const State& state, const Viewport& viewport, const Vec2d& at, double reach, Wanted wanted) {
  const DisplayList list = plan_view(state, viewport);
  Target best;
  int best_rank = -1;
  double best_distance = 0;
  for (const DisplayItem& item : list) {
    if (!item.target || !wanted(item.target.kind)) continue;
    const double distance = distance_to(item, at);
    const int rank = rank_of(item.target.kind);
    if (!(distance <= reach) || rank < best_rank) continue;
    // What is drawn later lies on top, so it wins where both are equally near.
    if (rank == best_rank && distance > best_distance) continue;
    best = item.target;
    best_rank = rank;
    best_distance = distance;
  }
  return best;
}

}  // namespace

Target pick(const State& state, const Viewport& viewport, const Vec2d& at) {
  constexpr int of_small_things = 4;
  const Sizes sizes(state);
  const Target usual = topmost(state, viewport, at, sizes.reach, [](TargetKind) { return true; });
  if (!state.appearance.touch || rank_of(usual.kind) >= of_small_things) return usual;
  // A finger also takes a small thing beside it, unless the middle of what it is on is nearer.
  const Target small = topmost(state, viewport, at, sizes.finger - sizes.handle,
                               [](TargetKind kind) { return rank_of(kind) >= of_small_things; });
  const auto away = [&](const Target& target) {
    return length(to_pixels(state.plan.camera, viewport, place_of(state, target, viewport)) - at);
  };
  if (!small) return usual;
  const bool is_body = usual.kind == TargetKind::object || usual.kind == TargetKind::edge;
  return is_body && away({TargetKind::object, usual.index}) < away(small) ? usual : small;
}

Target body_at(const State& state, const Vec2d& at) {
  return topmost(state, state.plan.viewport, at, Sizes(state).reach,
                 [](TargetKind kind) { return kind == TargetKind::object || kind == TargetKind::light; });
}

}  // namespace raywalk
