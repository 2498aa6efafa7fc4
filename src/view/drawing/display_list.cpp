#include "view/drawing/display_list.h"

#include "math/overloaded.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

using Segment = std::array<Vec2d, 2>;

double period_of(const DashPattern& dash) {
  double period = 0;
  for (int i = 0; i < dash.count; ++i) period += dash.lengths[static_cast<std::size_t>(i)];
  return period;
}

double squared_distance_to_segment(const Vec2d& a, const Vec2d& b, const Vec2d& at) {
  const Vec2d along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(at - a, along) / squared, 0.0, 1.0) : 0.0;
  const Vec2d apart = a + t * along - at;
  return dot(apart, apart);
}

double distance_to_polyline(const std::vector<Vec2d>& points, bool closed, const Vec2d& at) {
  if (points.empty()) return std::numeric_limits<double>::infinity();
  const Vec2d apart = points.front() - at;
  double nearest = dot(apart, apart);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    nearest = std::min(nearest, squared_distance_to_segment(points[i], points[i + 1], at));
  if (closed) nearest = std::min(nearest, squared_distance_to_segment(points.back(), points.front(), at));
  return std::sqrt(nearest);
}

double distance_to_arc(const ArcItem& arc, const Vec2d& at) {
  const auto point = [&](double angle) { return arc.centre + arc.radius * Vec2d(std::cos(angle), std::sin(angle)); };
  const Vec2d offset = at - arc.centre;
  const double turn = 2 * std::numbers::pi;
  double from_begin = std::fmod(std::atan2(offset.y, offset.x) - arc.begin, turn);
  if (from_begin < 0) from_begin += turn;
  if (from_begin <= arc.end - arc.begin) return std::abs(length(offset) - arc.radius);
  return std::min(length(point(arc.begin) - at), length(point(arc.end) - at));
}

double distance_to_text(const TextItem& text, const Vec2d& at) {
  const double width = text_width(text.text, text.size);
  const double left = text.anchor == TextAnchor::start    ? text.at.x
                      : text.anchor == TextAnchor::middle ? text.at.x - width / 2
                                                          : text.at.x - width;
  const double dx = std::max({left - at.x, at.x - left - width, 0.0});
  const double dy = std::max(std::abs(at.y - text.at.y) - text.size / 2, 0.0);
  return std::hypot(dx, dy);
}

bool all_finite(double v) { return std::isfinite(v); }
bool all_finite(const Vec2d& v) { return all_finite(v.x) && all_finite(v.y); }
bool all_finite(const std::vector<Vec2d>& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec2d& p) { return all_finite(p); });
}
bool all_finite(const Stroke& s) { return all_finite(s.width) && all_finite(s.phase); }
bool all_finite(const std::optional<Stroke>& s) { return !s || all_finite(*s); }

}  // namespace

std::vector<Segment> dashes(const LineItem& line, int most) {
  const double size = length(line.to - line.from);
  const double period = period_of(line.stroke.dash);
  if (line.stroke.dash.count == 0 || !(period > 0) || !(size > 0) || size / period * line.stroke.dash.count > most)
    return {{line.from, line.to}};
  const Vec2d along = (line.to - line.from) / size;
  // Where in the pattern the line starts.
  double phase = std::fmod(line.stroke.phase, period);
  if (phase < 0) phase += period;
  int part = 0;
  const auto part_length = [&] { return line.stroke.dash.lengths[static_cast<std::size_t>(part)]; };
  while (phase >= part_length()) {
    phase -= part_length();
    part = (part + 1) % line.stroke.dash.count;
  }
  std::vector<Segment> pieces;
  for (double begin = 0; begin < size;) {
    const double end = std::min(begin + part_length() - phase, size);
    if (part % 2 == 0 && end > begin) pieces.push_back({line.from + begin * along, line.from + end * along});
    begin = end;
    phase = 0;
    part = (part + 1) % line.stroke.dash.count;
  }
  return pieces;
}

std::optional<std::array<Vec2d, 3>> arrowhead(const LineItem& line) {
  const double size = length(line.to - line.from);
  if (!(line.arrow > 0) || !(size > 0)) return std::nullopt;
  const Vec2d along = (line.to - line.from) / size;
  const Vec2d across(-along.y, along.x);
  const Vec2d tip = line.from + line.arrow_at * (line.to - line.from);
  const Vec2d back = tip - line.arrow * along;
  return std::array{tip, back + 0.42 * line.arrow * across, back - 0.42 * line.arrow * across};
}

double text_width(std::string_view text, double size) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.5 * size * static_cast<double>(letters);
}

bool inside(const std::vector<Vec2d>& polygon, const Vec2d& at) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2d &a = polygon[i], &b = polygon[j];
    if ((a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x) odd = !odd;
    const auto [left, right] = std::minmax(a.x, b.x);
    const auto [low, high] = std::minmax(a.y, b.y);
    if (at.x >= left && at.x <= right && at.y >= low && at.y <= high && squared_distance_to_segment(a, b, at) == 0)
      return true;
  }
  return odd;
}

bool covers(const DisplayItem& item, const Vec2d& at) {
  const auto* polygon = std::get_if<PolygonItem>(&item.shape);
  return polygon != nullptr && polygon->fill ? inside(polygon->points, at) : distance_to(item, at) == 0;
}

double distance_to(const DisplayItem& item, const Vec2d& at) {
  return std::visit(
      Overloaded{
          [&](const LineItem& line) { return std::sqrt(squared_distance_to_segment(line.from, line.to, at)); },
          [&](const PolylineItem& polyline) { return distance_to_polyline(polyline.points, false, at); },
          [&](const PolygonItem& polygon) {
            const bool within = polygon.fill && inside(polygon.points, at);
            return within ? 0.0 : distance_to_polyline(polygon.points, true, at);
          },
          [&](const CircleItem& circle) {
            const double from_rim = length(at - circle.centre) - circle.radius;
            return circle.fill ? std::max(from_rim, 0.0) : std::abs(from_rim);
          },
          [&](const ArcItem& arc) { return distance_to_arc(arc, at); },
          [&](const TextItem& text) { return distance_to_text(text, at); },
      },
      item.shape);
}

bool is_finite(const DisplayList& list) {
  return std::all_of(list.begin(), list.end(), [](const DisplayItem& item) {
    return std::visit(
        Overloaded{
            [](const LineItem& i) {
              return all_finite(i.from) && all_finite(i.to) && all_finite(i.stroke) && all_finite(i.arrow) &&
                     all_finite(i.arrow_at);
            },
            [](const PolylineItem& i) { return all_finite(i.points) && all_finite(i.stroke); },
            [](const PolygonItem& i) { return all_finite(i.points) && all_finite(i.stroke); },
            [](const CircleItem& i) { return all_finite(i.centre) && all_finite(i.radius) && all_finite(i.stroke); },
            [](const ArcItem& i) {
              return all_finite(i.centre) && all_finite(i.radius) && all_finite(i.begin) && all_finite(i.end) &&
                     all_finite(i.stroke);
            },
            [](const TextItem& i) { return all_finite(i.at) && all_finite(i.size); },
        },
        item.shape);
  });
}

}  // namespace raywalk
