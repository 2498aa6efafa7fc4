#include "study/image_metrics.h"

#include <cmath>

#include "image/srgb.h"
#include "study/flip.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Image flat(int width, int height, const Rgb<float>& colour) {
  return {width, height, std::vector<Rgb<float>>(static_cast<std::size_t>(width * height), colour)};
}

// Something of everything: a gradient, an edge, a point, colours.
Image scenery(int width, int height, float gain) {
  Image image = flat(width, height, Rgb<float>(0));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float ramp = static_cast<float>(x) / static_cast<float>(width);
      image.at(x, y) = {gain * ramp, y < height / 2 ? 0.2F : 0.7F,
                        0.5F + 0.4F * std::sin(gain * static_cast<float>(x * y))};
    }
  image.at(width / 3, height / 3) = Rgb<float>(gain);
  return image;
}

// FLIP once more, straight from the paper's formulas: filters in two dimensions, nothing taken apart.
class PlainFlip {
 public:
  explicit PlainFlip(double pixels_per_degree) : ppd_(pixels_per_degree) {}

  [[nodiscard]] double at(const Image& a, const Image& b, int x, int y) const {
    const double c = std::pow(hyab(lab(blurred(a, x, y)), lab(blurred(b, x, y))), 0.7);
    const double most = std::pow(hyab(lab({0, 1, 0}), lab({0, 0, 1})), 0.7);
    const double colour = c < 0.4 * most ? 0.95 * c / (0.4 * most) : 0.95 + 0.05 * (c - 0.4 * most) / (0.6 * most);
    double feature = 0;
    for (const bool points : {false, true})
      feature = std::max(feature, std::abs(strength(a, x, y, points) - strength(b, x, y, points)));
    return std::pow(colour, 1 - std::sqrt(feature / std::sqrt(2.0)));
  }

 private:
  static Vec3d xyz(const Rgbd& c) {
    return {0.412386563 * c.x + 0.357591481 * c.y + 0.180450389 * c.z,
            0.212636821 * c.x + 0.715182962 * c.y + 0.072180156 * c.z,
            0.019330620 * c.x + 0.119197153 * c.y + 0.950372597 * c.z};
  }
  static Vec3d to_white(const Vec3d& c) { return c / Vec3d(0.950428545, 1, 1.088900371); }
  static Rgbd clamped(const Rgbd& c) { return glm::vec<3, double>(bound(c.x), bound(c.y), bound(c.z)); }
  static double bound(double x) { return std::min(std::max(x, 0.0), 1.0); }
  static Vec3d lab(const Rgbd& rgb) {
    const Vec3d c = to_white(xyz(rgb));
    const auto f = [](double t) { return t > 0.008856451679 ? std::cbrt(t) : 7.787037037 * t + 16.0 / 116; };
    const double l = 116 * f(c.y) - 16;
    return {l, l / 100 * 500 * (f(c.x) - f(c.y)), l / 100 * 200 * (f(c.y) - f(c.z))};
  }
  static double hyab(const Vec3d& a, const Vec3d& b) {
    return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
  }
  static Vec3d opponent(const Image& image, int x, int y) {
    x = std::min(std::max(x, 0), image.width - 1), y = std::min(std::max(y, 0), image.height - 1);
    const Vec3d c = to_white(xyz(clamped(Rgbd(image.at(x, y)))));
    return {116 * c.y - 16, 500 * (c.x - c.y), 200 * (c.y - c.z)};
  }
  [[nodiscard]] Rgbd blurred(const Image& image, int x, int y) const {
    const double pi = 3.14159265358979, a1[] = {1, 1, 34.1}, b1[] = {0.0047, 0.0053, 0.04}, a2[] = {0, 0, 13.5};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
    Vec3d sum(0.0), weights(0.0);
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx)
        for (int i = 0; i < 3; ++i) {
          const double r2 = (dx * dx + dy * dy) / (ppd_ * ppd_);
          const double weight = a1[i] * std::sqrt(pi / b1[i]) * std::exp(-pi * pi * r2 / b1[i]) +
                                a2[i] * std::sqrt(pi / 0.025) * std::exp(-pi * pi * r2 / 0.025);
          sum[i] += weight * opponent(image, x + dx, y + dy)[i];
          weights[i] += weight;
        }
    const Vec3d c = sum / weights;
    const double light = (c.x + 16) / 116;
    const Vec3d back = Vec3d(light + c.y / 500, light, light - c.z / 200) * Vec3d(0.950428545, 1, 1.088900371);
    return clamped({3.241003275 * back.x - 1.537398934 * back.y - 0.498615861 * back.z,
                    -0.969224334 * back.x + 1.875930071 * back.y + 0.041554224 * back.z,
                    0.055639423 * back.x - 0.204011202 * back.y + 1.057148933 * back.z});
  }
  [[nodiscard]] double strength(const Image& image, int x, int y, bool points) const {
    const double sd = 0.041 * ppd_;
    const int radius = static_cast<int>(std::ceil(3 * sd));
    double up[2] = {0, 0}, down[2] = {0, 0}, all_up = 0, all_down = 0;
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const double g = std::exp(-(dx * dx + dy * dy) / (2 * sd * sd));
        const double weight = points ? (dx * dx / (sd * sd) - 1) * g : -dx * g;
        const double across = (opponent(image, x + dx, y + dy).x + 16) / 116;
        const double along = (opponent(image, x + dy, y + dx).x + 16) / 116;
        (weight > 0 ? all_up : all_down) += std::abs(weight);
        (weight > 0 ? up : down)[0] += std::abs(weight) * across;
        (weight > 0 ? up : down)[1] += std::abs(weight) * along;
      }
    return std::hypot(up[0] / all_up - down[0] / all_down, up[1] / all_up - down[1] / all_down);
  }

  double ppd_;
};

}  // namespace

