#pragma once

#include "math/inlining.h"
#include "trace/kernel.h"

#include <optional>
#include <span>
#include <vector>

namespace raywalk {

/// The rays from the eye through pixels, one after the other, and what they hit.
template <class T>
class PrimaryRays {
 public:
  PrimaryRays(const World<T>& world, const RayGenerator<T>& camera) : world_(world), camera_(camera) {}

  /// Of the next pixel.
  [[nodiscard, RAYWALK_INLINE]] Ray<T> form(const Pixel& pixel, Statistics& statistics) {
    return camera_.primary_ray(pixel, draws_, statistics);
  }
  /// What it hits.
  template <class AnyRay>
  [[nodiscard, RAYWALK_INLINE]] std::optional<Hit<T>> closest(const AnyRay& ray, Statistics& statistics) const {
    return world_.accelerator.closest(ray, infinity<T>, statistics.tests);
  }

 private:
  const World<T>& world_;
  const RayGenerator<T>& camera_;
  typename RayGenerator<T>::PixelDraws draws_;
};

/// The same where a mesh is searched faster for several rays at once (accel/packet_search.h): some are formed and
/// searched ahead, and each has the answer that it has alone. A procedure has a loop of its own for them, so that where
/// there is no mesh no ray is asked whether it is searched already.
template <class T>
class PrimaryRaysAhead {
 public:
  /// All pixels of the block, which outlives this, come in turn.
  PrimaryRaysAhead(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block)
      : world_(world), camera_(camera), block_(block) {}

  /// Whether it is worth while; never where the program is to be small.
  [[nodiscard]] static bool pays(const World<T>& world) { return !few_kernels && world.accelerator.knows_packets(); }

  [[nodiscard]] Ray<T> form(const Pixel& pixel, Statistics& statistics) {
    if (++next_ >= rays_.size()) search_ahead(pixel, statistics);
    searched_ = true;
    return rays_[next_];
  }
  /// Whether it is known what the ray formed last hits, and its search is counted; and that, once.
  [[nodiscard]] bool searched() const { return searched_; }
  template <class AnyRay>
  [[nodiscard]] const std::optional<Hit<T>>& closest(const AnyRay& /*ray*/, Statistics& /*statistics*/) {
    searched_ = false;
    return hits_[next_];
  }

 private:
  [[gnu::noinline]] void search_ahead(const Pixel& pixel, Statistics& statistics) {
    constexpr std::size_t most = 16;
    rays_.clear(), next_ = 0;
    for (PixelBlock::Iterator at(block_, pixel); rays_.size() < most && at != block_.end(); ++at)
      rays_.push_back(camera_.primary_ray(*at, draws_, statistics));
    hits_.resize(most), t_max_.resize(most, infinity<T>);
    world_.accelerator.closest(rays_, std::span(t_max_).first(rays_.size()), hits_, statistics.tests);
  }

  const World<T>& world_;
  const RayGenerator<T>& camera_;
  const PixelBlock& block_;
  typename RayGenerator<T>::PixelDraws draws_;
  bool searched_ = false;
  std::size_t next_ = 0;
  std::vector<Ray<T>> rays_;  ///< of the next pixels
  std::vector<std::optional<Hit<T>>> hits_;
  std::vector<T> t_max_;
};

}  // namespace raywalk
