#include "study/experiment.h"

namespace raywalk::study {

std::vector<Experiment> all_experiments(Effort effort) {
  return {numerics_experiment(effort),     offsets_experiment(effort),    samples_experiment(effort),
          depth_experiment(effort),        endings_experiment(effort),    lights_experiment(effort),
          structures_experiment(effort),   constants_experiment(effort),  adaptive_experiment(effort),
          tessellation_experiment(effort), scene_experiment(effort),      photon_experiment(effort),
          radiosity_experiment(effort),    scattering_experiment(effort), sky_experiment(effort),
          width_experiment(effort)};
}

}  // namespace raywalk::study
