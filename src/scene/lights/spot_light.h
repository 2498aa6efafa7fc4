#pragma once

#include "math/elementary.h"
#include "math/sampling.h"
#include "scene/lights/attenuation.h"

#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

/// A point light that shines only into a cone: at full strength up to half of `inner_angle` from its axis, then falling
/// off (a smooth step in the cosine) to zero at half of `angle`.
struct SpotLight {
  Vec3d position{0.0};
  Vec3d look_at{1.0, 0.0, 0.0};  ///< a point on the cone's axis, other than `position`
  double angle = 60;             ///< full angle of the cone in degrees, 0 < angle <= 180
  double inner_angle = 40;       ///< full angle in degrees, 0 <= inner_angle <= angle
  Attenuation attenuation;
  friend bool operator==(const SpotLight&, const SpotLight&) = default;

  static constexpr std::string_view name = "spot";
  [[nodiscard]] std::optional<Vec3d> middle() const { return position; }
  [[nodiscard]] std::optional<Vec3d> axis() const { return look_at - position; }
  [[nodiscard]] bool is_delta() const { return true; }
  [[nodiscard]] double reach() const { return 0; }
  [[nodiscard]] std::vector<Vec3d> outline() const { return {}; }
  void move_by(const Vec3d& offset) {
    position += offset;
    look_at += offset;
  }

  template <class T>
  struct Prepared {
    static constexpr bool isotropic = false;
    Vec3<T> axis;  ///< unit length, along the beam
    T cos_inner, cos_outer;

    explicit Prepared(const SpotLight& light)
        : axis(normalize(light.look_at - light.position)),
          cos_inner(static_cast<T>(portable::cos(light.inner_angle / 2 * degree))),
          cos_outer(static_cast<T>(portable::cos(light.angle / 2 * degree))) {}
    [[nodiscard]] bool shines_along(const Vec3<T>& to_light) const {
      return -dot(to_light, axis) > cos_outer * length(to_light);
    }
    [[nodiscard]] T falloff(const Vec3<T>& to_light) const {
      return spot_falloff(-dot(to_light, axis), cos_inner, cos_outer);
    }
  };

 private:
  static constexpr double degree = std::numbers::pi / 180;
};

}  // namespace raywalk
