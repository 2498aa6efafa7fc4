#include "scene/light.h"

namespace raywalk {

namespace {

// One overload per kind: a kind without one does not compile.
std::optional<Vec3d> middle(const PointLight& light) { return light.position; }
std::optional<Vec3d> middle(const DirectionalLight& /*light*/) { return std::nullopt; }
std::optional<Vec3d> middle(const SpotLight& light) { return light.position; }
std::optional<Vec3d> middle(const SphereLight& light) { return light.position; }
std::optional<Vec3d> middle(const RectangleLight& light) { return light.corner + 0.5 * light.u + 0.5 * light.v; }

void move(PointLight& light, const Vec3d& offset) { light.position += offset; }
void move(DirectionalLight& /*light*/, const Vec3d& /*way*/) {}
void move(SpotLight& light, const Vec3d& offset) {
  light.position += offset;
  light.look_at += offset;
}
void move(SphereLight& light, const Vec3d& offset) { light.position += offset; }
void move(RectangleLight& light, const Vec3d& offset) { light.corner += offset; }

}  // namespace

std::optional<Vec3d> middle_of(const Light& light) {
  return std::visit([](const auto& kind) { return middle(kind); }, light.kind);
}

void move_by(Light& light, const Vec3d& offset) {
  std::visit([&](auto& kind) { move(kind, offset); }, light.kind);
}

bool is_area(const Light& light) {
  if (const auto* sphere = std::get_if<SphereLight>(&light.kind)) return sphere->radius > 0;
  if (const auto* rectangle = std::get_if<RectangleLight>(&light.kind))
    return rectangle->u != Vec3d(0.0) || rectangle->v != Vec3d(0.0);
  return false;
}

}  // namespace raywalk
