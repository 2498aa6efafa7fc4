// Images over footprints, against what theory says of their pyramid.

#include "trace/texture_pyramid.h"

#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

using namespace raywalk;

TEST_CASE("each level of a pyramid has the mean of the image, and half its pixels") {
  auto image = std::make_shared<Image>(Image{13, 6, {}});
  std::mt19937 bits(1);
  Rgbd sum(0.0);
  for (int i = 0; i < 13 * 6; ++i) {
    const auto grey = static_cast<float>(bits() % 256);
    image->pixels.emplace_back(grey, 2 * grey, 1.0F);
    sum += Rgbd(image->pixels.back());
  }
  const TexturePyramid pyramid(image);
  REQUIRE(pyramid.size() == 5);
  const std::vector<std::pair<int, int>> sizes{{13, 6}, {7, 3}, {4, 2}, {2, 1}, {1, 1}};
  for (int i = 0; i < pyramid.size(); ++i) {
    const Image& level = pyramid.level(i);
    CHECK(std::pair(level.width, level.height) == sizes[static_cast<std::size_t>(i)]);
    Rgbd own(0.0);
    for (const auto& pixel : level.pixels) own += Rgbd(pixel);
    CHECK(own.x / static_cast<double>(level.pixels.size()) == Approx(sum.x / 78).epsilon(1e-5));
    CHECK(own.z / static_cast<double>(level.pixels.size()) == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("a pyramid is the image close by, and its mean far away") {
  auto image = std::make_shared<Image>(Image{16, 16, {}});
  for (int i = 0; i < 256; ++i) image->pixels.emplace_back(static_cast<float>((i * 37) % 256));
  const TexturePyramid pyramid(image);
  const Footprint<double> point{}, tiny{{0.01, 0}, {0, 0.01}}, far{{3, 0}, {0, 2}}, farther{{1e9, 0}, {0, 1e8}},
      horizon{{infinity<double>, 0}, {0, 1}}, nowhere{{std::nan(""), 0}, {0, 1}};
  for (const Vec2d& uv : {Vec2d(0.3, 0.8), Vec2d(0.01, 0.99), Vec2d(-2.3, 7.1)}) {
    const Rgbd sharp = texture_colour(*image, uv.x, uv.y);
    CHECK(pyramid.trilinear(uv.x, uv.y, point) == sharp);
    CHECK(pyramid.trilinear(uv.x, uv.y, tiny) == sharp);
    for (const auto& footprint : {far, farther, horizon, nowhere}) {
      CHECK(pyramid.trilinear(uv.x, uv.y, footprint).x == Approx(127.5));
      CHECK(pyramid.ewa(uv.x, uv.y, footprint).x == Approx(127.5));
    }
    // Half way between two levels, in the logarithm.
    const Footprint<double> between{{std::sqrt(8.0) / 16, 0}, {0, 0.01}};
    const Rgbd one = texture_colour(pyramid.level(1), uv.x, uv.y), two = texture_colour(pyramid.level(2), uv.x, uv.y);
    CHECK(pyramid.trilinear(uv.x, uv.y, between).x == Approx((one.x + two.x) / 2));
  }
}

TEST_CASE("an ellipse keeps the stripes that it lies along, and a mean of both ways loses them") {
  // Stripes along the diagonal u = v, two pixels wide, so that a mistaken sign of the ellipse's tilt is seen.
  constexpr int edge = 64;
  auto image = std::make_shared<Image>(Image{edge, edge, {}});
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column)
      // v is up and rows count down: u - v in pixels is column + row.
      image->pixels.emplace_back((column + row + 1) % 16 < 8 ? 1.0F : 0.0F);
  const TexturePyramid pyramid(image);
  const auto contrast = [&](auto colour_at) {
    double low = 1, high = 0;
    for (int i = 0; i < 64; ++i) {
      const double grey = colour_at(Vec2d(0.5 + i / 64.0, 0.3)).x;
      low = std::min(low, grey), high = std::max(high, grey);
    }
    return high - low;
  };
  constexpr double far = 16.0 / edge, near = 1.0 / edge;
  const Footprint<double> along{{far, far}, {near, -near}}, across{{far, -far}, {near, near}};
  CHECK(contrast([&](Vec2d uv) { return pyramid.ewa(uv.x, uv.y, along); }) > 0.8);
  CHECK(contrast([&](Vec2d uv) { return pyramid.ewa(uv.x, uv.y, across); }) < 0.1);
  CHECK(contrast([&](Vec2d uv) { return pyramid.trilinear(uv.x, uv.y, along); }) < 0.2);
  // The narrow derivative may come first.
  CHECK(contrast([&](Vec2d uv) { return pyramid.ewa(uv.x, uv.y, Footprint<double>{along.y, along.x}); }) > 0.8);
}

TEST_CASE("a mirrored image is a repeated one of twice the size that holds its mirror images") {
  auto image = std::make_shared<Image>(Image{16, 8, {}}), doubled = std::make_shared<Image>(Image{32, 16, {}});
  std::mt19937 bits(5);
  for (int i = 0; i < 16 * 8; ++i) image->pixels.emplace_back(static_cast<float>(bits() % 256));
  for (int row = 0; row < 16; ++row)  // the upper half is v from 1 to 2
    for (int column = 0; column < 32; ++column)
      doubled->pixels.push_back(image->at(std::min(column, 31 - column), row < 8 ? 7 - row : row - 8));
  const TexturePyramid small(image), large(doubled);
  constexpr ImageWraps mirrored{ImageWrap::mirror, ImageWrap::mirror};
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() % 10007) / 10007;
  };
  for (int i = 0; i < 500; ++i) {
    const Vec2d uv(random(-5, 5), random(-5, 5));
    const double size = random(0, 0.2);
    const Footprint<double> footprint{{random(-1, 1) * size, random(-1, 1) * size},
                                      {random(-0.2, 0.2) * size, random(-0.2, 0.2) * size}};
    const Footprint<double> half{footprint.x / 2.0, footprint.y / 2.0};
    CAPTURE(uv.x, uv.y, size);
    CHECK(texture_colour(*image, uv.x, uv.y, mirrored).x ==
          Approx(texture_colour(*doubled, uv.x / 2, uv.y / 2).x).margin(1e-9));
    CHECK(small.trilinear(uv.x, uv.y, footprint, mirrored).x ==
          Approx(large.trilinear(uv.x / 2, uv.y / 2, half).x).margin(1e-4));
    CHECK(small.ewa(uv.x, uv.y, footprint, mirrored).x == Approx(large.ewa(uv.x / 2, uv.y / 2, half).x).margin(1e-4));
  }
}

