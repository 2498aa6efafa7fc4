#pragma once
// Where a scene's render time goes: what each effect that it uses adds, and what all effects would cost.

#include "math/stop.h"
#include "scene/effects.h"
#include "study/trial.h"

#include <functional>
#include <optional>
#include <vector>

namespace raywalk::study {

/// The scene without an effect: no mirror, no lens, one sample per pixel ... None for shadows, which a tracer cannot
/// leave out alone.
[[nodiscard]] std::optional<Scene> without(const Scene& scene, Effect effect);

/// The scene for a tracer that always computes every effect: a reflect and a refract ray at every hit, both drawn from
/// a lobe, `grid` x `grid` shadow rays to every light, and a lens and a time sample for every primary ray. Each has so
/// small a weight or offset that the picture stays the same.
[[nodiscard]] Scene with_everything(const Scene& scene, int grid);

/// Two rays at every hit double them at every depth: here a pixel has a thousand, and beyond it soon no end.
inline constexpr int deepest_everything = 10;

struct EffectCost {
  Effect effect;
  Cost saved;  ///< what the scene without the effect saves; seconds may be negative by chance
  double rays_share = 0, seconds_share = 0;  ///< of the whole
  double seconds_low = 0, seconds_high = 0;  ///< share; the interval of the median of the repetitions, 95%
};

struct SceneCost {
  ImageSize size;                   ///< of the pictures that were measured
  int repetitions = 0;              ///< of each
  Cost whole;                       ///< seconds: the median
  std::vector<EffectCost> effects;  ///< those that the scene uses and that can be left out, costliest first
  std::uint64_t shadow_rays = 0;    ///< of the whole
  /// Of with_everything at `everything_grid`; absent where it cannot be measured: beyond deepest_everything.
  std::optional<Cost> everything;
  int everything_grid = 4;
};

/// Measures picture by picture, so that its progress can be shown: each repetition renders a small picture of the
/// scene, without each effect, and with everything, in turn.
class CostSurvey {
 public:
  /// Pictures of about `samples` samples; every pixel takes all its samples. repetitions >= 1, not counting the
  /// warm-up.
  CostSurvey(const Scene& scene, int samples, int repetitions);

  /// Renders the next picture; returns whether any is left. Throws Stopped when cancelled through `stop`: the next
  /// call begins the picture again.
  bool work(const Stop& stop = {});
  /// Fraction of the pictures that are rendered, 0..1.
  [[nodiscard]] double done() const;
  /// The result of the repetitions so far; empty before the first is complete.
  [[nodiscard]] std::optional<SceneCost> result() const;

 private:
  SceneCost blank_;            ///< what does not depend on the measurements
  std::vector<Scene> scenes_;  ///< the whole, without each of blank_.effects, and everything if it can be measured
  std::vector<std::vector<Cost>> costs_;
  std::size_t next_ = 0;  ///< picture, counted over all repetitions
};

/// Runs a whole survey. Empty when stopped.
[[nodiscard]] std::optional<SceneCost> scene_cost(const Scene& scene, int samples = 8000, int repetitions = 7,
                                                  const std::function<void(double done)>& progress = {},
                                                  const Stop& stop = {});

}  // namespace raywalk::study
