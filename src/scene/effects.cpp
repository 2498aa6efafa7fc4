#include "scene/effects.h"

#include <algorithm>

namespace raywalk {

std::string_view effect_name(Effect effect) {
  switch (effect) {
    case Effect::shadows:
      return "shadows";
    case Effect::reflection:
      return "reflection";
    case Effect::refraction:
      return "refraction";
    case Effect::gloss:
      return "gloss";
    case Effect::translucency:
      return "translucency";
    case Effect::penumbra:
      return "penumbra";
    case Effect::depth_of_field:
      return "depth_of_field";
    case Effect::motion_blur:
      return "motion_blur";
    case Effect::antialiasing:
      return "antialiasing";
    case Effect::indirect_light:
      return "indirect_light";
    case Effect::textures:
      return "textures";
  }
  return "";
}

namespace {

/// The first object whose material satisfies `calls`, or null.
template <class Calls>
const Object* first_object(const Scene& scene, Calls calls) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const Object& object) { return calls(object.material); });
  return found == scene.objects.end() ? nullptr : &*found;
}

template <class Calls>
EffectUse use_if(const Scene& scene, Calls calls, const std::string& because, const std::string& none) {
  const Object* object = first_object(scene, calls);
  return object ? EffectUse{true, object->name + " " + because} : EffectUse{false, "none: " + none};
}

}  // namespace

Effects effects_of(const Scene& scene, int samples_per_pixel) {
  Effects effects;
  const auto lamp = std::find_if(scene.lights.begin(), scene.lights.end(),
                                 [](const Light& light) { return !is_black(light.strength); });
  effects[Effect::shadows] = lamp == scene.lights.end() ? EffectUse{false, "none: no light shines"}
                             : scene.objects.empty()    ? EffectUse{false, "none: nothing casts or catches a shadow"}
                                                        : EffectUse{true, lamp->name + " shines on objects"};
  effects[Effect::refraction] =
      use_if(scene, [](const Material& m) { return m.transmits(); }, "transmits", "nothing transmits");
  // Whatever transmits reflects too: a share by Fresnel's equations, or all of it beyond the critical angle.
  EffectUse& reflection = effects[Effect::reflection];
  reflection = use_if(scene, [](const Material& m) { return m.reflects(); }, "reflects", "nothing reflects");
  if (!reflection.used && effects.used(Effect::refraction)) {
    const auto shares = [](const Material& m) { return m.transmits() && m.dielectric; };
    reflection = use_if(scene, shares, "reflects a share of the light as a dielectric", "");
    if (!reflection.used)
      reflection = use_if(scene, [](const Material& m) { return m.transmits(); }, "can reflect totally inside", "");
  }
  effects[Effect::textures] = use_if(
      scene, [](const Material& m) { return m.checker.has_value(); }, "is checkered", "no material has a pattern");
  effects[Effect::antialiasing] =
      samples_per_pixel > 1 ? EffectUse{true, std::to_string(samples_per_pixel) + " samples are taken in each pixel"}
                            : EffectUse{false, "none: one sample in the centre of each pixel"};
  effects[Effect::gloss] = {false, "none: every mirror is sharp"};
  effects[Effect::translucency] = {false, "none: every transmitter is clear"};
  effects[Effect::penumbra] = {false, "none: every light is a point or a direction"};
  effects[Effect::depth_of_field] = {false, "none: the camera is a pinhole"};
  effects[Effect::motion_blur] = {false, "none: nothing moves"};
  effects[Effect::indirect_light] = {false, "none: Whitted's algorithm follows mirrors and glass only"};
  return effects;
}

}  // namespace raywalk
