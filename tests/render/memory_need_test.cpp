#include "render/memory_need.h"

#include "support/catch.h"

using namespace raywalk;

namespace {

Object instance_of(const std::shared_ptr<const GroupContent>& content, double x) {
  Instance instance;
  instance.content = content;
  Object object{"I" + std::to_string(x), instance, {}};
  object.transform = {{Translate{{x, 0, 0}}}};
  return object;
}

// 10^levels spheres, by groups of ten.
Scene crowd(int levels) {
  Group group{"G", {{"Ball", Sphere<double>{}, {}}}};
  auto content = std::make_shared<const GroupContent>(group);
  for (int level = 0; level < levels; ++level) {
    group.objects.clear();
    for (int i = 0; i < 10; ++i) group.objects.push_back(instance_of(content, i));
    content = std::make_shared<const GroupContent>(group);
  }
  Scene scene;
  scene.objects = {instance_of(content, 0)};
  return scene;
}

}  // namespace

TEST_CASE("instances are counted, not walked: a crowd of 10^30 is told at once") {
  const MemoryNeed need = memory_needed(crowd(30), {});
  CHECK(need.bytes > 1e32);
  CHECK_THAT(need.what, test::contains("shapes"));
}

TEST_CASE("the estimate of a crowd is what it was measured to be, within a third") {
  RenderSettings settings;
  settings.size = ImageSize{1, 1};
  const auto per_instance = [&] { return memory_needed(crowd(5), settings).bytes / 1e5; };
  // Measured as the difference of 400,000 and 200,000 instances of a sphere.
  CHECK(per_instance() == Approx(466).epsilon(0.33));
  settings.precision = Precision::float_;
  CHECK(per_instance() == Approx(305).epsilon(0.33));
  settings.precision = Precision::double_;
  settings.accelerator = AcceleratorKind::none;
  CHECK(per_instance() == Approx(372).epsilon(0.33));
}

TEST_CASE("objects that are no instances bring a surface each") {
  Scene scene;
  for (int i = 0; i < 1000; ++i) scene.objects.push_back({"Ball", Sphere<double>{{3.0 * i, 0, 0}, 1}, {}});
  RenderSettings settings;
  settings.size = ImageSize{1, 1};
  const auto per_object = [&] { return memory_needed(scene, settings).bytes / 1e3; };
  // Measured as the difference of rendering and of reading 800,000 strewn spheres.
  CHECK(per_object() == Approx(740).epsilon(0.33));
  settings.precision = Precision::float_;
  CHECK(per_object() == Approx(490).epsilon(0.33));
}

namespace {

// `copies` of a mesh of so many triangles that nobody looks at.
Scene forest(int copies, std::size_t triangles) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions.resize(triangles / 2);
  mesh->triangles.resize(triangles);
  MeshShape shape;
  shape.mesh = mesh;
  const auto content = std::make_shared<const GroupContent>(Group{"G", {{"Tree", shape, {}}}});
  Scene scene;
  for (int i = 0; i < copies; ++i) scene.objects.push_back(instance_of(content, i));
  return scene;
}

}  // namespace

TEST_CASE("copies of a mesh need little, unless a structure lists their triangles") {
  RenderSettings settings;
  settings.size = ImageSize{1, 1};
  const Scene trees = forest(10'000, 70'000);
  const double shared = memory_needed(trees, settings).bytes;
  // Measured: a render of 10,000 bunnies takes 120 MB more than one of a single bunny's file read.
  CHECK(shared < 3e8);
  settings.accelerator = AcceleratorKind::bvh;
  CHECK(memory_needed(trees, settings).bytes == Approx(shared));
  settings.accelerator = AcceleratorKind::grid;
  const MemoryNeed all = memory_needed(trees, settings);
  CHECK(all.bytes > 1e10);
  CHECK_THAT(all.what, test::contains("copies of meshes"));
  // More than there are numbers: they are stored, which needs too much.
  settings.accelerator = AcceleratorKind::automatic;
  CHECK(memory_needed(forest(100'000, 70'000), settings).bytes > 1e12);
}

TEST_CASE("a large picture of a small scene is what is named") {
  RenderSettings settings;
  settings.size = ImageSize{20000, 10000};
  const MemoryNeed need = memory_needed(crowd(1), settings);
  CHECK(need.what == "a picture of 20000 x 10000 pixels");
  CHECK(need.bytes >= 2e8 * 36);
}
