#pragma once
// The photon map: where light arrived, as a list of photons that can be searched by place. H. W. Jensen, "Global
// Illumination using Photon Maps", EGWR 1996; the balanced kd-tree in one array is that of his book (2001).

#include "math/stop.h"
#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk {

/// Light that arrived at a surface. Always in float: what a place rounds to is far less than the circle it counts in.
struct Photon {
  Vec3<float> position;
  Vec3<float> normal;  ///< unit length, of the side that it arrived at
  Rgb<float> power;    ///< flux; in a flat world, flux per unit of height
};
/// In the order in which they were stored.
struct StoredPhotons {
  std::vector<Photon> photons;
  std::vector<Vec3<float>> incidents;  ///< the direction that each travelled in, unit length; empty: nobody asks
};

/// What a search found.
struct PhotonsNear {
  Rgbd power{0.0};            ///< of the photons inside the circle; the one that marks its edge is not among them
  int count = 0;              ///< of these
  Rgbd answered{0.0};         ///< the sum of what `PhotonAnswer` makes of each, if asked
  double squared_radius = 0;  ///< of the circle
};

/// What a surface sends on of a photon's power: one whose answer depends on where light comes from.
using PhotonAnswer = std::function<Rgbd(const Photon& photon, const Vec3<float>& incident)>;

/// Photons that can be searched by place. The answers are a pure function of the list: the same on every machine.
class PhotonMap {
 public:
  PhotonMap() = default;
  /// Sorts the photons into a kd-tree. `stop` may cancel that, which then throws Stopped.
  explicit PhotonMap(std::vector<Photon> photons, const Stop& stop = {})
      : PhotonMap(StoredPhotons{std::move(photons), {}}, stop) {}
  explicit PhotonMap(const StoredPhotons& stored, const Stop& stop = {});

  [[nodiscard]] bool empty() const { return photons_.empty(); }
  [[nodiscard]] std::size_t size() const { return photons_.size(); }
  /// In the order of the tree.
  [[nodiscard]] const std::vector<Photon>& photons() const { return photons_; }

  /// The circle about `point` that reaches to the k-th photon (k >= 2), but at most to `radius`. Counted are photons
  /// that arrived on the side of `normal`, of unit length, within 60 degrees of it: not those around a corner. Without
  /// a normal all count, wherever they arrived.
  ///
  /// The photon that marks the circle's edge is not counted: with it, k / (pi r_k^2) would on average be k / (k - 1)
  /// too large. Where the radius ends the search first, all in the circle count. Either way the estimate is unbiased
  /// where the light is the same all over the circle.
  [[nodiscard]] PhotonsNear nearest(const Vec3d& point, const std::optional<Vec3d>& normal, int k,
                                    double radius = std::numeric_limits<double>::infinity(),
                                    const PhotonAnswer& answer = {}) const;
  /// All photons in the circle.
  [[nodiscard]] PhotonsNear within(const Vec3d& point, const std::optional<Vec3d>& normal, double radius,
                                   const PhotonAnswer& answer = {}) const;

 private:
  void sort(std::size_t begin, std::size_t end, std::vector<struct PlacedPhoton>& places, const Stop& stop);
  template <class Take>
  void search(const Vec3d& point, double& squared, Take&& take) const;

  std::vector<Vec3<float>> incidents_;
  std::vector<Photon> photons_;     ///< of each range the middle one splits; ranges of a few are lists
  std::vector<std::uint8_t> axes_;  ///< along which each photon splits its range
};

/// From flux to irradiance: what a circle of that radius counted, over its area; in a flat world, over its diameter.
[[nodiscard]] double photon_density(double squared_radius, bool flat);

}  // namespace raywalk
