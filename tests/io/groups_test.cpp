// Groups and their instances, meshes and motion in scene files.

#include "bad_scene.h"
#include "io/scene_file.h"
#include "io/scene_values.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string forest = camera + R"(
# A tree
[[group]]
name = "tree"

[[group.object]]
name = "trunk"                    # upright
type = "cylinder"
radii = 0.2
z_min = 0
z_max = 1

[[group.object]]
name = "crown"
type = "sphere"
centre = [0, 0, 1.5]
radius = 0.8                      # round
[group.object.material]
diffuse = [0.1, 0.6, 0.2]

# Two trees
[[group]]
name = "pair"
object = [
  { name = "left", type = "instance", group = "tree", transform = [["translate", -1, 0, 0]] },
  { name = "right", type = "instance", group = "tree", transform = [["translate", 1, 0, 0]], motion = [[0, 0, 0, 0], [1, 0, 0, 2]] },
]

[[object]]
name = "first pair"               # near the eye
type = "instance"
group = "pair"

[[object]]
name = "tetrahedron"
type = "mesh"
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
)";

std::string with_mesh(const std::string& lines) { return with_object("name = \"M\"\ntype = \"mesh\"\n" + lines); }

}  // namespace

TEST_CASE("a scene with groups is read") {
  const auto read = parse_scene(forest, "forest.toml");
  if (!read) FAIL(read.error().text());
  const Scene& scene = read->scene;
  REQUIRE(scene.groups.size() == 2);
  CHECK(scene.groups[0].objects.size() == 2);
  const auto& pair = std::get<Instance>(scene.objects[0].shape);
  REQUIRE(pair.content);
  CHECK(pair.content->group == scene.groups[1]);
  CHECK(pair.content->nesting == 2);
  CHECK(entries_of(scene.objects) == 1 + 2 + 4 + 1 + 4);
  const Bounds<double> box = bounds(scene.objects[0].shape);
  CHECK(box.min == Vec3d(-1.8, -0.8, 0));
  CHECK(box.max == Vec3d(1.8, 0.8, 2.3));
  CHECK(pair.content->group.objects[1].motion == Motion{{0, {0, 0, 0}}, {1, {0, 0, 2}}});
  const auto& mesh = std::get<MeshShape>(scene.objects[1].shape);
  CHECK(mesh.mesh->triangles[2] == Mesh::Corners{1, 2, 3});
  CHECK(material_uses(scene).size() == 3);
}

TEST_CASE("a scene with groups is written without loss, its comments kept") {
  const auto read = parse_scene(forest, "forest.toml");
  REQUIRE(read);
  CHECK(*format_scene(read->scene, forest) == forest);
  const auto tidy = format_scene(read->scene);
  REQUIRE(tidy);
  CHECK(parse_scene(*tidy, "tidy")->scene == read->scene);
  CHECK_THAT(*tidy, contains("[[group]]\nname = \"tree\"\n\n[[group.object]]\nname = \"trunk\""));

  Scene changed = read->scene;
  std::get<Sphere<double>>(changed.groups[0].objects[1].shape).radius = 0.9;
  changed.objects[0].transform = {{Translate{{0, 3, 0}}}};
  changed.objects[1].motion = {{0, {0, 0, 0}}, {2, {0, 1, 0}}};
  const auto text = format_scene(changed, forest);
  REQUIRE(text);
  CHECK(parse_scene(*text, "changed")->scene == changed);
  for (const char* comment :
       {"# A tree", "# upright", "0.9                      # round", "# Two trees", "# near the eye"})
    CHECK_THAT(*text, contains(comment));
  changed.objects.erase(changed.objects.begin());
  changed.groups[0].objects.pop_back();
  const auto fewer = format_scene(changed, *text);
  REQUIRE(fewer);
  CHECK(parse_scene(*fewer, "fewer")->scene == changed);
}

