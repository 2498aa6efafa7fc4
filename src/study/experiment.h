#pragma once
// An experiment: rounds of trials, and what follows from them.

#include "math/stop.h"
#include "study/report.h"
#include "study/trial.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raywalk::study {

/// How much is computed: in a test, in minutes, or as long as it takes to be sharp.
enum class Effort { glance, quick, full };

/// Mistakes made on purpose, so that tests see a study find them.
struct Faults {
  double shifted = 0;          ///< every sample of a pixel lies this much of a pixel aside: a biased sampler
  double reference = 1;        ///< what is taken for the truth is this many times the truth
  bool shuffled_seed = false;  ///< each sample draws with another seed
};

struct Experiment {
  std::string number, name, title;  ///< "E3", "samples", "Samples and samplers"
  std::string question;             ///< what it asks, in a sentence or two
  Columns columns;
  int rounds = 24;
  double weight = 1;  ///< how long all rounds take beside those of other experiments
  /// All trials of one round, interleaved. Stops early when asked to; such a round counts for nothing.
  std::function<std::vector<Trial>(int round, const Stop& stop)> run;
  /// Of all rounds.
  std::function<Report(const std::vector<Trial>&)> conclude;
};

[[nodiscard]] Experiment numerics_experiment(Effort effort);
[[nodiscard]] Experiment offsets_experiment(Effort effort);
[[nodiscard]] Experiment samples_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment depth_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment endings_experiment(Effort effort);
[[nodiscard]] Experiment lights_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment structures_experiment(Effort effort);
[[nodiscard]] Experiment constants_experiment(Effort effort);
[[nodiscard]] Experiment adaptive_experiment(Effort effort);
[[nodiscard]] Experiment tessellation_experiment(Effort effort);
[[nodiscard]] Experiment scene_experiment(Effort effort);

/// In the order of their numbers.
[[nodiscard]] std::vector<Experiment> all_experiments(Effort effort);

}  // namespace raywalk::study
