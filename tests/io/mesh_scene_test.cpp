#include "io/mesh_scene.h"

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a mesh opens as a scene that shows all of it, and is saved as a scene") {
  const std::string ball = std::string(RAYWALK_SOURCE_DIR) + "/scenes/ball.ply";
  auto document = read_scene(ball);
  REQUIRE(document);
  const Scene& scene = document->scene;
  REQUIRE(scene.objects.size() == 1);
  CHECK(scene.title == "ball.ply");
  // Every corner of the mesh is in the picture, and the mesh fills a good part of it.
  const Camera& camera = scene.camera;
  const Vec3d forward = normalize(camera.look_at - camera.eye), right = normalize(cross(forward, camera.up));
  const double aspect = static_cast<double>(scene.image.height) / scene.image.width;
  double widest = 0, highest = 0;
  for (const Vec3d& position : std::get<MeshShape>(scene.objects[0].shape).mesh->positions) {
    const Vec3d way = position - camera.eye;
    const double depth = dot(way, forward) * camera.half_extent();
    REQUIRE(depth > 0);
    widest = std::max(widest, std::abs(dot(way, right)) / depth);
    highest = std::max(highest, std::abs(dot(way, cross(right, forward))) / depth / aspect);
  }
  CHECK(widest < 1);
  CHECK(highest < 1);
  CHECK(std::max(widest, highest) > 0.5);

  const TemporaryFolder folder;
  CHECK_FALSE(write_scene(*document, folder.file("ball.ply")));  // a mesh's file is never written over
  REQUIRE(write_scene(*document, folder.file("ball.toml")));
  const auto again = read_scene(folder.file("ball.toml"));
  REQUIRE(again);
  CHECK(with_names_from(again->scene, again->path, ball).value() == scene);  // but for where the mesh is seen from
}

TEST_CASE("what a mesh file warns of is told, whether it is opened or a scene names it") {
  const TemporaryFolder folder;
  const std::string flat = "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", told = "its only triangle has no area";
  put(folder.file("flat.obj"), flat);
  const auto mesh = read_scene(folder.file("flat.obj"));
  REQUIRE(mesh);
  REQUIRE(mesh->warnings.size() == 1);
  CHECK_THAT(mesh->warnings[0], contains(told));
  const std::string head = "[camera]\neye = [5, 0, 0]\nlook_at = [0, 0, 0]\nfov = 45\n",
                    object = "[[object]]\ntype = \"mesh\"\n";
  put(folder.file("named.toml"),
      head + object + "name = \"a\"\nfile = \"flat.obj\"\n" + object + "name = \"b\"\nfile = \"flat.obj\"\n");
  const auto named = read_scene(folder.file("named.toml"));
  if (!named) FAIL(named.error().text());
  REQUIRE(named->warnings.size() == 1);
  CHECK_THAT(named->warnings[0], contains("flat.obj: warning: " + told));
  const auto inside = parse_scene(
      head + object + "name = \"a\"\nvertices = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]\ntriangles = [[0, 1, 2]]\n",
      "a.toml");
  if (!inside) FAIL(inside.error().text());
  REQUIRE(inside->warnings.size() == 1);
  CHECK_THAT(inside->warnings[0], contains("a.toml:9:13: warning: "));
  CHECK_THAT(inside->warnings[0], contains(told));
}

TEST_CASE("a mesh that cannot be read is told of as such") {
  const auto none = read_scene("nowhere.ply");
  REQUIRE_FALSE(none);
  CHECK(none.error().file == "nowhere.ply");
}
