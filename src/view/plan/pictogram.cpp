#include "view/plan/pictogram.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

/// Places within the square: 0, 0 is its middle, 1 its edge.
class Sketch {
 public:
  Sketch(Theme theme, double edge) : theme_(theme), colours_(palette(theme)), half_(edge / 2) {}
  [[nodiscard]] DisplayList take() { return std::move(list_); }

  void sphere(bool transparent) {
    const Stroke outline{colours_.ink, width()};
    if (transparent) {
      list_.push_back({CircleItem{at(0, 0), 0.7 * half_, colours_.ink.with_alpha(24), outline}});
      const Stroke ray{ray_style(theme_, RayKind::refract).colour, 1.2 * width()};
      list_.push_back({PolylineItem{{at(-1, -0.55), at(-0.58, -0.39), at(0.62, -0.33), at(1, -0.6)}, ray}});
    } else {
      list_.push_back({CircleItem{at(0, 0), 0.7 * half_, colours_.ink.with_alpha(110), outline}});
    }
    dot(at(0.7, 0));
  }
  void polygon() {
    const std::vector<Vec2d> corners{at(-0.7, 0.6), at(-0.5, -0.25), at(0.35, -0.35), at(0.7, 0.6)};
    list_.push_back({LineItem{at(0, 0.2), at(0, -0.8), {colours_.handle.with_alpha(120), width(), {{2, 3}, 2}}}});
    list_.push_back({PolygonItem{corners, colours_.ink.with_alpha(110), Stroke{colours_.ink, width()}}});
    for (const Vec2d& corner : corners) dot(corner);
    dot(at(0, -0.8));
  }
  void light() {
    list_.push_back({CircleItem{at(0, 0), 0.3 * half_, colours_.light, std::nullopt}});
    constexpr int beams = 8;
    for (int i = 0; i < beams; ++i) {
      const double angle = 2 * std::numbers::pi * i / beams;
      const Vec2d out(std::cos(angle), std::sin(angle));
      list_.push_back(
          {LineItem{at(0.45 * out.x, 0.45 * out.y), at(0.8 * out.x, 0.8 * out.y), {colours_.light, 1.4 * width()}}});
    }
  }

 private:
  [[nodiscard]] Vec2d at(double x, double y) const { return {half_ * (1 + x), half_ * (1 + y)}; }
  [[nodiscard]] double width() const { return half_ / 16; }
  void dot(const Vec2d& place) {
    list_.push_back({CircleItem{place, 0.13 * half_, colours_.plan, Stroke{colours_.handle, width()}}});
  }

  Theme theme_;
  const Palette& colours_;
  double half_;
  DisplayList list_;
};

}  // namespace

DisplayList pictogram(action::ObjectKind kind, Theme theme, double edge) {
  Sketch sketch(theme, edge);
  switch (kind) {
    case action::ObjectKind::solid_sphere:
      sketch.sphere(false);
      break;
    case action::ObjectKind::transparent_sphere:
      sketch.sphere(true);
      break;
    case action::ObjectKind::polygon:
      sketch.polygon();
      break;
    case action::ObjectKind::light:
      sketch.light();
      break;
  }
  return sketch.take();
}

}  // namespace raywalk
