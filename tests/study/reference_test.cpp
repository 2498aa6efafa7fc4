#include "study/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/shot.h"
#include "study/subjects.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::study;

namespace {

constexpr double pi = std::numbers::pi;

// The mean over a rectangle by 400 x 400 midpoints.
double midpoints(const Rectangle& r, const std::function<double(double, double)>& f) {
  constexpr int n = 400;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) sum += f(r.x0 + (r.x1 - r.x0) * (i + 0.5) / n, r.y0 + (r.y1 - r.y0) * (k + 0.5) / n);
  return sum / (n * n);
}

}  // namespace

TEST_CASE("the solid angle of a rectangle is the integral of h / r^3") {
  const Rectangle r{-0.3, 0.9, 0.2, 0.7};
  const double x = 0.4, y = -0.1, h = 0.8;
  const double sum = midpoints(r, [&](double px, double py) {
    const double square = (px - x) * (px - x) + (py - y) * (py - y) + h * h;
    return h / (square * std::sqrt(square));
  });
  CHECK(solid_angle(r, x, y, h) == Approx(sum * r.area()).epsilon(1e-5));
  CHECK(solid_angle({-1e9, 1e9, -1e9, 1e9}, 0, 0, 1) == Approx(2 * pi).epsilon(1e-6));
  CHECK(solid_angle({-1, 1, -1, 1}, 0, 0, 1) == Approx(2 * pi / 3).epsilon(1e-12));  // a face of a cube: 4 pi / 6
}

TEST_CASE("a disk's area in a rectangle, in every way that they can meet") {
  const double r = 0.8;
  CHECK(disk_area_in({-2, 2, -2, 2}, r) == Approx(pi * r * r));
  CHECK(disk_area_in({0, 2, -2, 2}, r) == Approx(pi * r * r / 2));
  CHECK(disk_area_in({0, 2, 0, 2}, r) == Approx(pi * r * r / 4));
  CHECK(disk_area_in({-0.1, 0.2, -0.3, 0.1}, r) == Approx(0.3 * 0.4));
  CHECK(disk_area_in({0.9, 1, 0, 1}, r) == 0);
  CHECK(disk_area_in({0.7, 1, 0.7, 1}, r) == 0);
  for (const Rectangle& cut : {Rectangle{0.5, 0.75, 0.25, 0.5},
                               {-0.75, -0.5, 0.25, 0.75},
                               {-0.1, 0.9, -0.9, 0.1},
                               {0.7, 0.9, -0.2, 0.3},
                               {-0.3, 0.2, 0.7, 0.9},
                               {-0.9, 0.9, -0.1, 0.4}}) {
    CAPTURE(cut.x0, cut.y0);
    const double share = midpoints(cut, [&](double x, double y) { return x * x + y * y <= r * r ? 1.0 : 0.0; });
    CHECK(disk_area_in(cut, r) == Approx(share * cut.area()).margin(1e-3 * cut.area()));
  }
}

TEST_CASE("form factors of the catalogue") {
  // Straight below the middle: R^2 / (R^2 + h^2).
  CHECK(disk_form_factor(2, 1.5, 0) == Approx(4 / 6.25).epsilon(1e-12));
  CHECK(disk_form_factor(1e6, 1, 3) == Approx(1).epsilon(1e-9));
  const auto integral = [](const Rectangle& r, double h, const std::function<bool(double, double)>& inside) {
    return r.area() * midpoints(r, [&](double x, double y) {
             const double square = x * x + y * y + h * h;
             return inside(x, y) ? h * h / (pi * square * square) : 0;
           });
  };
  const Rectangle r{-0.4, 1.1, 0.3, 0.8};
  CHECK(rectangle_form_factor(r, 0.9) == Approx(integral(r, 0.9, [](double, double) { return true; })).epsilon(1e-5));
  const Rectangle around{0.2, 1.8, -0.8, 0.8};
  const double by_area = integral(around, 0.7, [](double x, double y) { return (x - 1) * (x - 1) + y * y <= 0.64; });
  CHECK(disk_form_factor(0.8, 0.7, 1) == Approx(by_area).epsilon(2e-3));
}

