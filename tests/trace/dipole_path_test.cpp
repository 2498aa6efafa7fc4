// Paths that leave bodies by the dipole, against what it says of planes and balls in closed form.

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/effort.h"
#include "trace/dipole_limits.h"
#include "trace/paths.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// One unit of length is one mean free path of red; the others are scattered less.
Material milky(double albedo, double ior) {
  Material material = black();
  material.transmission = Rgbd(1.0);
  material.dielectric = ior != 1;
  material.ior = ior;
  material.scattering = Rgbd(albedo, albedo / 2, albedo / 4);
  material.absorption = Rgbd(1 - albedo, 1 - albedo, 1 - albedo);
  return material;
}

Dipole<double> dipole_of(const Material& m) { return {m.absorption, m.scattering, m.anisotropy, m.ior, m.dielectric}; }

Scene by_dipole(const ObjectShape& shape, const Material& material) {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.render.subsurface = Subsurface::dipole;
  scene.background = Rgbd(1.0);
  scene.objects = {{"Milk", shape, material}};
  return scene;
}

// What comes out of a ball of where light goes in: as of a disk of the same area, twice as far.
double of_ball(const Dipole<double>& dipole, int channel, double radius) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps, r = 2 * radius * u * u;
    sum += dipole.diffuse_reflectance(channel, r) * 2 * pi_v<double> * r * 4 * radius * u / steps;
  }
  return sum;
}

double reflected(double ior, double cos) {
  return refraction_at(Vec3d(std::sqrt(1 - cos * cos), 0, -cos), Vec3d(0, 0, 1), 1.0, ior).fresnel();
}

void check_close(const Rgbd& found, double error, const Rgbd& exact) {
  for (int c = 0; c < 3; ++c) {
    CAPTURE(c, found[c], error, exact[c]);
    CHECK(std::abs(found[c] - exact[c]) < 4.5 * error + 2e-5);
  }
  CHECK(error < (rounds(8) == 8 ? 2e-3 : 8e-3));
}

}  // namespace

TEST_CASE("a half-space seen by the dipole reflects its closed form, from any direction", "[odds]") {
  for (const double ior : {1.0, 1.3})
    for (const double albedo : {0.5, 0.9})
      for (const double cos : {1.0, 0.4}) {
        CAPTURE(ior, albedo, cos);
        const Material milk = milky(albedo, ior);
        const Estimate seen = light_along(by_dipole(Plane<double>{{0, 0, 0}, {-1, 0, 0}}, milk),
                                          {-cos, -std::sqrt(1 - cos * cos), 0}, {0, 0, 0}, rounds(1 << 17));
        const double mirrored = reflected(ior, cos);
        check_close(seen.mean, seen.error, mirrored + (1 - mirrored) * dipole_of(milk).total_reflectance());
      }
}

TEST_CASE("a ball seen by the dipole reflects what its surface says, as far as it goes", "[odds]") {
  for (const double ior : {1.0, 1.3})
    for (const double radius : {0.4, 2.0}) {
      CAPTURE(ior, radius);
      const Material milk = milky(0.95, ior);
      const Estimate seen = light_along(by_dipole(Sphere<double>{{0, 0, 0}, radius}, milk), {-9, 0.3 * radius, 0},
                                        {0, 0.3 * radius, 0}, rounds(1 << 17));
      const double mirrored = reflected(ior, std::sqrt(1 - 0.09));
      const Dipole<double> dipole = dipole_of(milk);
      Rgbd exact;
      for (int c = 0; c < 3; ++c) exact[c] = mirrored + (1 - mirrored) * of_ball(dipole, c, radius);
      check_close(seen.mean, seen.error, exact);
    }
}

TEST_CASE("a mesh of a ball is no other", "[odds]") {
  // A cube of 1 about the middle, by its shape and by triangles that have the same six sides.
  const Material milk = milky(0.9, 1.3);
  const Estimate box = light_along(by_dipole(Box<double>{{-1, -1, -1}, {1, 1, 1}}, milk), {-9, 0.2, 0.1}, {0, 0.2, 0.1},
                                   rounds(1 << 17));
  const Estimate mesh =
      light_along(by_dipole(box_mesh({-1, -1, -1}, {1, 1, 1}), milk), {-9, 0.2, 0.1}, {0, 0.2, 0.1}, rounds(1 << 17));
  check_close(box.mean, std::sqrt(box.error * box.error + mesh.error * mesh.error), mesh.mean);
}

