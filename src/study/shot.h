#pragma once
// Small pictures for experiments, in this thread.

#include "math/stop.h"
#include "render/film.h"
#include "study/experiment.h"
#include "trace/path.h"

#include <optional>

namespace raywalk::study {

struct Shot {
  Film<double> film;
  Cost cost;  ///< of tracing, without the preparation
  std::uint64_t shadow_rays = 0;
};

/// `shuffled`: each sample has its own seed, which a renderer must not do. `paths`: path length, for the path
/// integrator only. Throws Stopped when cancelled through `stop`.
[[nodiscard]] Shot shoot(const Scene& scene, ImageSize size, Sampling sampling, bool shuffled = false,
                         const std::optional<PathSettings>& paths = std::nullopt, const Stop& stop = {});

/// The size of a picture of the same aspect ratio with at most about `pixels` pixels.
[[nodiscard]] ImageSize shrunk(ImageSize size, double pixels);

/// A camera that looks straight down from (x, y, height) at z = 0, x to the right and y up. `half`: half the visible
/// width there.
[[nodiscard]] Camera looking_down(double x, double y, double height, double half);

/// The differences of all pixels' red from `truth`.
struct Compared {
  double rms = 0;   ///< root of the mean squared difference
  double mean = 0;  ///< the mean difference
};
[[nodiscard]] Compared compared(const Film<double>& film, const std::function<double(int column, int row)>& truth);

/// A number in [0, 1) that depends on the round and on `which` only.
[[nodiscard]] double drawn_for(int round, int which);

/// The seed of a round: rounds draw independently of each other.
[[nodiscard]] inline std::uint64_t seed_of(int round) { return 1000 + static_cast<std::uint64_t>(round); }

}  // namespace raywalk::study
