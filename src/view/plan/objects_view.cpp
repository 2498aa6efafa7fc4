#include "math/overloaded.h"
#include "scene/metals.h"
#include "view/plan/painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raywalk {

namespace {

constexpr double max_pixels = 1e5;  // of larger circles only what is near the pane is drawn

/// A line (in pixels) from one end of the pane to the other.
LineItem across_pane(const Painter& painter, const PlanLine& line) {
  const Vec2d nearest = line.nearest_to(Vec2d(painter.viewport.width, painter.viewport.height) / 2.0);
  const double far = painter.viewport.width + painter.viewport.height;
  return {nearest - far * line.along, nearest + far * line.along, {}};
}

void draw_plane(Painter& painter, const Object& object, const Target& target, Colour body) {
  const std::optional<PlanLine> cut = wall_line(object);
  if (!cut) return;  // level: above or below the plan
  const Vec2d along(cut->along.x, -cut->along.y);
  LineItem line = across_pane(painter, {painter.pixels(cut->point), along});
  const Stroke outline = painter.outline(target, body, 2);
  line.stroke = outline;
  painter.add_clipped(line, target);
  // Hatched on the back: the front is to the left of `along` in the scene.
  const Vec2d back = Vec2d(-along.y, along.x);
  const double spacing = 12 * painter.sizes.unit, size = 9 * painter.sizes.unit;
  const double whole = length(line.to - line.from);
  const int count = static_cast<int>(whole / spacing);
  for (int i = 0; i <= count; ++i) {
    const Vec2d foot = line.from + i * spacing * along;
    painter.add_clipped({foot, foot + size * (back - along) * std::numbers::sqrt2 / 2.0, painter.stroke(body)});
  }
}

/// What lies within a large circle near the pane, as a polygon: its rim, and behind that far enough to fill the pane.
/// None where it is out of sight.
std::optional<PolygonItem> part_of_circle(const Painter& painter, const Vec2d& centre, double radius) {
  const Vec2d middle = Vec2d(painter.viewport.width, painter.viewport.height) / 2.0;
  const double far = painter.viewport.width + painter.viewport.height, off = length(middle - centre);
  const Vec2d out = off > 0 ? (middle - centre) / off : Vec2d(1, 0), along(-out.y, out.x);
  const double outside = off - radius;  // of the middle
  if (!std::isfinite(off) || outside > far) return std::nullopt;
  const Vec2d rim = middle - outside * out;
  PolygonItem part;
  constexpr int pieces = 64;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = (2.0 * i / pieces - 1) * far / radius, half = std::sin(angle / 2);
    part.points.push_back(rim + radius * (std::sin(angle) * along - 2 * half * half * out));
  }
  const double depth = std::min(2 * radius, std::max(0.0, -outside) + 2 * far);
  part.points.push_back(part.points.back() - depth * out);
  part.points.push_back(part.points.front() - depth * out);
  return part;
}

void draw_sphere(Painter& painter, const Sphere<double>& sphere, const Target& target, Colour body) {
  const Vec2d centre = painter.pixels(plan(sphere.centre));
  const double radius = painter.pixels(plan_radius(sphere));
  const PixelRect box{centre - radius, centre + radius};
  if (box.overlap(painter.pane()) <= 0) return;
  Stroke outline = painter.outline(target, mix(body.with_alpha(255), painter.colours.ink, 0.5), body.a < 255 ? 1.6 : 1);
  if (!meets_plan(sphere)) {
    // Entirely above or below the plan: only its outline is visible, and no ray of the plan hits it.
    body = body.with_alpha(body.a / 5);
    outline.dash = painter.scaled({{2, 3}, 2});
  }
  if (radius <= max_pixels) return painter.add(CircleItem{centre, std::max(radius, 1.0), body, outline}, target);
  if (auto part = part_of_circle(painter, centre, radius)) {
    part->fill = body;
    part->stroke = outline;
    painter.add(std::move(*part), target);
  }
}

void draw_prism(Painter& painter, const Prism<double>& prism, const Target& target, Colour body) {
  std::vector<Vec2d> points;
  PixelRect box{Vec2d(1e300), Vec2d(-1e300)};
  for (const Vec2d& corner : prism.corners) {
    const Vec2d at = painter.pixels(corner);
    points.push_back(at);
    box = {{std::min(box.min.x, at.x), std::min(box.min.y, at.y)},
           {std::max(box.max.x, at.x), std::max(box.max.y, at.y)}};
  }
  if (box.overlap(painter.pane()) <= 0) return;
  const Stroke outline =
      painter.outline(target, mix(body.with_alpha(255), painter.colours.ink, 0.5), body.a < 255 ? 1.6 : 1);
  painter.add(PolygonItem{points, body, outline}, target);
  if (painter.state.walk.mode != Mode::move) return;
  for (std::size_t i = 0; i < points.size(); ++i)
    painter.add(LineItem{points[i], points[(i + 1) % points.size()], outline},
                {TargetKind::edge, target.index, static_cast<int>(i)});
}

/// Objects without an outline in the plan are shown as their box, dashed.
void draw_footprint(Painter& painter, const Object& object, const Target& target, Colour body) {
  const std::optional<Bounds<double>> footprint = footprint_of(object);
  if (!footprint) return;
  const Vec2d low = plan(footprint->min), high = plan(footprint->max);
  std::vector<Vec2d> points;
  for (const Vec2d& corner : {low, Vec2d(high.x, low.y), high, Vec2d(low.x, high.y)})
    points.push_back(painter.pixels(corner));
  if (PixelRect{points[3], points[1]}.overlap(painter.pane()) <= 0) return;
  Stroke outline = painter.outline(target, mix(body.with_alpha(255), painter.colours.ink, 0.5), 1);
  outline.dash = painter.scaled({{6, 4}, 2});
  painter.add(PolygonItem{points, body.with_alpha(body.a / 3), outline}, target);
}

