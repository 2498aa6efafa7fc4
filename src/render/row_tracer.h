#pragma once
// The rows of a progressive picture, each traced by itself: in this program's threads, or in another program that is
// told nothing but the scene. Who traces a row, and when, changes no bit of it.

#include "render/heat.h"
#include "render/world_cache.h"
#include "trace/kernel.h"

#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

/// What a preview shows.
struct PreviewSettings {
  ImageSize size{};  ///< each side >= 1
  Precision precision = Precision::double_;
  int samples = 16;  ///< of each pixel when finished, >= 1
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  /// What the pixels show instead of their colours: the cost of the ray through the centre, without further samples; or
  /// the noise of the samples, of which there are then at least `fewest_for_noise`.
  Heat heat = Heat::none;
  static constexpr int fewest_for_noise = 16;
  std::optional<Fault> fault{};  ///< breaks the tracer on purpose
  friend bool operator==(const PreviewSettings&, const PreviewSettings&) = default;

  /// Samples of each pixel to take after its centre. One sample per pixel is the centre itself.
  [[nodiscard]] int samples_to_take() const;
};

/// A visit of every row of a grid: first those that trace pixel centres on ever finer grids, then one for each sample.
struct PreviewPass {
  static constexpr int coarsest = 8;
  int stride = coarsest;  ///< of the grid
  int sample = -1;        ///< -1: the centres of what the grid before this one has left out
  [[nodiscard]] bool of_centres() const { return sample < 0; }
  /// The one after it.
  [[nodiscard]] PreviewPass next() const;
  friend bool operator==(const PreviewPass&, const PreviewPass&) = default;
};

struct PreviewRow {
  PreviewPass pass;
  int row = 0;
};

struct TracedRow {
  PreviewRow of;
  std::vector<Rgbd> shades;   ///< of the pass's pixels in the row, from left to right; rounded as the precision has it
  std::vector<double> costs;  ///< of each, for a map of what the ray through the centre costs
  Statistics statistics;
};

/// The first column of a pass in a row, and how far it is to the next.
struct PreviewColumns {
  int begin = 0, step = 1;
};
[[nodiscard]] PreviewColumns columns_of(const PreviewRow& row);

class RowTracer {
 public:
  /// Builds the world, unless `worlds`, the cache of this scene, has it. Throws Stopped when cancelled.
  RowTracer(const Scene& scene, const PreviewSettings& settings, WorldCache& worlds, const Stop& stop = {});
  ~RowTracer();
  RowTracer(RowTracer&&) noexcept;
  RowTracer& operator=(RowTracer&&) noexcept;

  /// In any order, in any thread, any number of times. Throws Stopped when cancelled, also inside a pixel.
  [[nodiscard]] TracedRow trace(const PreviewRow& row, const Stop& stop = {}) const;

 private:
  class Tracing;
  template <class T>
  class TracingIn;
  std::unique_ptr<Tracing> tracing_;
};

}  // namespace raywalk
