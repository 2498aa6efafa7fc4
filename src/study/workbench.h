#pragma once
// One scene under several settings: what each costs, and how far its picture is from the right one. In slices of time,
// so that a person can look on.

#include "accel/accelerator.h"
#include "io/image.h"
#include "study/trial.h"
#include "trace/kernel.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raywalk::study {

/// A position for each knob.
struct Setup {
  int samples = 16;  ///< of each pixel, >= 1; with a tolerance, at most
  Sampler sampler = Sampler::jittered;
  int light_grid = 0;    ///< n x n rays to an area light; 0: as many as each light says
  int depth = 5;         ///< >= 1
  double threshold = 0;  ///< of contribution, 0..1
  bool single_precision = false;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  double tolerance = 0;  ///< of adaptive sampling; 0: every pixel takes all samples
  Numerics numerics = Numerics::robust;
  double epsilon = usual_epsilon;  ///< of naive numerics, in scene units; with robust ones the usual
  friend bool operator==(const Setup&, const Setup&) = default;
};

/// As the scene's file has it.
[[nodiscard]] Setup setup_of(const Scene& scene);
/// The scene under a setup; precision and accelerator are not the scene's.
[[nodiscard]] Scene under(const Scene& scene, const Setup& setup);

/// A setup that was tried.
struct Attempt {
  Setup setup;
  double done = 0;  ///< 0..1; below 1 nothing of the following is there
  Image image{};
  Cost cost{};       ///< seconds: of one thread
  double error = 0;  ///< 0 before there is a reference; root of the mean squared difference of its channels from the
                     ///< reference, linear light
};

/// Which cost a picture is weighed against.
enum class CostAxis {
  seconds,
  rays,
  tests,  ///< of boxes, cells and primitives
};
[[nodiscard]] double cost_on(CostAxis axis, const Cost& cost);

/// The finished attempts that no other one beats, cheapest first: whatever costs no more errs more.
[[nodiscard]] std::vector<int> frontier(const std::vector<Attempt>& attempts, CostAxis axis);

/// Traces attempts one after the other and, when none waits, the reference: in double precision, deeper by
/// `deeper` than any attempt, without a threshold, with robust
/// numerics, as the mean of pictures that draw independently of each other.
/// What is still to come off the reference is known from its two halves: floor().
class Workbench {
 public:
  static constexpr int deeper = 3;
  static constexpr int samples_a_pass = 16, most_passes = 64;

  Workbench();
  ~Workbench();
  Workbench(Workbench&&) noexcept;
  Workbench& operator=(Workbench&&) noexcept;

  /// Starts afresh with this scene, in pictures of this size, and these setups.
  void reset(const Scene& scene, ImageSize size, const std::vector<Setup>& setups);
  /// Also this one; one that is there already is not traced again.
  void try_out(const Setup& setup);

  /// Works for about `milliseconds`, and one row at least. Whether anything is left to do.
  bool work(double milliseconds);
  [[nodiscard]] bool finished() const;

  [[nodiscard]] const std::vector<Attempt>& attempts() const { return attempts_; }
  /// The mean of the passes so far; empty before the second one is done.
  [[nodiscard]] const Image& reference() const { return reference_; }
  /// Samples of each pixel in it.
  [[nodiscard]] int reference_samples() const { return passes_ * samples_a_pass; }
  /// The root of the mean squared error that the reference itself still has, estimated; no smaller error can be told.
  [[nodiscard]] double floor() const { return floor_; }
  /// Another number whenever any of the above has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  class Development;

 private:
  void begin();
  void end();
  void take_reference();
  void forget_reference(int depth);
  [[nodiscard]] double error_of(const Attempt& attempt) const;

  std::unique_ptr<Scene> scene_;
  ImageSize size_{};
  std::vector<Attempt> attempts_;
  std::unique_ptr<Development> under_way_;
  int attempt_ = -1;  ///< that is under way; -1: a pass of the reference
  int depth_ = 0;     ///< of the reference
  std::vector<Rgbd> halves_[2];
  Image reference_;
  int passes_ = 0;
  double floor_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace raywalk::study
