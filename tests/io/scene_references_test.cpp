#include "image/image_file.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
#include "text/file.h"

#include <string>

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

namespace {

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string meshes_and_textures =
    "# mine\n[camera]\neye = [-5, 0]\nlook_at = [0, 0]\nfov = 45\n"
    "[[group]]\nname = \"G\"\n[[group.object]]\nname = \"P\"\ntype = \"mesh\"\nfile = \"parts/p.ply\"\n"
    "[[object]]\nname = \"M\"\ntype = \"mesh\"\nfile = \"m.ply\"  # beside it\n"
    "[[object]]\nname = \"I\"\ntype = \"instance\"\ngroup = \"G\"\n"
    "[[object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n"
    "[object.material]\ndiffuse = 0.5\n[object.material.texture]\nfile = \"t.png\"\n";

struct Place {
  Place() {
    for (const char* name : {"from", "from/parts", "to", "to/deep"}) fs::create_directory(folder.file(name));
    for (const char* name : {"from/m.ply", "from/parts/p.ply"}) REQUIRE(write_file_atomically(folder.file(name), ply));
    REQUIRE(write_image(folder.file("from/t.png"), {1, 1, {{1, 0, 0}}}));
    REQUIRE(write_file_atomically(folder.file("from/s.toml"), meshes_and_textures));
  }
  [[nodiscard]] SceneDocument read(const std::string& name) const {
    auto document = read_scene(folder.file(name));
    INFO(name << (document ? "" : ": " + document.error().text()));
    REQUIRE(document);
    return *document;
  }
  TemporaryFolder folder;
};

}  // namespace

TEST_CASE("a scene that is written elsewhere finds its meshes and textures again") {
  const Place place;
  SceneDocument document = place.read("from/s.toml");
  CHECK(document.files.size() == 4);
  fs::create_directory_symlink("to/deep", place.folder.file("short"));
  for (const std::string name : {"s2.toml", "from/parts/s2.toml", "to/s2.toml", "to/deep/s2.toml", "short/s3.toml"}) {
    SceneDocument copy = document;
    REQUIRE(write_scene(copy, place.folder.file(name)));
    const SceneDocument back = place.read(name);
    CHECK(back.files.size() == 4);
    CHECK_THAT(back.text, contains("# mine") && contains("# beside it"));
    CHECK(back.text.find(place.folder.path()) == std::string::npos);
    // Once more, from where it was read first: an edit, and then back home.
    copy.scene.objects[0].name = "Mesh";
    REQUIRE(write_scene(copy, place.folder.file(name)));
    CHECK(place.read(name).scene.objects[0].name == "Mesh");
    REQUIRE(write_scene(copy, place.folder.file("from/home.toml")));
    CHECK_THAT(place.read("from/home.toml").text, contains("file = \"m.ply\"") && contains("\"parts/p.ply\""));
  }
  // In the same folder, by whatever name, not a letter changes.
  fs::create_directory_symlink("from", place.folder.file("same"));
  REQUIRE(write_scene(document, place.folder.file("same/s4.toml")));
  CHECK(contents(place.folder.file("from/s4.toml")) == meshes_and_textures);
}

TEST_CASE("absolute names stay, and a mesh by itself is named from the scene's folder") {
  const Place place;
  SceneDocument document = place.read("from/s.toml");
  const std::string absolute = place.folder.file("from/m.ply");
  std::get<MeshShape>(document.scene.objects[0].shape).file = absolute;
  REQUIRE(write_scene(document, place.folder.file("to/a.toml")));
  CHECK_THAT(place.read("to/a.toml").text, contains('"' + absolute + '"'));

  SceneDocument mesh = place.read("from/m.ply");
  REQUIRE(write_scene(mesh, place.folder.file("from/beside.toml")));
  CHECK_THAT(place.read("from/beside.toml").text, contains("file = \"m.ply\""));
  REQUIRE(write_scene(mesh, place.folder.file("to/deep/m.toml")));
  CHECK_THAT(place.read("to/deep/m.toml").text, contains("file = \"../../from/m.ply\""));
}

TEST_CASE("a name that no TOML can hold is said, and nothing is written") {
  const Place place;
  fs::rename(place.folder.file("from"), place.folder.file("fr\xff"));
  SceneDocument document = place.read("fr\xff/s.toml");
  const auto written = write_scene(document, place.folder.file("to/s.toml"));
  REQUIRE_FALSE(written);
  CHECK_THAT(written.error().text(), contains("m.ply") && contains("UTF-8"));
  CHECK_FALSE(fs::exists(place.folder.file("to/s.toml")));
}
