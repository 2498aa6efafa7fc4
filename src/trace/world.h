#pragma once

#include "accel/accelerator.h"
#include "scene/effects.h"
#include "scene/scene.h"

#include <vector>

namespace raywalk {

/// A scene made ready for tracing in scalar type T: every number rounded once, primitives in their accelerator.
/// The primitive's id is the object's index in the scene.
template <class T>
struct World {
  struct Pattern {
    Rgb<T> even, odd;
    T size;
  };

  struct Surface {
    Rgb<T> ambient, diffuse, specular, reflection, transmission, emission;
    T shininess, ior;
    bool dielectric, transmits, filters_shadows;
    bool fixed_normal;     ///< the shading normal does not turn to face the ray
    bool lit_from_behind;  ///< and a light behind it may show its highlight
    std::optional<Pattern> checker;
  };

  struct Lamp {
    int index;        ///< in Scene::lights
    Rgb<T> strength;  ///< not black: those are left out
    bool directional;
    Vec3<T> place;  ///< position, or unit direction from any surface to a directional light
    T constant, linear, quadratic;
  };

  explicit World(const Scene& scene, AcceleratorKind kind = AcceleratorKind::automatic);

  Accelerator<T> accelerator;
  std::vector<Surface> surfaces;
  std::vector<Lamp> lamps;
  Rgb<T> background, ambient;
  int depth;
  T threshold;
  Effects effects;
  /// By primitive: whether it lets shadow rays through weighted, or stops them. Empty when all of them stop.
  std::vector<std::uint8_t> filters_shadows, stops_shadows;

  [[nodiscard]] const Surface& surface(int primitive) const { return surfaces[static_cast<std::size_t>(primitive)]; }
};

extern template struct World<float>;
extern template struct World<double>;

}  // namespace raywalk
