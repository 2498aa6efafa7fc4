// What a picture's file cannot hold is counted, whatever the tracer's own numbers are.

#include "render/render.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

// All that is seen shines with `radiance`.
Scene wall(double radiance) {
  Scene scene;
  scene.camera.eye = {0, 0, 4};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.image = {4, 3};
  Material material;
  material.diffuse = Rgbd(0.0);
  material.emission = Rgbd(radiance);
  scene.objects = {{"Wall", Plane<double>{}, material}};
  return scene;
}

}  // namespace

TEST_CASE("shades beyond a file's float are counted, by every integrator and in both precisions") {
  for (const Precision precision : {Precision::double_, Precision::float_})
    for (const Integrator integrator :
         {Integrator::cast, Integrator::whitted, Integrator::distributed, Integrator::path}) {
      RenderSettings settings;
      settings.precision = precision;
      settings.sampling.per_pixel = 2;
      Scene scene = wall(1e39);  // a float holds 3.4e38
      scene.render.integrator = integrator;
      const auto too_bright = render(scene, settings);
      REQUIRE(too_bright);
      INFO(name_of(integrator) << (precision == Precision::float_ ? ", float" : ", double"));
      CHECK(too_bright->statistics.not_finite == 2 * 12);
      CHECK(too_bright->not_finite_pixels == 12);
      scene.objects[0].material.emission = Rgbd(3e38);
      const auto bright = render(scene, settings);
      REQUIRE(bright);
      CHECK(bright->statistics.not_finite == 0);
      CHECK(bright->not_finite_pixels == 0);
    }
}

TEST_CASE("pixels are counted too: the sum of bright corners may be too large where none of them is") {
  RenderSettings settings;
  settings.precision = Precision::float_;
  settings.sampling.corners = true;
  const auto rendering = render(wall(3e38), settings);
  REQUIRE(rendering);
  CHECK(rendering->statistics.not_finite == 0);
  CHECK(rendering->not_finite_pixels == 12);
}
