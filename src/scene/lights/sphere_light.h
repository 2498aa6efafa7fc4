#pragma once

#include "math/sampling.h"
#include "scene/lights/attenuation.h"

#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

/// An area light in the form of a sphere.
struct SphereLight {
  Vec3d position{0.0};  ///< its centre
  double radius = 1;    ///< >= 0; 0 is a point light
  int samples = 1;      ///< >= 1
  Attenuation attenuation;
  friend bool operator==(const SphereLight&, const SphereLight&) = default;

  static constexpr std::string_view name = "sphere";
  [[nodiscard]] std::optional<Vec3d> middle() const { return position; }
  [[nodiscard]] std::optional<Vec3d> axis() const { return std::nullopt; }
  [[nodiscard]] bool is_delta() const { return !(radius > 0); }
  [[nodiscard]] double reach() const { return radius; }
  [[nodiscard]] std::vector<Vec3d> outline() const { return {}; }
  void move_by(const Vec3d& offset) { position += offset; }

  template <class T>
  struct Prepared {
    static constexpr bool isotropic = true;
    Vec3<T> centre;
    T radius;

    explicit Prepared(const SphereLight& light) : centre(light.position), radius(static_cast<T>(light.radius)) {}
    template <class S>
    [[nodiscard]] S half_extent(const Vec3<S>& /*direction*/) const {
      return static_cast<S>(radius);
    }
    [[nodiscard]] double seen_radius(const Vec3d& /*l*/) const { return static_cast<double>(radius); }
    [[nodiscard]] Vec3<T> sample(const Vec2<T>& unit) const { return centre + radius * sample_uniform_sphere(unit); }
    [[nodiscard]] Vec3<T> regular(int point, int grid) const {
      return centre + radius * regular_on_sphere<T>(point, grid);
    }
  };
};

}  // namespace raywalk
