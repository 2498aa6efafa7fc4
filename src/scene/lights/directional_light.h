#pragma once

#include "math/vec.h"

#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

/// Light from infinitely far away; not attenuated.
struct DirectionalLight {
  Vec3d direction{0.0, 0.0, 1.0};  ///< from the surface to the light; any length but 0
  friend bool operator==(const DirectionalLight&, const DirectionalLight&) = default;

  static constexpr std::string_view name = "directional";
  [[nodiscard]] std::optional<Vec3d> middle() const { return std::nullopt; }
  [[nodiscard]] std::optional<Vec3d> axis() const { return -direction; }
  [[nodiscard]] bool is_delta() const { return true; }
  [[nodiscard]] double reach() const { return 0; }
  [[nodiscard]] std::vector<Vec3d> outline() const { return {}; }
  void move_by(const Vec3d& /*offset*/) {}

  template <class T>
  struct Prepared {
    static constexpr bool isotropic = true;
    explicit Prepared(const DirectionalLight& /*light*/) {}
  };
};

}  // namespace raywalk
