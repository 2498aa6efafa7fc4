#include "gui/painter.h"

#include "gui/ui.h"
#include "gui/widgets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raywalk {

namespace {

constexpr double pi = 3.14159265358979323846;

class ListPainter {
 public:
  ListPainter(ImDrawList& draw, ImVec2 origin, float scale, const Fonts* fonts)
      : draw_(draw), origin_(origin), scale_(scale), fonts_(fonts) {}

  void operator()(const LineItem& line) {
    for (const auto& [from, to] : dashes(line))
      draw_.AddLine(at(from), at(to), colour(line.stroke), width(line.stroke));
    if (const auto head = arrowhead(line))
      fill_triangle(draw_, at((*head)[0]), at((*head)[1]), at((*head)[2]), colour(line.stroke));
  }

  void operator()(const PolylineItem& item) {
    if (item.stroke.dash.count == 0) {
      set_points(item.points);
      draw_.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour(item.stroke), 0, width(item.stroke));
      return;
    }
    // Dashes continue across corners.
    Stroke stroke = item.stroke;
    for (std::size_t i = 0; i + 1 < item.points.size(); ++i) {
      (*this)(LineItem{item.points[i], item.points[i + 1], stroke});
      stroke.phase += length(item.points[i + 1] - item.points[i]);
    }
  }

  void operator()(const PolygonItem& item) {
    set_points(item.points);
    if (points_.size() < 3) return;
    if (item.fill) {
      const ImU32 fill = to_imgui(*item.fill);
      const auto triangles = triangulate(points_);
      // Triangles without anti-aliasing, which would show seams. The outline smooths the edge.
      const ImDrawListFlags flags = draw_.Flags;
      draw_.Flags &= ~ImDrawListFlags_AntiAliasedFill;
      for (const auto& [a, b, c] : triangles) draw_.AddTriangleFilled(point(a), point(b), point(c), fill);
      draw_.Flags = flags;
      if (!item.stroke) outline(fill, 1);
    }
    if (item.stroke && item.stroke->dash.count == 0) {
      outline(colour(*item.stroke), width(*item.stroke));
    } else if (item.stroke) {
      PolylineItem closed{item.points, *item.stroke};
      closed.points.push_back(item.points.front());
      (*this)(closed);
    }
  }

  void operator()(const CircleItem& item) {
    const auto radius = static_cast<float>(item.radius) * scale_;
    if (item.fill) draw_.AddCircleFilled(at(item.centre), radius, to_imgui(*item.fill));
    if (!item.stroke) return;
    if (item.stroke->dash.count == 0) {
      draw_.AddCircle(at(item.centre), radius, colour(*item.stroke), 0, width(*item.stroke));
    } else {
      (*this)(ArcItem{item.centre, item.radius, 0, 2 * pi, *item.stroke});
    }
  }

  void operator()(const ArcItem& item) {
    const double turn = item.end - item.begin;
    const int pieces = std::clamp(static_cast<int>(std::abs(turn) * std::sqrt(item.radius * scale_) * 2), 8, 512);
    PolylineItem line{{}, item.stroke};
    for (int i = 0; i <= pieces; ++i) {
      const double angle = item.begin + turn * i / pieces;
      line.points.push_back(item.centre + item.radius * Vec2d(std::cos(angle), std::sin(angle)));
    }
    (*this)(line);
  }

