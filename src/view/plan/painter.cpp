#include "view/plan/painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raywalk {

double PixelRect::overlap(const PixelRect& other) const {
  const double width = std::min(max.x, other.max.x) - std::max(min.x, other.min.x);
  const double height = std::min(max.y, other.max.y) - std::max(min.y, other.min.y);
  return width > 0 && height > 0 ? width * height : 0;
}

double width_of(const std::string& text, double size) {
  const auto letter = [](char c) {
    switch (c) {
      case 'i':
      case 'j':
      case 'l':
      case ' ':
      case '.':
        return 0.24;
      case 'f':
      case 'r':
      case 't':
      case 'I':
        return 0.34;
      case 'm':
      case 'w':
      case 'M':
      case 'W':
        return 0.76;
      default:
        return c >= 'A' && c <= 'Z' ? 0.58 : 0.5;
    }
  };
  double width = 0;
  for (const char c : text)
    if ((c & 0xC0) != 0x80) width += letter(c) * size;
  return std::min(width, text_width(text, size));
}

bool cross_each_other(const std::array<Vec2d, 2>& a, const std::array<Vec2d, 2>& b) {
  const auto sides = [](const std::array<Vec2d, 2>& line, const std::array<Vec2d, 2>& of) {
    const Vec2d along = line[1] - line[0];
    return cross(along, of[0] - line[0]) * cross(along, of[1] - line[0]) < 0;
  };
  return sides(a, b) && sides(b, a);
}

bool PixelRect::meets(const Vec2d& from, const Vec2d& to) const {
  // Liang and Barsky, as below.
  double begin = 0, end = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double along = to[axis] - from[axis];
    if (along == 0) {
      if (from[axis] < min[axis] || from[axis] > max[axis]) return false;
      continue;
    }
    const double a = (min[axis] - from[axis]) / along, b = (max[axis] - from[axis]) / along;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end;
}

DashPattern Painter::scaled(DashPattern dash) const {
  for (double& part : dash.lengths) part *= sizes.unit;
  return dash;
}

Stroke Painter::outline(const Target& target, Colour colour, double width) const {
  const bool selected = state.walk.mode == Mode::move && state.plan.selected.kind == target.kind &&
                        state.plan.selected.index == target.index;
  const bool hovered = state.plan.hovered.kind == target.kind && state.plan.hovered.index == target.index;
  if (selected) return stroke(colours.selected, std::max(width, 2.0));
  if (hovered) return stroke(colours.hovered, std::max(width, 1.6));
  return stroke(colour, width);
}

namespace {

constexpr double around_viewport = 20;  // of a line's own width, and more, in units

}  // namespace

