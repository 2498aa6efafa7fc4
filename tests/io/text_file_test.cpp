// Every reader of text takes what editors and systems put around it, or names it.

#include "text/text_file.h"

#include <algorithm>
#include <vector>

#include "io/mesh_file.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct FormatText {
  std::string ending, text;
};

const std::vector<FormatText> formats{
    {"toml",
     "title = \"t\"\n[camera]\neye = [0, 0, 4]\nlook_at = [0, 0, 0]\nup = [0, 1, 0] # up\nfov = 30\n[[object]]\n"
     "name = \"Ball\"\ntype = \"sphere\"\ncentre = [0, 0, 0]\nradius = 0.5\n"},
    {"nff",
     "v\nfrom 0 0 4\nat 0 0 0\nup 0 1 0\nangle 30\nhither 0.1\nresolution 8 6\n# a light\nl 0 0 4\n"
     "f 1 1 1 1 0 0 0 1\ns 0 0 0 0.5\n"},
    {"test", "size 8 6\n# the eye\ncamera 0 0 4 0 0 0 0 1 0 30\ndirectional 0 0 1 1 1 1\nsphere 0 0 0 0.5\n"},
    {"obj", "v 0 0 0\n# a corner\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"ply",
     "ply\nformat ascii 1.0\ncomment three corners\nelement vertex 3\nproperty float x\nproperty float y\n"
     "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
     "3 0 1 2\n"},
    {"gltf",
     "{\"asset\": {\"version\": \"2.0\"},\n\"buffers\": [{\"byteLength\": 36, \"uri\": \"data:;base64,"
     "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}],\n\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],\n"
     "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\"}],\n"
     "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}]}\n"},
};

std::string all_replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string utf16(const std::string& text, bool big) {
  std::string wide;
  for (const char c : text) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
  return wide;
}

/// What a scene holds; meshes by what they hold.
void check_same(const Scene& a, const Scene& b) {
  CHECK(a.camera == b.camera);
  CHECK(a.lights == b.lights);
  REQUIRE(a.objects.size() == b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const auto *one = std::get_if<MeshShape>(&a.objects[i].shape), *other = std::get_if<MeshShape>(&b.objects[i].shape);
    if (one == nullptr) {
      CHECK(a.objects[i] == b.objects[i]);
    } else {
      CHECK(*one->mesh == *other->mesh);
    }
  }
}

}  // namespace

TEST_CASE("all readers take a byte order mark, any line ends, and a last line without one") {
  const TemporaryFolder folder;
  for (const FormatText& each : formats) {
    const std::string path = folder.file("one." + each.ending);
    put(path, each.text);
    const auto plain = read_scene(path);
    INFO(each.ending << (plain ? "" : plain.error().text()));
    REQUIRE(plain);
    const std::string mark(utf8_mark), crlf = all_replaced(each.text, "\n", "\r\n"),
                                       cr = all_replaced(each.text, "\n", "\r");
    const std::string bare = each.text.substr(0, each.text.size() - 1);
    for (const std::string& text :
         {mark + each.text, crlf, mark + crlf, cr, mark + cr, bare, mark + bare, mark + mark + bare}) {
      put(path, text);
      const auto read = read_scene(path);
      INFO(text << (read ? "" : read.error().text()));
      REQUIRE(read);
      check_same(read->scene, plain->scene);
      CHECK(read->warnings == plain->warnings);
    }
  }
}

TEST_CASE("all readers name UTF-16 and UTF-32, with a mark and without") {
  const TemporaryFolder folder;
  for (const FormatText& each : formats) {
    const std::string little = utf16(each.text, false), big = utf16(each.text, true);
    for (const auto& [bytes, words] : std::vector<std::pair<std::string, std::string>>{
             {"\xff\xfe" + little, "UTF-16, as its byte order mark (BOM) says"},
             {"\xfe\xff" + big, "UTF-16, as its byte order mark (BOM) says"},
             {std::string("\xff\xfe\0\0", 4) + utf16(little, false), "UTF-32, as its byte order mark (BOM) says"},
             {std::string("\0\0\xfe\xff", 4) + utf16(big, true), "UTF-32, as its byte order mark (BOM) says"},
             {little, "UTF-16, without a byte order mark"},
             {big, "UTF-16, without a byte order mark"}}) {
      const std::string path = folder.file("one." + each.ending);
      put(path, bytes);
      const auto read = read_scene(path);
      REQUIRE(!read);
      INFO(read.error().text());
      CHECK(read.error().file == path);
      CHECK(read.error().line == 1);
      CHECK_THAT(read.error().message, contains(words) && contains("(expected UTF-8)"));
      CHECK(!read.error().hint.empty());
    }
  }
}