TEST_CASE("the metrics of two pixels, by hand") {
  Image reference = flat(2, 1, {0.5F, 0.25F, 0}), test = reference;
  test.at(1, 0) = {0.5F, 0.75F, 0.25F};
  const ImageMetrics m = compare_images(test, reference);
  CHECK(m.mse == Approx((0.25 + 0.0625) / 6).epsilon(1e-12));
  CHECK(m.rel_mse == Approx((0.25 / 0.0725 + 0.0625 / 0.01) / 6).epsilon(1e-12));
  const double green = srgb_encode(0.75) - srgb_encode(0.25), blue = srgb_encode(0.25);
  CHECK(m.psnr == Approx(10 * std::log10(6 / (green * green + blue * blue))).epsilon(1e-12));
  CHECK(m.worst == 0.5);
  CHECK(m.worst_column == 1);
  CHECK(m.worst_row == 0);
  CHECK(m.percentile99 == 0.5);  // one of two pixels is more than 1%
  const Image difference = difference_image(test, reference);
  CHECK(difference.at(0, 0) == Rgb<float>(0));
  CHECK(difference.at(1, 0) == Rgb<float>(0, 0.5F, 0.25F));
}

TEST_CASE("99 of 100 pixels do not exceed the 99th percentile, and one does") {
  Image reference = flat(20, 10, Rgb<float>(0)), test = reference;
  for (std::size_t i = 0; i < 200; ++i) test.pixels[i] = Rgb<float>(0, static_cast<float>((7 * i) % 200 + 1), 0);
  CHECK(compare_images(test, reference).percentile99 == 198);  // 198 of 200 are at most 198
}

TEST_CASE("equal pictures differ by nothing in any metric") {
  const Image image = scenery(24, 17, 0.8F);
  const ImageMetrics m = compare_images(image, image);
  CHECK(m.mse == 0);
  CHECK(m.rel_mse == 0);
  CHECK(std::isinf(m.psnr));
  CHECK(m.flip == 0);
  CHECK(m.percentile99 == 0);
  CHECK(m.worst == 0);
}

TEST_CASE("what the screen cannot show counts for PSNR and FLIP not at all, for the others in full") {
  const ImageMetrics m = compare_images(flat(3, 3, Rgb<float>(5)), flat(3, 3, Rgb<float>(1)));
  CHECK(m.mse == 16);
  CHECK(m.rel_mse == Approx(16 / 1.01));
  CHECK(std::isinf(m.psnr));
  CHECK(m.flip == 0);
}