std::optional<std::array<double, 2>> Painter::seen_stretch(const Vec2d& from, const Vec2d& to, double margin) const {
  const Vec2d low(-margin), high = Vec2d(viewport.width, viewport.height) + margin;
  const Vec2d along = to - from;
  // Y.-D. Liang and B. Barsky, "A new concept and method for line clipping", ACM TOG 3(1), 1984.
  double begin = 0, end = 1;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0) {
      if (from[axis] < low[axis] || from[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double a = (low[axis] - from[axis]) / along[axis], b = (high[axis] - from[axis]) / along[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (!(begin < end)) return std::nullopt;
  return std::array{begin, end};
}

void Painter::add_clipped(LineItem line, const Target& target) {
  const auto seen = seen_stretch(line.from, line.to, around_viewport * sizes.unit);
  if (!seen) return;
  const auto [begin, end] = *seen;
  const Vec2d along = line.to - line.from;
  LineItem clipped = line;
  clipped.from = line.from + begin * along;
  clipped.to = line.from + end * along;
  clipped.stroke.phase += begin * length(along);
  add(clipped, target);
}

Vec2d Painter::seen_end(const Vec2d& from, const Vec2d& to) const {
  const auto seen = seen_stretch(from, to, around_viewport * sizes.unit);
  return seen ? from + (*seen)[1] * (to - from) : to;
}

namespace {

/// Half the size of a note's background.
Vec2d half_of_note(const std::string& text, double size) { return {width_of(text, size) / 2 + 0.2 * size, 0.6 * size}; }

/// Whether the outline of a filled drawing runs through a box.
bool runs_through(const Shape2d& shape, const PixelRect& box) {
  if (const auto* circle = std::get_if<CircleItem>(&shape); circle != nullptr && circle->fill) {
    const Vec2d low = box.min - circle->centre, high = box.max - circle->centre;
    const Vec2d nearest(std::max({low.x, -high.x, 0.0}), std::max({low.y, -high.y, 0.0}));
    const Vec2d farthest(std::max(-low.x, high.x), std::max(-low.y, high.y));
    return length(nearest) < circle->radius && length(farthest) > circle->radius;
  }
  const auto* polygon = std::get_if<PolygonItem>(&shape);
  if (polygon == nullptr || !polygon->fill || polygon->points.empty()) return false;
  Vec2d before = polygon->points.back();
  for (const Vec2d& corner : polygon->points) {
    if (box.meets(before, corner)) return true;
    before = corner;
  }
  return false;
}

}  // namespace

bool Painter::covers_kept(const PixelRect& box) const {
  return std::any_of(kept_free.begin(), kept_free.end(),
                     [&](const PixelRect& taken) { return box.overlap(taken) > 0; });
}

bool Painter::note(const std::vector<Vec2d>& places, const std::string& text) {
  return note(places, text, [](const Vec2d& /*place*/) { return 0.0; });
}

bool Painter::note_off_bodies(const std::vector<Vec2d>& places, const std::string& text) {
  return note(places, text, [](const Vec2d& /*place*/) { return 0.0; }, true);
}

bool Painter::note(const std::vector<Vec2d>& places, const std::string& text,
                   const std::function<double(const Vec2d&)>& more, bool off_bodies) {
  const Vec2d half = half_of_note(text, sizes.text);
  const double area = 4 * half.x * half.y;
  const auto is_free = [&](const PixelRect& box) {
    return box.overlap(pane()) > 0.999 * area && !covers_kept(box) &&
           std::none_of(leaders.begin(), leaders.end(), [&](const auto& line) { return box.meets(line[0], line[1]); });
  };
  std::optional<Vec2d> best;
  constexpr double of_ray = 6, of_outline = 6;  // the background of a text would bite a piece out of a body
  double least = 0;
  for (const Vec2d& place : places) {
    const PixelRect box{place - half, place + half};
    if (!is_free(box)) continue;
    const auto rays =
        std::count_if(prominent.begin(), prominent.end(), [&](const auto& ray) { return box.meets(ray[0], ray[1]); });
    double cost = of_ray * static_cast<double>(rays) + more(place);
    if (!std::isfinite(cost) || (best && cost >= least)) continue;
    if (std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
          return item.target.kind == TargetKind::object && runs_through(item.shape, box);
        })) {
      if (off_bodies) continue;
      cost += of_outline;
    }
    if (best && cost >= least) continue;
    best = place;
    least = cost;
    if (least == 0) break;
  }
  if (best) note(*best, text);
  return best.has_value();
}

bool Painter::note_beside(const Vec2d& of, const Vec2d& away, const std::string& text,
                          const std::optional<PixelRect>& around) {
  return note_near(of, away, text, {}, around);
}

bool Painter::note_along(const Vec2d& from, const Vec2d& to, const std::string& text, bool above) {
  const Vec2d first = seen_end(to, from), last = seen_end(from, to), way = last - first;
  const double size = length(way);
  if (!(size > 0)) return false;
  Vec2d across = Vec2d(-way.y, way.x) / size;
  if ((across.y < 0) != above) across = -across;
  const Vec2d half = half_of_note(text, sizes.text);
  const double clear = half.x * std::abs(across.x) + half.y * std::abs(across.y) + 4 * sizes.unit;
  std::vector<Vec2d> places;
  for (const double side : {clear, -clear})
    for (const double part : {0.5, 0.35, 0.65, 0.2, 0.8}) places.push_back(first + part * way + side * across);
  return note_near((first + last) / 2.0, across, text, places, {});
}

double Painter::inside_bodies(const Vec2d& from, const Vec2d& to) const {
  const double size = length(to - from), step = 4 * sizes.unit;
  double inside = 0;
  // Not at its end, which may be on one.
  for (double at = 2 * step; at < size; at += step) {
    const Vec2d place = to + at / size * (from - to);
    if (std::any_of(list.begin(), list.end(), [&](const DisplayItem& item) {
          return item.target.kind == TargetKind::object && covers(item, place);
        }))
      inside += step;
  }
  return inside;
}

bool Painter::note_near(const Vec2d& of, const Vec2d& away, const std::string& text, const std::vector<Vec2d>& first,
                        const std::optional<PixelRect>& around) {
  const Vec2d half = half_of_note(text, sizes.text), across(-away.y, away.x);
  std::vector<Vec2d> places = first;
  for (const double gap : {6.0, 22.0, 44.0, 70.0, 110.0, 150.0})
    for (const double turn : {0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0}) {
      const Vec2d way = std::cos(turn * std::numbers::pi) * away + std::sin(turn * std::numbers::pi) * across;
      // As far as the box reaches in this direction.
      const double reach = std::min(half.x / std::max(std::abs(way.x), 1e-9), half.y / std::max(std::abs(way.y), 1e-9));
      places.push_back(of + (reach + gap * sizes.unit) * way);
    }
  // From a place to the point, unless they are beside each other.
  const auto leader = [&](const Vec2d& at) -> std::optional<Vec2d> {
    const Vec2d edge(std::clamp(of.x, at.x - half.x, at.x + half.x), std::clamp(of.y, at.y - half.y, at.y + half.y));
    const bool is_first = std::find(first.begin(), first.end(), at) != first.end();
    return is_first || length(edge - of) < 14 * sizes.unit ? std::nullopt : std::optional(edge);
  };
  const std::size_t before = list.size();
  const bool is_there = note(places, text, [&](const Vec2d& at) {
    if (std::find(first.begin(), first.end(), at) != first.end()) return 0.0;
    const std::optional<Vec2d> edge = leader(at);
    const double turned = 1 - dot(at - of, away) / std::max(length(at - of), 1e-9);  // 0: not at all
    if (!edge) return turned;
    const bool from_its_side = dot(*edge - of, away) >= -1e-9;
    const bool runs_over = std::any_of(kept_free.begin(), kept_free.end(), [&](const PixelRect& taken) {
      return !(from_its_side && around == taken) && taken.meets(*edge, of);
    });
    const bool crosses = std::any_of(leaders.begin(), leaders.end(),
                                     [&](const auto& other) { return cross_each_other({*edge, of}, other); });
    if (runs_over || crosses) return std::numeric_limits<double>::infinity();
    // What it is of may lie on a ray itself.
    const double size = length(*edge - of);
    const std::array line{*edge, of + std::min(3 * sizes.unit / size, 1.0) * (*edge - of)};
    const auto rays =
        std::count_if(prominent.begin(), prominent.end(), [&](const auto& ray) { return cross_each_other(line, ray); });
    constexpr double of_crossing = 3, of_body = 0.05;  // of a unit of the line inside one
    return turned + of_crossing * static_cast<double>(rays) +
           (size / 60 + of_body * inside_bodies(*edge, of)) / sizes.unit;
  });
  if (!is_there) return false;
  if (const std::optional<Vec2d> edge = leader(std::get<TextItem>(list.back().shape).at)) {
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(before),
                {LineItem{*edge, of, stroke(colours.text.with_alpha(190), 0.7)}});
    leaders.push_back({*edge, of});
  }
  return true;
}

