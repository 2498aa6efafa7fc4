#include "render/film.h"

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("a film holds the mean of the samples") {
  Film<double> film({3, 2});
  CHECK(film.pixels() == Film<double>::Pixels(6, Rgbd(0.0)));
  for (int sample = 0; sample < 4; ++sample) film.add(2, 1, sample, Rgbd(sample, 2.0 * sample, 1.0));
  CHECK(film.at(2, 1) == Rgbd(1.5, 3.0, 1.0));
  CHECK(film.pixels()[5] == Rgbd(1.5, 3.0, 1.0));
  CHECK(film.at(1, 1) == Rgbd(0.0));
}

TEMPLATE_TEST_CASE("equal samples leave the mean at their value, to the last bit", "", float, double) {
  const Rgb<TestType> shade(static_cast<TestType>(0.1), static_cast<TestType>(1) / 3, static_cast<TestType>(0.7));
  Film<TestType> film({1, 1});
  Rgb<TestType> sum(0);
  bool sum_drifts = false;
  for (int sample = 0; sample < 100; ++sample) {
    film.add(0, 0, sample, shade);
    CHECK(film.at(0, 0) == shade);
    sum += shade;
    sum_drifts = sum_drifts || sum / static_cast<TestType>(sample + 1) != shade;
  }
  // Or else these numbers would show nothing.
  REQUIRE(sum_drifts);
}

TEST_CASE("an image has the film's numbers, rounded to float") {
  Film<double> film({2, 2});
  film.add(1, 0, 0, Rgbd(0.1, 7.0, 1e-60));
  film.add(0, 1, 0, Rgbd(1.0 / 3));
  const Image image = image_of(film);
  CHECK(image.width == 2);
  CHECK(image.height == 2);
  REQUIRE(image.pixels.size() == 4);
  CHECK(image.at(1, 0) == Rgb<float>(0.1F, 7.0F, 0.0F));
  CHECK(image.at(0, 1) == Rgb<float>(static_cast<float>(1.0 / 3)));
  CHECK(image.at(0, 0) == Rgb<float>(0));
}