TEST_CASE("lamps that glow light a floor by their form factors: the path tracer agrees") {
  const double h = 1.2, aside = 0.7, radius = 0.5;
  const Rectangle panel{0.1, 0.9, -0.3, 0.4};
  for (const bool round : {true, false}) {
    CAPTURE(round);
    Scene scene;
    Material matte, glow;
    matte.diffuse = Rgbd(1.0);
    glow.diffuse = Rgbd(0.0), glow.emission = Rgbd(3.0);
    const Shape<double> lamp = round ? Shape<double>(Disk<double>{{aside, 0, h}, {0, 0, -1}, radius})
                                     : Shape<double>(Box<double>{{panel.x0, panel.y0, h}, {panel.x1, panel.y1, h}});
    scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matte}, {"Lamp", lamp, glow}};
    scene.camera = looking_down(0, 0, 0.5, 1e-7);
    scene.render.integrator = Integrator::path;
    scene.render.sampler = Sampler::sobol;
    const Shot shot = shoot(scene, {8, 8}, {1024, 3}, false, PathSettings{2, 4, PathStrategy::both});
    double mean = 0, squares = 0;
    for (const Rgbd& pixel : shot.film.pixels()) mean += pixel.x / 64;
    for (const Rgbd& pixel : shot.film.pixels()) squares += (pixel.x - mean) * (pixel.x - mean);
    const double truth = 3 * (round ? disk_form_factor(radius, h, aside) : rectangle_form_factor(panel, h));
    const double error = std::sqrt(squares / 63 / 64);
    CHECK(std::abs(mean - truth) < 5 * error + 1e-6);
    CHECK(error < 2e-3 * truth);
  }
}

TEST_CASE("the outline of a ball straight ahead is a circle of the silhouette's radius") {
  Scene scene;
  Material glow;
  glow.diffuse = Rgbd(0.0), glow.emission = Rgbd(1.0);
  const double radius = 0.9, distance = 2;
  scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, radius}, glow}};
  scene.camera = looking_down(0, 0, distance, 1.6);  // 0.8 at distance 1
  scene.render.integrator = Integrator::distributed;
  constexpr int edge = 24, samples = 1024;
  const Shot shot = shoot(scene, {edge, edge}, {samples, 1});
  const double pixel = 1.6 / edge;
  int on_edge = 0;
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) {
      const Rectangle r{-0.8 + pixel * column, -0.8 + pixel * (column + 1), 0.8 - pixel * (row + 1), 0.8 - pixel * row};
      const double covered = disk_area_in(r, silhouette_radius(radius, distance)) / r.area();
      on_edge += covered > 0.01 && covered < 0.99 ? 1 : 0;
      CHECK(std::abs(shot.film.at(column, row).x - covered) < 0.02);
    }
  CHECK(on_edge > 40);
}

TEST_CASE("furnaces are geometric series") {
  CHECK(furnace(2, 0.5, 1) == 2);
  CHECK(furnace(2, 0.5, 3) == Approx(2 + 1 + 0.5));
  CHECK(furnace(2, 1, 7) == 14);
  CHECK(endless_furnace(2, 0.75) == Approx(8));
}

TEST_CASE("what subjects say of their pixels is what many samples of them show") {
  for (const Subject& subject : {smooth_subject(), edge_subject(), lens_subject()}) {
    CAPTURE(subject.name);
    const Shot shot = shoot(subject.scene, {12, 12}, {4096, 5});
    double worst = 0;
    int counted = 0;
    for_each_pixel(subject, shot.film, [&](double shown, double truth) {
      worst = std::max(worst, std::abs(shown - truth));
      ++counted;
    });
    CHECK(counted > 20);
    CHECK(worst < 0.02);
    if (subject.name == "smooth") CHECK(worst < 1e-3);
  }
}
