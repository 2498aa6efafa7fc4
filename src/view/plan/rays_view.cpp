#include "view/plan/painter.h"
#include "view/text/text.h"
#include "view/walk/lit.h"
#include "view/walk/tween.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// The drawn end of the ray, in scene units, where its end may not be known yet; none if it is infinite.
std::optional<Vec2d> drawn_end(const RayRecord& ray, const Scene& scene, bool known) {
  if (known) return ray.endless ? std::nullopt : std::optional(plan(ray.end));
  const bool to_a_place = ray.light >= 0 && ray.light < static_cast<int>(scene.lights.size()) &&
                          middle_of(scene.lights[static_cast<std::size_t>(ray.light)]).has_value();
  return to_a_place ? std::optional(plan(ray.origin + ray.direction)) : std::nullopt;
}

/// A point beyond the pane, from any start in it; from outside, measured from its middle.
Vec2d beyond_pane(const Painter& painter, const Vec2d& from, const Vec2d& along) {
  const Vec2d middle = Vec2d(painter.viewport.width, painter.viewport.height) / 2.0;
  return from + (painter.viewport.width + painter.viewport.height + length(middle - from)) * along;
}

/// Growth outside the pane takes no time.
Vec2d grown_end(const Painter& painter, const RayRecord& ray, const RayWay& way, const Growth& growth) {
  const auto before = growth.from_start ? RayWay{way.from, way.from, way.along} : *ray_way(painter, ray, false);
  const Vec2d start = painter.seen_end(before.from, before.to), end = painter.seen_end(way.from, way.to);
  return start + growth.part * (end - start);
}

/// Why the ray was not formed, beside its stub. In a narrow pane the sentence below it has to suffice.
void draw_why_not(Painter& painter, const RayRecord& ray, const Vec2d& from, const Vec2d& along) {
  const std::string why(text(ray.ending, painter.state.appearance.language));
  if (text_width(why, painter.sizes.text) + 28 * painter.sizes.unit > 0.5 * painter.viewport.width) return;
  painter.note_beside(from + 24 * painter.sizes.unit * along, along, why);
}

/// A ray whose end is not known yet fades towards the border of the pane, so as not to seem to pass through objects.
void add_fading(Painter& painter, LineItem line, const Target& target) {
  constexpr int pieces = 8;
  constexpr double whole = 0.5, faintest = 0.25;  // of the length, of the colour
  const Vec2d from = line.from, to = painter.seen_end(line.from, line.to);
  const double alpha = line.stroke.colour.a, phase = line.stroke.phase, size = length(to - from);
  const auto piece = [&](double begin, double end, double share) {
    LineItem part = line;
    part.from = from + begin * (to - from);
    part.to = from + end * (to - from);
    part.stroke.phase = phase + begin * size;
    part.stroke.colour.a = static_cast<std::uint8_t>(alpha * share);
    painter.add_clipped(part, target);
    line.arrow = 0;  // only the first piece has one
  };
  piece(0, whole, 1);
  for (int i = 0; i < pieces; ++i)
    piece(whole + (1 - whole) * i / pieces, whole + (1 - whole) * (i + 1) / pieces,
          1 - (1 - faintest) * (i + 1) / pieces);
}

void draw_ray(Painter& painter, const RaysShown& shown, int index, const RayLook& look) {
  const RayRecord& ray = painter.state.walk.timeline->rays()[static_cast<std::size_t>(index)];
  const bool known = ray.found_at <= shown.position;
  const std::optional<RayWay> way = ray_way(painter, ray, known);
  if (!way) return;
  const auto& [from, end, along, open] = *way;
  const Stroke stroke = ray_stroke(painter, ray, look);
  const Target target = shown.pointed_at ? Target{TargetKind::ray, index} : Target{};
  if (!ray.formed) {
    draw_stub(painter, from, along, stroke, target);
    if (look.prominence == Prominence::current) draw_why_not(painter, ray, from, along);
    return;
  }
  const std::optional<Growth> growth = growth_of(painter.state, index);
  const Vec2d to = growth ? grown_end(painter, ray, *way, *growth) : end;
  if (look.prominence >= Prominence::of_pixel) painter.prominent.push_back({from, to});
  if (look.hovered) painter.add_clipped({from, to, {painter.colours.hovered.with_alpha(90), 8 * painter.sizes.unit}});
  LineItem line{from, to, stroke, ray_arrow(painter, look), 0.55};
  const double visible = length(to - from);
  if (visible < 3 * line.arrow) line.arrow = visible / 3;
  if (open && !growth)
    add_fading(painter, line, target);
  else
    painter.add_clipped(line, target);
  if (known && ray.ending == Ending::blocked && !growth) draw_blocked(painter, to, along, stroke);
}

void draw_normal(Painter& painter, const RayRecord& ray) {
  const Vec3d outward = ray.outward_shading_normal();
  const Vec2d normal(outward.x, -outward.y);
  if (!(length(normal) > 1e-6)) return;
  const Vec2d at = painter.pixels(plan(ray.end));
  LineItem line{at, at + 26 * painter.sizes.unit * normal, painter.stroke(painter.colours.normal),
                5 * painter.sizes.unit};
  painter.prominent.push_back({line.from, line.to});
  painter.add_clipped({line.from, line.to, {painter.halo(), 2.6 * line.stroke.width}});  // seen on a body of its colour
  painter.add_clipped(line);
}

}  // namespace

std::optional<RayWay> ray_way(const Painter& painter, const RayRecord& ray, bool known) {
  const Vec2d towards(ray.direction.x, -ray.direction.y);  // on the screen
  const double size = length(towards);
  if (!(size > 0)) return std::nullopt;
  const Vec2d along = towards / size;
  const Vec2d from = painter.pixels(plan(ray.origin));
  const std::optional<Vec2d> end = drawn_end(ray, painter.scene(), known);
  return RayWay{from, end ? painter.pixels(*end) : beyond_pane(painter, from, along), along, !known && !end};
}

