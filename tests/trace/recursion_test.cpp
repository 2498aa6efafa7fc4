// How much stack SHADE takes to call itself, of every kernel: what is promised to those who make the stack.

#include "trace/recursion.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "support/catch.h"
#include "trace/scene_kernel.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Asked before the first level and at each from the fifth on: notes how far apart the stack was.
class Depths : public Stopper {
 public:
  Depths() { raised = true; }
  bool stops() override {
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    least = std::min(least, here), most = std::max(most, here);
    ++times;
    return false;
  }
  std::uintptr_t least = std::numeric_limits<std::uintptr_t>::max(), most = 0;
  int times = 0;
};

class Nobody : public Observer {
 public:
  void record(Event&& event) override { const Event taken = std::move(event); }
};

// Between two mirrors, or inside a glass ball: one ray a level.
Scene endless(int depth, bool glass) {
  Scene scene;
  scene.limits = {depth, 0};
  scene.camera.eye = {0, 0, 0};
  scene.camera.look_at = {1, 0.001, 0};
  scene.image = {1, 1};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0.5, 0}, {}}}};
  Material mirror;
  (glass ? mirror.transmission : mirror.reflection) = Rgbd(0.999);
  if (glass) {
    mirror.ior = 1.0001;
    for (int i = 0; i < depth + 4; ++i)
      scene.objects.push_back({"Pane " + std::to_string(i), Plane<double>{{1.0 + i, 0, 0}, {-1, 0, 0}}, mirror});
  } else {
    scene.objects.push_back({"Right", Plane<double>{{1, 0, 0}, {-1, 0, 0}}, mirror});
    scene.objects.push_back({"Left", Plane<double>{{-1, 0, 0}, {1, 0, 0}}, mirror});
  }
  return scene;
}

template <class T>
std::size_t bytes_a_level(const Scene& scene, std::optional<Fault> fault, bool watched) {
  const World<T> world(scene, AcceleratorKind::automatic, fault);
  const RayGenerator<T> camera(scene, {1, 1}, {1, 1});
  Depths depths;
  const PixelBlock block{0, 1, 0, 1, 0, 1, 1, Stop(depths)};
  const PutPixel<T> nowhere = [](const Pixel&, const Rgb<T>&) {};
  Nobody nobody;
  const SceneKernel<T> kernel(scene, world);
  if (watched)
    trace_watched(world, camera, block, nowhere, nobody);
  else
    static_cast<void>(trace(world, camera, block, nowhere));
  REQUIRE(depths.times >= scene.limits.depth - 4);
  return (depths.most - depths.least) / static_cast<std::size_t>(scene.limits.depth - 2);
}

}  // namespace

TEMPLATE_TEST_CASE("no kernel takes more stack a level than is promised", "[trace]", float, double) {
  const Integrator integrator = GENERATE(Integrator::whitted, Integrator::distributed);
  const bool glass = GENERATE(false, true), naive = GENERATE(false, true), watched = GENERATE(false, true);
  const bool lobes = GENERATE(false, true), wide = GENERATE(false, true), textures = GENERATE(false, true);
  CAPTURE(integrator, glass, naive, watched, lobes, wide, textures);
  Scene scene = endless(40, glass);
  scene.render.integrator = integrator;
  scene.render.numerics = naive ? Numerics::naive : Numerics::robust;
  for (Object& object : scene.objects) {
    // So little that no ray leaves its way.
    if (lobes) object.material.gloss = object.material.translucency = 1e-9;
    if (textures) object.material.checker = Checker{Rgbd(1.0), Rgbd(0.9), 1};
  }
  if (wide) scene.lights = {{"Ball", Rgbd(1.0), SphereLight{{0, 0.5, 0}, 0.1, 1, {}}}};
  const std::size_t bytes = bytes_a_level<TestType>(scene, {}, watched);
  CAPTURE(bytes);
  CHECK(bytes > 64);
  CHECK(bytes <= stack_a_level);
}

TEMPLATE_TEST_CASE("nor does one that is broken on purpose", "[trace]", float, double) {
  const bool watched = GENERATE(false, true);
  const std::size_t bytes = bytes_a_level<TestType>(endless(40, false), Fault::shadow_ray_misaimed, watched);
  CAPTURE(bytes);
  CHECK(bytes <= stack_a_level);
}

TEST_CASE("what is too deep for the stack is refused with what fits", "[trace]") {
  CHECK_FALSE(why_too_deep(10));
  const auto error = why_too_deep(1 << 30);
  REQUIRE(error);
  CHECK_THAT(error->text(), contains("KiB of stack") && contains("fits"));
  CHECK(stack_left() > std::size_t{64} << 10);
}
