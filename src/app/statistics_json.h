#pragma once

#include "render/render.h"

#include <string>

namespace raywalk {

/// Context of a render's statistics.
struct RenderReport {
  std::string scene, image;  ///< paths
  ImageSize size;
  Sampling sampling;
  RenderChoices choices;
  TraceLimits limits;
  Precision precision = Precision::double_;
  double load_seconds = 0, write_seconds = 0;
};

/// The statistics as JSON, with a newline at the end: `rays`, `ended`, `tests`, `random_draws`, `seconds`, `threads`,
/// `effects` and what was rendered. Names are those of ray_kind_name, ending_name and effect_name.
[[nodiscard]] std::string statistics_json(const Rendering& rendering, const RenderReport& report);

}  // namespace raywalk
