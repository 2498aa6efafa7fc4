// Primary rays that are searched together: each pixel is what it is alone.

#include "trace/primary_rays.h"

#include "accel/meshes.h"
#include "support/catch.h"
#include "trace/pictures.h"
#include "trace/scene_kernel.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A ball of 1,280 triangles, half of it behind a mirror, under a lamp and a sky; an emitter over it.
Scene ball_scene(Integrator integrator, double aperture) {
  Scene scene;
  scene.camera.eye = {0.3, -4, 1}, scene.camera.look_at = Vec3d(0.0), scene.camera.up = {0, 0, 1};
  scene.camera.fov = FieldOfView{40, FovAxis::x};
  scene.camera.aperture = aperture;
  MeshShape mesh;
  mesh.mesh = std::make_shared<Mesh>(icosphere(3));
  scene.objects.push_back({"Ball", mesh, {}});
  scene.objects.back().material.diffuse = Rgbd(0.6);
  scene.objects.push_back({"Mirror", Sphere<double>{{0.5, -1, 0}, 0.4}, {}});
  scene.objects.back().material.reflection = Rgbd(0.8);
  scene.objects.push_back({"Panel", Box<double>{{-1, -1, 2}, {0, 0, 2.1}}, {}});
  scene.objects.back().material.emission = Rgbd(3.0);
  scene.lights.push_back({"Lamp", Rgbd(0.5), PointLight{{2, -3, 3}, {}}});
  scene.sky = Sky{GradientSky{}};
  scene.render.integrator = integrator;
  return scene;
}

template <class T>
std::vector<Rgb<T>> traced(const SceneKernel<T>& kernel, const RayGenerator<T>& camera, const PixelBlock& block,
                           Statistics& statistics) {
  std::vector<Rgb<T>> shades;
  statistics += kernel(camera, block, [&](const Pixel&, const Rgb<T>& shade) { shades.push_back(shade); });
  return shades;
}

}  // namespace

TEMPLATE_TEST_CASE("pixels of a mesh have the bits that each has alone, whatever is searched with them", "", float,
                   double) {
  using T = TestType;
  const Integrator integrator = GENERATE(Integrator::whitted, Integrator::distributed, Integrator::path);
  const int samples = GENERATE(1, 3);
  const double aperture = GENERATE(0.0, 0.1);
  const Scene scene = ball_scene(integrator, aperture);
  const World<T> world(scene);
  REQUIRE(world.accelerator.knows_packets());
  const ImageSize size{21, 9};
  const SceneKernel<T> kernel(scene, world);
  const RayGenerator<T> camera(scene, size, size, Sampling{samples});
  Statistics together, alone;
  PixelBlock all{0, size.width, 0, size.height};
  all.samples = samples;
  const auto shades = traced(kernel, camera, all, together);
  std::vector<Rgb<T>> each;
  for (const Pixel& pixel : all)
    for (const Rgb<T>& shade :
         traced(kernel, camera, {pixel.column, pixel.column + 1, pixel.row, pixel.row + 1, pixel.sample}, alone))
      each.push_back(shade);
  CHECK(shades == each);
  CHECK(together.rays == alone.rays);
  CHECK(together.ended == alone.ended);
  CHECK(together.draws == alone.draws);
}
