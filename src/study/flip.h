#pragma once

#include "image/image_file.h"

#include <vector>

namespace raywalk {

/// Pixels per degree of visual angle: of a screen 0.7 m wide with 3840 pixels, seen from 0.7 m, as in the paper.
inline constexpr double default_pixels_per_degree = 67.0206;

/// How visible the difference is when the two pictures are shown alternately, for each pixel, from 0 to 1: P.
/// Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom and M. Fairchild, "FLIP: A Difference Evaluator
/// for Alternating Images", PACMCGIT 3(2), 2020. For pictures as a screen shows them: values outside 0..1 are clamped.
/// Both are of the same size, and finite. Top row first.
[[nodiscard]] std::vector<float> flip_map(const Image& reference, const Image& test,
                                          double pixels_per_degree = default_pixels_per_degree);

}  // namespace raywalk
