#pragma once
// Where the time of a scene goes: what each effect that it calls for adds, and what all effects would cost.

#include "math/stop.h"
#include "scene/effects.h"
#include "study/trial.h"

#include <functional>
#include <optional>
#include <vector>

namespace raywalk::study {

/// The scene as if it did not call for an effect: no mirror, no lens, one sample a pixel ... Nothing for what a tracer
/// cannot leave out by itself: shadows.
[[nodiscard]] std::optional<Scene> without(const Scene& scene, Effect effect);

/// The scene as a tracer sees it that does not ask what a scene calls for: a reflect and a refract ray at every hit,
/// both drawn from a lobe, `grid` x `grid` shadow rays to every lamp, and a drawn point of the lens and of the
/// shutter's time for every primary ray. Each weighs so little, or lies so near to where it was, that the picture stays
/// what it is.
[[nodiscard]] Scene with_everything(const Scene& scene, int grid);

struct EffectCost {
  Effect effect;
  Cost saved;  ///< of the whole, what is not there without the effect; seconds may be negative by chance
  double rays_share = 0, seconds_share = 0;  ///< of the whole
  double seconds_low = 0, seconds_high = 0;  ///< share; the interval of the median of the repetitions, 95%
};

struct SceneCost {
  ImageSize size;                   ///< of the pictures that were measured
  int repetitions = 0;              ///< of each
  Cost whole;                       ///< seconds: the median
  std::vector<EffectCost> effects;  ///< those that the scene calls for and that can be left out, dearest first
  std::uint64_t shadow_rays = 0;    ///< of the whole
  Cost everything;                  ///< of with_everything at `everything_grid`
  int everything_grid = 4;
};

/// Measures picture by picture, so that a person can look on: each repetition renders a small picture of the scene, of
/// it with everything, and of it without each effect, in turns.
class CostSurvey {
 public:
  /// Pictures of about `samples` samples; every pixel takes all its samples. repetitions >= 1, the one that warms up
  /// not counted.
  CostSurvey(const Scene& scene, int samples, int repetitions);

  /// Renders the next picture. Whether any is left.
  bool work();
  /// Share of the pictures that are rendered, 0..1.
  [[nodiscard]] double done() const;
  /// What the repetitions so far tell; empty before the first one is complete.
  [[nodiscard]] std::optional<SceneCost> result() const;

 private:
  SceneCost blank_;            ///< what does not depend on the measurements
  std::vector<Scene> scenes_;  ///< the whole, everything, without each of blank_.effects
  std::vector<std::vector<Cost>> costs_;
  std::size_t next_ = 0;  ///< picture, counted over all repetitions
};

/// A survey to its end. Empty when stopped.
[[nodiscard]] std::optional<SceneCost> scene_cost(const Scene& scene, int samples = 8000, int repetitions = 7,
                                                  const std::function<void(double done)>& progress = {},
                                                  const Stop& stop = {});

}  // namespace raywalk::study
