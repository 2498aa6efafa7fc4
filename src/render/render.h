#pragma once

#include "math/stop.h"
#include "render/film.h"
#include "render/tiles.h"
#include "render/tree_size.h"
#include "trace/kernel.h"

#include <functional>
#include <numeric>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// How far a render has come.
struct Progress {
  double done = 0;          ///< fraction of the work, 0..1
  double seconds = 0;       ///< since the trace began
  double seconds_left = 0;  ///< estimated; 0 if unknown
};

/// How to render. Nothing here but `size`, `sampling`, `precision`, `tolerance` and `fault` can change a bit of the
/// picture. The scene (Scene::render) chooses integrator, sampler and light grid; samples and tolerance are set here.
struct RenderSettings {
  std::optional<ImageSize> size{};  ///< of the whole image, each side >= 1; absent: the scene's own
  Sampling sampling{};
  Precision precision = Precision::double_;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  BuildQuality build = BuildQuality::automatic;
  std::optional<Fault> fault{};  ///< breaks the tracer on purpose
  int threads = 0;               ///< 0: as many as the machine runs concurrently

  /// Whether shadow rays first test the last blocker of the same light; absent: with any structure but a list, whose
  /// few objects are quickly tested.
  std::optional<bool> shadow_cache{};
  /// Of adaptive sampling (render/adaptive.h), in display values from 0 to 1; 0: every pixel takes all its samples.
  double tolerance = 0;

  /// Renders only this share: the film's other pixels mean nothing. Where corners are sampled, it is that of the
  /// corners, for pixels at a share's edge need those of others.
  std::optional<Share> share{};

  /// Called regularly, in the thread that called `render`.
  std::function<void(const Progress&)> progress{};
  /// Called before the trace if a pixel may take impractically many rays.
  std::function<void(const TreeSize&)> endless{};
  /// When raised, the render ends soon and returns what is done: complete samples only.
  Stop stop{};
  /// For tests: permutes the tiles, numbered from 0.
  std::function<void(std::vector<int>& tiles)> reorder_tiles{};
};

/// A picture and what it cost.
struct Rendering {
  std::variant<Film<double>, Film<float>> film;  ///< the alternative for the requested precision
  Statistics statistics;                         ///< when cancelled, without the blocks that were incomplete
  Effects effects;
  AcceleratorKind accelerator = AcceleratorKind::none;  ///< what was built
  AcceleratorStatistics structure;
  double build_seconds = 0, trace_seconds = 0;
  int threads = 1;                     ///< that took part
  std::vector<double> busy_seconds{};  ///< of each thread that traced
  double done = 1;       ///< fraction of the samples taken; below 1 only when cancelled. Missing pixels are black
  bool finished = true;  ///< all samples were taken

  std::size_t not_finite_pixels = 0;  ///< NaN or infinite in the picture's file
  /// The average number of threads at work; equals `threads` for perfect load balancing.
  [[nodiscard]] double busy_threads() const {
    return trace_seconds > 0 ? std::accumulate(busy_seconds.begin(), busy_seconds.end(), 0.0) / trace_seconds : 1;
  }
  template <class T>
  [[nodiscard]] const Film<T>& film_of() const {
    return std::get<Film<T>>(film);
  }
  [[nodiscard]] Image image() const {
    return std::visit([](const auto& of) { return image_of(of); }, film);
  }
  /// The same row by row, for as long as this lives.
  [[nodiscard]] ImageRows rows() const {
    return std::visit([](const auto& of) { return rows_of(of); }, film);
  }
};

/// Renders the scene's image. Fails only when it does not fit into memory, or its depth not onto the stack.
[[nodiscard]] Result<Rendering> render(const Scene& scene, const RenderSettings& settings = {});

/// The strip: one row of as many pixels as SCREEN has cells. For a planar scene, at one sample a pixel, cell i equals
/// bit for bit pixel k i + (k - 1) / 2 of the middle row of every image of that size that has an odd number of rows and
/// k times the cells in columns, k odd. With more samples that holds for k = 1. `settings.size` is that of the image.
/// Cells have no corners: `settings.sampling.corners` is ignored.
[[nodiscard]] Result<Rendering> render_strip(const Scene& scene, const RenderSettings& settings = {});

}  // namespace raywalk
