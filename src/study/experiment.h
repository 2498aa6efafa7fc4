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

/// How much is computed: for a test, for minutes, or until the results are sharp.
enum class Effort { glance, quick, full };
/// The one of three numbers that belongs to an effort.
[[nodiscard]] constexpr int by_effort(Effort effort, int full, int quick, int glance) {
  return effort == Effort::full ? full : effort == Effort::quick ? quick : glance;
}

/// Deliberate faults, for tests that a study finds them.
struct Faults {
  double shifted = 0;          ///< every sample is shifted by this fraction of a pixel: a biased sampler
  double reference = 1;        ///< factor on the reference values
  bool shuffled_seed = false;  ///< each sample draws with another seed
};

struct Experiment {
  std::string number, name, title;  ///< "E3", "samples", "Samples and samplers"
  std::string question;             ///< in a sentence or two
  Columns columns;
  int rounds = 24;
  double weight = 1;  ///< relative duration of all rounds
  /// All trials of one round, interleaved. Ends early when stopped; such a round is discarded.
  std::function<std::vector<Trial>(int round, const Stop& stop)> run;
  /// From all rounds.
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
[[nodiscard]] Experiment photon_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment radiosity_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment scattering_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment sky_experiment(Effort effort, const Faults& faults = {});
[[nodiscard]] Experiment width_experiment(Effort effort);

/// In the order of their numbers.
[[nodiscard]] std::vector<Experiment> all_experiments(Effort effort);

}  // namespace raywalk::study
