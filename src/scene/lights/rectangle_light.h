#pragma once

#include "math/vec.h"
#include "scene/lights/attenuation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

/// An area light in the form of a parallelogram; it has no back.
struct RectangleLight {
  Vec3d corner{0.0};
  Vec3d u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};  ///< its edges from `corner`; both 0 is a point light
  int samples = 1;                           ///< >= 1
  Attenuation attenuation;
  friend bool operator==(const RectangleLight&, const RectangleLight&) = default;

  static constexpr std::string_view name = "rectangle";
  [[nodiscard]] std::optional<Vec3d> middle() const { return corner + 0.5 * u + 0.5 * v; }
  [[nodiscard]] std::optional<Vec3d> axis() const { return std::nullopt; }
  [[nodiscard]] bool is_delta() const { return u == Vec3d(0.0) && v == Vec3d(0.0); }
  [[nodiscard]] double reach() const { return std::max(length(u + v), length(u - v)) / 2; }
  [[nodiscard]] std::vector<Vec3d> outline() const { return {corner, corner + u, corner + u + v, corner + v}; }
  void move_by(const Vec3d& offset) { corner += offset; }

  template <class T>
  struct Prepared {
    static constexpr bool isotropic = true;
    Vec3<T> corner, u, v;

    explicit Prepared(const RectangleLight& light) : corner(light.corner), u(light.u), v(light.v) {}
    template <class S>
    [[nodiscard]] S half_extent(const Vec3<S>& direction) const {
      return (std::abs(dot(direction, Vec3<S>(u))) + std::abs(dot(direction, Vec3<S>(v)))) / 2;
    }
    [[nodiscard]] double seen_radius(const Vec3d& l) const {
      return std::sqrt(std::abs(dot(cross(Vec3d(u), Vec3d(v)), l)) / std::numbers::pi);
    }
    [[nodiscard]] Vec3<T> sample(const Vec2<T>& unit) const { return corner + unit.x * u + unit.y * v; }
  };
};

}  // namespace raywalk
