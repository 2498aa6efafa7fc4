#include "scene/maps.h"

#include "scene/material.h"

#include <algorithm>

namespace raywalk {

Material second_of(const Material& material) {
  Material second = material;
  if (!material.mask) return second;
  const SecondMaterial& its = material.mask->second;
  second.ambient = its.ambient;
  second.diffuse = its.diffuse;
  second.diffuse_roughness = its.diffuse_roughness;
  second.specular = its.specular;
  second.shininess = its.shininess;
  second.reflection = its.reflection;
  second.transmission = Rgbd(0.0);
  second.roughness = its.roughness;
  second.emission = its.emission;
  second.maps = its.maps;
  second.checker.reset();
  second.texture.reset();
  second.mask.reset();
  return second;
}

namespace {

/// Of one list of maps: the first parameter that has several.
std::string why_twice(const std::vector<ParameterMap>& maps) {
  for (auto map = maps.begin(); map != maps.end(); ++map)
    if (std::any_of(maps.begin(), map, [&](const ParameterMap& before) { return before.of == map->of; }))
      return std::string(name_of(map->of)) + " has two maps (expected at most one of each parameter)";
  return {};
}

}  // namespace

std::string why_not_mapped(const Material& material) {
  if (std::string why = why_twice(material.maps); !why.empty()) return why;
  const auto is_of_light_through = [](const ParameterMap& map) { return map.of == MappedParameter::transmission; };
  const bool filters = material.transmits() && material.shadow == ShadowKind::filtered;
  if (filters && (material.mask || std::any_of(material.maps.begin(), material.maps.end(), is_of_light_through)))
    return "filtered shadows go neither with a map of transmission nor with a mask (expected shadow = \"opaque\")";
  if (!material.mask) return {};
  const SecondMaterial& second = material.mask->second;
  if (std::string why = why_twice(second.maps); !why.empty()) return "in the second material, " + why;
  for (const ParameterMap& map : second.maps)
    if (map.of == MappedParameter::transmission || map.of == MappedParameter::gloss ||
        map.of == MappedParameter::translucency)
      return "the second material has no " + std::string(name_of(map.of)) + " of its own to map (expected a map of " +
             "ambient, diffuse, diffuse_roughness, specular, shininess, reflection, roughness or emission)";
  if (!is_black(second.reflection) && material.transmits() && material.dielectric)
    return "reflection of the second material does not go with a dielectric, which would split it (expected 0)";
  if (second.roughness > 0 && (material.gloss > 0 || material.translucency > 0))
    return "roughness of the second material does not go with gloss or translucency of the first (expected 0)";
  if (second.roughness > 0 && material.transmits() && !material.dielectric)
    return "roughness of the second material goes with transmission of the first only where dielectric = true "
           "(expected 0)";
  return {};
}

}  // namespace raywalk
