#pragma once
// How a surface scatters where a ray of a recording met it: by the maps, tables and bodies that light is traced by.

#include "timeline/timeline.h"
#include "trace/surface_vertex.h"

#include <optional>

namespace raywalk {

struct Scattering {
  Bsdf<double> bsdf;  ///< with its facets, whether rays are drawn by them or not; it speaks of the world's tables
  double roughness;   ///< of small facets; 0: smooth
  std::optional<Vec3d> refracted;  ///< of rough glass: where smooth glass would bend the ray to
};

/// At the end of ray `ray`. None where it ended at no surface, is a beam or a cone, or cannot be followed from EYE:
/// light was scattered on its way inside a body.
[[nodiscard]] std::optional<Scattering> scattering_at(const World<double>& world, const Scene& scene,
                                                      const Timeline& timeline, int ray);

}  // namespace raywalk
