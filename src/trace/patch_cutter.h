#pragma once
// Cuts surfaces into flat pieces. Included by trace/patches.cpp and trace/beam_scene.cpp alone.

#include "trace/patches.h"

namespace raywalk {

/// The front sides of the patches of a scene, one primitive after the other; more than `most` are given up.
struct CutScene {
  std::vector<Patch> patches;
  std::vector<bool> closed;  ///< by primitive: it has an inside
};
struct CutSettings {
  double size = infinity<double>;  ///< the longest side of a patch
  int most = Patches::most;
  bool flat = false;     ///< in the plane
  int least_sides = 16;  ///< of what stands for a circle
};
[[nodiscard]] CutScene cut_into_patches(const World<double>& world, const CutSettings& settings, const Stop& stop);
/// The largest side of the box about all that is bounded; 1 where nothing is.
[[nodiscard]] double extent_of(const World<double>& world);

}  // namespace raywalk