  void operator()(const TextItem& item) {
    if (fonts_ == nullptr) return;
    const auto [font, size] = lettering(*fonts_, static_cast<float>(item.size) * scale_);
    const char* end = item.text.data() + item.text.size();
    const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, item.text.data(), end);
    ImVec2 place = at(item.at);
    place.y -= extent.y / 2;
    switch (item.anchor) {
      case TextAnchor::start:
        break;
      case TextAnchor::middle:
        place.x -= extent.x / 2;
        break;
      case TextAnchor::end:
        place.x -= extent.x;
        break;
    }
    const ImVec2 upright{std::round(place.x), std::round(place.y)};
    const auto letters = [&](ImVec2 by, Colour with) {
      draw_.AddText(font, size, {upright.x + by.x, upright.y + by.y}, to_imgui(with), item.text.data(), end);
    };
    if (item.halo) {
      // Copies all around, near and far enough that there is no gap between them.
      const double thick = std::max(0.12 * static_cast<double>(size), 1.0);
      for (const double far : {0.5, 1.0})
        for (int i = 0; i < 12; ++i) {
          const double turn = 2 * pi * i / 12;
          letters({static_cast<float>(far * thick * std::cos(turn)), static_cast<float>(far * thick * std::sin(turn))},
                  *item.halo);
        }
    }
    letters({0, 0}, item.colour);
  }

 private:
  [[nodiscard]] ImVec2 at(const Vec2d& p) const {
    return {origin_.x + static_cast<float>(p.x) * scale_, origin_.y + static_cast<float>(p.y) * scale_};
  }
  [[nodiscard]] ImVec2 point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] static ImU32 colour(const Stroke& stroke) { return to_imgui(stroke.colour); }
  [[nodiscard]] float width(const Stroke& stroke) const { return static_cast<float>(stroke.width) * scale_; }

  void set_points(const std::vector<Vec2d>& points) {
    points_.clear();
    for (const Vec2d& p : points) points_.push_back(at(p));
  }
  void outline(ImU32 with, float thickness) {
    draw_.AddPolyline(points_.data(), static_cast<int>(points_.size()), with, ImDrawFlags_Closed, thickness);
  }

  ImDrawList& draw_;
  ImVec2 origin_;
  float scale_;
  const Fonts* fonts_;
  std::vector<ImVec2> points_;
};

float turn(ImVec2 a, ImVec2 b, ImVec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

}  // namespace

void paint(ImDrawList& draw, const DisplayList& list, const Rect& pane, float scale, const Fonts& fonts) {
  draw.PushClipRect(corner(pane), opposite(pane), true);
  ListPainter painter(draw, corner(pane), scale, &fonts);
  for (const DisplayItem& item : list) std::visit(painter, item.shape);
  draw.PopClipRect();
}

void paint_line(ImDrawList& draw, const LineItem& line) { ListPainter(draw, {0, 0}, 1, nullptr)(line); }

FontChoice lettering(const Fonts& fonts, float size) {
  FontChoice best{fonts.text, 0};
  for (ImFont* font : {fonts.text, fonts.small, fonts.title}) {
    const float height = line_height(fonts, *font);
    if (std::abs(height - size) < std::abs(best.size - size)) best = {font, height};
  }
  constexpr float near = 0.12f;
  if (std::abs(best.size - size) > near * size) best.size = size;
  return best;
}

std::vector<std::array<int, 3>> triangulate(const std::vector<ImVec2>& corners) {
  const auto p = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
  std::vector<int> left(corners.size());
  std::iota(left.begin(), left.end(), 0);
  float area = 0;
  for (std::size_t i = 0; i < left.size(); ++i) area += turn({0, 0}, corners[i], corners[(i + 1) % corners.size()]);
  if (area < 0) std::reverse(left.begin(), left.end());

  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 3) {
    const std::size_t count = left.size();
    bool clipped = false;
    for (std::size_t i = 0; i < count && !clipped; ++i) {
      const int a = left[(i + count - 1) % count], b = left[i], c = left[(i + 1) % count];
      if (turn(p(a), p(b), p(c)) < 0) continue;  // not convex
      const bool ear = std::none_of(left.begin(), left.end(), [&](int other) {
        return other != a && other != b && other != c && turn(p(a), p(b), p(other)) > 0 &&
               turn(p(b), p(c), p(other)) > 0 && turn(p(c), p(a), p(other)) > 0;
      });
      if (!ear) continue;
      triangles.push_back({a, b, c});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      clipped = true;
    }
    if (!clipped) return triangles;
  }
  if (left.size() == 3) triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace raywalk
