#include "view/legend/legend.h"

#include "view/text/shown.h"
#include "view/text/text.h"

#include <algorithm>

namespace raywalk {

Legend legend(const State& state) {
  Legend legend;
  const auto str = [](const State& in, std::string_view id) { return std::string(text(id, in.appearance.language)); };
  const auto row = [&](RayKind kind, std::string_view in_short, std::string_view meaning) {
    legend.rays.push_back({kind, ray_style(state.appearance.theme, kind), kind_name(state, kind), str(state, in_short),
                           str(state, meaning)});
  };
  if (state.walk.timeline->of_beams())
    row(RayKind::beam, "ray.short_beam", "legend.beam");
  else if (state.walk.timeline->of_cones())
    row(RayKind::beam, "ray.short_cone", "legend.cone");
  else
    row(RayKind::primary, "ray.short_primary", "legend.primary");
  if (!state.walk.timeline->of_radiosity())
    row(RayKind::shadow, state.walk.timeline->of_cones() ? "ray.short_shadow_cone" : "ray.short_shadow",
        "legend.shadow");
  // Cones are reflected and refracted as cones.
  if (!state.walk.timeline->of_radiosity() && !state.walk.timeline->of_cones()) {
    row(RayKind::reflect, "ray.short_reflect", "legend.reflect");
    row(RayKind::refract, "ray.short_refract", "legend.refract");
  }
  if (state.walk.timeline->of_photons()) row(RayKind::photon, "ray.short_photon", "legend.photon");
  const auto sign = [&](Ending ending, std::string_view meaning) {
    legend.signs.push_back({std::string(symbol(ending)), str(state, meaning)});
  };
  sign(Ending::hit, "legend.sign_hit");
  sign(Ending::missed, "legend.sign_missed");
  sign(Ending::blocked, "legend.sign_blocked");
  sign(Ending::reached_light, "legend.sign_reached_light");
  for (const Ending limit : {Ending::depth, Ending::threshold, Ending::total_internal_reflection, Ending::facing_away})
    legend.signs.push_back({std::string(symbol(limit)), std::string(text(limit, state.appearance.language))});
  legend.signs.push_back({"-|", str(state, "legend.sign_stub")});
  legend.signs.push_back({"->", str(state, "legend.sign_normal")});
  const Scene& scene = state.scene();
  const auto has_lobe = [](const Object& object) {
    return object.material.is_rough() || object.material.is_rough_diffuse();
  };
  if (std::any_of(scene.objects.begin(), scene.objects.end(), has_lobe)) {
    sign(Ending::wrong_side, "ending.wrong_side");
    legend.signs.push_back({"-<", str(state, "legend.sign_lobe")});
  }
  if (scene.sky) legend.signs.push_back({"( )", str(state, "legend.sign_ring")});
  if (state.walk.timeline->of_radiosity()) legend.signs.push_back({"( )", str(state, "legend.sign_patches")});
  return legend;
}

}  // namespace raywalk
