// EYE, SCREEN and the lights.

#include "view/plan/painter.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

/// Directions on the screen of the view: forward and to its left, of unit length.
struct ViewAxes {
  Vec2d forward, left;
};

ViewAxes view_axes(const ScreenPlace& screen) {
  const double size = length(screen.forward);
  const Vec2d forward = size > 1e-9 ? Vec2d(screen.forward.x, -screen.forward.y) / size : Vec2d(1, 0);
  return {forward, {forward.y, -forward.x}};
}

}  // namespace

void draw_screen(Painter& painter) {
  const ScreenPlace screen = screen_place(painter.scene().camera);
  const int cells = painter.scene().camera.screen.cells;
  const Vec2d first = painter.pixels(screen.first), last = painter.pixels(screen.last);
  const Vec2d forward = view_axes(screen).forward;
  const double cell = length(last - first) / cells;
  const Vec2d half = std::clamp(cell, 14 * painter.sizes.unit, 22 * painter.sizes.unit) / 2 * forward;
  const auto along = [&](double t) { return first + t * (last - first); };

  // The edges of the view, from EYE through the ends of SCREEN.
  const Vec2d eye = painter.pixels(plan(painter.scene().camera.eye));
  for (const Vec2d& end : {first, last}) {
    LineItem edge{eye, end, {painter.colours.dim_text.with_alpha(90), painter.sizes.unit, painter.scaled({{1, 5}, 2})}};
    painter.add_clipped(edge);
  }

  const std::vector<std::optional<Rgbd>> shades = shades_shown(painter.state);
  const bool room_for_lines = cell >= 3 * painter.sizes.unit;
  for (int i = 0; i < cells; ++i) {
    const double t0 = static_cast<double>(i) / cells, t1 = static_cast<double>(i + 1) / cells;
    const std::optional<Rgbd>& shade = shades[static_cast<std::size_t>(i)];
    PolygonItem quad{{along(t0) - half, along(t0) + half, along(t1) + half, along(t1) - half}, {}, {}};
    quad.fill = shade ? display_colour(*shade, painter.scene().encoding) : painter.colours.empty_cell;
    if (room_for_lines) quad.stroke = Stroke{painter.colours.ink.with_alpha(70), 0.6 * painter.sizes.unit};
    painter.add(quad, {TargetKind::cell, i});
  }
  painter.add(PolygonItem{{first - half, first + half, last + half, last - half},
                          std::nullopt,
                          painter.outline({TargetKind::screen_distance, -1}, painter.colours.ink)});
  // The current pixel, and the hovered one.
  const auto mark = [&](int column, Colour colour, double width) {
    if (column < 0 || column >= cells) return;
    const double t0 = static_cast<double>(column) / cells, t1 = static_cast<double>(column + 1) / cells;
    const Vec2d out = half * 1.35;
    painter.add(PolygonItem{{along(t0) - out, along(t0) + out, along(t1) + out, along(t1) - out},
                            std::nullopt,
                            painter.stroke(colour, width)});
  };
  if (painter.state.walk.mode != Mode::move) mark(current_cell(painter.state), painter.colours.next, 1.6);
  if (painter.state.live.shown) mark(live_cell(painter.state), painter.colours.next, 1.6);
  if (painter.state.plan.hovered.kind == TargetKind::cell && painter.state.walk.mode != Mode::move)
    mark(painter.state.plan.hovered.index, painter.colours.hovered, 1.2);
  constexpr int pieces = 8;
  for (int i = 0; i <= pieces; ++i)
    painter.keep_free(along(static_cast<double>(i) / pieces),
                      std::max(length(half), length(last - first) / pieces / 2));
}

