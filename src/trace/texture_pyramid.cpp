#include "trace/texture_pyramid.h"

#include "math/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace raywalk {

namespace {

/// The same row or column of pixels in half as many, rounded up; each is the mean of what it covers.
struct Halved {
  explicit Halved(int size) : from(size), to((size + 1) / 2) {}
  int from, to;
  /// Calls `use(pixel, weight)` for what pixel `i` covers; the weights sum to 1.
  template <class Use>
  void each(int i, Use use) const {
    const double ratio = static_cast<double>(from) / to, begin = i * ratio, end = (i + 1) * ratio;
    for (int at = static_cast<int>(begin); at < from && at < end; ++at) {
      const double covered = std::min(end, at + 1.0) - std::max(begin, static_cast<double>(at));
      if (covered > 0) use(at, covered / ratio);
    }
  }
};

Image halved(const Image& image) {
  const Halved across(image.width), down(image.height);
  Image half{across.to, down.to, {}};
  half.pixels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  for (int row = 0; row < half.height; ++row)
    for (int column = 0; column < half.width; ++column) {
      Rgbd sum(0.0);
      down.each(row, [&](int y, double high) {
        across.each(column, [&](int x, double wide) { sum += high * wide * Rgbd(image.at(x, y)); });
      });
      half.pixels.emplace_back(sum);
    }
  return half;
}

/// exp(-2 r) - exp(-2), by r in 0..1: the square of the distance from the middle of an ellipse.
class GaussianTable {
 public:
  GaussianTable() {
    for (std::size_t i = 0; i < weights_.size(); ++i)
      weights_[i] = portable::exp(-2.0 * static_cast<double>(i) / last) - portable::exp(-2.0);
  }
  /// Linear between the entries, so that it is continuous.
  [[nodiscard]] double operator()(double r) const {
    const double place = r * last;
    const auto below = std::min(static_cast<std::size_t>(place), weights_.size() - 2);
    return weights_[below] + (place - static_cast<double>(below)) * (weights_[below + 1] - weights_[below]);
  }

 private:
  static constexpr double last = 128;
  std::array<double, 129> weights_;
};

constexpr double countless = 1e15;  // pixels: so long is no footprint but one at the horizon

/// In pixels of a level: a vector, and its length.
Vec2d in_pixels(const Image& level, const Vec2d& vector) { return {vector.x * level.width, vector.y * level.height}; }
double length_of(const Vec2d& vector) { return std::sqrt(dot(vector, vector)); }

}  // namespace

TexturePyramid::TexturePyramid(std::shared_ptr<const Image> image) : image_(std::move(image)) {
  for (const Image* last = image_.get(); last->width > 1 || last->height > 1; last = &smaller_.back()) {
    Image half = halved(*last);
    smaller_.push_back(std::move(half));
  }
}

template <class T>
auto TexturePyramid::level_of(T width) const -> Between<T> {
  const int top = size() - 1;
  if (!(width > 1)) return {0, T(0)};
  int exponent = 0;
  const double mantissa = std::frexp(static_cast<double>(width), &exponent);  // in 1/2..1
  if (exponent - 1 >= top) return {top, T(0)};
  return {exponent - 1, static_cast<T>(portable::log1p(2 * mantissa - 1) / std::numbers::ln2)};
}

template <class T>
Rgb<T> TexturePyramid::trilinear(T u, T v, const Footprint<T>& footprint, ImageWraps wraps) const {
  const double width =
      std::max(length_of(in_pixels(*image_, Vec2d(footprint.x))), length_of(in_pixels(*image_, Vec2d(footprint.y))));
  if (!(width < countless)) return Rgb<T>(level(size() - 1).pixels.front());
  const Between<T> between = level_of(static_cast<T>(width));
  const Rgb<T> sharp = texture_colour(level(between.level), u, v, wraps);
  if (between.share == 0) return sharp;
  return sharp + between.share * (texture_colour(level(between.level + 1), u, v, wraps) - sharp);
}

