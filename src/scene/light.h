#pragma once

#include "math/vec.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace raywalk {

/// 1 / (constant + linear r + quadratic r^2), r the distance to the light in scene units. Terms are >= 0, not all 0.
struct Attenuation {
  double constant = 1, linear = 0, quadratic = 0;
  friend bool operator==(const Attenuation&, const Attenuation&) = default;
};

struct PointLight {
  Vec3d position{0.0};
  Attenuation attenuation;
  friend bool operator==(const PointLight&, const PointLight&) = default;
};

/// Light from infinitely far away; not attenuated.
struct DirectionalLight {
  Vec3d direction{0.0, 0.0, 1.0};  ///< from the surface to the light; any length but 0
  friend bool operator==(const DirectionalLight&, const DirectionalLight&) = default;
};

/// A point light that shines only into a cone: at full strength up to half of `inner_angle` from its axis, then falling
/// off (a smooth step in the cosine) to zero at half of `angle`.
struct SpotLight {
  Vec3d position{0.0};
  Vec3d look_at{1.0, 0.0, 0.0};  ///< a point on the cone's axis, other than `position`
  double angle = 60;             ///< full angle of the cone in degrees, 0 < angle <= 180
  double inner_angle = 40;       ///< full angle in degrees, 0 <= inner_angle <= angle
  Attenuation attenuation;
  friend bool operator==(const SpotLight&, const SpotLight&) = default;
};

/// Area lights. Each is the mean of point lights spread uniformly over it: it has no back, is never hit and occludes
/// nothing. At every hit, samples x samples of its points are tested.
struct SphereLight {
  Vec3d position{0.0};  ///< its centre
  double radius = 1;    ///< >= 0; 0 is a point light
  int samples = 1;      ///< >= 1
  Attenuation attenuation;
  friend bool operator==(const SphereLight&, const SphereLight&) = default;
};

struct RectangleLight {
  Vec3d corner{0.0};
  Vec3d u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};  ///< its edges from `corner`; both 0 is a point light
  int samples = 1;                           ///< >= 1
  Attenuation attenuation;
  friend bool operator==(const RectangleLight&, const RectangleLight&) = default;
};

struct Light {
  std::string name;
  Rgbd strength{1.0};
  std::variant<PointLight, DirectionalLight, SpotLight, SphereLight, RectangleLight> kind;
  friend bool operator==(const Light&, const Light&) = default;
};

/// What each kind is called, in scene files and to people.
constexpr std::string_view light_name(const PointLight& /*light*/) { return "point"; }
constexpr std::string_view light_name(const DirectionalLight& /*light*/) { return "directional"; }
constexpr std::string_view light_name(const SpotLight& /*light*/) { return "spot"; }
constexpr std::string_view light_name(const SphereLight& /*light*/) { return "sphere"; }
constexpr std::string_view light_name(const RectangleLight& /*light*/) { return "rectangle"; }

/// The centre of a light, or nothing for one at infinity.
[[nodiscard]] std::optional<Vec3d> middle_of(const Light& light);
/// Moves the whole light; a directional one stays.
void move_by(Light& light, const Vec3d& offset);
/// Whether the light has an extent, and so casts penumbras.
[[nodiscard]] bool is_area(const Light& light);

}  // namespace raywalk
