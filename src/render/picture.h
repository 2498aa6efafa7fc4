#pragma once

#include "render/adaptive.h"
#include "render/film.h"
#include "render/tiles.h"
#include "trace/scene_kernel.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace raywalk {

/// A picture in progress: the one pass over pixels that render, preview, workbench and studies share. Blocks that do
/// not overlap may be traced concurrently.
template <class T>
class Picture {
 public:
  /// `size` pixels, which are the image `whole` or a strip of it. The scene's world outlives this. `tolerance`: of
  /// adaptive sampling. `paths`: traces paths so, whatever the scene's integrator.
  Picture(const Scene& scene, const World<T>& world, ImageSize size, ImageSize whole, const Sampling& sampling,
          double tolerance = 0, const std::optional<PathSettings>& paths = std::nullopt)
      : kernel_(scene, world, paths),
        camera_(scene, size, whole, sampling),
        film_(size),
        adaptive_(size, sampling.per_pixel, tolerance) {}

  /// Traces only the pixels of this share, and what adaptive sampling has to know of their neighbours.
  void restrict_to(const Share& share) {
    const ImageSize size = film_.size();
    std::vector<PixelBlock> wanted;
    Tiles(size).for_share(share, [&](PixelBlock block) {
      const int more = adaptive_.reach();
      block.column_begin = std::max(block.column_begin - more, 0);
      block.column_end = std::min(block.column_end + more, size.width);
      block.row_begin = std::max(block.row_begin - more, 0);
      block.row_end = std::min(block.row_end + more, size.height);
      wanted.push_back(block);
    });
    adaptive_.restrict_to(wanted);
  }

  /// Takes the block's samples of its active pixels into the film, and calls `each()` after every sample.
  template <class Each>
  Statistics trace(PixelBlock block, Each each) {
    const PutPixel<T> put = [&](const Pixel& p, const Rgb<T>& shade) {
      adaptive_.add(film_, p.column, p.row, p.sample, shade);
      each();
    };
    if (adaptive_.all_active()) return trace_into(block, put);
    Statistics statistics;
    PixelBlock run = block;
    for (run.row_begin = block.row_begin; run.row_begin < block.row_end; ++run.row_begin) {
      run.row_end = run.row_begin + 1;
      adaptive_.for_each_run(run.row_begin, block.column_begin, block.column_end, [&](int begin, int end) {
        run.column_begin = begin;
        run.column_end = end;
        statistics += trace_into(run, put);
      });
    }
    return statistics;
  }
  Statistics trace(const PixelBlock& block) {
    return trace(block, [] {});
  }
  /// Every sample of the block goes to `put` instead.
  Statistics trace_into(const PixelBlock& block, const PutPixel<T>& put) const { return kernel_(camera_, block, put); }

  /// The samples of the current pass, as Adaptive has them, and its end: whether any pixel continues.
  [[nodiscard]] int from() const { return adaptive_.from(); }
  [[nodiscard]] int to() const { return adaptive_.to(); }
  [[nodiscard]] bool next() { return adaptive_.next(film_); }
  /// The samples that all pixels together will have taken if no remaining pixel stops early.
  [[nodiscard]] std::uint64_t expected() const { return adaptive_.expected(); }

  [[nodiscard]] const SceneKernel<T>& kernel() const { return kernel_; }
  [[nodiscard]] const RayGenerator<T>& camera() const { return camera_; }
  void set_camera(const RayGenerator<T>& camera) { camera_ = camera; }
  [[nodiscard]] Film<T>& film() { return film_; }
  [[nodiscard]] const Film<T>& film() const { return film_; }

 private:
  SceneKernel<T> kernel_;
  RayGenerator<T> camera_;
  Film<T> film_;
  Adaptive<T> adaptive_;
};

}  // namespace raywalk
