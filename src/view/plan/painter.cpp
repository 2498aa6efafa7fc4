#include "view/plan/painter.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

double PixelRect::overlap(const PixelRect& other) const {
  const double width = std::min(max.x, other.max.x) - std::max(min.x, other.min.x);
  const double height = std::min(max.y, other.max.y) - std::max(min.y, other.min.y);
  return width > 0 && height > 0 ? width * height : 0;
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

std::optional<std::array<double, 2>> Painter::seen_stretch(const Vec2d& from, const Vec2d& to) const {
  const double margin = 20 * sizes.unit;
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
  const auto seen = seen_stretch(line.from, line.to);
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
  const auto seen = seen_stretch(from, to);
  return seen ? from + (*seen)[1] * (to - from) : to;
}

namespace {

/// Half the size of a note's background.
Vec2d half_of_note(const std::string& text, double size) {
  return {text_width(text, size) / 2 + 0.2 * size, 0.6 * size};
}

}  // namespace

void Painter::note(const std::vector<Vec2d>& places, const std::string& text) {
  const Vec2d half = half_of_note(text, sizes.text);
  const double area = 4 * half.x * half.y;
  const auto is_free = [&](const Vec2d& at) {
    const PixelRect box{at - half, at + half};
    return box.overlap(pane()) > 0.999 * area &&
           std::none_of(kept_free.begin(), kept_free.end(),
                        [&](const PixelRect& taken) { return box.overlap(taken) > 0; });
  };
  const auto free = std::find_if(places.begin(), places.end(), is_free);
  note(free == places.end() ? places.front() : *free, text);
}

void Painter::note(const Vec2d& at, const std::string& text) {
  const double size = sizes.text;
  const Vec2d half = half_of_note(text, size);
  add(PolygonItem{{at - half, {at.x + half.x, at.y - half.y}, at + half, {at.x - half.x, at.y + half.y}},
                  colours.plan.with_alpha(165),
                  std::nullopt});
  add(TextItem{at, text, size, colours.text, TextAnchor::middle});
  kept_free.push_back({at - half, at + half});
}

Vec2d Painter::seen_middle(Vec2d from, Vec2d to) const {
  const auto inside = [&](const Vec2d& p) {
    return Vec2d(std::clamp(p.x, 0.0, viewport.width), std::clamp(p.y, 0.0, viewport.height));
  };
  return (inside(from) + inside(to)) / 2.0;
}

}  // namespace raywalk
