#pragma once
// One scene under several settings: the cost of each, and the error of its picture. In time slices, so that progress
// can be shown.

#include "accel/accelerator.h"
#include "image/image_file.h"
#include "math/stop.h"
#include "math/words.h"
#include "study/trial.h"
#include "trace/kernel.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raywalk::study {

/// A value for each knob.
struct Setup {
  int samples = 16;  ///< of each pixel, >= 1; with a tolerance, at most
  Sampler sampler = Sampler::jittered;
  int light_grid = 0;    ///< n x n rays to an area light; 0: each light's own
  int depth = 5;         ///< >= 1
  double threshold = 0;  ///< of contribution, 0..1
  bool single_precision = false;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  double tolerance = 0;  ///< of adaptive sampling; 0: every pixel takes all samples
  Numerics numerics = Numerics::robust;
  double epsilon = default_epsilon;  ///< of naive numerics, in scene units; the default with robust ones
  friend bool operator==(const Setup&, const Setup&) = default;
};

/// The scene's own setup.
[[nodiscard]] Setup setup_of(const Scene& scene);
/// The scene under a setup; precision and accelerator are not part of a scene.
[[nodiscard]] Scene under(const Scene& scene, const Setup& setup);

/// A setup that was tried.
struct Attempt {
  Setup setup;
  double done = 0;  ///< 0..1; below 1 the rest is not available
  Image image{};
  Cost cost{};       ///< seconds: of one thread
  double error = 0;  ///< 0 before there is a reference; root of the mean squared difference of its channels from the
                     ///< reference, linear light
};

/// What a workbench has found, as told by another program that has one of the same scene and setups.
struct Findings {
  std::vector<Attempt> attempts;  ///< the first ones, without setups; an image that was told before is left out
  Image reference;                ///< left out where it was told before
  int reference_samples = 0;
  double floor = 0;
};

/// Which cost is compared with the error.
enum class CostAxis {
  seconds,
  rays,
  tests,  ///< of boxes, cells and primitives
};
[[nodiscard]] double cost_on(CostAxis axis, const Cost& cost);

/// The Pareto front of the finished attempts, cheapest first: whatever costs no more has a larger error.
[[nodiscard]] std::vector<int> frontier(const std::vector<Attempt>& attempts, CostAxis axis);

/// Traces attempts in order and, if none is waiting, the reference: in double precision, deeper by `deeper` than any
/// attempt, without a threshold, with robust numerics, as the mean of independent pictures. The error of the reference
/// is estimated from its two halves: floor().
class Workbench {
 public:
  static constexpr int deeper = 3;
  static constexpr int samples_a_pass = 16, max_passes = 64;

  Workbench();
  ~Workbench();
  Workbench(Workbench&&) noexcept;
  Workbench& operator=(Workbench&&) noexcept;

  /// Restarts with this scene, this picture size, and these setups.
  void reset(const Scene& scene, ImageSize size, const std::vector<Setup>& setups);
  /// Adds a setup; an existing one is not traced again.
  void try_out(const Setup& setup);

  /// Works for about `milliseconds`, at least one row. Returns whether anything is left to do. Throws Stopped when
  /// cancelled through `stop`, also inside a pixel: the next call goes on from there.
  bool work(double milliseconds, const Stop& stop = {});
  [[nodiscard]] bool finished() const;
  /// Instead of work().
  void show(Findings found);

  [[nodiscard]] const std::vector<Attempt>& attempts() const { return attempts_; }
  /// The mean of the passes so far; empty before the second one is done.
  [[nodiscard]] const Image& reference() const { return reference_; }
  /// Its samples per pixel.
  [[nodiscard]] int reference_samples() const { return passes_ * samples_a_pass; }
  /// The estimated root mean squared error of the reference itself; smaller errors are not measurable.
  [[nodiscard]] double floor() const { return floor_; }
  /// Changes whenever any of the above does.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  class Development;

 private:
  void begin(const Stop& stop);
  void end();
  void take_reference();
  void forget_reference(int depth);
  [[nodiscard]] double error_of(const Attempt& attempt) const;

  std::unique_ptr<Scene> scene_;
  ImageSize size_{};
  std::vector<Attempt> attempts_;
  std::unique_ptr<Development> under_way_;
  int attempt_ = -1;  ///< in progress; -1: a pass of the reference
  int depth_ = 0;     ///< of the reference
  std::vector<Rgbd> halves_[2];
  Image reference_;
  int passes_ = 0;
  double floor_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace raywalk::study

namespace raywalk {
template <>
inline constexpr Word<study::CostAxis> words_of<study::CostAxis>[] = {
    {study::CostAxis::rays, "rays"}, {study::CostAxis::tests, "tests"}, {study::CostAxis::seconds, "seconds"}};
}  // namespace raywalk
