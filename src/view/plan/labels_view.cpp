// Names beside the things of the plan.

#include "view/plan/labels_place.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// Whether one of `count` objects, or lights, is named: all of a few, of more only what is selected or hovered.
bool is_named(const Painter& painter, std::size_t count, const Target& target) {
  constexpr std::size_t few = 40;
  const PlanRoom& plan_room = painter.state.plan;
  return count <= few || plan_room.selected == target || plan_room.hovered == target;
}

/// Relative luminance and contrast as defined in WCAG 2.1.
double luminance(Colour c) {
  const auto linear = [](std::uint8_t byte) {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

double contrast(Colour a, Colour b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// The colour there without rays: the plan's background under the bodies, which may be translucent.
Colour ground_at(const Painter& painter, const std::vector<DrawnBody>& bodies, const Vec2d& at) {
  Colour ground = painter.colours.plan;
  for (const DrawnBody& body : bodies)
    if (covers(body.item, at)) ground = mix(ground, body.fill.with_alpha(255), body.fill.a / 255.0);
  return ground;
}

/// Black or white, whichever is more legible on the background of a label; none where neither is legible enough (WCAG
/// 2.1, level AA).
std::optional<Colour> readable_on(const Painter& painter, const std::vector<DrawnBody>& bodies,
                                  const PixelRect& label) {
  constexpr Colour black{0, 0, 0}, white{255, 255, 255};
  double on_black = 1e9, on_white = 1e9;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec2d at(label.min.x + part * (label.max.x - label.min.x), (label.min.y + label.max.y) / 2);
    const Colour ground = ground_at(painter, bodies, at);
    on_black = std::min(on_black, contrast(black, ground));
    on_white = std::min(on_white, contrast(white, ground));
  }
  if (std::max(on_black, on_white) < 4.5) return std::nullopt;
  return on_black > on_white ? black : white;
}

void add_objects(const Painter& painter, const std::vector<DrawnBody>& bodies, std::vector<Labelled>& things) {
  const State& state = painter.state;
  for (std::size_t i = 0; i < painter.scene().objects.size(); ++i) {
    const Object& object = painter.scene().objects[i];
    const Target target{TargetKind::object, static_cast<int>(i)};
    if (!is_named(painter, painter.scene().objects.size(), target)) continue;
    Labelled thing{shown_name(state, object.name),
                   Vec2d(0.0),
                   Vec2d(0.0),
                   false,
                   target,
                   !object.material.transmits(),
                   state.plan.selected == target || state.plan.hovered == target};  // its name is still shown on hover
    const auto body =
        std::find_if(bodies.begin(), bodies.end(), [&](const DrawnBody& b) { return b.item.target == target; });
    if (body != bodies.end()) {
      thing.at = painter.pixels(place_of(state, target, painter.viewport));
      PixelRect box = body->box;
      // Of a body whose middle is outside, what is seen of it.
      if (const PixelRect pane = painter.pane(); !pane.meets(thing.at, thing.at) && box.overlap(pane) > 0) {
        box = {{std::max(box.min.x, pane.min.x), std::max(box.min.y, pane.min.y)},
               {std::min(box.max.x, pane.max.x), std::min(box.max.y, pane.max.y)}};
        thing.at = (box.min + box.max) / 2.0;
      }
      thing.half = {std::max(box.max.x - thing.at.x, thing.at.x - box.min.x),
                    std::max(box.max.y - thing.at.y, thing.at.y - box.min.y)};
    } else {
      // A wall; objects drawn neither as body nor as wall have no name here.
      const auto line = wall_line(object);
      if (!line) continue;
      thing.at = painter.pixels(line->nearest_to(state.plan.camera.centre));
      thing.half = Vec2d(14 * painter.sizes.unit);
    }
    things.push_back(std::move(thing));
  }
}

/// The outline of SCREEN.
std::optional<PolygonItem> drawn_screen(const DisplayList& list) {
  std::optional<PolygonItem> whole;
  for (const DisplayItem& item : list) {
    const auto* cell = std::get_if<PolygonItem>(&item.shape);
    if (cell == nullptr || item.target.kind != TargetKind::cell || cell->points.size() != 4) continue;
    // From the first cell's beginning to the last one's end.
    if (!whole) whole = *cell;
    whole->points[2] = cell->points[2];
    whole->points[3] = cell->points[3];
  }
  return whole;
}

/// Of what is drawn of it; of a light that reaches far, of its sign alone.
Vec2d half_of_light(const Painter& painter, const Light& light) {
  const double sign = 14 * painter.sizes.unit, most = 60 * painter.sizes.unit;
  const double reach = painter.pixels(reach_of(light));
  if (!is_area(light) || reach > most) return Vec2d(sign);
  const std::vector<Vec3d> corners = outline_of(light);
  Vec2d half(corners.empty() ? std::max(sign, reach) : sign);
  const Vec2d middle = painter.pixels(plan(middle_of(light).value_or(Vec3d(0.0))));
  for (const Vec3d& corner : corners) {
    const Vec2d out = painter.pixels(plan(corner)) - middle;
    half = {std::max(half.x, std::abs(out.x)), std::max(half.y, std::abs(out.y))};
  }
  return half;
}

std::vector<Labelled> labelled_things(const Painter& painter, const std::vector<DrawnBody>& bodies) {
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
  things.push_back(
      {std::string(text("object.eye", painter.state.appearance.language)), middle_of_eye, Vec2d(17 * unit)});
  things.push_back(
      {std::string(text("object.screen", painter.state.appearance.language)), (first + last) / 2.0, screen_half});
  things.back().strip = drawn_screen(painter.list);
  const PlanRoom& plan_room = painter.state.plan;
  for (std::size_t i = 0; i < painter.scene().lights.size(); ++i) {
    const Light& light = painter.scene().lights[i];
    const Target target{TargetKind::light, static_cast<int>(i)};
    if (!is_named(painter, painter.scene().lights.size(), target)) continue;
    things.push_back({shown_name(painter.state, light.name),
                      painter.pixels(light_place(painter.scene(), light, plan_room.camera, painter.viewport)),
                      half_of_light(painter, light), true, Target{}, false,
                      plan_room.selected == target || plan_room.hovered == target});
  }
  add_objects(painter, bodies, things);
  return things;
}

}  // namespace

void draw_labels(Painter& painter) {
  const double gap = 3 * painter.sizes.unit;
  const std::vector<DrawnBody> bodies = drawn_bodies(painter.list);
  std::vector<Labelled> things = labelled_things(painter, bodies);
  std::erase_if(things, [&](const Labelled& thing) {
    return thing.text.empty() || PixelRect{thing.at - thing.half, thing.at + thing.half}.overlap(painter.pane()) <= 0;
  });
  const std::vector<LabelPlace> places = place_labels(painter, bodies, things);
  struct Shown {
    const LabelPlace& place;
    Colour colour;
    std::optional<Colour> halo;  ///< beside its body, where rays cross it
  };
  std::vector<Shown> shown;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const LabelPlace& place = places[i];
    if (!is_shown(things[i], place)) continue;
    const PixelRect box = place.box();
    painter.kept_free.push_back({box.min - gap / 2, box.max + gap / 2});
    const std::optional<Colour> readable = place.on_body ? readable_on(painter, bodies, box) : std::nullopt;
    shown.push_back(
        {place, readable.value_or(painter.colours.text), readable ? std::nullopt : std::optional(painter.halo())});
    if (readable) continue;
    if (place.leader) {
      const auto [from, to] = *place.leader;
      painter.add(LineItem{from, to, painter.stroke(painter.colours.text.with_alpha(190), 0.7)});
      // Into a body; it ends beside a symbol.
      if (things[i].body) painter.add(CircleItem{to, 1.8 * painter.sizes.unit, painter.colours.text, std::nullopt});
    }
  }
  // Above the leaders of all.
  for (const Shown& each : shown) draw_letters(painter, each.place.at, each.place.letters, each.colour, each.halo);
}

}  // namespace raywalk
