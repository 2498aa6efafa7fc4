#pragma once

#include "trace/kernel.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace raywalk {

/// The rays from the eye through the pixels of a block, one after the other, and what they hit. Where a mesh is
/// searched faster for several rays at once (accel/packet_search.h), some are formed and searched ahead; each has the
/// answer that it has alone.
template <class T>
class PrimaryRays {
 public:
  PrimaryRays(const World<T>& world, const RayGenerator<T>& camera) : world_(world), camera_(camera) {}

  /// Allows it for the pixels of a block, which outlives this, and all of which come in turn; not where the program is
  /// to be small.
  void look_ahead(const PixelBlock& block) {
    block_ = &block;
    if constexpr (!few_kernels) together_ = world_.accelerator.knows_packets();
  }

  /// Of the next pixel.
  [[nodiscard]] Ray<T> form(const Pixel& pixel, Statistics& statistics) {
    if (few_kernels || !together_) return camera_.primary_ray(pixel, draws_, statistics);
    if (++next_ >= rays_.size()) search_ahead(pixel, statistics);
    found_ = &hits_[next_];
    return rays_[next_];
  }
  /// Whether it is known what the ray formed last hits, and its search is counted; and that, once.
  [[nodiscard]] bool searched() const { return found_ != nullptr; }
  [[nodiscard]] const std::optional<Hit<T>>& take() { return *std::exchange(found_, nullptr); }

 private:
  [[gnu::noinline]] void search_ahead(const Pixel& pixel, Statistics& statistics) {
    constexpr std::size_t most = 16;
    rays_.clear(), next_ = 0;
    for (PixelBlock::Iterator at(*block_, pixel); rays_.size() < most && at != block_->end(); ++at)
      rays_.push_back(camera_.primary_ray(*at, draws_, statistics));
    hits_.resize(most), t_max_.resize(most, infinity<T>);
    world_.accelerator.closest(rays_, std::span(t_max_).first(rays_.size()), hits_, statistics.tests);
  }

  const World<T>& world_;
  const RayGenerator<T>& camera_;
  bool together_ = false;
  const PixelBlock* block_ = nullptr;
  typename RayGenerator<T>::PixelDraws draws_;
  const std::optional<Hit<T>>* found_ = nullptr;
  std::size_t next_ = 0;
  std::vector<Ray<T>> rays_;  ///< of the next pixels
  std::vector<std::optional<Hit<T>>> hits_;
  std::vector<T> t_max_;
};

}  // namespace raywalk
