// What ink looks like in the plan.

#include "view/ink/ink.h"

#include "math/overloaded.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace raywalk {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double pen_width = 2.6;  // units of Sizes

Stroke ink_stroke(const Painter& painter, const InkMark& mark, double width) {
  return {ink_colour(mark.colour, painter.state.appearance.theme), width * painter.sizes.unit};
}

/// Words on a plate, so that they are read across rays; `at`: as TextItem has it.
void add_words(Painter& painter, const Vec2d& at, const std::string& words, double size, Colour colour,
               TextAnchor anchor) {
  const double width = width_of(words, size), gap = 0.25 * size;
  const double left = anchor == TextAnchor::start    ? at.x
                      : anchor == TextAnchor::middle ? at.x - width / 2
                                                     : at.x - width;
  const Vec2d low(left - gap, at.y - 0.62 * size), high(left + width + gap, at.y + 0.62 * size);
  painter.add(
      PolygonItem{{low, {high.x, low.y}, high, {low.x, high.y}}, painter.colours.plan.with_alpha(200), std::nullopt});
  painter.add(TextItem{at, words, size, colour, anchor});
}

/// The words of a tool in the middle of the first of these places where they cover no name; else in the first.
void add_reading(Painter& painter, const std::vector<Vec2d>& places, const std::string& words, Colour colour) {
  const double size = painter.sizes.text;
  const Vec2d half(width_of(words, size) / 2 + 0.25 * size, 0.62 * size);
  const auto free = std::find_if(places.begin(), places.end(),
                                 [&](const Vec2d& at) { return !painter.covers_kept({at - half, at + half}); });
  add_words(painter, free == places.end() ? places.front() : *free, words, size, colour, TextAnchor::middle);
}

void draw(Painter& painter, const InkMark& mark, const PenStroke& pen) {
  const Stroke stroke = ink_stroke(painter, mark, pen_width);
  std::vector<Vec2d> line;
  for (const Vec2d& point : pen.points) line.push_back(painter.pixels(point));
  line = smooth(line, 4 * painter.sizes.unit);
  // Ends are round, and a line without length is a dot.
  for (const Vec2d& end : {line.front(), line.back()})
    painter.add(CircleItem{end, stroke.width / 2, stroke.colour, std::nullopt});
  if (line.size() > 1) painter.add(PolylineItem{std::move(line), stroke});
}

void draw(Painter& painter, const InkMark& mark, const InkArrow& arrow) {
  painter.add_clipped({painter.pixels(arrow.from), painter.pixels(arrow.to), ink_stroke(painter, mark, pen_width),
                       16 * painter.sizes.unit});
}

void draw(Painter& painter, const InkMark& mark, const InkText& note) {
  add_words(painter, painter.pixels(note.at), note.text, 1.25 * painter.sizes.text, ink_stroke(painter, mark, 1).colour,
            TextAnchor::start);
}

void draw(Painter& painter, const InkMark& mark, const Ruler& ruler) {
  const double unit = painter.sizes.unit;
  const Vec2d from = painter.pixels(ruler.from), to = painter.pixels(ruler.to);
  const double extent = length(to - from);
  if (!(extent > 0)) return;
  const Vec2d along = (to - from) / extent, across(-along.y, along.x);
  const Stroke line = ink_stroke(painter, mark, 2), tick = ink_stroke(painter, mark, 1.2);
  painter.add_clipped({from, to, line});
  for (const Vec2d& end : {from, to}) painter.add_clipped({end - 9 * unit * across, end + 9 * unit * across, line});
  // Marks as fine as can be told apart, every fifth one longer.
  const double step = grid_step(painter.state.plan.camera), whole = length(ruler.to - ruler.from);
  constexpr int most = 500;
  for (int i = 1; i < most && i * step < whole; ++i) {
    const Vec2d at = from + painter.pixels(i * step) * along;
    painter.add_clipped({at, at + (i % 5 == 0 ? 8 : 4.5) * unit * across, tick});
  }
  const std::string words = reading_of(mark, painter.state.appearance.language);
  // On the side without marks, else on the other.
  const double half = width_of(words, painter.sizes.text) / 2;
  const double away = 6 * unit + std::abs(across.x) * half + std::abs(across.y) * 0.62 * painter.sizes.text;
  const Vec2d first = painter.seen_end(to, from), last = painter.seen_end(from, to);
  std::vector<Vec2d> places;
  for (const double side : {-away, away + 8 * unit})
    for (const double part : {0.5, 0.35, 0.65, 0.2, 0.8})
      places.push_back(first + part * (last - first) + side * across);
  add_reading(painter, places, words, line.colour);
}