double Painter::room_along(const Vec2d& from, const Vec2d& along) const {
  const PixelRect all = pane();
  double room = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    if (from[axis] <= all.min[axis] || from[axis] >= all.max[axis]) return 0;
    if (along[axis] == 0) continue;
    room = std::min(room, ((along[axis] > 0 ? all.max[axis] : all.min[axis]) - from[axis]) / along[axis]);
  }
  if (!frame.empty() && !inside(frame, from)) return 0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2d begin = frame[i] - from, side = frame[(i + 1) % frame.size()] - frame[i];
    const double slant = cross(along, side);
    if (slant == 0) continue;
    const double far = cross(begin, side) / slant, part = cross(begin, along) / slant;
    if (far >= 0 && part >= 0 && part <= 1) room = std::min(room, far);
  }
  return room;
}

void Painter::note(const Vec2d& at, const std::string& text) {
  const double size = sizes.text;
  const Vec2d half = half_of_note(text, size);
  add(TextItem{at, text, size, colours.text, TextAnchor::middle, halo()});
  // Another text just above or below it would be read as its next line.
  const Vec2d clear = half + Vec2d(0, 0.3 * size);
  kept_free.push_back({at - clear, at + clear});
}

Vec2d Painter::seen_middle(Vec2d from, Vec2d to) const {
  if (const auto seen = seen_stretch(from, to, 0)) return from + ((*seen)[0] + (*seen)[1]) / 2 * (to - from);
  const auto inside = [&](const Vec2d& p) {
    return Vec2d(std::clamp(p.x, 0.0, viewport.width), std::clamp(p.y, 0.0, viewport.height));
  };
  return (inside(from) + inside(to)) / 2.0;
}

}  // namespace raywalk
