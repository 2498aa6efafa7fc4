#pragma once

#include "math/words.h"
#include "scene/scene.h"

#include <array>
#include <iterator>
#include <string>
#include <string_view>

namespace raywalk {

/// The effects that a scene may or may not call for. The tracer simulates only those that are used. New ones come last:
/// links name them by their order (view/link/link.h).
enum class Effect {
  shadows,
  reflection,
  refraction,
  gloss,
  translucency,
  penumbra,
  depth_of_field,
  motion_blur,
  antialiasing,
  indirect_light,
  textures,
  sky,
  scattering,
  filtering,
  microfacets,
  maps,
};
template <>
inline constexpr Word<Effect> words_of<Effect>[] = {{Effect::shadows, "shadows"},
                                                    {Effect::reflection, "reflection"},
                                                    {Effect::refraction, "refraction"},
                                                    {Effect::gloss, "gloss"},
                                                    {Effect::translucency, "translucency"},
                                                    {Effect::penumbra, "penumbra"},
                                                    {Effect::depth_of_field, "depth_of_field"},
                                                    {Effect::motion_blur, "motion_blur"},
                                                    {Effect::antialiasing, "antialiasing"},
                                                    {Effect::indirect_light, "indirect_light"},
                                                    {Effect::textures, "textures"},
                                                    {Effect::sky, "sky"},
                                                    {Effect::scattering, "scattering"},
                                                    {Effect::filtering, "filtering"},
                                                    {Effect::microfacets, "microfacets"},
                                                    {Effect::maps, "maps"}};
inline constexpr int effect_count = static_cast<int>(std::size(words_of<Effect>));

struct EffectUse {
  bool used = false;
  std::string why;  ///< one clause, for people: "the material of Mirror Sphere reflects"
};

/// Which effects a scene calls for and why. Effects that are enabled but inert, or that the integrator leaves out,
/// count as not used.
class Effects {
 public:
  [[nodiscard]] const EffectUse& operator[](Effect effect) const { return uses_[static_cast<std::size_t>(effect)]; }
  EffectUse& operator[](Effect effect) { return uses_[static_cast<std::size_t>(effect)]; }
  [[nodiscard]] bool used(Effect effect) const { return (*this)[effect].used; }

 private:
  std::array<EffectUse, effect_count> uses_;
};

/// With the scene's own choices of rendering; an integrator that leaves an effect out makes it unused.
[[nodiscard]] Effects effects_of(const Scene& scene, int samples_per_pixel = 1);

/// The scene's integrator, `automatic` resolved: distributed where an effect of it is called for, else whitted. Beams
/// and cones that cannot be followed through the scene count as automatic.
[[nodiscard]] Integrator integrator_of(const Scene& scene, int samples_per_pixel = 1);
/// Whether it may draw random numbers: cast and whitted take their samples at fixed positions.
[[nodiscard]] constexpr bool draws_random(Integrator integrator) { return traits_of(integrator).draws_random; }
/// Whether lights have extents for it, by samples or as a whole; and whether lobes have.
[[nodiscard]] constexpr bool has_extents(Integrator integrator) {
  return draws_random(integrator) || traits_of(integrator).has_width;
}
[[nodiscard]] constexpr bool has_lobes(Integrator integrator) {
  return draws_random(integrator) || traits_of(integrator).has_lobes;
}

/// Whether light that surfaces send each other, by patches, may be in the place of ambient light, and whether it is.
[[nodiscard]] constexpr bool may_take_ambient_from_patches(Integrator integrator) {
  const IntegratorTraits& traits = traits_of(integrator);
  return traits.is_recursive && !traits.is_global && !traits.has_width;
}
[[nodiscard]] bool takes_ambient_from_patches(const Scene& scene);
/// Whether surfaces are cut into patches, for that or for radiosity.
[[nodiscard]] inline bool cuts_patches(const Scene& scene) {
  return scene.render.integrator == Integrator::radiosity || takes_ambient_from_patches(scene);
}

/// Whether it shades by normals of maps; else by those of the shapes.
[[nodiscard]] constexpr bool bends_normals(Integrator integrator) {
  return !traits_of(integrator).has_width && integrator != Integrator::radiosity;
}

/// The number of points on a light that are sampled at a hit, along each of its two sides; 1 except for area lights.
[[nodiscard]] int light_grid_of(const Scene& scene, const Light& light);

}  // namespace raywalk
