#include "scene/copied_meshes.h"

#include "support/catch.h"

using namespace raywalk;

namespace {

MeshShape mesh_of(std::size_t triangles) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles.assign(triangles, {0, 1, 2});
  MeshShape shape;
  shape.mesh = mesh;
  return shape;
}

std::shared_ptr<const GroupContent> group_of(std::vector<Object> objects) {
  return std::make_shared<const GroupContent>(Group{"group", std::move(objects)});
}

Object instance(const std::shared_ptr<const GroupContent>& content) { return {"Copy", Instance{"group", content}, {}}; }

}  // namespace

TEST_CASE("what stands in several places is copied, through groups of groups") {
  const Object tree{"Tree", mesh_of(100), {}}, stone{"Stone", mesh_of(100), {}};
  const auto inner = group_of({tree, tree}), outer = group_of({instance(inner), instance(inner), stone});
  Scene scene;
  scene.objects = {instance(outer), instance(inner)};
  const CopiedMeshes copied(scene);
  CHECK(copied.has(tree, false));
  CHECK_FALSE(copied.has(tree, true));
  CHECK_FALSE(copied.has(stone, false));
  CHECK(copied.share(600));
  CHECK_FALSE(copied.share(601));
  CHECK(copied.spared() == 5 * 100 - 6);
  CHECK_FALSE(copied.share());
}

TEST_CASE("what moves, transmits or emits is not, nor what has few triangles") {
  Object tree{"Tree", mesh_of(100), {}};
  SECTION("moves") { tree.motion = {{0, {0, 0, 0}}, {1, {0, 0, 1}}}; }
  SECTION("transmits") { tree.material.transmission = Rgbd(0.5); }
  SECTION("emits") { tree.material.emission = Rgbd(0.5); }
  SECTION("has few") { tree.shape = mesh_of(31); }
  SECTION("wears a material that transmits") {
    auto& shape = std::get<MeshShape>(tree.shape);
    Material glass;
    glass.transmission = Rgbd(0.5);
    auto mesh = *shape.mesh;
    mesh.materials.assign(mesh.triangles.size(), 0);
    shape.mesh = std::make_shared<const Mesh>(mesh);
    shape.materials = std::make_shared<const std::vector<Material>>(1, glass);
  }
  Scene scene;
  scene.objects = {instance(group_of({tree, tree}))};
  const CopiedMeshes copied(scene);
  CHECK_FALSE(copied.has(tree, !tree.motion.empty()));
  CHECK(copied.spared() == 0);
}

TEST_CASE("an instance that moves takes its copies out") {
  const Object tree{"Tree", mesh_of(100), {}};
  const auto group = group_of({tree});
  Scene scene;
  scene.objects = {instance(group), instance(group)};
  CHECK(CopiedMeshes(scene).has(tree, false));
  scene.objects[1].motion = {{0, {0, 0, 0}}, {1, {0, 0, 1}}};
  CHECK_FALSE(CopiedMeshes(scene).has(tree, false));
}

TEST_CASE("so many copies that their triangles cannot be numbered are not shared") {
  auto content = group_of({{"Tree", mesh_of(100'000), {}}});
  for (int level = 0; level < 5; ++level) content = group_of(std::vector<Object>(10, instance(content)));
  Scene scene;
  scene.objects = {instance(content)};
  CHECK_FALSE(CopiedMeshes(scene).share(0));
}
