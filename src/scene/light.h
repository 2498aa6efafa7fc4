#pragma once
// The lights of a scene. Each kind has a file in scene/lights: its numbers, and its answers to what everyone else asks
// (concept LightKind). A new kind needs its file, a place in the list below, and its keys in scene/schema_lights.h.

#include "scene/lights/directional_light.h"
#include "scene/lights/point_light.h"
#include "scene/lights/rectangle_light.h"
#include "scene/lights/sphere_light.h"
#include "scene/lights/spot_light.h"

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

using AnyLight = std::variant<PointLight, DirectionalLight, SpotLight, SphereLight, RectangleLight>;

/// What a kind of light answers. A light that is no delta light is the mean of point lights spread uniformly over it:
/// it is never hit and occludes nothing, and has a member `samples`: samples x samples of its points are tested at
/// every hit. A light that weakens with distance has a member `attenuation`.
///
/// `Kind::Prepared<T>` is what the tracer needs in scalar type T, every number rounded once: whether it is `isotropic`,
/// that is, shines everywhere with the same strength; `shines_along` and `falloff`, if not. If it can have an extent,
/// `sample`, which maps the unit square to the light, uniformly in area; `half_extent`, how far it reaches along a unit
/// direction from its centre; and `seen_radius`, of a disc of the area that is seen of it along a unit direction.
template <class Kind>
concept LightKind = requires(const Kind& light, Kind& own, const Vec3d& offset) {
  { Kind::name } -> std::convertible_to<std::string_view>;   // in scene files and to people
  { light.middle() } -> std::same_as<std::optional<Vec3d>>;  // its centre; none: it is infinitely far away
  { light.axis() } -> std::same_as<std::optional<Vec3d>>;    // along which it shines, of any length, if one
  { light.is_delta() } -> std::same_as<bool>;                // no extent: it casts no penumbras
  { light.reach() } -> std::same_as<double>;                 // radius of a bounding sphere about its centre
  { light.outline() } -> std::same_as<std::vector<Vec3d>>;   // its corners, as it is drawn; none: a ball
  { own.move_by(offset) };                                   // moves the whole light; a distant one stays
  { Kind::template Prepared<double>::isotropic } -> std::convertible_to<bool>;
  typename Kind::template Prepared<float>;
};

struct Light {
  std::string name;
  Rgbd strength{1.0};
  AnyLight kind;
  friend bool operator==(const Light&, const Light&) = default;
};

template <LightKind Kind>
constexpr std::string_view light_name(const Kind& /*light*/) {
  return Kind::name;
}

[[nodiscard]] inline std::optional<Vec3d> middle_of(const Light& light) {
  return std::visit([](const auto& kind) { return kind.middle(); }, light.kind);
}
[[nodiscard]] inline std::optional<Vec3d> axis_of(const Light& light) {
  return std::visit([](const auto& kind) { return kind.axis(); }, light.kind);
}
[[nodiscard]] inline double reach_of(const Light& light) {
  return std::visit([](const auto& kind) { return kind.reach(); }, light.kind);
}
[[nodiscard]] inline std::vector<Vec3d> outline_of(const Light& light) {
  return std::visit([](const auto& kind) { return kind.outline(); }, light.kind);
}
inline void move_by(Light& light, const Vec3d& offset) {
  std::visit([&](auto& kind) { kind.move_by(offset); }, light.kind);
}
/// Whether the light has an extent, and so casts penumbras.
[[nodiscard]] inline bool is_area(const Light& light) {
  return std::visit([](const auto& kind) { return !kind.is_delta(); }, light.kind);
}
/// All 1 for lights that do not weaken.
[[nodiscard]] inline Attenuation attenuation_of(const Light& light) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.attenuation; }) return kind.attenuation;
        return Attenuation{};
      },
      light.kind);
}
/// The member `samples`; 1 where there is none.
[[nodiscard]] inline int samples_of(const Light& light) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.samples; }) return kind.samples;
        return 1;
      },
      light.kind);
}

}  // namespace raywalk