TEST_CASE("a clamped image is one within a wide frame of its edge") {
  constexpr int size = 16, frame = 48;
  auto image = std::make_shared<Image>(Image{size, size, {}});
  std::mt19937 bits(5);
  for (int i = 0; i < size * size; ++i) image->pixels.emplace_back(static_cast<float>(bits() % 256));
  auto framed = std::make_shared<Image>(Image{size + 2 * frame, size + 2 * frame, {}});
  const auto clamped = [](int i) { return std::clamp(i - frame, 0, size - 1); };
  for (int row = 0; row < framed->height; ++row)
    for (int column = 0; column < framed->width; ++column)
      framed->pixels.push_back(image->at(clamped(column), clamped(row)));
  const TexturePyramid small(image), large(framed);
  constexpr ImageWraps edges{ImageWrap::clamp, ImageWrap::clamp};
  constexpr double ratio = double{size} / (size + 2 * frame), begin = double{frame} / (size + 2 * frame);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() % 10007) / 10007;
  };
  for (int i = 0; i < 500; ++i) {
    const Vec2d uv(random(-2, 3), random(-2, 3)), there = Vec2d(begin) + ratio * uv;
    // Less than a pixel narrow, so that it is of the lowest level.
    const Footprint<double> footprint{{random(-0.5, 0.5), random(-0.5, 0.5)}, {random(0, 0.03), random(0, 0.03)}};
    CAPTURE(uv.x, uv.y);
    CHECK(texture_colour(*image, uv.x, uv.y, edges).x == Approx(texture_colour(*framed, there.x, there.y).x));
    CHECK(small.ewa(uv.x, uv.y, footprint, edges).x ==
          Approx(large.ewa(there.x, there.y, {ratio * footprint.x, ratio * footprint.y}).x));
  }
  for (const double far : {1e3, 1e9, 1e30}) {
    CHECK(texture_colour(*image, far, far, edges) == Rgbd(image->at(size - 1, 0)));
    CHECK(small.ewa(-far, -far, {{0.3, 0.1}, {0.01, 0.02}}, edges).x == Approx(image->at(0, size - 1).x));
  }
}

TEST_CASE("the mean over an ellipse is that by weights that are taken anew for each pixel of the image") {
  // By the paper, without a table, and of the lowest level alone: an ellipse less than a pixel narrow.
  auto image = std::make_shared<Image>(Image{24, 16, {}});
  std::mt19937 bits(3);
  for (int i = 0; i < 24 * 16; ++i) image->pixels.emplace_back(static_cast<float>(bits() % 256));
  const TexturePyramid pyramid(image);
  for (const Footprint<double>& footprint :
       {Footprint<double>{{0.2, 0.05}, {0.01, -0.055}}, Footprint<double>{{0.02, 0.06}, {-0.04, 0.01}}}) {
    const Vec2d uv(0.37, 0.61), size(24, 16);
    const Vec2d x = footprint.x * size, y = footprint.y * size;  // the derivatives, v up
    // |M^-1 d|^2 where M M^T = x x^T + y y^T + 1.
    const double a = x.x * x.x + y.x * y.x + 1, b = x.x * x.y + y.x * y.y, c = x.y * x.y + y.y * y.y + 1;
    double sum = 0, weights = 0;
    for (int row = -32; row < 48; ++row)
      for (int column = -32; column < 56; ++column) {
        const Vec2d d(column + 0.5 - uv.x * size.x, (1 - uv.y) * size.y - (row + 0.5));
        const double r = (c * d.x * d.x - 2 * b * d.x * d.y + a * d.y * d.y) / (a * c - b * b);
        if (!(r < 1)) continue;
        const double weight = std::exp(-2 * r) - std::exp(-2.0);
        sum += weight * static_cast<double>(image->at((column + 48) % 24, (row + 32) % 16).x);
        weights += weight;
      }
    CHECK(pyramid.ewa(uv.x, uv.y, footprint).x == Approx(sum / weights).epsilon(1e-4));
  }
}
