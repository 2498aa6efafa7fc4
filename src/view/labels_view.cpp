// Names beside the things of the plan, each in the free place nearest to where a reader looks for it.

#include "view/painter.h"
#include "view/text.h"

#include <algorithm>
#include <limits>

namespace raywalk::detail {

namespace {

/// With more objects than this only those selected or pointed at are named.
constexpr std::size_t few_objects = 40;

struct Labelled {
  std::string text;
  Vec2d at;            ///< middle of the thing, pixels
  Vec2d half;          ///< half its extent
  bool above = false;  ///< rather above than below
  Target body{};       ///< the filled drawing that the label may stand on, when it fits
  Colour on_body{};    ///< of its letters there
  bool solid = false;  ///< no ray runs through the body, and so through letters on it
};

/// A filled drawing of an object, and the box around it.
struct Body {
  DisplayItem item;
  Box box;
};

double luminance(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// Black or white, whichever is easier to read on this body.
Colour readable_on(const Painter& painter, Colour body) {
  const Colour seen = mix(painter.colours.plan, body.with_alpha(255), body.a / 255.0);
  return luminance(seen) > 140 ? Colour{0, 0, 0} : Colour{255, 255, 255};
}

Box box_of(const Vec2d& middle, const Vec2d& half) { return {middle - half, middle + half}; }

std::optional<Box> filled_box(const Shape2d& shape) {
  if (const auto* circle = std::get_if<CircleItem>(&shape); circle != nullptr && circle->fill)
    return box_of(circle->centre, Vec2d(circle->radius));
  const auto* polygon = std::get_if<PolygonItem>(&shape);
  if (polygon == nullptr || !polygon->fill || polygon->points.empty()) return std::nullopt;
  Box box{polygon->points.front(), polygon->points.front()};
  for (const Vec2d& p : polygon->points)
    box = {{std::min(box.min.x, p.x), std::min(box.min.y, p.y)}, {std::max(box.max.x, p.x), std::max(box.max.y, p.y)}};
  return box;
}

std::vector<Body> drawn_bodies(const DisplayList& list) {
  std::vector<Body> bodies;
  for (const DisplayItem& item : list)
    if (item.target.kind == TargetKind::object)
      if (const std::optional<Box> box = filled_box(item.shape)) bodies.push_back({item, *box});
  return bodies;
}

/// Share of a label's box that a body covers, by samples.
double covered(const Body& body, const Box& label) {
  if (body.box.overlap(label) <= 0) return 0;
  constexpr int columns = 8, rows = 2;
  int inside = 0;
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const Vec2d size = label.max - label.min;
      const Vec2d sample = label.min + Vec2d(size.x * i / columns, size.y * j / rows);
      inside += distance_to(body.item, sample) == 0 ? 1 : 0;
    }
  return static_cast<double>(inside) / ((columns + 1) * (rows + 1));
}

double covered_by(const std::vector<Body>& bodies, const Target& target, const Box& label) {
  double most = 0;
  for (const Body& body : bodies)
    if (body.item.target == target) most = std::max(most, covered(body, label));
  return most;
}

void add_objects(const Painter& painter, const std::vector<Body>& bodies, std::vector<Labelled>& things) {
  const State& state = painter.state;
  for (std::size_t i = 0; i < painter.scene().objects.size(); ++i) {
    const Object& object = painter.scene().objects[i];
    const Target target{TargetKind::object, static_cast<int>(i)};
    if (painter.scene().objects.size() > few_objects && state.selected != target && state.hovered != target) continue;
    Labelled thing{object.name,
                   Vec2d(0.0),
                   Vec2d(0.0),
                   false,
                   target,
                   readable_on(painter, body_colour(painter.scene(), object.material)),
                   !object.material.transmits()};
    const auto body =
        std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.item.target == target; });
    if (body != bodies.end()) {
      thing.at = painter.pixels(place_of(state, target, painter.viewport));
      thing.half = {std::max(body->box.max.x - thing.at.x, thing.at.x - body->box.min.x),
                    std::max(body->box.max.y - thing.at.y, thing.at.y - body->box.min.y)};
    } else {
      // A wall; what is neither drawn as a body nor as a wall has no name here.
      const auto* plane = std::get_if<Plane<double>>(&object.shape);
      const auto line = plane != nullptr && object.transform.empty() ? plan_line(*plane) : std::nullopt;
      if (!line) continue;
      const Vec2d middle = state.camera.centre;
      thing.at = painter.pixels(line->point + dot(middle - line->point, line->along) * line->along);
      thing.half = Vec2d(14 * painter.sizes.unit);
    }
    things.push_back(std::move(thing));
  }
}

std::vector<Labelled> labelled_things(const Painter& painter, const std::vector<Body>& bodies) {
  const double unit = painter.sizes.unit;
  const Camera& camera = painter.scene().camera;
  const ScreenPlace screen = screen_place(camera);
  const Vec2d first = painter.pixels(screen.first), last = painter.pixels(screen.last);
  const Vec2d eye = painter.pixels(plan(camera.eye));
  const Vec2d back = eye - (first + last) / 2.0;
  const double distance = length(back);
  const Vec2d middle_of_eye = distance > 0 ? eye + 12 * unit / distance * back : eye;
  const Vec2d screen_half(std::abs(first.x - last.x) / 2 + 10 * unit, std::abs(first.y - last.y) / 2 + 10 * unit);
  std::vector<Labelled> things;
  things.push_back({std::string(text(TextId::eye, painter.state.language)), middle_of_eye, Vec2d(17 * unit)});
  things.push_back({std::string(text(TextId::screen, painter.state.language)), (first + last) / 2.0, screen_half});
  for (const Light& light : painter.scene().lights)
    things.push_back({light.name, painter.pixels(light_place(light, painter.state.camera, painter.viewport)),
                      Vec2d(14 * unit), true});
  add_objects(painter, bodies, things);
  return things;
}