template <class T>
Rgb<T> TexturePyramid::ewa(T u, T v, const Footprint<T>& footprint, ImageWraps wraps) const {
  // The longer derivative is taken as the major axis; the shorter one is widened where it is too narrow.
  constexpr double narrowest = 1.0 / 16;
  Vec2d longer = in_pixels(*image_, Vec2d(footprint.x)), shorter = in_pixels(*image_, Vec2d(footprint.y));
  double major = length_of(longer), minor = length_of(shorter);
  const Rgb<T> mean(level(size() - 1).pixels.front());
  if (!(major < countless && minor < countless) || !std::isfinite(u) || !std::isfinite(v)) return mean;
  if (major < minor) std::swap(longer, shorter), std::swap(major, minor);
  if (minor < narrowest * major) {
    const double wider = narrowest * major;
    shorter = minor > 0 ? shorter * (wider / minor) : Vec2d(-longer.y, longer.x) * narrowest;
    minor = wider;
  }
  const auto in_copies = [&](const Vec2d& pixels) {
    return Vec2<T>(Vec2d(pixels.x / image_->width, pixels.y / image_->height));
  };
  const Footprint<T> widened{in_copies(longer), in_copies(shorter)};
  const Between<T> between = level_of(static_cast<T>(minor));
  if (between.level == size() - 1) return mean;  // however far the ellipse reaches
  const Rgb<T> sharp = ewa_of_level(between.level, u, v, widened, wraps);
  if (between.share == 0) return sharp;
  return sharp + between.share * (ewa_of_level(between.level + 1, u, v, widened, wraps) - sharp);
}

/// Heckbert's A, B, C and F: the ellipse is A x^2 + B x y + C y^2 = F in pixels from its middle. 1 is added to A and C,
/// which is the filter between pixels, so that some pixel is always inside.
template <class T>
Rgb<T> TexturePyramid::ewa_of_level(int number, T u, T v, const Footprint<T>& footprint, ImageWraps wraps) const {
  static const GaussianTable gaussian;
  const Image& pixels = level(number);
  Vec2d dx = in_pixels(pixels, Vec2d(footprint.x)), dy = in_pixels(pixels, Vec2d(footprint.y));
  // What is one pixel wide or high is the same everywhere along that, and levels make it no smaller.
  if (pixels.width == 1) dx.x = dy.x = 0;
  if (pixels.height == 1) dx.y = dy.y = 0;
  const auto place = [](T along, ImageWrap wrap) {
    return wrap == ImageWrap::clamp ? along : near_first_copy(along, wrap);
  };
  constexpr double farthest = 1 << 30;  // pixels, beyond the edge that goes on: rows and columns are counted in int
  const double x = std::clamp(static_cast<double>(place(u, wraps.u)) * pixels.width - 0.5, -farthest, farthest);
  // Rows count downwards.
  const double y = std::clamp(static_cast<double>(1 - place(v, wraps.v)) * pixels.height - 0.5, -farthest, farthest);
  double A = dx.y * dx.y + dy.y * dy.y + 1, B = 2 * (dx.x * dx.y + dy.x * dy.y), C = dx.x * dx.x + dy.x * dy.x + 1;
  const double F = A * C - B * B / 4;
  A /= F, B /= F, C /= F;
  // Half the sides of its bounding rectangle.
  const double determinant = A * C - B * B / 4;
  const double wide = std::sqrt(C / determinant), high = std::sqrt(A / determinant);
  Rgbd sum(0.0);
  double weights = 0;
  for (int row = static_cast<int>(std::ceil(y - high)); row <= static_cast<int>(std::floor(y + high)); ++row)
    for (int column = static_cast<int>(std::ceil(x - wide)); column <= static_cast<int>(std::floor(x + wide));
         ++column) {
      const double s = column - x, t = row - y;
      const double r = A * s * s + B * s * t + C * t * t;
      if (!(r < 1)) continue;
      const double weight = gaussian(r);
      sum += weight *
             Rgbd(pixels.at(wrapped_index(column, pixels.width, wraps.u), wrapped_index(row, pixels.height, wraps.v)));
      weights += weight;
    }
  return weights > 0 ? Rgb<T>(sum / weights) : texture_colour(pixels, u, v, wraps);
}

template Rgb<float> TexturePyramid::trilinear(float, float, const Footprint<float>&, ImageWraps) const;
template Rgb<double> TexturePyramid::trilinear(double, double, const Footprint<double>&, ImageWraps) const;
template Rgb<float> TexturePyramid::ewa(float, float, const Footprint<float>&, ImageWraps) const;
template Rgb<double> TexturePyramid::ewa(double, double, const Footprint<double>&, ImageWraps) const;

}  // namespace raywalk
