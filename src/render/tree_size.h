#pragma once
// The size of the ray trees of a picture, estimated before hours are spent on them.

#include "math/stop.h"
#include "trace/scene_kernel.h"

#include <optional>

namespace raywalk {

/// A pixel that takes impractically many rays.
struct TreeSize {
  double rays = 0;         ///< of one pixel with all its samples, estimated; shadow rays included
  double growth = 1;       ///< of the tree, per level
  int depth = 1;           ///< of the scene
  int samples = 1;         ///< of a pixel
  double shadow_rays = 0;  ///< of a hit
};

/// The first of a few probe pixels that takes more than a million rays; nothing if none does, which takes a few
/// thousand rays to find out. Called before the trace: changes `world.depth` temporarily. Throws Stopped when `stop` is
/// asked.
template <class T>
[[nodiscard]] std::optional<TreeSize> endless_tree(World<T>& world, const SceneKernel<T>& kernel,
                                                   const RayGenerator<T>& camera, ImageSize size, int samples,
                                                   const Stop& stop);

}  // namespace raywalk