/// Distance in pixels from a label's box to what a body draws; 0 where they touch.
double distance_to_box(const Body& body, const Box& label) {
  constexpr int columns = 8;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= columns; ++i)
    for (const double y : {label.min.y, label.max.y})
      least = std::min(least, distance_to(body.item, {label.min.x + (label.max.x - label.min.x) * i / columns, y}));
  return least;
}

/// How easily a label is taken for that of another body, 0..1: much where another is nearer than its own, a little
/// where another is near at all.
double mistakable(const Labelled& thing, const std::vector<Body>& bodies, const Box& label, double unit) {
  double own = 0, other = std::numeric_limits<double>::infinity();
  for (const Body& body : bodies) {
    const double distance = distance_to_box(body, label);
    if (thing.body && body.item.target == thing.body) {
      own = distance;
    } else {
      other = std::min(other, distance);
    }
  }
  const double crowded = 60 * unit, enough = 2 * own + 4 * unit;
  return std::max(other < enough ? 0.9 * (1 - other / enough) : 0.0, 0.3 * std::max(0.0, 1 - other / crowded));
}

/// How far from the middle of its thing, in this direction, a label stands clear of it, as part of the way beside the
/// box around it. A slanted wall's box is mostly empty, so its label may stand nearer; at a slant the way may be too
/// short.
double clear_at(const Labelled& thing, const std::vector<Body>& bodies, const Vec2d& half, const Vec2d& way) {
  if (!thing.body) return 1;
  constexpr int steps = 16;
  constexpr double most = 1.5;
  for (int i = 0; i < most * steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    if (covered_by(bodies, thing.body, box_of(thing.at + t * way, half)) == 0) return t;
  }
  return most;
}

/// Middles that a label of this half size can have beside its thing, the best first.
std::vector<Vec2d> places_beside(const Labelled& thing, const std::vector<Body>& bodies, const Vec2d& half,
                                 double gap) {
  const double dx = thing.half.x + half.x + gap, dy = thing.half.y + half.y + gap;
  const double first = thing.above ? -1 : 1;
  std::vector<Vec2d> places;
  for (const Vec2d& side : {Vec2d(0, first), Vec2d(0, -first), Vec2d(1, 0), Vec2d(-1, 0), Vec2d(0.7, 0.8),
                            Vec2d(-0.7, 0.8), Vec2d(0.7, -0.8), Vec2d(-0.7, -0.8)}) {
    const Vec2d way(side.x * dx, side.y * dy);
    places.push_back(thing.at + clear_at(thing, bodies, half + gap, way) * way);
  }
  return places;
}

}  // namespace

void draw_labels(Painter& painter) {
  const double size = painter.sizes.text, gap = 5 * painter.sizes.unit;
  const Box pane = painter.pane();
  const std::vector<Body> bodies = drawn_bodies(painter.list);
  for (const Labelled& thing : labelled_things(painter, bodies)) {
    const Vec2d half(text_width(thing.text, size) / 2, size / 2);
    if (thing.text.empty() || box_of(thing.at, thing.half).overlap(pane) <= 0) continue;
    const double area = 4 * half.x * half.y;
    const auto hidden_at = [&](const Vec2d& place, const Target& own) {
      const Box box = box_of(place, half);
      double hidden = 4 * (area - box.overlap(pane));
      for (const Box& taken : painter.kept_free) hidden += box.overlap(taken);
      for (const Body& body : bodies)
        if (!own || body.item.target != own) hidden += 0.7 * area * covered(body, box);
      return hidden;
    };
    const auto cost_of = [&](const Vec2d& place, const Target& own) {
      return hidden_at(place, own) +
             (own ? 0 : area * mistakable(thing, bodies, box_of(place, half), painter.sizes.unit));
    };
    Vec2d best = thing.at;
    double least = std::numeric_limits<double>::infinity();
    const bool fits =
        thing.body && thing.solid && covered_by(bodies, thing.body, box_of(thing.at, half + gap / 2)) == 1;
    if (fits) least = cost_of(thing.at, thing.body);
    double order = 0;
    for (const Vec2d& place : places_beside(thing, bodies, half, gap)) {
      const double cost = cost_of(place, {}) + 0.02 * area * ++order;
      if (cost >= least) continue;
      least = cost;
      best = place;
    }
    const bool on_body = fits && best == thing.at;
    // Where there is room for none it would only hide others; pointed at, the thing still says its name.
    const bool wanted = !thing.body || painter.state.selected == thing.body || painter.state.hovered == thing.body;
    if (!on_body && !wanted && hidden_at(best, {}) > 0.6 * area) continue;
    if (!on_body) {
      // A plate that keeps the letters readable across rays.
      const Vec2d plate = half + Vec2d(gap, 0);
      painter.add(PolygonItem{
          {best - plate, {best.x + plate.x, best.y - plate.y}, best + plate, {best.x - plate.x, best.y + plate.y}},
          painter.colours.plan.with_alpha(150),
          std::nullopt});
    }
    const Colour colour = on_body ? thing.on_body : painter.colours.text;
    painter.add(TextItem{best, thing.text, size, colour, TextAnchor::middle});
    painter.kept_free.push_back(box_of(best, half + gap / 2));
  }
}

}  // namespace raywalk::detail
