// Motion blur against formulas: a pixel is the share of the shutter's time that something covers it.

#include <algorithm>

#include "support/catch.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a moving edge blurs to the share of the shutter's time that it covers") {
  // A glowing wall to the left of y = 0 moves to the right. Its keys cross y = -1 at time 1, -2 at 1.5, -4 at 4.5; the
  // shutter is open from 1 to 4.5.
  const Motion motion{{0, {0, 0, 0}}, {1, {0, -1, 0}}, {1.5, {0, -2, 0}}, {4.5, {0, -4, 0}}, {9, {0, 99, 0}}};
  Scene scene;
  scene.camera.shutter_open = 1;
  scene.camera.shutter_close = 4.5;
  scene.objects = {
      object("Wall", Polygon<double>{{{5, 0, -50}, {5, 90, -50}, {5, 90, 50}, {5, 0, 50}}, {}}, glowing(1))};
  scene.objects[0].motion = motion;
  // When the edge reaches y: linear between the keys.
  const auto reached = [](double y) { return y > -2 ? 1 + (-1 - y) / 2 : 1.5 + (-2 - y) * 1.5; };
  const auto mean_of = [&](double y, Sampler sampler, int samples) {
    scene.render.sampler = sampler;
    return sample(scene, {0, y, 0}, {5, y, 0}, samples);
  };
  for (const double y : {-0.9, -1.1, -1.5, -1.99, -2.2, -3.0, -3.9, -4.1}) {
    const double exact = std::clamp((4.5 - reached(y)) / 3.5, 0.0, 1.0);
    CAPTURE(y, exact);
    const Sampled random = mean_of(y, Sampler::random, 4000);
    CHECK(std::abs(random.mean - exact) <= random.tolerance() + 1e-9);
    CHECK(random.statistics.drawn(Effect::motion_blur) == 4000);
    // One sample in each stretch of time: only the one in which the edge passes can fall to either side.
    for (const int n : {64, 1024}) {
      CHECK(std::abs(mean_of(y, Sampler::jittered, n).mean - exact) <= 1.0 / n + 1e-9);
      CHECK(std::abs(mean_of(y, Sampler::sobol, n).mean - exact) <= 1.0 / n + 1e-9);
    }
  }
  // Without chance it is where it stood when the shutter opened.
  scene.render.integrator = Integrator::whitted;
  CHECK(mean_of(-0.9, Sampler::jittered, 4).mean == 1);
  CHECK(mean_of(-1.1, Sampler::jittered, 4).mean == 0);
}

TEST_CASE("shadows and mirrors see what moves at the time of the ray that asks") {
  // The edge of a cover passes before the lamp, as the floor sees it, at half the shutter's time.
  Scene scene = lit_floor(lamp({0, 0, 4}, 1));
  scene.objects.push_back(object("Cover", Box<double>{{-90, -50, 1}, {0, 50, 1.5}}, black()));
  scene.objects[1].motion = {{0, {-1, 0, 0}}, {1, {1, 0, 0}}};
  // From x the way to the lamp crosses the top of the box, its nearest edge, at x (1 - 1.5 / 4), and its foot at
  // x (1 - 1 / 4): the way is free until the edge has come to the lesser of both.
  const double cosine_at_half = 4 / std::sqrt(0.25 + 16.0);
  for (const double x : {-0.5, 0.5}) {
    const double edge = std::min(x * (1 - 1.5 / 4), x * (1 - 1.0 / 4));
    const Sampled sampled = sample(scene, {x, -1, 0.5}, {x, 0, 0}, 4096);
    CAPTURE(x);
    CHECK(sampled.mean / cosine_at_half == Approx((1 + edge) / 2).margin(1.0 / 4096));
  }
  Scene mirrored;
  Material mirror = black();
  mirror.reflection = Rgbd(1.0);
  mirrored.objects = {object("Mirror", Plane<double>{{0, 0, 0}, {1, 0, 0}}, mirror),
                      object("Wall", Box<double>{{9, 0, -50}, {10, 90, 50}}, glowing(1))};
  mirrored.objects[1].motion = {{0, {0, 0, 0}}, {1, {0, -4, 0}}};
  for (const double y : {-1.0, -3.0})
    CHECK(sample(mirrored, {5, y, 0}, {0, y, 0}, 1024).mean == Approx((4 + y) / 4).margin(1.0 / 1024));
}
