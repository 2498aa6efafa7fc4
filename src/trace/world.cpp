#include "trace/world.h"

#include <algorithm>

namespace raywalk {

namespace {

template <class T>
typename World<T>::Surface surface_of(const Material& m) {
  typename World<T>::Surface surface{Rgb<T>(m.ambient),
                                     Rgb<T>(m.diffuse),
                                     Rgb<T>(m.specular),
                                     Rgb<T>(m.reflection),
                                     Rgb<T>(m.transmission),
                                     Rgb<T>(m.emission),
                                     static_cast<T>(m.shininess),
                                     static_cast<T>(m.ior),
                                     m.dielectric,
                                     m.transmits(),
                                     m.shadow == ShadowKind::filtered && m.transmits(),
                                     m.normal == ShadingNormal::fixed,
                                     m.normal == ShadingNormal::fixed && !is_black(m.specular),
                                     {}};
  if (m.checker) surface.checker = {Rgb<T>(m.checker->even), Rgb<T>(m.checker->odd), static_cast<T>(m.checker->size)};
  return surface;
}

template <class T>
typename World<T>::Lamp lamp_of(int index, const Light& light) {
  typename World<T>::Lamp lamp{index, Rgb<T>(light.strength), false, Vec3<T>(0), 1, 0, 0};
  if (const auto* sun = std::get_if<DirectionalLight>(&light.kind)) {
    lamp.directional = true;
    lamp.place = Vec3<T>(normalize(sun->direction));
  } else if (const auto* point = std::get_if<PointLight>(&light.kind); point == nullptr) {
    lamp.place = Vec3<T>(*middle_of(light));
  } else {
    lamp.place = Vec3<T>(point->position);
    lamp.constant = static_cast<T>(point->attenuation.constant);
    lamp.linear = static_cast<T>(point->attenuation.linear);
    lamp.quadratic = static_cast<T>(point->attenuation.quadratic);
  }
  return lamp;
}

template <class T>
Primitives<T> primitives_of(const Scene& scene) {
  Primitives<T> primitives;
  for (const Object& object : scene.objects) {
    // Readers and editors refuse singular maps; an object under one would be flat and is left where it was.
    const auto place = object.transform.empty() ? std::nullopt : placement<T>(affine_of(object.transform));
    place ? primitives.add(shape_cast<T>(object.shape), *place) : primitives.add(shape_cast<T>(object.shape));
  }
  return primitives;
}

}  // namespace

template <class T>
World<T>::World(const Scene& scene, AcceleratorKind kind)
    : accelerator(primitives_of<T>(scene), kind),
      background(scene.background),
      ambient(scene.ambient),
      depth(scene.limits.depth),
      threshold(static_cast<T>(scene.limits.threshold)),
      effects(effects_of(scene)) {
  for (const Object& object : scene.objects) {
    surfaces.push_back(surface_of<T>(object.material));
    const bool filters = surfaces.back().filters_shadows;
    const int id = static_cast<int>(filters_shadows.size()), same = accelerator.primitives().first_equal(id);
    // Of two that filter in the same place, only the first is there.
    filters_shadows.push_back(filters && (same == id || !surface(same).filters_shadows));
    stops_shadows.push_back(!filters);
  }
  const bool all_stop = std::all_of(stops_shadows.begin(), stops_shadows.end(), [](auto stops) { return stops != 0; });
  if (all_stop) filters_shadows.clear(), stops_shadows.clear();
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (!is_black(scene.lights[i].strength)) lamps.push_back(lamp_of<T>(static_cast<int>(i), scene.lights[i]));
}

template struct World<float>;
template struct World<double>;

}  // namespace raywalk