TEST_CASE("FLIP of even pictures is that of their two colours") {
  // L*a*b* of black, white, green and blue stand in every table: L 0; 100; 87.735 (-86.185, 83.181);
  // 32.297 (79.186, -107.860). Hunt's adjustment multiplies a and b by L/100.
  const auto mean = [](const Rgb<float>& a, const Rgb<float>& b) {
    return compare_images(flat(9, 9, a), flat(9, 9, b)).flip;
  };
  const double most = std::pow(55.438 + std::hypot(75.614 + 25.575, 72.979 + 34.836), 0.7);
  const double from_black = std::pow(100.0, 0.7);
  CHECK(mean(Rgb<float>(1), Rgb<float>(0)) ==
        Approx(0.95 + 0.05 * (from_black - 0.4 * most) / (0.6 * most)).epsilon(1e-4));
  CHECK(mean({0, 1, 0}, {0, 0, 1}) == Approx(1).epsilon(1e-6));
  // A dark grey, linear 0.01: L = 116 f(0.01) - 16 = 8.991, below the knee.
  CHECK(mean(Rgb<float>(0.01F), Rgb<float>(0)) == Approx(0.95 * std::pow(8.9914, 0.7) / (0.4 * most)).epsilon(1e-4));
}

TEST_CASE("FLIP is the paper's formulas, to the border of the picture") {
  const Image a = scenery(13, 11, 0.9F), b = scenery(13, 11, 0.5F);
  for (const double ppd : {20.0, default_pixels_per_degree}) {
    const PlainFlip plain(ppd);
    const std::vector<float> map = flip_map(a, b, ppd);
    for (const auto& [x, y] : {std::pair(0, 0), {12, 10}, {4, 3}, {7, 5}, {0, 9}}) {
      CAPTURE(ppd, x, y);
      CHECK(static_cast<double>(map[static_cast<std::size_t>(y * 13 + x)]) ==
            Approx(plain.at(a, b, x, y)).epsilon(2e-5));
    }
  }
}

TEST_CASE("FLIP does not ask which of the two is right, and stays within 0..1") {
  const Image a = scenery(20, 20, 1), b = scenery(20, 20, 0.3F);
  const std::vector<float> forth = flip_map(a, b), back = flip_map(b, a);
  double sum = 0;
  for (std::size_t i = 0; i < forth.size(); ++i) {
    CHECK(forth[i] == back[i]);
    CHECK((forth[i] >= 0 && forth[i] <= 1));
    sum += static_cast<double>(forth[i]);
  }
  CHECK(sum > 1);
}

TEST_CASE("an error that makes an edge is seen more than the same error spread evenly") {
  const Image grey = flat(40, 40, Rgb<float>(0.3F));
  Image spread = grey, edge = grey;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      spread.at(x, y) += Rgb<float>(0.05F);
      if (x >= 20) edge.at(x, y) += Rgb<float>(0.1F);
    }
  // Beside the edge against the middle of the even field.
  CHECK(flip_map(grey, edge)[20 * 40 + 20] > 1.2F * flip_map(grey, spread)[20 * 40 + 20]);
  // The picture of it is light where the error is.
  const Image map = flip_image(edge, grey);
  CHECK(map.at(30, 20).x > map.at(5, 20).x);
  CHECK(map.at(5, 20) == flip_image(grey, grey).at(0, 0));
}

TEST_CASE("pictures of different sizes, empty or with NaN are not compared") {
  const Image image = flat(3, 2, Rgb<float>(1));
  CHECK(!why_not_comparable(image, image));
  CHECK_THAT(why_not_comparable(image, flat(2, 3, Rgb<float>(1))).value().text(), contains("3 x 2 and 2 x 3"));
  CHECK_THAT(why_not_comparable({}, {}).value().text(), contains("empty"));
  Image bad = image;
  bad.at(1, 1).y = std::nanf("");
  CHECK_THAT(why_not_comparable(image, bad).value().text(), contains("1 of 6 pixels of the second"));
  CHECK_THAT(why_not_comparable(bad, image).value().text(), contains("1 of 6 pixels of the first"));
}
