// A file that is named many times, by whatever names, is read once and its contents are shared.

#include "image/image_file.h"
#include "io/mesh_file.h"
#include "io/mesh_gltf.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string three_corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string seen_from_z = "[camera]\neye = [0, 0, 4]\nlook_at = [0, 0, 0]\nup = [0, 1, 0]\nfov = 30\n";

Image red_dot() { return {1, 1, {Rgb<float>(1, 0, 0)}}; }

}  // namespace

TEST_CASE("a library of materials that is named a hundred times is read once") {
  const TemporaryFolder folder;
  put(folder.file("one.mtl"), "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  std::string obj;
  for (int i = 0; i < 50; ++i) obj += "mtllib one.mtl\nmtllib ./one.mtl\n";
  put(folder.file("one.obj"), obj + three_corners + "usemtl blue\nf 1 2 3\n");
  const auto read = read_mesh(folder.file("one.obj"));
  REQUIRE(read);
  REQUIRE(read->materials);
  CHECK(read->materials->size() == 2);
  CHECK((*read->materials)[static_cast<std::size_t>(read->mesh->materials[0])].diffuse == Rgbd(0, 0, 1));
}

TEST_CASE("of two libraries that name one material, the one named last has it, also when named again") {
  const TemporaryFolder folder;
  put(folder.file("red.mtl"), "newmtl paint\nKd 1 0 0\n");
  put(folder.file("blue.mtl"), "newmtl paint\nKd 0 0 1\nnewmtl more\nKd 0 1 0\n");
  const std::string face = "usemtl paint\nf 1 2 3\n";
  put(folder.file("one.obj"), three_corners + "mtllib red.mtl\n" + face + "mtllib blue.mtl\n" + face +
                                  "mtllib red.mtl\n" + face + "usemtl more\nf 1 2 3\n");
  const auto read = read_mesh(folder.file("one.obj"));
  REQUIRE(read);
  const auto colour = [&](std::size_t i) {
    return (*read->materials)[static_cast<std::size_t>(read->mesh->materials[i])].diffuse;
  };
  CHECK(colour(0) == Rgbd(1, 0, 0));
  CHECK(colour(1) == Rgbd(0, 0, 1));
  CHECK(colour(2) == Rgbd(1, 0, 0));
  CHECK(colour(3) == Rgbd(0, 1, 0));
  CHECK(read->materials->size() == 3);
}

TEST_CASE("buffers of one file share its bytes") {
  const TemporaryFolder folder;
  put(folder.file("one.bin"), std::string(36, '\0'));
  std::string json = "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [";
  for (int i = 0; i < 10; ++i)
    json +=
        std::string(i == 0 ? "" : ", ") + "{\"byteLength\": 36, \"uri\": \"" + (i % 2 == 0 ? "./" : "") + "one.bin\"}";
  const auto file = detail::open_gltf(json + "]}", folder.file("one.gltf"));
  INFO((file ? "" : file.error().text()));
  REQUIRE(file);
  REQUIRE(file->buffers.size() == 10);
  for (const auto& buffer : file->buffers) CHECK(buffer == file->buffers[0]);
}

TEST_CASE("meshes and textures of a scene are read once, by whatever names") {
  const TemporaryFolder folder;
  put(folder.file("one.obj"), three_corners + "f 1 2 3\n");
  REQUIRE(write_image(folder.file("dot.png"), red_dot()));
  std::string text = seen_from_z;
  for (int i = 0; i < 3; ++i) {
    std::string dots;
    for (int j = 0; j < i; ++j) dots += "./";
    text += "[[object]]\nname = \"" + std::to_string(i) + "\"\ntype = \"mesh\"\nfile = \"" + dots +
            "one.obj\"\nmaterial = { texture = { file = \"" + dots + "dot.png\" } }\n";
  }
  put(folder.file("one.toml"), text);
  const auto read = read_scene(folder.file("one.toml"));
  INFO((read ? "" : read.error().text()));
  REQUIRE(read);
  const auto& objects = read->scene.objects;
  for (const Object& object : objects) {
    CHECK(std::get<MeshShape>(object.shape).mesh == std::get<MeshShape>(objects[0].shape).mesh);
    CHECK(object.material.texture->pixels == objects[0].material.texture->pixels);
    CHECK(object.material.texture->pixels);
  }
}

TEST_CASE("a line may name several libraries, or one with spaces in its name") {
  const TemporaryFolder folder;
  put(folder.file("red.mtl"), "newmtl red\nKd 1 0 0\n");
  put(folder.file("deep blue.mtl"), "newmtl blue\nKd 0 0 1\n");
  put(folder.file("one.obj"), "mtllib red.mtl  deep blue.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  CHECK_THAT(read_mesh(folder.file("one.obj")).error().message, contains("cannot be read"));
  put(folder.file("one.obj"),
      "mtllib deep blue.mtl\nmtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl blue\nf 1 2 3\n");
  CHECK(read_mesh(folder.file("one.obj"))->materials->size() == 2);
  put(folder.file("blue.mtl"), "newmtl blue\nKd 0 0 1\n");
  put(folder.file("one.obj"), "mtllib red.mtl\tblue.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl blue\nf 1 2 3\n");
  CHECK(read_mesh(folder.file("one.obj"))->materials->size() == 2);
  put(folder.file("one.obj"), "mtllib " + std::string(100'000, 'x') + "\n");
  CHECK(read_mesh(folder.file("one.obj")).error().text().size() < 1000);
}

TEST_CASE("what is in groups wears its textures, also in groups of groups") {
  const TemporaryFolder folder;
  REQUIRE(write_image(folder.file("dot.png"), red_dot()));
  put(folder.file("one.toml"),
      seen_from_z +
          "[[group]]\nname = \"inner\"\n[[group.object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [0, 0]\n"
          "radius = 1\nmaterial = { texture = { file = \"dot.png\" } }\n"
          "[[group]]\nname = \"outer\"\n[[group.object]]\nname = \"One\"\ntype = \"instance\"\ngroup = \"inner\"\n"
          "[[group]]\nname = \"plain\"\n[[group.object]]\nname = \"Bare\"\ntype = \"sphere\"\ncentre = [9, 0]\nradius "
          "= 1\n"
          "[[object]]\nname = \"A\"\ntype = \"instance\"\ngroup = \"outer\"\n"
          "[[object]]\nname = \"B\"\ntype = \"instance\"\ngroup = \"outer\"\ntransform = [[\"translate\", 3, 0, 0]]\n"
          "[[object]]\nname = \"C\"\ntype = \"instance\"\ngroup = \"plain\"\n");
  const auto read = read_scene(folder.file("one.toml"));
  INFO((read ? "" : read.error().text()));
  REQUIRE(read);
  int textured = 0;
  for (const MaterialUse& dress : material_uses(read->scene))
    if (dress.material->texture) {
      ++textured;
      CHECK(dress.material->texture->pixels);
    }
  CHECK(textured == 1);  // shared, however often it is used
  const auto content = [&](std::size_t i) { return std::get<Instance>(read->scene.objects[i].shape).content; };
  CHECK(content(0) == content(1));
}
