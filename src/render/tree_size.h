#pragma once
// How large the ray trees of a picture become: said before hours are spent on them.

#include "math/stop.h"
#include "trace/path_kernel.h"

#include <optional>

namespace raywalk {

/// A pixel that takes more rays than one would wait for.
struct TreeSize {
  double rays = 0;      ///< of one pixel with all its samples, about; shadow rays included
  double growth = 1;    ///< of the tree, from one level to the next
  int depth = 1;        ///< of the scene
  int samples = 1;      ///< of a pixel
  int shadow_rays = 0;  ///< of a hit
};

/// The first pixel among a few spread over the picture that takes more than a million rays; nothing where none does,
/// which a few thousand rays show. Asked before the trace: changes `world.depth` meanwhile. Throws Stopped when `stop`
/// is asked.
template <class T>
[[nodiscard]] std::optional<TreeSize> endless_tree(World<T>& world, const SceneKernel<T>& kernel,
                                                   const RayGenerator<T>& camera, ImageSize size, int samples,
                                                   const Stop& stop);

}  // namespace raywalk
