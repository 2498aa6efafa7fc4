// The dipole by itself: what comes out of a plane is its closed form, and distances are drawn as that says.

#include "trace/dipole.h"

#include <cmath>

#include "support/catch.h"

using namespace raywalk;

namespace {

// What is absorbed or scattered per unit of length is `extinction` in all.
template <class T>
Dipole<T> milk(double albedo, double ior = 1, double extinction = 1, bool by_fresnel = true) {
  return {Rgb<T>(static_cast<T>((1 - albedo) * extinction)), Rgb<T>(static_cast<T>(albedo * extinction)), T(0),
          static_cast<T>(ior), by_fresnel};
}

// Fresnel's reflectance of unpolarised light that comes from an index n1.
double fresnel(double n1, double n2, double cos) {
  const double sin = n1 / n2 * std::sqrt(1 - cos * cos);
  if (sin >= 1) return 1;
  const double out = std::sqrt(1 - sin * sin);
  const double s = (n1 * cos - n2 * out) / (n1 * cos + n2 * out), p = (n2 * cos - n1 * out) / (n2 * cos + n1 * out);
  return (s * s + p * p) / 2;
}

// Of light inside that goes out evenly: (1 + F) / (1 - F).
double a_of(double ior, bool by_fresnel = true) {
  constexpr int steps = 200000;
  double reflected = 0;
  for (int i = 0; i < steps; ++i) {
    const double cos = (i + 0.5) / steps, all = fresnel(ior, 1, cos);
    reflected += 2 * cos * (by_fresnel || all == 1 ? all : 0.0) / steps;
  }
  return (1 + reflected) / (1 - reflected);
}

// As the paper has it.
double closed_form(double albedo, double a) {
  const double falloff = std::sqrt(3 * (1 - albedo));
  return albedo / 2 * (1 + std::exp(-4.0 / 3 * a * falloff)) * std::exp(-falloff);
}

// The integral of R_d over the disk of this radius.
double within(const Dipole<double>& dipole, double radius) {
  constexpr int steps = 200000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    // r = radius u^2: closer to the middle, where most comes out
    const double u = (i + 0.5) / steps, r = radius * u * u;
    sum += dipole.diffuse_reflectance(0, r) * 2 * pi_v<double> * r * 2 * radius * u / steps;
  }
  return sum;
}

}  // namespace

TEST_CASE("a dipole's light is what the closed form says, whatever bends at the surface") {
  for (const double ior : {1.0, 1.3, 1.5})
    for (const double albedo : {0.3, 0.5, 0.9, 0.99}) {
      CAPTURE(ior, albedo);
      const double exact = closed_form(albedo, a_of(ior));
      CHECK(milk<double>(albedo, ior).total_reflectance().x == Approx(exact).epsilon(1e-5));
      CHECK(milk<float>(albedo, ior).total_reflectance().x == Approx(exact).epsilon(1e-4));
      CHECK(within(milk<double>(albedo, ior), 300) == Approx(exact).epsilon(1e-3));
      // Of no scale.
      CHECK(milk<double>(albedo, ior, 40).total_reflectance().x == Approx(exact).epsilon(1e-5));
      CHECK(within(milk<double>(albedo, ior, 40), 300.0 / 40) == Approx(exact).epsilon(1e-3));
    }
  CHECK(milk<double>(0.9).total_reflectance().x == Approx(0.385584).epsilon(1e-5));
  CHECK(milk<double>(1, 1.4).total_reflectance().x == Approx(1));
  // Jensen et al. have F_dr by a polynomial of the index.
  for (const double n : {1.1, 1.3, 1.5}) {
    const double polynomial = -1.440 / (n * n) + 0.710 / n + 0.668 + 0.0636 * n;
    CHECK((1 + polynomial) / (1 - polynomial) == Approx(a_of(n)).epsilon(0.02));
  }
}

TEST_CASE("a surface that reflects by its own colour reflects inside only what cannot get out") {
  CHECK(a_of(1.5, false) == Approx((1 + (1 - 1 / 2.25)) / (1 / 2.25)).epsilon(1e-4));
  CHECK(milk<double>(0.9, 1.5, 1, false).total_reflectance().x ==
        Approx(closed_form(0.9, a_of(1.5, false))).epsilon(1e-4));
  CHECK(milk<double>(0.9, 1.5, 1, false).leaving(0.3) == 1);
}

TEST_CASE("light that is mostly scattered ahead is as if less of it were scattered") {
  const Dipole<double> ahead(Rgbd(0.1), Rgbd(2.0), 0.75, 1.3, true), evenly(Rgbd(0.1), Rgbd(0.5), 0, 1.3, true);
  for (const double r : {0.0, 0.1, 1.0, 5.0})
    CHECK(ahead.diffuse_reflectance(0, r) == Approx(evenly.diffuse_reflectance(0, r)));
}

TEST_CASE("all that comes out goes somewhere") {
  for (const double ior : {0.8, 1.0, 1.3, 2.4}) {
    const Dipole<double> dipole = milk<double>(0.9, ior);
    double sum = 0;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
      const double cos = (i + 0.5) / steps;
      sum += 2 * cos * dipole.leaving(cos) / steps;
      if (i % 1000 == 0) CHECK(dipole.transmittance(cos) == Approx(1 - fresnel(1, ior, cos)).epsilon(0).margin(1e-9));
    }
    CHECK(sum == Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("distances are drawn by what comes out there") {
  const auto check = []<class T>(T, double albedo, double ior, double tolerance) {
    const Dipole<T> dipole = milk<T>(albedo, ior, 2);
    const Dipole<double> exact = milk<double>(albedo, ior, 2);
    const double far[] = {0.05, 0.2, 0.7, 2, 6};
    int nearer[5] = {};
    constexpr int draws = 1 << 16;
    for (int i = 0; i < draws; ++i) {
      const T r = dipole.sample_radius(1, static_cast<T>((i + 0.5) / draws));
      REQUIRE(r >= 0);
      REQUIRE(std::isfinite(r));
      for (int k = 0; k < 5; ++k) nearer[k] += r < far[k];
    }
    for (int k = 0; k < 5; ++k) {
      CAPTURE(albedo, ior, far[k]);
      CHECK(nearer[k] / static_cast<double>(draws) ==
            Approx(within(exact, far[k]) / exact.total_reflectance().x).margin(tolerance));
      CHECK(dipole.pdf(1, static_cast<T>(far[k])) ==
            Approx(exact.diffuse_reflectance(0, far[k]) / exact.total_reflectance().x).epsilon(tolerance));
    }
  };
  for (const double albedo : {0.2, 0.9, 0.9999, 1.0})
    for (const double ior : {1.0, 1.3}) {
      check(1.0, albedo, ior, 1e-4);
      check(1.0F, albedo, ior, 1e-3);
    }
}

TEST_CASE("a channel that scatters nothing lets nothing out, and none is without number") {
  const Dipole<float> red({1, 1, 0}, {1, 0, 0}, 0, 1.3F, true);
  CHECK(red.total_reflectance().y == 0);
  CHECK(red.total_reflectance().z == 0);
  for (const float r : {0.0F, 1e-30F, 1e-3F, 1.0F, 1e15F})
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(r, channel);
      CHECK(std::isfinite(red.diffuse_reflectance(channel, r)));
      CHECK(std::isfinite(red.pdf(channel, r)));
      CHECK((channel == 0 || red.pdf(channel, r) == 0));
    }
}
