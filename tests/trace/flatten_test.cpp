// Groups, meshes and motion in the world: what is spelt out by hand gives the same picture, bit for bit.

#include "accel/meshes.h"
#include "io/scene_file.h"
#include "pictures.h"
#include "support/catch.h"
#include "trace/optics.h"
#include "trace/world.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

template <class T>
std::vector<Rgb<T>> pixels_of(const Scene& scene) {
  return picture<T>(scene, 49, 37).pixels;
}

std::shared_ptr<const GroupContent> group_of(std::vector<Object> objects) {
  return std::make_shared<const GroupContent>(Group{"group", std::move(objects)});
}

Object moved(Object object, std::vector<TransformStep> steps) {
  object.transform = std::move(steps);
  return object;
}

Object instance(std::string name, std::shared_ptr<const GroupContent> content, std::vector<TransformStep> steps) {
  return moved({std::move(name), Instance{"group", std::move(content)}, {}}, std::move(steps));
}

MeshShape square_mesh(double z) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshShape shape;
  shape.mesh = mesh;
  return shape;
}

}  // namespace

TEST_CASE("instances give the picture of what they stand for") {
  Scene by_hand = busy_scene(), grouped = by_hand;
  const TransformStep turn{Rotate{{1, 2, 3}, 40}}, shift{Translate{{0.5, 0, 0.25}}}, flip{Mirror{{0, 1, 0}}};
  const std::vector<Object> parts(by_hand.objects.begin(), by_hand.objects.begin() + 4);
  const std::vector<Object> rest(by_hand.objects.begin() + 4, by_hand.objects.end());
  by_hand.objects.clear(), grouped.objects.clear();
  for (const Object& part : parts) by_hand.objects.push_back(moved(part, {turn, shift}));
  for (const Object& part : parts) by_hand.objects.push_back(moved(part, {turn, shift, flip}));
  const auto inner = group_of(parts);
  const auto outer = group_of({instance("inner", inner, {turn, shift})});
  grouped.objects = {instance("first", outer, {}), instance("second", outer, {flip})};
  for (Scene* scene : {&by_hand, &grouped}) scene->objects.insert(scene->objects.end(), rest.begin(), rest.end());
  CHECK((pixels_of<double>(grouped) == pixels_of<double>(by_hand)));
  CHECK((pixels_of<double>(grouped) == pixels_of<double>(by_hand)));  // not both pictures in the message
  CHECK((pixels_of<float>(grouped) == pixels_of<float>(by_hand)));
  const World<double> world(grouped);
  CHECK(world.accelerator.primitives().size() == 10);
  CHECK(world.object(0) == 0);
  CHECK(world.object(7) == 1);
  CHECK(world.object(9) == 3);
  CHECK(world.surfaces.size() == 6);
}

TEST_CASE("triangles of a mesh come after all shapes and know their object") {
  Scene scene = busy_scene();
  scene.objects.insert(scene.objects.begin(), {"Square", square_mesh(-0.5), black()});
  const World<float> world(scene);
  const int shapes = static_cast<int>(scene.objects.size()) - 1;
  CHECK(world.accelerator.primitives().size() == shapes + 2);
  CHECK(world.object(0) == 1);
  CHECK(world.object(shapes) == 0);
  CHECK(world.object(shapes + 1) == 0);
  CHECK(world.surface(shapes).diffuse == Rgb<float>(0));
  CHECK(world.surface(0).specular == Rgb<float>(Rgbd(0.4)));
}

TEST_CASE("a mesh's own materials colour its triangles, unless the scene says otherwise") {
  MeshShape shape = square_mesh(0);
  auto mesh = std::make_shared<Mesh>(*shape.mesh);
  mesh->materials = {0, -1};
  shape.mesh = mesh;
  Material red;
  red.diffuse = {1, 0, 0};
  shape.materials = std::make_shared<const std::vector<Material>>(1, red);
  Scene scene;
  scene.objects = {{"Square", shape, black()}};
  World<double> world(scene);
  CHECK(world.surface(0).diffuse == Rgbd(1, 0, 0));
  CHECK(world.surface(1).diffuse == Rgbd(0.0));
  std::get<MeshShape>(scene.objects[0].shape).file_materials = false;
  CHECK(World<double>(scene).surface(0).diffuse == Rgbd(0.0));
}