TEST_CASE("a mesh's file is found beside the scene, and named again when it is written") {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("meshes"));
  put(folder.file("meshes/one.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string text = with_mesh("file = \"meshes/one.obj\"\nsmooth = false\n");
  put(folder.file("scene.toml"), text);
  auto read = read_scene(folder.file("scene.toml"));
  if (!read) FAIL(read.error().text());
  const auto& mesh = std::get<MeshShape>(read->scene.objects[0].shape);
  REQUIRE(mesh.mesh);
  CHECK(mesh.mesh->triangles.size() == 1);
  CHECK_FALSE(mesh.smooth);
  CHECK(*format_scene(read->scene, text) == text);
  CHECK_THAT(*format_scene(read->scene), contains("file = \"meshes/one.obj\""));
  // What is wrong with the mesh is told with the mesh's place; that it is missing, with the scene's.
  put(folder.file("meshes/one.obj"), "v 0 0 0\nf 1 2 3\n");
  const auto bad = read_scene(folder.file("scene.toml"));
  REQUIRE(!bad);
  CHECK(bad.error().file == folder.file("meshes/one.obj"));
  CHECK(bad.error().line == 2);
  std::filesystem::remove(folder.file("meshes/one.obj"));
  const auto missing = read_scene(folder.file("scene.toml"));
  REQUIRE(!missing);
  CHECK(missing.error().file == folder.file("scene.toml"));
  CHECK(missing.error().line == 8);
}

TEST_CASE("what breaks a rule of groups, meshes and motion is refused") {
  const std::string corners = "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n";
  const std::string instance = "[[object]]\nname = \"I\"\ntype = \"instance\"\n";
  const std::string group =
      "[[group]]\nname = \"tree\"\n[[group.object]]\nname = \"B\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n";
  std::string tower =
      camera +
      "[[group]]\nname = \"g0\"\nobject = [{ name = \"s\", type = \"sphere\", centre = [0, 0], radius = 1 }]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string number = std::to_string(i), below = std::to_string(i - 1);
    tower += "[[group]]\nname = \"g" + number + "\"\n";
    for (int j = 0; j < 8; ++j)
      tower += "[[group.object]]\nname = \"" + number + "/" + std::to_string(j) +
               "\"\ntype = \"instance\"\ngroup = \"g" + below + "\"\n";
  }
  const BadScene scenes[] = {
      {"no such group", camera + group + instance + "group = \"tre\"\n", 15, 9, "there is no group \"tre\" above",
       "\"tree\""},
      {"a group of itself",
       camera + "[[group]]\nname = \"a\"\n[[group.object]]\nname = \"b\"\ntype = \"instance\"\ngroup = \"a\"\n", 10, 9,
       "no group \"a\" above", "[[group.object]]"},
      {"an instance with a material", camera + group + instance + "group = \"tree\"\nmaterial = { diffuse = 1 }\n", 16,
       0, "has the materials of the objects in its group", "[[group]]"},
      {"a misspelt key of an instance", camera + group + instance + "group = \"tree\"\ntransfrom = []\n", 16, 1,
       "(expected name, type, group, transform or motion)", "\"transform\"?"},
      {"two of one name",
       camera + group + "[[object]]\nname = \"tree\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n", 13, 8,
       "\"tree\" is already used in line 6", "different name"},
      {"too many", tower, 0, 0, "objects and triangles (expected at most", "grow fast"},
      {"no mesh", with_mesh(""), 5, 0, "has neither file nor vertices", "file ="},
      {"both", with_mesh("file = \"a.obj\"\n" + corners), 0, 0, "", ""},
      {"a wrong corner", with_mesh(corners + "triangles = [[0, 1, 3]]\n"), 9, 0, "names vertex 3 (expected 0 to 2)",
       "number 0"},
      {"half a corner", with_mesh(corners + "triangles = [[0, 1, 0.5]]\n"), 9, 0, "names vertex 0.5", "number 0"},
      {"too few normals", with_mesh(corners + "triangles = [[0, 1, 2]]\nnormals = [[0, 0, 1]]\n"), 10, 0,
       "1 normals for 3 vertices", "each vertex"},
      {"times back", with_sphere("centre = [0, 0]\nradius = 1\nmotion = [[0, 0, 0, 0], [0, 1, 0, 0]]\n"), 10, 0,
       "the time 0 does not come after 0", "order"},
      {"a short key", with_sphere("centre = [0, 0]\nradius = 1\nmotion = [[0, 1, 0]]\n"), 10, 0,
       "a key [time, x, y, z]", ""},
  };
  for (const BadScene& bad : scenes) {
    INFO(bad.name);
    const auto read = parse_scene(bad.text, "bad.toml");
    REQUIRE(!read);
    INFO(read.error().text());
    if (bad.line != 0) CHECK(read.error().line == bad.line);
    if (bad.column != 0) CHECK(read.error().column == bad.column);
    CHECK_THAT(read.error().message, contains(bad.message));
    CHECK_THAT(read.error().hint, contains(bad.hint));
  }
}
