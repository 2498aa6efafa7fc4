#pragma once

#include "math/vec.h"
#include "scene/lights/attenuation.h"

#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

struct PointLight {
  Vec3d position{0.0};
  Attenuation attenuation;
  friend bool operator==(const PointLight&, const PointLight&) = default;

  static constexpr std::string_view name = "point";
  [[nodiscard]] std::optional<Vec3d> middle() const { return position; }
  [[nodiscard]] std::optional<Vec3d> axis() const { return std::nullopt; }
  [[nodiscard]] bool is_delta() const { return true; }
  [[nodiscard]] double reach() const { return 0; }
  [[nodiscard]] std::vector<Vec3d> outline() const { return {}; }
  void move_by(const Vec3d& offset) { position += offset; }

  template <class T>
  struct Prepared {
    static constexpr bool isotropic = true;
    explicit Prepared(const PointLight& /*light*/) {}
  };
};

}  // namespace raywalk
