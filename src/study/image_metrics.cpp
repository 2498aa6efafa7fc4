#include "study/image_metrics.h"

#include "image/srgb.h"
#include "render/heat.h"
#include "study/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raywalk {

namespace {

double shown(float linear) { return srgb_encode(std::clamp(static_cast<double>(linear), 0.0, 1.0)); }

std::optional<Error> not_finite(const Image& image, std::string_view which) {
  const auto bad = std::count_if(image.pixels.begin(), image.pixels.end(),
                                 [](const Rgb<float>& pixel) { return !is_finite(pixel); });
  if (bad == 0) return std::nullopt;
  return Error{"", 0, 0,
               fmt::format("{} of {} pixels of the {} picture are no finite numbers", bad, image.pixels.size(), which),
               "raywalk render warns of them: strengths or colours of the scene may be too large to add up"};
}

}  // namespace

std::optional<Error> why_not_comparable(const Image& test, const Image& reference) {
  if (test.width != reference.width || test.height != reference.height)
    return Error{"", 0, 0,
                 fmt::format("the pictures are of different sizes ({} x {} and {} x {} pixels; expected the same)",
                             test.width, test.height, reference.width, reference.height),
                 "render both with the same --size"};
  if (test.pixels.empty())
    return Error{"", 0, 0, "the pictures are empty (expected at least one pixel)", "are these the right files?"};
  if (auto why = not_finite(test, "first")) return why;
  return not_finite(reference, "second");
}

ImageMetrics compare_images(const Image& test, const Image& reference) {
  ImageMetrics metrics;
  double shown_mse = 0;
  std::vector<double> differences;
  differences.reserve(test.pixels.size());
  for (std::size_t i = 0; i < test.pixels.size(); ++i) {
    double largest = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const float a = test.pixels[i][channel], b = reference.pixels[i][channel];
      const double difference = static_cast<double>(a) - static_cast<double>(b), square = difference * difference;
      constexpr double little = 0.01;
      metrics.mse += square;
      metrics.rel_mse += square / (static_cast<double>(b) * static_cast<double>(b) + little);
      const double on_screen = shown(a) - shown(b);
      shown_mse += on_screen * on_screen;
      largest = std::max(largest, std::abs(difference));
    }
    if (largest > metrics.worst) {
      metrics.worst = largest;
      metrics.worst_column = static_cast<int>(i) % test.width;
      metrics.worst_row = static_cast<int>(i) / test.width;
    }
    differences.push_back(largest);
  }
  const double channels = 3 * static_cast<double>(test.pixels.size());
  metrics.mse /= channels;
  metrics.rel_mse /= channels;
  metrics.psnr = -10 * std::log10(shown_mse / channels);
  const std::vector<float> map = flip_map(reference, test);
  metrics.flip = std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
  // The smallest difference that at least 99% of the pixels do not exceed.
  const std::size_t rank = (99 * differences.size() + 99) / 100 - 1;
  std::nth_element(differences.begin(), differences.begin() + static_cast<std::ptrdiff_t>(rank), differences.end());
  metrics.percentile99 = differences[rank];
  return metrics;
}

Image difference_image(const Image& test, const Image& reference) {
  Image image = test;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] -= reference.pixels[i];
  return image;
}

Image flip_image(const Image& test, const Image& reference) {
  Image image{test.width, test.height, {}};
  for (const float error : flip_map(reference, test)) {
    const auto colour = heat_colour(static_cast<double>(error));
    const auto linear = [&](std::size_t i) { return static_cast<float>(srgb_decode(colour[i] / 255.0)); };
    image.pixels.emplace_back(linear(0), linear(1), linear(2));
  }
  return image;
}

}  // namespace raywalk
