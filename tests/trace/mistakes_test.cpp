// The mistakes of trace/fault.h in light that surfaces send each other, where the light is known in closed form: each
// is far outside of the interval in which the procedure without it lies.

#include "trace/enclosures.h"
#include "trace/photon_scenes.h"

#include <numbers>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The mean of the picture over seeds, with a fault or without.
Means mean_with(Scene scene, std::optional<Fault> fault) {
  constexpr int samples = 4, seeds = 6;
  scene.render.numerics = Numerics::naive;
  const World<double> world(scene, AcceleratorKind::automatic, fault);
  SceneKernel<double> kernel(scene, world);
  std::vector<double> values;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    if (kernel.photons()) static_cast<void>(kernel.send_photons(seed, 0, samples));
    if (kernel.radiosity()) kernel.shoot_light();
    values.push_back(mean_of_picture(kernel, scene, {8, 6}, samples, seed));
  }
  return means_of(values);
}

struct Known {
  Scene scene;
  double radiance;  ///< that every pixel has
};

constexpr double albedo = 0.5, emitted = 1;

Known glowing(const Shape<double>& room, Integrator integrator) {
  Known known{{}, emitted / (1 - albedo)};
  known.scene.objects = {{"Room", room, matt(albedo, emitted)}};
  known.scene.render.integrator = integrator;
  known.scene.render.radiosity.patch = 1.5;
  known.scene.camera.eye = {0.1, 0.2, 0};
  known.scene.camera.look_at = {1, 0.2, 0};
  known.scene.camera.screen = {1, 1, 8};
  known.scene.background = known.scene.ambient = Rgbd(0.0);
  return known;
}

/// A ball with a lamp in its middle, of strength 1 before the factor pi that intensities have (scenes/README.md).
Known lit_by_photons(const Vec3d& eye) {
  constexpr double radius = 2;
  const double irradiance = std::numbers::pi / (radius * radius) / (1 - albedo);
  Known known{by_photons(hollow_ball(radius, albedo, {0, 0, 0}, {0, 0, 1}), 20000, 60),
              albedo / std::numbers::pi * irradiance};
  known.scene.render.photons.radius = 0.5;
  known.scene.camera.eye = eye;
  known.scene.camera.look_at = eye + Vec3d(1, 0, 0);
  return known;
}

Known where_it_is_known(Fault fault) {
  switch (integrator_of(fault)) {
    case Integrator::photons: {
      if (fault != Fault::photons_from_behind) return lit_by_photons({0.1, 0.2, 0});
      // Between the lit ball and one around it, all is dark.
      Known dark = lit_by_photons({-2.5, 0, 0});
      dark.scene.objects.push_back({"Outside", Sphere<double>{{0, 0, 0}, 3}, matt(albedo)});
      dark.radiance = 0;
      return dark;
    }
    case Integrator::radiosity:
      return glowing(Box<double>{{-2, -1.5, -1}, {1.5, 2, 1.2}}, Integrator::radiosity);
    default:
      return glowing(ball, Integrator::path);
  }
}

}  // namespace

TEST_CASE("mistakes about light from everywhere are seen where that light is known", "[odds]") {
  int tried = 0;
  for (const Fault fault : values_of<Fault>) {
    if (integrator_of(fault) == Integrator::automatic) continue;
    ++tried;
    CAPTURE(name_of(fault));
    const Known known = where_it_is_known(fault);
    const Means right = mean_with(known.scene, {}), wrong = mean_with(known.scene, fault);
    CAPTURE(right.mean, right.error, wrong.mean, wrong.error, known.radiance);
    // Circles reach over what curves, and patches are found between their corners.
    const double interval = 4.5 * right.error + 0.02 * known.radiance + 1e-9;
    CHECK(std::abs(right.mean - known.radiance) <= interval);
    CHECK(std::abs(wrong.mean - known.radiance) > 3 * interval + 4.5 * wrong.error);
  }
  CHECK(tried == 8);
}