/// An eye from the side: lids, the front of the eyeball, and the iris.
void draw_eye(Painter& painter) {
  const ViewAxes frame = view_axes(screen_place(painter.scene().camera));
  const Vec2d at = painter.pixels(plan(painter.scene().camera.eye));
  const double unit = 1.35 * painter.sizes.unit;
  const Target target{TargetKind::eye};
  const auto place = [&](double forward, double left) {
    return at + unit * (forward * frame.forward + left * frame.left);
  };
  const Stroke outline = painter.outline(target, painter.colours.ink, 1.4);
  // The ray starts at `at`, which is the middle of the pupil.
  const double radius = 13;
  const double open = 0.66;  // radians from the axis to the lids
  std::vector<Vec2d> front;
  constexpr int pieces = 10;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = open * (2.0 * i / pieces - 1);
    front.push_back(place(-radius + radius * std::cos(angle), radius * std::sin(angle)));
  }
  std::vector<Vec2d> ball = front;
  ball.push_back(place(-19, 0));
  painter.add(PolygonItem{ball, mix(painter.colours.plan, painter.colours.ink, 0.12), std::nullopt}, target);
  painter.add(PolylineItem{front, outline}, target);
  painter.add(PolylineItem{{place(1, 10.4), place(-19, 0), place(1, -10.4)}, outline}, target);
  // The iris is a lens across the front, the pupil a dot at its middle.
  std::vector<Vec2d> iris;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 0.36 * (2.0 * i / pieces - 1);
    iris.push_back(place(-radius + radius * std::cos(angle), radius * std::sin(angle)));
  }
  for (int i = pieces; i >= 0; --i) {
    const double side = 2.0 * i / pieces - 1;
    iris.push_back(place(-3.4 + 2.4 * side * side, 4.6 * side));
  }
  painter.add(PolygonItem{iris, Colour{86, 150, 200}, painter.stroke(painter.colours.ink, 0.7)}, target);
  painter.add(CircleItem{place(-1.2, 0), 1.4 * unit, Colour{10, 10, 10}, std::nullopt}, target);
  painter.keep_free(place(-9, 0), 13 * unit);
}

namespace {

/// How far a light with an extent reaches, seen from above.
void draw_extent(Painter& painter, const Light& light) {
  const Colour fill = painter.colours.light.with_alpha(40);
  const Stroke edge = painter.stroke(painter.colours.light.with_alpha(200));
  std::vector<Vec2d> corners;
  for (const Vec3d& corner : outline_of(light)) corners.push_back(painter.pixels(plan(corner)));
  if (!corners.empty())
    painter.add(PolygonItem{std::move(corners), fill, edge});
  else if (const auto middle = middle_of(light))
    painter.add(CircleItem{painter.pixels(plan(*middle)), painter.pixels(reach_of(light)), fill, edge});
}

}  // namespace

void draw_lights(Painter& painter) {
  const double unit = painter.sizes.unit;
  for (std::size_t i = 0; i < painter.scene().lights.size(); ++i) {
    const Light& light = painter.scene().lights[i];
    const Target target{TargetKind::light, static_cast<int>(i)};
    const Vec2d at = painter.pixels(light_place(painter.scene(), light, painter.state.plan.camera, painter.viewport));
    const Stroke outline = painter.outline(target, painter.colours.light, 1.4);
    if (is_area(light)) draw_extent(painter, light);
    constexpr int spokes = 8;
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double angle = 2 * std::numbers::pi * spoke / spokes;
      const Vec2d out(std::cos(angle), std::sin(angle));
      painter.add(LineItem{at + 9.5 * unit * out, at + 14 * unit * out, outline}, target);
    }
    painter.add(CircleItem{at, 6.5 * unit, painter.colours.light, outline}, target);
    if (const auto* sun = std::get_if<DirectionalLight>(&light.kind)) {
      // Its light comes from infinity: parallel arrows.
      const Vec2d away = -plan(sun->direction);
      const double size = length(away);
      if (size > 0) {
        const Vec2d along = Vec2d(away.x, -away.y) / size, across(-along.y, along.x);
        for (const double side : {-8.0, 0.0, 8.0}) {
          const Vec2d start = at + unit * (18.0 * along + side * across);
          painter.add(LineItem{start, start + 20 * unit * along, outline, 6 * unit, 1.0}, target);
        }
        painter.keep_free(at + 28 * unit * along, 12 * unit);
      }
    }
    painter.keep_free(at, 14 * unit);
  }
}

}  // namespace raywalk