void draw(Painter& painter, const InkMark& mark, const Protractor& tool) {
  const double unit = painter.sizes.unit;
  const Vec2d vertex = painter.pixels(tool.vertex), from = painter.pixels(tool.from), to = painter.pixels(tool.to);
  const Stroke arm = ink_stroke(painter, mark, 2), tick = ink_stroke(painter, mark, 1.2);
  if (length(from - vertex) > 0) painter.add_clipped({vertex, from, arm});
  if (to != from && length(to - vertex) > 0) painter.add_clipped({vertex, to, arm});
  painter.add(CircleItem{vertex, 3.5 * unit, arm.colour, std::nullopt});
  if (from == to || !(length(from - vertex) > 0) || !(length(to - vertex) > 0)) return;
  const double begin = std::atan2(from.y - vertex.y, from.x - vertex.x);
  double turn = std::atan2(to.y - vertex.y, to.x - vertex.x) - begin;
  turn -= 2 * pi * std::round(turn / (2 * pi));
  const double radius = std::clamp(0.7 * std::min(length(from - vertex), length(to - vertex)), 26 * unit, 80 * unit);
  painter.add(ArcItem{vertex, radius, std::min(begin, begin + turn), std::max(begin, begin + turn), tick});
  // A mark every ten degrees, from the first arm on.
  for (int degrees = 10; degrees * pi / 180 < std::abs(turn); degrees += 10) {
    const double angle = begin + std::copysign(degrees * pi / 180, turn);
    const Vec2d way(std::cos(angle), std::sin(angle));
    painter.add(LineItem{vertex + radius * way, vertex + (radius - (degrees % 30 == 0 ? 8 : 4.5) * unit) * way, tick});
  }
  const Vec2d middle(std::cos(begin + turn / 2), std::sin(begin + turn / 2));
  const std::string words = reading_of(mark, painter.state.appearance.language);
  const double half = width_of(words, painter.sizes.text) / 2;
  const double away = radius + 6 * unit + std::abs(middle.x) * half + std::abs(middle.y) * 0.62 * painter.sizes.text;
  std::vector<Vec2d> places;
  for (const double farther : {0.0, 20.0, 40.0, 70.0}) places.push_back(vertex + (away + farther * unit) * middle);
  add_reading(painter, places, words, arm.colour);
}

}  // namespace

Colour ink_colour(InkColour colour, Theme theme) {
  const bool light = theme == Theme::projector;
  switch (colour) {
    case InkColour::plain:
      return palette(theme).text;
    case InkColour::red:
      return light ? Colour{190, 30, 45} : Colour{255, 99, 88};
    case InkColour::blue:
      return light ? Colour{0, 92, 190} : Colour{96, 170, 255};
    case InkColour::green:
      return light ? Colour{0, 118, 70} : Colour{70, 205, 130};
    case InkColour::yellow:
      return light ? Colour{150, 98, 0} : Colour{250, 205, 60};
  }
  return palette(theme).text;
}

std::string_view text(InkColour colour, Language language) {
  switch (colour) {
    case InkColour::plain:
      return text("ink.plain", language);
    case InkColour::red:
      return text("ink.red", language);
    case InkColour::blue:
      return text("ink.blue", language);
    case InkColour::green:
      return text("ink.green", language);
    case InkColour::yellow:
      return text("ink.yellow", language);
  }
  return {};
}

std::string reading_of(const InkMark& mark, Language language) {
  return std::visit(Overloaded{
                        [](const InkText& note) { return note.text; },
                        [&](const Ruler& ruler) { return number_text(length(ruler.to - ruler.from), language); },
                        [&](const Protractor& tool) {
                          const Vec2d a = tool.from - tool.vertex, b = tool.to - tool.vertex;
                          const double angle = std::abs(std::atan2(a.x * b.y - a.y * b.x, dot(a, b)));
                          return number_text(angle * 180 / pi, language) + "\u00b0";
                        },
                        [](const auto&) { return std::string(); },
                    },
                    mark.shape);
}

void draw_mark(Painter& painter, const InkMark& mark) {
  std::visit([&](const auto& shape) { draw(painter, mark, shape); }, mark.shape);
}

int mark_at(const State& state, const Vec2d& pixels) {
  const Ink& ink = state.document.contents.ink;
  const double reach = (state.appearance.touch ? 2 : 1) * Sizes(state).reach;
  for (std::size_t i = ink.size(); i-- > 0;) {
    Painter alone(state, state.plan.viewport);
    draw_mark(alone, ink[i]);
    if (std::any_of(alone.list.begin(), alone.list.end(),
                    [&](const DisplayItem& item) { return distance_to(item, pixels) <= reach; }))
      return static_cast<int>(i);
  }
  return -1;
}

void InkRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  for (const InkMark& mark : state.document.contents.ink) draw_mark(painter, mark);
  if (!inks(state)) return;
  // What is being written stands in a field of the window.
  if (state.ink.begun && text_begun(state) == nullptr) draw_mark(painter, state.ink.begun->mark);
  if (!state.plan.pointer) return;
  const Colour colour = ink_colour(state.ink.colour, state.appearance.theme);
  const Stroke ring{colour, 1.4 * painter.sizes.unit};
  if (state.ink.tool == InkTool::eraser) {
    painter.add(CircleItem{*state.plan.pointer, painter.sizes.reach, std::nullopt, ring});
  } else if (state.ink.tool != InkTool::pen && state.ink.tool != InkTool::text) {
    const Snapped place = snapped(state, state.ink.begun ? &*state.ink.begun : nullptr,
                                  to_scene(state.plan.camera, painter.viewport, *state.plan.pointer), {});
    if (place.onto) painter.add(CircleItem{painter.pixels(place.at), 7 * painter.sizes.unit, std::nullopt, ring});
  }
}

}  // namespace raywalk