Stroke ray_stroke(const Painter& painter, const RayRecord& ray, const RayLook& look) {
  const RayStyle& style = ray_style(painter.state.appearance.theme, ray.kind);
  Stroke stroke{style.colour, painter.sizes.unit, painter.scaled(style.dash)};
  switch (look.prominence) {
    case Prominence::faded:
      stroke.colour.a = 34;
      break;
    case Prominence::earlier:
      stroke.colour.a = 100;
      break;
    case Prominence::of_pixel:
      stroke.width = 1.7 * painter.sizes.unit;
      stroke.colour.a = 225;
      break;
    case Prominence::current:
      stroke.width = 3.2 * painter.sizes.unit;
      break;
  }
  if (look.hovered) {
    stroke.width = std::max(stroke.width, 3.2 * painter.sizes.unit);
    stroke.colour.a = 255;
  }
  return stroke;
}

double ray_arrow(const Painter& painter, const RayLook& look) {
  if (look.hovered || look.prominence == Prominence::current) return 12 * painter.sizes.unit;
  return (look.prominence == Prominence::of_pixel ? 8 : 6) * painter.sizes.unit;
}

void draw_blocked(Painter& painter, const Vec2d& at, const Vec2d& along, const Stroke& ray) {
  const Vec2d across(-along.y, along.x);
  const double size = 5 * painter.sizes.unit;
  const Stroke stroke{ray.colour, std::max(ray.width, 1.6 * painter.sizes.unit)};
  painter.add_clipped({at - size * (along + across), at + size * (along + across), stroke});
  painter.add_clipped({at - size * (along - across), at + size * (along - across), stroke});
}

void draw_stub(Painter& painter, const Vec2d& from, const Vec2d& along, const Stroke& stroke, const Target& target) {
  const double size = 24 * painter.sizes.unit, bar = 6 * painter.sizes.unit;
  const Vec2d to = from + size * along, across(-along.y, along.x);
  painter.add_clipped({from, to, stroke}, target);
  painter.add_clipped(
      {to - bar * across, to + bar * across, {stroke.colour, std::max(stroke.width, 1.6 * painter.sizes.unit)}},
      target);
}

RaysShown rays_shown(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const int position = state.walk.position, pixel = timeline.current_pixel(position);
  const bool in_lesson = state.lessons.shown && state.lessons.at() != nullptr;
  const int wished = state.bugs.hunt ? state.bugs.hunt->first_pixel : in_lesson ? state.lessons.first_pixel : 0;
  return {position, pixel, timeline.current_ray(position), std::min(wished, pixel), state.legend.earlier};
}

std::optional<Prominence> prominence_of(const State& state, const RaysShown& shown, int index) {
  const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(index)];
  if (ray.pixel < shown.first_pixel || !state.legend.shows(ray.kind)) return std::nullopt;
  if (index == shown.current) return Prominence::current;
  if (ray.pixel == shown.pixel) return Prominence::of_pixel;
  // What no limit prevented is shown only with its pixel.
  const bool by_itself =
      ray.ending == Ending::facing_away || ray.ending == Ending::outside_cone || ray.ending == Ending::wrong_side;
  if (!ray.formed && by_itself) return std::nullopt;
  switch (shown.others) {
    case Earlier::shown:
      return Prominence::earlier;
    case Earlier::faded:
      return shown.pixel - shown.first_pixel > few_pixels ? Prominence::faded : Prominence::earlier;
    case Earlier::hidden:
      return std::nullopt;
  }
  return std::nullopt;
}

void draw_rays(Painter& painter, const RaysShown& shown) {
  draw_beams(painter, shown);
  const State& state = painter.state;
  const Timeline& timeline = *state.walk.timeline;
  const auto count = static_cast<int>(timeline.rays_at(shown.position).size());
  const auto draw_all = [&](auto prominent) {
    for (int index = 0; index < count; ++index) {
      if (timeline.rays()[static_cast<std::size_t>(index)].beam >= 0) continue;  // an area (beams_view.cpp)
      const std::optional<Prominence> prominence = prominence_of(state, shown, index);
      if (prominence && !is_lit(state, index) && prominent(*prominence))
        draw_ray(painter, shown, index, {*prominence, false});
    }
  };
  draw_all([](Prominence prominence) { return prominence != Prominence::current; });
  for (int index = 0; index < count; ++index) {
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
    if (ray.pixel == shown.pixel && ray.ending == Ending::hit && ray.formed && ray.beam < 0 &&
        ray.found_at <= shown.position && state.legend.shows(ray.kind) && !growth_of(state, index))
      draw_normal(painter, ray);
  }
  draw_all([](Prominence prominence) { return prominence == Prominence::current; });
  // What is pointed at elsewhere is shown even where its kind is hidden.
  for (int index = 0; index < count; ++index) {
    if (!is_lit(state, index) || timeline.rays()[static_cast<std::size_t>(index)].beam >= 0) continue;
    draw_ray(painter, shown, index, {index == shown.current ? Prominence::current : Prominence::of_pixel, true});
  }
}

void draw_flat_note(Painter& painter, std::string_view id) {
  const std::string words(text(id, painter.state.appearance.language));
  const double margin = 16 * painter.sizes.unit, beside = width_of(words, painter.sizes.text) / 2 + margin;
  std::vector<Vec2d> places;
  for (const double x : {painter.viewport.width / 2, beside, painter.viewport.width - beside})
    for (const double y : {painter.viewport.height - margin, margin}) places.emplace_back(x, y);
  painter.note(places, words);
}

}  // namespace raywalk