TEST_CASE("files that were joined carry a mark inside, which is refused with its line") {
  const TemporaryFolder folder;
  for (const FormatText& each : formats) {
    if (each.ending == "ply") continue;  // its numbers are checked word by word
    const std::string path = folder.file("one." + each.ending);
    std::string text = each.text;
    text.insert(text.find('\n', text.find('\n') + 1) + 1, utf8_mark);
    put(path, text);
    const auto read = read_scene(path);
    REQUIRE(!read);
    INFO(read.error().text());
    CHECK(read.error().line == 3);
    CHECK_THAT(read.error().message, contains("byte order mark"));
  }
}

TEST_CASE("materials of a mesh are text like any other") {
  const TemporaryFolder folder;
  const std::string obj = "mtllib one.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n",
                    mtl = "newmtl red\nKd 1 0 0\n";
  put(folder.file("one.obj"), obj);
  for (const std::string& text :
       {mtl, std::string(utf8_mark) + mtl, all_replaced(mtl, "\n", "\r\n"), all_replaced(mtl, "\n", "\r")}) {
    put(folder.file("one.mtl"), text);
    const auto read = read_mesh(folder.file("one.obj"));
    REQUIRE(read);
    CHECK(read->warnings.empty());
    REQUIRE(read->materials);
    CHECK(read->materials->front().diffuse == Rgbd(1, 0, 0));
  }
  put(folder.file("one.mtl"), "\xff\xfe" + utf16(mtl, false));
  const auto read = read_mesh(folder.file("one.obj"));
  REQUIRE(!read);
  CHECK_THAT(read.error().message, contains("UTF-16"));
}

TEST_CASE("no text holds a byte 0, in the middle or at its end") {
  const TemporaryFolder folder;
  for (const FormatText& each : formats) {
    if (each.ending == "ply") continue;  // whose numbers may be bytes
    const std::string path = folder.file("one." + each.ending);
    for (const std::size_t at : {each.text.size() / 2, each.text.size()}) {
      std::string text = each.text;
      put(path, text.insert(at, 1, '\0'));
      const auto read = read_scene(path);
      INFO(each.ending);
      REQUIRE(!read);
      CHECK(read.error().line == 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      CHECK_THAT(read.error().message, contains("0x00"));
    }
  }
  put(folder.file("one.obj"), "mtllib one.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  put(folder.file("one.mtl"), std::string("newmtl red\nK\0d 1 0 0\n", 22));
  const auto mesh = read_mesh(folder.file("one.obj"));
  REQUIRE(!mesh);
  CHECK_THAT(mesh.error().text(), contains("one.mtl:2: this is no text"));
}

TEST_CASE("what is read as TOML for want of a known ending says so") {
  const TemporaryFolder folder;
  for (const std::string name : {"scene.pov", "scene.toml"}) {
    put(folder.file(name), "// POV-Ray\nsphere { <0, 0, 0>, 1 }\n");
    const auto read = read_scene(folder.file(name));
    REQUIRE(!read);
    CHECK((read.error().hint.find("read as TOML, for its name has none of the endings .toml, .nff") !=
           std::string::npos) == (name == "scene.pov"));
  }
}

TEST_CASE("a lesson or a demo with a byte 0 is no text") {
  const TemporaryFolder folder;
  for (const std::string where : {"title\n", "title\nwords\n"}) {
    put(folder.file("en.md"), where + '\0' + "end\n");
    const auto text = read_text(folder.file("en.md"), 1000);
    REQUIRE_FALSE(text);
    CHECK(text.error().line == 1 + std::count(where.begin(), where.end(), '\n'));
    CHECK_THAT(text.error().message, contains("0x00"));
  }
}

TEST_CASE("numbers of a binary PLY keep every byte, whatever line ends its header has") {
  const auto ply = [](const std::string& end) {
    std::string bytes = all_replaced(
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
        "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n",
        "\n", end);
    return bytes + "\n\r\r" + "\r\n\n" + "\n\n\r" + std::string("\3\0\1\2", 4);
  };
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto read = parse_ply(ply(end), "one.ply");
    INFO((read ? "" : read.error().text()));
    REQUIRE(read);
    CHECK(read->mesh->positions == std::vector<Vec3d>{{10, 13, 13}, {13, 10, 10}, {10, 10, 13}});
  }
}

TEST_CASE("a scene that came with a byte order mark is written with it") {
  const TemporaryFolder folder;
  const std::string path = folder.file("one.toml"),
                    text = std::string(utf8_mark) + all_replaced(formats[0].text, "\n", "\r\n");
  put(path, text);
  auto document = read_scene(path);
  REQUIRE(document);
  REQUIRE(write_scene(*document, path));
  CHECK(contents(path) == text);
}
