#pragma once
// How far one picture is from another.

#include "image/image_file.h"

#include <optional>
#include <string>

namespace raywalk {

struct ImageMetrics {
  double mse = 0;      ///< mean squared difference of the channels, linear light
  double rel_mse = 0;  ///< the same, each over the reference's square + 0.01 (F. Rousselle et al., TOG 30(6), 2011)
  double psnr = 0;     ///< decibels, of what a screen shows (sRGB, 0..1); infinite for equal pictures
  double flip = 0;     ///< mean of flip_map (study/flip.h)
  double percentile99 = 0;              ///< of the pixels' largest channel differences, linear light
  double worst = 0;                     ///< the largest of them
  int worst_column = 0, worst_row = 0;  ///< where that is
};

/// Why the two cannot be compared: not of one size, or not finite somewhere.
[[nodiscard]] std::optional<Error> why_not_comparable(const Image& test, const Image& reference);

/// Both comparable.
[[nodiscard]] ImageMetrics compare_images(const Image& test, const Image& reference);

/// Test - reference, for each channel.
[[nodiscard]] Image difference_image(const Image& test, const Image& reference);

/// flip_map as colours, from dark (no difference) to light (render/heat.h).
[[nodiscard]] Image flip_image(const Image& test, const Image& reference);

}  // namespace raywalk
