#include "scene/effects.h"

#include "scene/beam_limits.h"
#include "scene/cone_limits.h"

#include <algorithm>
#include <functional>
#include <type_traits>

namespace raywalk {

namespace {

/// The first object whose material satisfies `calls`, or null.
template <class Calls>
const Object* first_object(const Scene& scene, Calls calls) {
  for (const MaterialUse& use : material_uses(scene))
    if (std::invoke(calls, *use.material)) return use.object;
  return nullptr;
}

template <class Calls>
EffectUse use_if(const Scene& scene, Calls calls, const std::string& because, const std::string& none) {
  const Object* object = first_object(scene, calls);
  return object ? EffectUse{true, object->name + " " + because} : EffectUse{false, "none: " + none};
}

/// The first light of non-zero strength that `calls` accepts, or null.
template <class Calls>
const Light* first_light(const Scene& scene, Calls calls) {
  const auto found = std::find_if(scene.lights.begin(), scene.lights.end(),
                                  [&](const Light& light) { return !is_black(light.strength) && calls(light); });
  return found == scene.lights.end() ? nullptr : &*found;
}

EffectUse left_out(Integrator integrator, std::string_view what) {
  return {false, "none: " + std::string(name_of(integrator)) + " " + std::string(what)};
}

EffectUse refraction(const Scene& scene, Integrator integrator) {
  if (!traits_of(integrator).is_recursive) return left_out(integrator, "follows no ray beyond the first hit");
  if (!scene.render.switches.refraction) return {false, "none: it is switched off"};
  return use_if(scene, &Material::transmits, "transmits", "nothing transmits");
}

/// Every transmitting material also reflects: a part by Fresnel's equations, or everything beyond the critical angle.
EffectUse reflection(const Scene& scene, Integrator integrator) {
  if (!traits_of(integrator).is_recursive) return left_out(integrator, "follows no ray beyond the first hit");
  const EffectSwitches& on = scene.render.switches;
  EffectUse use =
      use_if(scene, [&](const Material& m) { return on.reflection && m.reflects(); }, "reflects", "nothing reflects");
  const auto transmits = [&](const Material& m) { return on.refraction && m.transmits(); };
  const auto shares = [&](const Material& m) { return on.reflection && transmits(m) && m.dielectric; };
  if (!use.used && first_object(scene, transmits) != nullptr) {
    use = use_if(scene, shares, "reflects a share of the light as a dielectric", "");
    if (!use.used) use = use_if(scene, transmits, "can reflect totally inside", "");
  }
  return use;
}

EffectUse gloss(const Scene& scene, Integrator integrator) {
  const EffectUse use = use_if(scene, &Material::is_glossy, "has a rough reflection", "every mirror is sharp");
  return use.used && !has_lobes(integrator) ? left_out(integrator, "takes every mirror as sharp") : use;
}

EffectUse translucency(const Scene& scene, Integrator integrator) {
  const EffectUse use =
      use_if(scene, &Material::is_translucent, "scatters what it transmits", "every transmitter is clear");
  return use.used && !has_lobes(integrator) ? left_out(integrator, "takes every transmitter as clear") : use;
}

/// A scene may be lit by emitting objects only. It then has soft shadows, but not from a light.
EffectUse no_light(const Scene& scene) {
  const Object* emitter = first_object(scene, &Material::emits);
  if (emitter == nullptr) return {false, "none: no light shines"};
  const std::string_view followers = scene.render.radiosity.as_ambient ? "only paths and patches" : "only paths";
  return {false, "none: no light shines; what " + emitter->name + " emits is indirect light, which " +
                     std::string(followers) + " follow"};
}

EffectUse penumbra(const Scene& scene, Integrator integrator) {
  if (first_light(scene, [](const Light&) { return true; }) == nullptr) return no_light(scene);
  const Light* area = first_light(scene, is_area);
  if (area == nullptr) return {false, "none: every light is a point or a direction"};
  if (scene.objects.empty()) return {false, "none: nothing casts or catches a shadow"};
  if (has_extents(integrator)) return {true, area->name + " has an extent"};
  area = first_light(scene, [&](const Light& light) { return light_grid_of(scene, light) > 1; });
  if (area == nullptr) return left_out(integrator, "takes every light from its middle");
  const std::string grid = std::to_string(light_grid_of(scene, *area));
  return {true, area->name + " is a grid of " + grid + " x " + grid + " points"};
}

EffectUse depth_of_field(const Scene& scene, Integrator integrator) {
  if (!(scene.camera.aperture > 0)) return {false, "none: the camera is a pinhole"};
  if (!draws_random(integrator)) return left_out(integrator, "takes the lens as a pinhole");
  return {true, "the camera has a lens"};
}

EffectUse motion_blur(const Scene& scene, Integrator integrator) {
  const Object* mover = first_moving_object(scene);
  if (mover == nullptr) return {false, "none: nothing moves while the shutter is open"};
  if (!draws_random(integrator)) return left_out(integrator, "sees everything where it is when the shutter opens");
  return {true, mover->name + " moves while the shutter is open"};
}

EffectUse antialiasing(int samples_per_pixel, Integrator integrator) {
  if (traits_of(integrator).has_width)
    return {true,
            std::string("a pixel is a ") + (integrator == Integrator::beams ? "beam" : "cone") + " as wide as itself"};
  if (samples_per_pixel <= 1) return {false, "none: one sample in the centre of each pixel"};
  return {true, std::to_string(samples_per_pixel) + " samples are taken in each pixel"};
}

EffectUse indirect_light(const Scene& scene, Integrator integrator) {
  const IntegratorTraits& traits = traits_of(integrator);
  if (!traits.is_recursive && !traits.is_global) return left_out(integrator, "follows no ray beyond the first hit");
  if (takes_ambient_from_patches(scene))
    return {true, "patches send each other light, which is in the place of ambient light"};
  if (!traits.is_global) return {false, "none: Whitted's algorithm follows mirrors and glass only"};
  if (scene.render.path_length == 1) return {false, "none: paths end at what is seen"};
  return use_if(
      scene,
      [](const Material& m) { return !is_black(m.diffuse) || !is_black(m.specular) || m.reflects() || m.transmits(); },
      "sends on the light that comes from other surfaces", "every surface is black");
}

EffectUse sky(const Scene& scene) {
  if (!scene.sky) return {false, "none: the background is the same everywhere"};
  const std::string_view kind =
      std::visit([](const auto& of) { return std::decay_t<decltype(of)>::name; }, scene.sky->kind);
  return {true, "rays that leave the scene meet the sky, of type " + std::string(kind)};
}

EffectUse scattering(const Scene& scene, Integrator integrator) {
  const EffectUse use =
      use_if(scene, &Material::scatters_inside, "scatters light inside", "no body scatters light inside");
  if (!use.used || integrator == Integrator::path) return use;
  if (!traits_of(integrator).is_recursive) return left_out(integrator, "follows no ray into a body");
  return left_out(integrator, "takes light that is scattered inside as absorbed");
}

EffectUse filtering(const Scene& scene, Integrator integrator) {
  EffectUse use = use_if(scene, &Material::filters_checker, "has its checker filtered", "");
  if (!use.used) use = use_if(scene, &Material::filters_texture, "has its image filtered", "no pattern is filtered");
  return use.used && integrator == Integrator::beams
             ? left_out(integrator, "cuts checkers into their squares, and takes images in the middle of each part")
             : use;
}

/// Without random numbers rough glass still has its highlights, but with beams.
EffectUse rough_glass(const Scene& scene, Integrator integrator) {
  const EffectUse use =
      use_if(scene, &Material::is_rough_glass, "is glass of small facets", "nothing is of metal or rough");
  const IntegratorTraits& traits = traits_of(integrator);
  return use.used && traits.has_width && !traits.has_lobes ? left_out(integrator, "takes rough glass as clear") : use;
}

/// Without random numbers a rough mirror still has its highlights. Matt surfaces are there for every integrator.
EffectUse microfacets(const Scene& scene, Integrator integrator) {
  const EffectSwitches& on = scene.render.switches;
  EffectUse use;
  if (!traits_of(integrator).is_recursive) {
    use = left_out(integrator, "follows no ray beyond the first hit");
  } else if (!on.reflection) {
    use = {false, "none: reflection is switched off"};
  } else {
    use = use_if(scene, &Material::is_metal, "is a mirror of metal", "");
    if (!use.used) use = use_if(scene, &Material::is_rough_mirror, "is a mirror of small mirrors", "");
    if (!use.used && on.refraction)
      use = rough_glass(scene, integrator);
    else if (!use.used)
      use.why = "none: refraction is switched off, and nothing else is of metal or rough";
  }
  if (use.used) return use;
  const EffectUse matt = use_if(scene, &Material::is_rough_diffuse, "is matt and rough", "");
  if (!matt.used) return use;
  return integrator == Integrator::radiosity ? left_out(integrator, "takes matt surfaces as smooth") : matt;
}

/// Where light is of patches or of whole cones, a normal of one point says nothing.
EffectUse maps(const Scene& scene, Integrator integrator) {
  EffectUse use = use_if(scene, &Material::has_mapped_parameters, "is another material from point to point", "");
  if (use.used) return use;
  use = use_if(scene, &Material::has_bent_normals, "has a relief of normals", "every surface is alike all over");
  return use.used && !bends_normals(integrator) ? left_out(integrator, "takes reliefs as flat") : use;
}

EffectUse shadows(const Scene& scene, Integrator integrator) {
  const Light* light = first_light(scene, [](const Light&) { return true; });
  if (light == nullptr && traits_of(integrator).is_global && indirect_light(scene, integrator).used) {
    if (scene.sky) return {true, "the sky shines, and paths look for it from all surfaces"};
    return use_if(scene, &Material::emits, "emits, and paths look for it from all surfaces", "no light shines");
  }
  if (light == nullptr) return {false, "none: no light shines"};
  if (scene.objects.empty()) return {false, "none: nothing casts or catches a shadow"};
  return {true, light->name + " shines on objects"};
}

}  // namespace

Integrator integrator_of(const Scene& scene, int samples_per_pixel) {
  const Integrator chosen = scene.render.integrator;
  const bool cannot = (chosen == Integrator::cones && !why_no_cones(scene).empty()) ||
                      (chosen == Integrator::beams && !why_no_space_beams(scene).empty());
  if (chosen != Integrator::automatic && !cannot) return chosen;
  const Integrator whole = Integrator::distributed;
  const bool calls = samples_per_pixel > 1 || gloss(scene, whole).used || translucency(scene, whole).used ||
                     penumbra(scene, whole).used || depth_of_field(scene, whole).used ||
                     motion_blur(scene, whole).used || first_object(scene, &Material::is_rough) != nullptr;
  return calls ? Integrator::distributed : Integrator::whitted;
}

bool takes_ambient_from_patches(const Scene& scene) {
  if (!scene.render.radiosity.as_ambient) return false;
  return may_take_ambient_from_patches(integrator_of(scene));
}

int light_grid_of(const Scene& scene, const Light& light) {
  if (!is_area(light)) return 1;
  if (scene.render.light_grid) return *scene.render.light_grid;
  return samples_of(light);
}

Effects effects_of(const Scene& scene, int samples_per_pixel) {
  const Integrator integrator = integrator_of(scene, samples_per_pixel);
  Effects effects;
  effects[Effect::shadows] = shadows(scene, integrator);
  effects[Effect::reflection] = reflection(scene, integrator);
  effects[Effect::refraction] = refraction(scene, integrator);
  effects[Effect::gloss] = gloss(scene, integrator);
  effects[Effect::translucency] = translucency(scene, integrator);
  effects[Effect::penumbra] = penumbra(scene, integrator);
  effects[Effect::depth_of_field] = depth_of_field(scene, integrator);
  effects[Effect::motion_blur] = motion_blur(scene, integrator);
  effects[Effect::antialiasing] = antialiasing(samples_per_pixel, integrator);
  effects[Effect::indirect_light] = indirect_light(scene, integrator);
  effects[Effect::sky] = sky(scene);
  effects[Effect::scattering] = scattering(scene, integrator);
  effects[Effect::filtering] = filtering(scene, integrator);
  effects[Effect::microfacets] = microfacets(scene, integrator);
  effects[Effect::maps] = maps(scene, integrator);
  effects[Effect::textures] =
      use_if(scene, [](const Material& m) { return m.checker.has_value(); }, "is checkered", "");
  EffectUse& textures = effects[Effect::textures];
  if (!textures.used)
    textures = use_if(
        scene, [](const Material& m) { return m.texture.has_value(); }, "wears an image", "no material has a pattern");
  return effects;
}

}  // namespace raywalk