namespace {

// Balls of several materials, smooth and with a pattern, by twos and threes in groups of groups, on a mirror.
Scene many_balls() {
  auto ball = std::make_shared<Mesh>(icosphere(2));
  for (std::size_t i = 0; i < ball->triangles.size(); ++i) ball->materials.push_back(static_cast<int>(i % 3) - 1);
  for (const Vec3d& at : ball->positions) ball->uv.push_back({at.x, at.y});
  MeshShape coloured;
  coloured.mesh = ball;
  Material red, mirror;
  red.diffuse = {1, 0.1, 0.1}, red.specular = Rgbd(0.4);
  mirror.diffuse = Rgbd(0.1), mirror.reflection = Rgbd(0.7);
  coloured.materials = std::make_shared<const std::vector<Material>>(std::vector{red, mirror});
  MeshShape flat = coloured;
  flat.file_materials = flat.smooth = false;
  Material checked = mirror;
  checked.checker = Checker{{0.9, 0.9, 0.9}, {0.1, 0.4, 0.1}, 0.3};
  const auto pair = group_of({{"Coloured", coloured, checked},
                              moved({"Flat", flat, checked}, {TransformStep{Translate{{0, 2.5, 0}}}}),
                              moved({"Sphere", Sphere<double>{{0, 0, 1.5}, 0.4}, red}, {})});
  const auto row =
      group_of({instance("near", pair, {TransformStep{Scale{{1, 0.7, 1.2}}}, TransformStep{Rotate{{1, 2, 3}, 40}}}),
                instance("far", pair, {TransformStep{Translate{{3, 0.3, 0}}}, TransformStep{Mirror{{0, 1, 0}}}})});
  Scene scene = busy_scene();
  scene.camera.eye = {-16, 3, 4};
  scene.objects.resize(1);
  for (int i = 0; i < 3; ++i)
    scene.objects.push_back(
        instance("row " + std::to_string(i), row,
                 {TransformStep{Scale{Vec3d(0.6)}}, TransformStep{Translate{{2.0 * i, 3.0 * i - 3, 0}}}}));
  // Its triangles are stored, for it moves, and so are those of glass.
  Object moving = instance("moving", pair, {TransformStep{Translate{{-3, -2, 0}}}});
  moving.motion = {{0, {0, 0, 0}}, {1, {0, 0, 0.4}}};
  scene.objects.push_back(moving);
  Material glass = checked;
  glass.transmission = Rgbd(0.8);
  scene.objects.push_back(moved({"Glass", flat, glass}, {TransformStep{Translate{{-4, 1, 0}}}}));
  return scene;
}

}  // namespace

TEMPLATE_TEST_CASE("meshes that share their triangles give the picture of stored ones, bit for bit", "", float,
                   double) {
  using T = TestType;
  Scene scene = many_balls();
  scene.render.integrator = GENERATE(Integrator::whitted, Integrator::distributed, Integrator::path);
  const BuildOptions share{.share_copies_from = 0}, store{.share_copies_from = 1e9};
  const Sampling two{2};
  const auto stored = picture<T>(scene, 49, 37, two, store), shared = picture<T>(scene, 49, 37, two, share);
  CHECK(same_bits(stored, shared));
  CHECK(stored.statistics.rays == shared.statistics.rays);
  CHECK(stored.statistics.ended == shared.statistics.ended);
  const World<T> all(scene, AcceleratorKind::automatic, {}, store), few(scene, AcceleratorKind::automatic, {}, share);
  const auto &stored_ones = all.accelerator.primitives(), &shared_ones = few.accelerator.primitives();
  REQUIRE(stored_ones.size() == shared_ones.size());
  CHECK(stored_ones.own_size() == stored_ones.size());
  CHECK(shared_ones.triangles().copies().size() == 12);
  CHECK(shared_ones.own_size() == stored_ones.size() - 12 * 320);
  int differing = 0;
  for (int id = 0; id < stored_ones.size(); ++id) {
    differing += all.object(id) != few.object(id);
    differing += all.surface(id).diffuse != few.surface(id).diffuse;
    differing += all.surface(id).reflection != few.surface(id).reflection;
    differing += all.piece(id).triangle != few.piece(id).triangle || all.piece(id).member != few.piece(id).member;
  }
  CHECK(differing == 0);
}

