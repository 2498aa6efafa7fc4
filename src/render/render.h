#pragma once

#include "math/stop.h"
#include "render/film.h"
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
  double done = 0;          ///< share of the work, 0..1
  double seconds = 0;       ///< since the trace began
  double seconds_left = 0;  ///< an estimate from the above; 0 while there is none
};

/// How to render. Nothing here but `size`, `sampling`, `precision`, `tolerance` and `fault` can change a bit of the
/// picture. What the scene chooses (Scene::render) is its integrator, sampler and light grid; samples and tolerance are
/// stated here.
struct RenderSettings {
  std::optional<ImageSize> size{};  ///< of the whole image, each side >= 1; absent: the scene's own
  Sampling sampling{};
  Precision precision = Precision::double_;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  std::optional<Fault> fault{};  ///< breaks the tracer on purpose
  int threads = 0;               ///< 0: as many as the machine runs at once

  /// Whether shadow rays first try what hid the same light last; absent: with any structure but a list, whose few
  /// objects are soon tested.
  std::optional<bool> shadow_cache{};
  /// Of adaptive sampling (render/adaptive.h), in what a screen shows from 0 to 1; 0: every pixel takes all its
  /// samples.
  double tolerance = 0;

  /// Told now and then, in the thread that called `render`.
  std::function<void(const Progress&)> progress{};
  /// Told before the trace where a pixel may take more rays than one would wait for.
  std::function<void(const TreeSize&)> endless{};
  /// Once raised, the render ends soon and returns what is done: whole samples only.
  Stop stop{};
  /// For tests: brings the tiles, numbered from 0 on, into another order.
  std::function<void(std::vector<int>& tiles)> reorder_tiles{};
};

/// A picture and what it took.
struct Rendering {
  std::variant<Film<double>, Film<float>> film;  ///< the alternative that the precision asked for
  Statistics statistics;  ///< of what was stopped inside a pixel, without the pixels nearest to that
  Effects effects;
  AcceleratorKind accelerator = AcceleratorKind::none;  ///< what was built
  AcceleratorStatistics structure;
  double build_seconds = 0, trace_seconds = 0;
  int threads = 1;                     ///< that took part
  std::vector<double> busy_seconds{};  ///< of each thread that traced
  double done = 1;       ///< share of the samples taken; below 1 only when stopped. What is missing is black
  bool finished = true;  ///< every sample was taken

  /// Pixels that the picture's file holds as NaN or infinite.
  [[nodiscard]] std::size_t not_finite_pixels() const {
    return std::visit([](const auto& of) { return not_finite(of); }, film);
  }
  /// Threads that were at work on the average; the number of threads when the work was shared evenly.
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
};

/// The scene's image. Fails only when it does not fit into memory, or its depth not on the stack.
[[nodiscard]] Result<Rendering> render(const Scene& scene, const RenderSettings& settings = {});

/// The strip: one row of as many pixels as SCREEN has cells. For a planar scene, at one sample a pixel, cell i equals
/// bit for bit pixel k i + (k - 1) / 2 of the middle row of every image of that size that has an odd number of rows and
/// k times the cells in columns, k odd. With more samples that holds for k = 1. `settings.size` is that of the image.
/// Cells have no corners: `settings.sampling.corners` is not heeded.
[[nodiscard]] Result<Rendering> render_strip(const Scene& scene, const RenderSettings& settings = {});

}  // namespace raywalk
