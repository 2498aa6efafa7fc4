#include "trace/dipole_limits.h"

#include "scene/effects.h"
#include "trace/world.h"

#include <fmt/format.h>

#include <algorithm>

namespace raywalk {

namespace {

/// What the dipole makes of a body wrongly.
void judge(const Object& object, std::vector<std::string>& losses) {
  const Material& its = object.material;
  if (!its.scatters_inside()) return;
  double depth = infinity<double>, albedo = 1;  // of the channel that gets farthest, and of the one that loses most
  const Bounds<double> box = image_of(affine_of(object.transform), bounds(object.shape));
  const Vec3d size = box.max - box.min;
  for (int channel = 0; channel < 3; ++channel) {
    const double scattered = its.scattering[channel] * (1 - its.anisotropy),
                 extinction = its.absorption[channel] + scattered;
    depth = std::min(depth, std::min({size.x, size.y, size.z}) * extinction);
    if (scattered > 0) albedo = std::min(albedo, scattered / extinction);
  }
  constexpr double thin = 5, dark = 0.5;
  if (depth < thin)
    losses.push_back(
        fmt::format("\"{}\" is only {:.2g} mean free paths thick: the dipole takes it as endless, and lets "
                    "no light through",
                    object.name, depth));
  if (albedo < dark)
    losses.push_back(fmt::format("\"{}\" absorbs {:.0f}% of what it would scatter: the dipole makes it too dark",
                                 object.name, 100 * (1 - albedo)));
}

}  // namespace

std::vector<std::string> dipole_losses(const Scene& scene) {
  if (scene.render.subsurface != Subsurface::dipole || !effects_of(scene).used(Effect::scattering)) return {};
  const World<float> world(scene, AcceleratorKind::none);
  if (!world.bodies.empty())
    return {"bodies lie in one another or hold the eye: light inside of them walks, and does not leave by the dipole"};
  std::vector<std::string> losses;
  for (const Object& object : scene.objects) judge(object, losses);
  for (const Group& group : scene.groups)
    for (const Object& object : group.objects) judge(object, losses);
  return losses;
}

}  // namespace raywalk
