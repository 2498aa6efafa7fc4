#include "trace/beam_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace raywalk {

namespace {

/// As much of a sum of products may be rounding.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
/// Nothing is cut off that is thinner, in units of the window.
constexpr double thinnest = 1e-10;

}  // namespace

WindowSides sides_of(const WindowPiece& piece, const WindowLine& line) {
  WindowSides sides;
  for (const Vec2d& corner : piece) {
    const double value = line.at(corner);
    sides.inside = sides.inside || value > line.slack;
    sides.outside = sides.outside || value < -line.slack;
  }
  return sides;
}

WindowHalves halves_of(const WindowPiece& piece, const WindowLine& line) {
  const WindowSides sides = sides_of(piece, line);
  if (!sides.inside) return {{}, piece};
  if (!sides.outside) return {piece, {}};
  WindowHalves halves;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec2d &from = piece[i], &to = piece[i + 1 == piece.size() ? 0 : i + 1];
    const double here = line.at(from), there = line.at(to);
    const bool starts_on = std::abs(here) <= line.slack, ends_on = std::abs(there) <= line.slack;
    if (here > 0 || starts_on) halves.inside.push_back(from);
    if (here < 0 || starts_on) halves.outside.push_back(from);
    if (starts_on || ends_on || (here > 0) == (there > 0)) continue;
    const Vec2d crossing = from + here / (here - there) * (to - from);
    halves.inside.push_back(crossing);
    halves.outside.push_back(crossing);
  }
  return halves;
}

double area_of(const WindowPiece& piece) {
  double twice = 0;
  for (std::size_t i = 2; i < piece.size(); ++i) twice += cross(piece[i - 1] - piece[0], piece[i] - piece[0]);
  return std::abs(twice) / 2;
}

Vec2d middle_of(const WindowPiece& piece) {
  Vec2d weighted(0.0), mean(0.0);
  double area = 0;
  for (std::size_t i = 2; i < piece.size(); ++i) {
    const Vec2d a = piece[i - 1] - piece[0], b = piece[i] - piece[0];
    area += cross(a, b);
    weighted += cross(a, b) * (a + b);
  }
  for (const Vec2d& corner : piece) mean += (corner - piece[0]) / static_cast<double>(piece.size());
  const Vec2d centroid = weighted / (3 * area);
  // Of what is thin, the mean of its corners, which lies inside whatever is rounded.
  const bool thin = !(std::abs(area) > thinnest * thinnest) || !std::isfinite(centroid.x + centroid.y);
  return piece[0] + (thin ? mean : centroid);
}

WindowLine BeamView::line(const Vec3d& vector, double scale) const {
  WindowLine line{dot(vector, right), dot(vector, down), dot(vector, corner)};
  const double reach = length(corner) + extent * (length(right) + length(down));
  line.slack = std::max(rounding * scale * reach, thinnest * std::sqrt(line.a * line.a + line.b * line.b));
  return line;
}

WindowLine BeamView::nearness(const BeamPlane& plane) const {
  const double height = -plane.above(eye), size = std::abs(height);
  const double terms = std::abs(dot(plane.normal, eye)) + std::abs(plane.offset);
  return line(plane.normal / height, length(plane.normal) / size * (1 + terms / size));
}

WindowLine BeamView::above(const BeamPlane& plane, const BeamPlane& on) const {
  const double eye_above = plane.above(eye), height = -on.above(eye);
  const double sign = height < 0 ? -1 : 1;
  return line(sign * (eye_above * on.normal + height * plane.normal),
              (std::abs(dot(plane.normal, eye)) + std::abs(plane.offset)) * length(on.normal) +
                  std::abs(height) * length(plane.normal));
}

BeamView BeamView::mirrored(const BeamPlane& mirror) const {
  const auto turned = [&](const Vec3d& v) { return v - 2 * dot(mirror.normal, v) * mirror.normal; };
  return {eye - 2 * mirror.above(eye) * mirror.normal, turned(corner), turned(right), turned(down), extent};
}

}  // namespace raywalk