TEST_CASE("lamps, things that emit and directions find the same light where it comes out", "[odds]") {
  const Material milk = milky(0.9, 1.3);
  const Dipole<double> dipole = dipole_of(milk);
  const double mirrored = reflected(1.3, 1);
  Scene scene = by_dipole(Plane<double>{{0, 0, 0}, {-1, 0, 0}}, milk);
  scene.background = Rgbd(0.0);
  DirectionalLight sun;
  const double cos = 0.6;
  sun.direction = {-cos, 0.8, 0};
  scene.lights = {{"Sun", Rgbd(1.0), sun}};
  const Estimate lit = light_along(scene, {-1, 0, 0}, {0, 0, 0}, rounds(1 << 17));
  check_close(lit.mean, lit.error, (1 - mirrored) * cos * dipole.leaving(cos) * dipole.total_reflectance());

  scene.lights.clear();
  scene.objects.push_back({"Lamp", Sphere<double>{{-3, 2, 0}, 1}, glowing(3)});
  const auto by = [&](PathStrategy strategy) {
    PathSettings settings;
    settings.strategy = strategy;
    return light_along(scene, {-1, 0, 0}, {0, 0, 0}, rounds(1 << 18), settings);
  };
  const Estimate both = by(PathStrategy::both), lights = by(PathStrategy::lights),
                 directions = by(PathStrategy::directions);
  CHECK(both.error < directions.error);
  CHECK(std::abs(both.mean.x - lights.mean.x) < 4.5 * std::hypot(both.error, lights.error));
  CHECK(std::abs(both.mean.x - directions.mean.x) < 4.5 * std::hypot(both.error, directions.error));
}

TEMPLATE_TEST_CASE("watched or not, by the dipole the same light comes out, and all of it is a number", "", float,
                   double) {
  struct Counter final : Observer {
    int exits = 0;
    void record(Event&& event) override {
      if (const auto* found = std::get_if<Found>(&event.detail))
        exits += std::holds_alternative<DipoleNumbers>(found->numbers);
    }
  } counter;
  Scene scene = by_dipole(Sphere<double>{{0, 0, 0}, 1}, milky(0.9, 1.3));
  scene.objects.push_back({"Floor", Plane<double>{{0, 0, -1.2}, {0, 0, 1}}, matte(0.5)});
  scene.objects.push_back({"Thin", Disk<double>{{0, 2, 0}, {-1, 0, 0}, 0.5}, matte(0.5, 2)});
  scene.camera.eye = {-4, 0, 0};
  scene.camera.screen = {1, 1.2, 3};
  const auto plain = path_picture<TestType>(scene, 31, 23, {}, {4, 7});
  const auto watched = path_picture<TestType>(scene, 31, 23, {}, {4, 7}, &counter);
  CHECK(same_bits(plain, watched));
  CHECK(same_counts(plain.statistics, watched.statistics));
  CHECK(counter.exits > 150);
  CHECK(plain.statistics.ends(Ending::scattered) == static_cast<std::uint64_t>(counter.exits));
  CHECK(plain.statistics.not_finite == 0);
  for (const auto& shade : plain.pixels) CHECK((shade.x >= 0 && shade.y >= 0 && shade.z >= 0));
}

TEST_CASE("bodies that lie in one another are walked through, and that is said; so is what the dipole makes wrong") {
  const Material milk = milky(0.9, 1.3);
  Scene scene = by_dipole(Sphere<double>{{0, 0, 0}, 9}, milk);
  scene.camera.eye = {-20, 0, 0};
  scene.render.integrator = Integrator::path;
  CHECK(World<double>(scene).dipoles.size() == 1);
  CHECK(dipole_losses(scene).empty());
  scene.objects.push_back({"Bubble", Sphere<double>{{0, 0, 0}, 1}, milky(0.9, 1.4)});
  CHECK(World<double>(scene).dipoles.empty());
  REQUIRE(dipole_losses(scene).size() == 1);
  CHECK(dipole_losses(scene)[0].find("walks") != std::string::npos);
  scene.objects.pop_back();
  scene.camera.eye = {0, 0, 0};  // all around the eye
  CHECK(World<double>(scene).dipoles.empty());
  scene.camera.eye = {-20, 0, 0};

  scene.objects[0].shape = Box<double>{{-9, -9, 0}, {9, 9, 1}};
  REQUIRE(dipole_losses(scene).size() == 1);
  CHECK(dipole_losses(scene)[0].find("\"Milk\" is only") == 0);
  scene.objects[0].shape = Sphere<double>{{0, 0, 0}, 9};
  scene.objects[0].material = milky(0.3, 1.3);
  REQUIRE(dipole_losses(scene).size() == 1);
  CHECK(dipole_losses(scene)[0].find("too dark") != std::string::npos);
  // Nobody asked for it.
  scene.render.subsurface = Subsurface::walk;
  CHECK(dipole_losses(scene).empty());
  CHECK(World<double>(scene).dipoles.empty());
  scene.render.subsurface = Subsurface::dipole;
  scene.render.integrator = Integrator::whitted;
  CHECK(dipole_losses(scene).empty());
}
