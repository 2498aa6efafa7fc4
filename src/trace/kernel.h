#pragma once
// The tracer's compiled kernels: one for each scalar and each set of effects inside the hit loop, and an observed one.

#include "math/stop.h"
#include "math/words.h"
#include "trace/policy.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"
#include "trace/world.h"

#include <functional>
#include <type_traits>

namespace raywalk {

/// The scalar type that a trace runs in: 24 or 53 bits.
enum class Precision { float_, double_ };
template <>
inline constexpr Word<Precision> words_of<Precision>[] = {{Precision::float_, "float"}, {Precision::double_, "double"}};

class BouncedLight;

/// The pixels of a rectangle, row by row; with `stride` > 1 only every `stride`-th column and row, from the first.
struct PixelBlock {
  int column_begin = 0, column_end = 0, row_begin = 0, row_end = 0;
  int sample = 0;
  int stride = 1;
  int samples = 1;                        ///< from `sample` on: all samples of a pixel before those of the next
  Stop stop{};                            ///< may cancel inside a pixel, which is then not put: tracing throws Stopped
  const BouncedLight* bounced = nullptr;  ///< in the place of ambient light, if the tracer's kernel has it

  class Iterator {
   public:
    Iterator(const PixelBlock& block, Pixel pixel) : block_(&block), pixel_(pixel) {}
    const Pixel& operator*() const { return pixel_; }
    Iterator& operator++() {
      if (++pixel_.sample < block_->sample + block_->samples) return *this;
      pixel_.sample = block_->sample;
      pixel_.column += block_->stride;
      if (pixel_.column >= block_->column_end) {
        pixel_.column = block_->column_begin;
        pixel_.row += block_->stride;
      }
      return *this;
    }
    /// Only ever compared with end().
    bool operator!=(const Iterator&) const { return pixel_.row < block_->row_end; }

   private:
    const PixelBlock* block_;
    Pixel pixel_;
  };
  [[nodiscard]] Iterator begin() const {
    const bool empty = column_begin >= column_end || row_begin >= row_end;
    return {*this, {column_begin, empty ? row_end : row_begin, sample, sample + samples}};
  }
  [[nodiscard]] Iterator end() const { return {*this, {column_begin, row_end, sample}}; }
};

template <class T>
using PutPixel = std::function<void(const Pixel&, const Rgb<T>&)>;

/// Runs MAIN ALGORITHM over a block of pixels.
template <class T>
using Kernel = Statistics (*)(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                              const PutPixel<T>& put);
/// The smallest kernel that is compiled with all of the world's effects.
[[nodiscard]] Kernel<float> kernel_for(const World<float>& world);
[[nodiscard]] Kernel<double> kernel_for(const World<double>& world);
/// Runs it.
template <class T>
[[nodiscard]] Statistics trace(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                               const std::type_identity_t<PutPixel<T>>& put) {
  return kernel_for(world)(world, camera, block, put);
}

/// The same with every effect's code in the loop, observed by `observer`: same bits, same statistics.
Statistics trace_watched(const World<float>& world, const RayGenerator<float>& camera, const PixelBlock& block,
                         const PutPixel<float>& put, Observer& observer);
Statistics trace_watched(const World<double>& world, const RayGenerator<double>& camera, const PixelBlock& block,
                         const PutPixel<double>& put, Observer& observer);

}  // namespace raywalk
