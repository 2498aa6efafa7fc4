#include "math/overloaded.h"
#include "view/plan/painter.h"

#include <algorithm>
#include <numbers>

namespace raywalk {

namespace {

void draw_dot(Painter& painter, const Target& target) {
  const bool hovered =
      painter.state.plan.hovered == target || (painter.state.plan.drag && painter.state.plan.drag->target == target);
  const bool selected = painter.state.plan.selected == target;
  const Vec2d at = painter.pixels(place_of(painter.state, target, painter.viewport));
  const Colour fill = hovered ? painter.colours.hovered : selected ? painter.colours.selected : painter.colours.plan;
  const double largest = 1.35 * painter.sizes.handle, radius = hovered ? largest : painter.sizes.handle;
  painter.add(CircleItem{at, radius, fill, painter.stroke(painter.colours.handle)}, target);
  painter.keep_free(at, largest);
}

/// A ring on a stalk: rotates its object.
void draw_rotation(Painter& painter, const Target& target, const Prism<double>& prism) {
  const Vec2d centre = painter.pixels(centroid(prism));
  const Vec2d at = painter.pixels(place_of(painter.state, target, painter.viewport));
  const Stroke stalk{painter.colours.handle.with_alpha(120), painter.sizes.unit, painter.scaled({{2, 3}, 2})};
  painter.add(LineItem{centre, at, stalk});
  draw_dot(painter, target);
  painter.add(ArcItem{at, 2 * painter.sizes.handle, -0.75 * std::numbers::pi, 0.5 * std::numbers::pi,
                      painter.stroke(painter.colours.handle)});
}

void draw_view_direction(Painter& painter) {
  const Target target{TargetKind::view_direction};
  const Vec2d from = painter.pixels(place_of(painter.state, {TargetKind::screen_distance}, painter.viewport));
  const Vec2d to = painter.pixels(place_of(painter.state, target, painter.viewport));
  painter.add(LineItem{from, to, painter.outline(target, painter.colours.handle), 8 * painter.sizes.unit});
  // Keeps names off the arrow.
  constexpr int pieces = 4;
  for (int i = 0; i <= pieces; ++i)
    painter.keep_free(from + static_cast<double>(i) / pieces * (to - from), length(to - from) / pieces / 2);
  draw_dot(painter, target);
}

/// A body as small as its handles could not be taken hold of itself: its corners wait until it is seen larger.
bool has_room_for_corners(const Painter& painter, const Object& object) {
  const std::optional<Bounds<double>> box = footprint_of(object);
  if (!box) return false;
  const Vec2d size = plan(box->max - box->min);
  return painter.pixels(std::max(size.x, size.y)) >= 5 * painter.sizes.handle;
}

}  // namespace

void draw_handles(Painter& painter) {
  const Scene& scene = painter.scene();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const int index = static_cast<int>(i);
    const auto concerns = [&](const Target& target) { return belongs_to_object(target) && target.index == index; };
    if (scene.objects.size() > few_handled && !concerns(painter.state.plan.selected) &&
        !concerns(painter.state.plan.hovered))
      continue;
    if (!scene.objects[i].transform.empty()) continue;  // its handles would be elsewhere
    std::visit(Overloaded{
                   [&](const Sphere<double>&) { draw_dot(painter, {TargetKind::radius, index}); },
                   [](const auto&) {},
                   [&](const Prism<double>& prism) {
                     draw_rotation(painter, {TargetKind::rotation, index}, prism);
                     if (!has_room_for_corners(painter, scene.objects[i])) return;
                     for (int corner = 0; corner < prism.sides(); ++corner)
                       draw_dot(painter, {TargetKind::corner, index, corner});
                   },
               },
               scene.objects[i].shape);
  }
  const auto is_asked_for = [&](int light) {
    const auto concerns = [&](const Target& target) { return belongs_to_light(target) && target.index == light; };
    return concerns(painter.state.plan.selected) || concerns(painter.state.plan.hovered);
  };
  for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light)
    if (has_radius(scene.lights[static_cast<std::size_t>(light)]) &&
        (scene.lights.size() <= few_handled || is_asked_for(light)))
      draw_dot(painter, {TargetKind::light_radius, light});
  draw_view_direction(painter);
  draw_dot(painter, {TargetKind::screen_distance});
  draw_dot(painter, {TargetKind::screen_height, -1, 0});
  draw_dot(painter, {TargetKind::screen_height, -1, 1});
}

}  // namespace raywalk