TEST_CASE("what does not move in truth gives the bits of what stands still") {
  const Scene still = busy_scene();
  Scene inert = still;
  inert.objects[0].motion = {{0.3, {0, 0, 0}}};
  inert.objects[2].motion = {{0, {0, 0, 0}}, {1, {0, 0, 0}}};
  CHECK((pixels_of<double>(inert) == pixels_of<double>(still)));
  // One offset at all times is a place.
  Scene placed = still, offset = still;
  placed.objects[1].transform = {{Translate{{0, 0.5, 0.25}}}};
  offset.objects[1].motion = {{0, {0, 0.5, 0.25}}, {1, {0, 0.5, 0.25}}};
  CHECK((pixels_of<double>(offset) == pixels_of<double>(placed)));
  CHECK((pixels_of<double>(offset) != pixels_of<double>(still)));
  // Moving, rays that draw no time see it where it is when the shutter opens.
  Scene moving = still;
  moving.render.integrator = Integrator::whitted;
  moving.objects[1].motion = {{0, {0, 9, 9}}, {1, {0, 0.5, 0.25}}, {2, {7, 0, 0}}};
  moving.camera.shutter_open = 1;
  moving.camera.shutter_close = 1.5;
  const auto a = pixels_of<double>(moving), b = pixels_of<double>(placed);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing += length(Vec3d(a[i] - b[i])) > 1e-9;
  CHECK(differing < a.size() / 100);
}

TEST_CASE("a filtering mesh weights the light at each of its sheets") {
  Scene scene;
  scene.camera.eye = {0, 0, 4};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.ambient = Rgbd(0.0);
  Material white = black();
  white.diffuse = Rgbd(1.0);
  Material filter = black();
  filter.transmission = {0.5, 0.25, 1};
  filter.ior = 1;
  filter.shadow = ShadowKind::filtered;
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, white),
                   {"Upper", square_mesh(7), filter},
                   {"Lower", square_mesh(6), filter}};
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0.1, 0.2, 1}}}};
  const auto seen = pixels_of<double>(scene);
  const Rgbd middle = seen[seen.size() / 2];
  const double n_l = 1 / std::sqrt(1.05);
  CHECK(middle.x == Approx(0.25 * n_l));
  CHECK(middle.y == Approx(0.0625 * n_l));
  CHECK(middle.z == Approx(n_l));
}

TEMPLATE_TEST_CASE("a smoothed normal never sends a ray to the wrong side", "", float, double) {
  using T = TestType;
  const Vec3<T> side(0, 0, 1);
  int bent = 0;
  for (int i = 1; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      const T a = static_cast<T>(i) / 40, b = static_cast<T>(j) / 20;
      const Vec3<T> incident(std::sin(a), 0, -std::cos(a));  // over the horizon at a > pi / 2: not formed
      if (!(dot(incident, side) < 0)) continue;
      const Vec3<T> smooth = normalize(Vec3<T>(std::sin(b), std::sin(3 * b) / 3, std::cos(b)));
      const Vec3<T> normal = consistent_shading_normal(incident, side, smooth);
      CHECK(dot(normal, incident) < 0);
      CHECK(dot(reflect(incident, normal), side) > 0);
      bent += normal != smooth;
      if (dot(smooth, incident) < 0 && dot(reflect(incident, smooth), side) > 0) CHECK(normal == smooth);
    }
  }
  CHECK(bent > 100);
}

TEST_CASE("the shadow cache changes no picture, and saves tests where many points are hidden by one thing") {
  Scene scene = busy_scene();
  scene.objects.push_back(object("Roof", Box<double>{{-9, -9, 2.5}, {9, 9, 3}}, black()));
  for (int i = 0; i < 40; ++i)
    scene.objects.push_back(
        object("Dust " + std::to_string(i), Sphere<double>{{0.1 * i - 2, 2.4, 1.5}, 0.04}, black()));
  const auto run = [&](bool cached) {
    World<double> world(scene);
    world.shadow_cache = cached;
    const RayGenerator<double> camera(scene.camera, {49, 37}, {49, 37});
    std::pair<std::vector<Rgbd>, Statistics> result;
    result.second = trace(world, camera, PixelBlock{0, 49, 0, 37},
                          [&](const Pixel& /*pixel*/, const Rgbd& shade) { result.first.push_back(shade); });
    return result;
  };
  const auto plain = run(false), cached = run(true);
  CHECK((plain.first == cached.first));
  CHECK(plain.second.ends(Ending::blocked) == cached.second.ends(Ending::blocked));
  CHECK(cached.second.tests.nodes < plain.second.tests.nodes);
}
