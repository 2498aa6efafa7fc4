#pragma once

#include "math/vec.h"
#include "scene/material.h"

#include <array>

namespace raywalk {

/// The index of refraction eta + i k of a metal for red, green and blue light: 650, 550 and 450 nm.
struct MetalIndex {
  Rgbd eta, k;
};

/// Interpolated linearly between the wavelengths measured by H.-J. Hagemann, W. Gudat and C. Kunz, "Optical Constants
/// from the Far Infrared to the X-Ray Region: Mg, Al, Cu, Ag, Au, Bi, C, and Al2O3", DESY report SR-74/7, 1974 (tables
/// 3 and 5). Not of MirrorKind::ideal.
[[nodiscard]] inline MetalIndex refractive_index(MirrorKind metal) {
  /// Of the wavelengths next below and above: where it lies between, and the index at both.
  struct Between {
    double below, above;
    std::array<double, 2> eta, k;
  };
  const auto index = [](const Between& red, const Between& green, const Between& blue) {
    MetalIndex at{};
    const std::array<const Between*, 3> colours{&red, &green, &blue};
    constexpr std::array wavelengths{650., 550., 450.};
    for (std::size_t c = 0; c < colours.size(); ++c) {
      const Between& of = *colours[c];
      const double share = (wavelengths[c] - of.below) / (of.above - of.below);
      at.eta[static_cast<int>(c)] = of.eta[0] + share * (of.eta[1] - of.eta[0]);
      at.k[static_cast<int>(c)] = of.k[0] + share * (of.k[1] - of.k[0]);
    }
    return at;
  };
  switch (metal) {
    case MirrorKind::gold:
      return index({619.9, 826.5, {0.487, 0.418}, {3.31, 5.13}}, {516.6, 563.5, {0.878, 0.613}, {2.01, 2.64}},
                   {442.8, 476.8, {1.826, 1.541}, {1.81, 1.71}});
    case MirrorKind::copper:
      return index({619.9, 652.5, {0.272, 0.214}, {3.24, 3.67}}, {539.1, 563.6, {1.037, 0.826}, {2.59, 2.60}},
                   {442.8, 476.9, {1.169, 1.152}, {2.36, 2.50}});
    case MirrorKind::silver:
      return index({619.9, 826.6, {0.269, 0.271}, {4.18, 5.80}}, {495.9, 619.9, {0.237, 0.269}, {3.09, 4.18}},
                   {413.3, 495.9, {0.226, 0.237}, {2.28, 3.09}});
    case MirrorKind::aluminium:
      return index({619.9, 688.8, {1.292, 1.731}, {7.28, 7.96}}, {495.9, 619.9, {0.771, 1.292}, {5.91, 7.28}},
                   {413.3, 495.9, {0.548, 0.771}, {5.00, 5.91}});
    case MirrorKind::ideal:
      break;
  }
  return {Rgbd(1.0), Rgbd(0.0)};
}

/// The share of light that a metal reflects of what comes straight at it.
[[nodiscard]] inline Rgbd reflectance_at_right_angles(MirrorKind metal) {
  const auto [eta, k] = refractive_index(metal);
  const Rgbd one(1.0);
  return ((eta - one) * (eta - one) + k * k) / ((eta + one) * (eta + one) + k * k);
}

}  // namespace raywalk
