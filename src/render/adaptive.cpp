#include "render/adaptive.h"

#include "image/srgb.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raywalk {

namespace {

/// As a screen shows it, 0..1.
double shown(double linear) { return srgb_encode(std::clamp(linear, 0.0, 1.0)); }

/// The probability that a normal variable is farther than x >= 0 standard deviations from its mean: M. Abramowitz and
/// I. Stegun, Handbook of Mathematical Functions, 26.2.11 and 26.2.14.
double two_sided_tail(double x) {
  const double density = std::sqrt(2 / std::numbers::pi) * portable::exp(-x * x / 2);
  if (x > 2) {
    double fraction = x;
    for (int k = 100; k > 0; --k) fraction = x + k / fraction;
    return density / fraction;
  }
  double sum = 0, term = x;
  for (int odd = 3; sum + term != sum; odd += 2) sum += std::exchange(term, term * (x * x / odd));
  return 1 - density * sum;
}

/// The two-sided quantile of the normal distribution, by bisection.
double normal_quantile(double two_sided) {
  double low = 0, high = 40;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (two_sided_tail(middle) > two_sided ? low : high) = middle;
  }
  return low;
}

}  // namespace

double student_quantile(double two_sided, int freedom) {
  // M. Abramowitz and I. Stegun, Handbook of Mathematical Functions, 26.7.5.
  const double x = normal_quantile(two_sided), v = freedom, x2 = x * x;
  const double g1 = x * (x2 + 1) / 4;
  const double g2 = x * ((5 * x2 + 16) * x2 + 3) / 96;
  const double g3 = x * (((3 * x2 + 19) * x2 + 17) * x2 - 15) / 384;
  const double g4 = x * ((((79 * x2 + 776) * x2 + 1482) * x2 - 1920) * x2 - 945) / 92160;
  return x + (g1 + (g2 + (g3 + g4 / v) / v) / v) / v;
}

template <class T>
Adaptive<T>::Adaptive(ImageSize size, int most, double tolerance)
    : size_(size),
      most_(most),
      to_(most),
      tolerance_(tolerance),
      expected_(static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                static_cast<std::uint64_t>(most)) {
  if (!(tolerance > 0) || most <= first_look) return;
  to_ = first_look;
  for (int look = first_look; look < most; look *= 2) ++looks_;
  spread_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), Vec3<float>(0));
}

template <class T>
void Adaptive<T>::restrict_to(const std::vector<PixelBlock>& blocks) {
  active_.assign(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height), 0);
  for (const PixelBlock& block : blocks)
    for (int row = block.row_begin; row < block.row_end; ++row)
      std::fill(active_.begin() + static_cast<std::ptrdiff_t>(index(block.column_begin, row)),
                active_.begin() + static_cast<std::ptrdiff_t>(index(block.column_begin, row)) +
                    (block.column_end - block.column_begin),
                std::uint8_t{1});
  expected_ =
      static_cast<std::uint64_t>(std::count(active_.begin(), active_.end(), 1)) * static_cast<std::uint64_t>(most_);
}

template <class T>
bool Adaptive<T>::is_known(const Rgb<T>& mean, const Vec3<float>& spread, double quantile) const {
  for (int channel = 0; channel < 3; ++channel) {
    const double variance = static_cast<double>(spread[channel]) / (to_ - 1);
    const double half = quantile * std::sqrt(variance / to_), middle = static_cast<double>(mean[channel]);
    const double at = shown(middle);
    if (!(shown(middle + half) - at <= tolerance_ && at - shown(middle - half) <= tolerance_)) return false;
  }
  return true;
}

template <class T>
bool Adaptive<T>::next(const Film<T>& film) {
  if (to_ == most_) return false;
  const double quantile = student_quantile((1 - confidence) / looks_, to_ - 1);
  std::vector<std::uint8_t> unknown(spread_.size());
  for (int row = 0; row < size_.height; ++row)
    for (int column = 0; column < size_.width; ++column)
      unknown[index(column, row)] =
          is_active(column, row) && !is_known(film.at(column, row), spread_[index(column, row)], quantile);
  std::vector<std::uint8_t> active(spread_.size());
  std::uint64_t going_on = 0;
  for (int row = 0; row < size_.height; ++row)
    for (int column = 0; column < size_.width; ++column) {
      if (!is_active(column, row)) continue;  // its samples are no longer the first ones
      std::uint8_t& goes_on = active[index(column, row)];
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, size_.height - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, size_.width - 1); ++x)
          goes_on |= unknown[index(x, y)];
      going_on += goes_on;
      if (!goes_on) expected_ -= static_cast<std::uint64_t>(most_ - to_);
    }
  active_ = std::move(active);
  from_ = to_;
  to_ = std::min(2 * to_, most_);
  return going_on > 0;
}

template class Adaptive<float>;
template class Adaptive<double>;

}  // namespace raywalk
