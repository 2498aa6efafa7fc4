#pragma once
// Shadows with edges: light is sent by whole patches, but what comes straight from lamps and from what emits is
// received by elements, parts of a patch that are as small as it changes (M. Cohen, D. Greenberg, D. Immel and P.
// Brock, "An Efficient Radiosity Approach for Realistic Image Synthesis", IEEE CG&A 6(3), 1986).

#include "trace/patches.h"

#include <array>
#include <cstddef>
#include <vector>

namespace raywalk {

/// The elements of one patch: quarters of quarters of it.
class PatchElements {
 public:
  PatchElements() = default;
  /// Of a patch in a flat surface, in space. `sources`: the patches that emit. `bounced`: the irradiance that comes by
  /// other patches; what is a fiftieth of all light there is not seen.
  PatchElements(const Patches& patches, int patch, const std::vector<int>& sources, const Rgbd& bounced);

  [[nodiscard]] bool empty() const { return elements_.empty(); }
  /// The irradiance that comes straight, at a point of the patch.
  [[nodiscard]] Rgbd straight_light_at(const Vec3d& point) const;

  static constexpr int least_depth = 1, most_depth = 4;  ///< how often a patch is quartered

 private:
  struct Element {
    Patch piece;
    std::array<Rgbd, 4> light;  ///< at its corners
    std::size_t quarters = 0;   ///< the first of four; 0: it has none
  };

  std::vector<Element> elements_;  ///< the whole patch first
};

}  // namespace raywalk
