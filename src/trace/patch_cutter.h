#pragma once
// Cuts surfaces into patches. Included by trace/patches.cpp alone.

#include "trace/patches.h"

namespace raywalk {

/// The front sides of the patches of a scene, one primitive after the other; more than `most` are given up.
struct CutScene {
  std::vector<Patch> patches;
  std::vector<bool> closed;  ///< by primitive: it has an inside
};
/// `size`: the longest side of a patch.
[[nodiscard]] CutScene cut_into_patches(const World<double>& world, double size, bool flat, int most, const Stop& stop);
/// The largest side of the box about all that is bounded; 1 where nothing is.
[[nodiscard]] double extent_of(const World<double>& world);

}  // namespace raywalk
