// Names beside the things of the plan, each in the free place nearest to where a reader looks for it.

#include "view/painter.h"
#include "view/text.h"
#include "view/update_parts.h"

#include <algorithm>
#include <limits>

namespace raywalk::detail {

namespace {

struct Labelled {
  std::string text;
  Vec2d at;             ///< middle of the thing, pixels
  Vec2d half;           ///< half its extent: labels go beside it
  bool inside = false;  ///< the label fits into the thing
  bool above = false;   ///< rather above than below
  Colour colour{};
};

double luminance(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// Black or white, whichever is easier to read on this body.
Colour readable_on(const Painter& painter, Colour body) {
  const Colour seen = mix(painter.colours.plan, body.with_alpha(255), body.a / 255.0);
  return luminance(seen) > 140 ? Colour{0, 0, 0} : Colour{255, 255, 255};
}

Box box_of(const Vec2d& middle, const Vec2d& half) { return {middle - half, middle + half}; }

void add_objects(const Painter& painter, std::vector<Labelled>& things) {
  for (const Object& object : painter.scene().objects) {
    Labelled thing{object.name, Vec2d(0.0), Vec2d(0.0), false, false, painter.colours.text};
    double room = 0;
    const auto beside_footprint = [&] {
      const std::optional<Bounds<double>> footprint = footprint_of(object);
      if (!footprint) return thing.text.clear();
      thing.at = painter.pixels(plan(footprint->min + footprint->max) / 2.0);
      const Vec2d size = plan(footprint->max - footprint->min);
      thing.half = {painter.pixels(size.x) / 2, painter.pixels(size.y) / 2};
    };
    if (!object.transform.empty()) {
      beside_footprint();
    } else {
      std::visit(Overloaded{
                     [&](const Sphere<double>& sphere) {
                       thing.at = painter.pixels(plan(sphere.centre));
                       thing.half = Vec2d(painter.pixels(plan_radius(sphere)));
                       room = 1.7 * thing.half.x;
                     },
                     [&](const Plane<double>& plane) {
                       const std::optional<PlanLine> line = plan_line(plane);
                       if (!line) return thing.text.clear();
                       const Vec2d middle = painter.state.camera.centre;
                       thing.at = painter.pixels(line->point + dot(middle - line->point, line->along) * line->along);
                       thing.half = Vec2d(14 * painter.sizes.unit);
                     },
                     [&](const Prism<double>& prism) {
                       thing.at = painter.pixels(centroid(prism));
                       for (const Vec2d& corner : prism.corners) {
                         const Vec2d arm = painter.pixels(corner) - thing.at;
                         thing.half = {std::max(thing.half.x, std::abs(arm.x)),
                                       std::max(thing.half.y, std::abs(arm.y))};
                       }
                       room = 1.1 * thing.half.x;
                     },
                     [&](const auto&) { beside_footprint(); },
                 },
                 object.shape);
    }
    if (thing.text.empty()) continue;
    thing.inside = text_width(thing.text, painter.sizes.text) < room;
    if (thing.inside) thing.colour = readable_on(painter, body_colour(painter.scene(), object.material));
    things.push_back(thing);
  }
}

std::vector<Labelled> labelled_things(const Painter& painter) {
  const double unit = painter.sizes.unit;
  const Camera& camera = painter.scene().camera;
  const ScreenPlace screen = screen_place(camera);
  const Vec2d first = painter.pixels(screen.first), last = painter.pixels(screen.last);
  std::vector<Labelled> things;
  things.push_back({std::string(text(TextId::eye)), painter.pixels(plan(camera.eye)) - Vec2d(12 * unit, 0),
                    Vec2d(17 * unit), false, false, painter.colours.text});
  things.push_back({std::string(text(TextId::screen)),
                    (first + last) / 2.0,
                    {std::abs(first.x - last.x) / 2 + 8 * unit, std::abs(first.y - last.y) / 2 + 8 * unit},
                    false,
                    false,
                    painter.colours.text});
  for (const Light& light : painter.scene().lights)
    things.push_back({light.name, painter.pixels(light_place(light, painter.state.camera, painter.viewport)),
                      Vec2d(14 * unit), false, true, painter.colours.text});
  add_objects(painter, things);
  return things;
}

/// Middles that a label of this half size can have, the best first.
std::vector<Vec2d> candidates(const Labelled& thing, const Vec2d& half, double gap) {
  const double dx = thing.half.x + half.x + gap, dy = thing.half.y + half.y + gap;
  std::vector<Vec2d> places;
  if (thing.inside) places.push_back(thing.at);
  const double first = thing.above ? -1 : 1;
  for (const Vec2d& side : {Vec2d(0, first), Vec2d(0, -first), Vec2d(1, 0), Vec2d(-1, 0), Vec2d(0.7, 0.8),
                            Vec2d(-0.7, 0.8), Vec2d(0.7, -0.8), Vec2d(-0.7, -0.8)})
    places.push_back(thing.at + Vec2d(side.x * dx, side.y * dy));
  return places;
}

}  // namespace

void draw_labels(Painter& painter) {
  const double size = painter.sizes.text;
  const Box pane = painter.pane();
  const double gap = 4 * painter.sizes.unit;
  for (const Labelled& thing : labelled_things(painter)) {
    const Vec2d half(text_width(thing.text, size) / 2, size / 2);
    if (thing.text.empty() || box_of(thing.at, thing.half).overlap(pane) <= 0) continue;
    double least = std::numeric_limits<double>::infinity();
    Vec2d best = thing.at;
    double order = 0;
    for (const Vec2d& place : candidates(thing, half, gap)) {
      const Box box = box_of(place, half);
      const double area = 4 * half.x * half.y;
      double cost = 4 * (area - box.overlap(pane)) + 0.01 * area * order++;
      const bool inside = thing.inside && place == thing.at;
      for (const Box& taken : painter.kept_free) cost += (inside ? 0.5 : 1.0) * box.overlap(taken);
      if (cost >= least) continue;
      least = cost;
      best = place;
    }
    const bool within = thing.inside && best == thing.at;
    if (!within) {
      // A plate that keeps the letters readable across rays.
      const Vec2d plate = half + Vec2d(gap, gap / 4);
      painter.add(PolygonItem{
          {best - plate, {best.x + plate.x, best.y - plate.y}, best + plate, {best.x - plate.x, best.y + plate.y}},
          painter.colours.plan.with_alpha(170),
          std::nullopt});
    }
    painter.add(TextItem{best, thing.text, size, within ? thing.colour : painter.colours.text, TextAnchor::middle});
    painter.kept_free.push_back(box_of(best, half + gap / 2));
  }
}

}  // namespace raywalk::detail