/// Whether it lies above or below the plan.
bool is_off_plan(const Object& object) {
  if (std::holds_alternative<Plane<double>>(object.shape)) return false;
  if (const auto* sphere = std::get_if<Sphere<double>>(&object.shape); sphere != nullptr && object.transform.empty())
    return !meets_plan(*sphere);
  const std::optional<Bounds<double>> box = footprint_of(object);
  return box && (box->min.z > 0 || box->max.z < 0);
}

void draw_object(Painter& painter, const Object& object, const Target& target, Colour body) {
  if (std::holds_alternative<Plane<double>>(object.shape)) return draw_plane(painter, object, target, body);
  if (!object.transform.empty()) return draw_footprint(painter, object, target, body);
  std::visit(Overloaded{
                 [&](const Sphere<double>& sphere) { draw_sphere(painter, sphere, target, body); },
                 [&](const Prism<double>& prism) { draw_prism(painter, prism, target, body); },
                 [&](const auto&) { draw_footprint(painter, object, target, body); },
             },
             object.shape);
}

/// Thins out many small spheres: one is drawn per cell of the pane. A million of them take longer to draw than to
/// trace.
class Thinning {
 public:
  explicit Thinning(const Painter& painter) : painter_(painter) {
    constexpr std::size_t few = 5000;
    if (painter.scene().objects.size() > few) taken_.resize(across_ * (cell_of(painter.viewport.height) + 1));
  }
  [[nodiscard]] bool hides(const Object& object) {
    const auto* sphere = std::get_if<Sphere<double>>(&object.shape);
    if (taken_.empty() || sphere == nullptr || !object.transform.empty()) return false;
    if (painter_.pixels(sphere->radius) > cell) return false;
    const Vec2d at = painter_.pixels(plan(sphere->centre));
    const Viewport& pane = painter_.viewport;
    if (!(at.x >= 0 && at.y >= 0 && at.x < pane.width && at.y < pane.height)) return true;
    std::vector<bool>::reference taken = taken_[cell_of(at.y) * across_ + cell_of(at.x)];
    const bool hidden = taken;
    taken = true;
    return hidden;
  }

 private:
  static constexpr double cell = 6;  ///< pixels
  static std::size_t cell_of(double pixels) { return static_cast<std::size_t>(pixels / cell); }
  const Painter& painter_;
  std::size_t across_ = cell_of(painter_.viewport.width) + 1;
  std::vector<bool> taken_;
};

}  // namespace

Colour body_colour(const Scene& scene, const Material& material) {
  // Unlit: the diffuse colour under white light, and a part of reflection and transmission, so that a mirror is not
  // black, and a metal has its colour.
  Rgbd colour = scene.ambient * material.ambient + material.diffuse;
  if (material.checker) colour *= (material.checker->even + material.checker->odd) / 2.0;
  colour += material.emission;
  if (material.is_metal())
    colour += 0.7 * material.reflection * reflectance_at_right_angles(material.mirror);
  else
    colour += 0.25 * material.reflection;
  if (material.transmits()) {
    const Rgbd tinted = colour + 0.6 * material.transmission;
    return display_colour(tinted).with_alpha(56);
  }
  return display_colour(colour);
}

void draw_objects(Painter& painter) {
  const auto& objects = painter.scene().objects;
  const auto draw = [&](int index) {
    const Object& object = objects[static_cast<std::size_t>(index)];
    draw_object(painter, object, {TargetKind::object, index}, body_colour(painter.scene(), object.material));
  };
  // In Move the selected one is on top, so that one dropped onto another can be picked up again.
  const bool moving = painter.state.walk.mode == Mode::move;
  const int on_top = moving && belongs_to_object(painter.state.plan.selected) ? painter.state.plan.selected.index : -1;
  Thinning crowd(painter);
  std::vector<int> in_plan;  // a floor or a ceiling lies beneath these, and leaves them to the pointer
  for (int index = 0; index < static_cast<int>(objects.size()); ++index) {
    const Object& object = objects[static_cast<std::size_t>(index)];
    if (index == on_top || crowd.hides(object)) continue;
    if (is_off_plan(object))
      draw(index);
    else
      in_plan.push_back(index);
  }
  std::for_each(in_plan.begin(), in_plan.end(), draw);
  if (on_top >= 0) draw(on_top);
}

void draw_grid(Painter& painter) {
  double step = grid_step(painter.state.plan.camera);
  while (painter.pixels(step) < 36 * painter.sizes.unit) step *= 10;
  const Vec2d first = to_scene(painter.state.plan.camera, painter.viewport, {0, painter.viewport.height});
  const Vec2d last = to_scene(painter.state.plan.camera, painter.viewport, {painter.viewport.width, 0});
  const Stroke faint{painter.colours.grid, painter.sizes.unit};
  // Counted in whole lines: far from the origin, adding a step to a coordinate may not change it.
  const auto lines = [step](double from, double to) { return static_cast<int>(std::min((to - from) / step, 1e4)); };
  const double x0 = std::ceil(first.x / step) * step, y0 = std::ceil(first.y / step) * step;
  for (int i = 0; i <= lines(x0, last.x); ++i) {
    const double x = painter.pixels(Vec2d(x0 + i * step, 0)).x;
    painter.add(LineItem{{x, 0}, {x, painter.viewport.height}, faint});
  }
  for (int i = 0; i <= lines(y0, last.y); ++i) {
    const double y = painter.pixels(Vec2d(0, y0 + i * step)).y;
    painter.add(LineItem{{0, y}, {painter.viewport.width, y}, faint});
  }
}

}  // namespace raywalk
