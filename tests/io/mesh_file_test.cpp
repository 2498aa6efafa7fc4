// Meshes from files, right ones and wrong ones.

#include "io/mesh_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <filesystem>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A square of two triangles with normals and texture points.
const std::string square_ply =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
    "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\nelement edge 0\nend_header\n"
    "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n1 2 0 0 0 1 1 1\n0 2 0.5 0 0 1 0 1\n4 0 1 2 3 255\n";

const std::string square_obj =
    "# a square\nmtllib square.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0.5\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
    "usemtl red\nf 1/1/1 2/2/1 3//1 \\\n -1//-1\nusemtl nothing\nf 1 2 3\n";

template <class Number>
void put_number(std::string& bytes, Number number, bool big) {
  std::array<char, sizeof(Number)> raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string binary_ply(bool big, std::uint32_t vertices = 3, std::int32_t last = 2) {
  std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") + "_endian 1.0\nelement vertex " +
                      std::to_string(vertices) +
                      "\nproperty double x\nproperty float y\nproperty short z\nproperty list uchar char extra\n"
                      "element face 1\nproperty list uint int vertex_index\nend_header\n";
  for (int i = 0; i < 3; ++i) {
    put_number(bytes, i == 1 ? 0.1 : 0.0, big);
    put_number(bytes, i == 2 ? 2.5F : 0.0F, big);
    put_number(bytes, static_cast<std::int16_t>(-300), big);
    bytes += std::string("\2ab", 3);
  }
  put_number(bytes, std::uint32_t{3}, big);
  for (const std::int32_t corner : {0, 1, last}) put_number(bytes, corner, big);
  return bytes;
}

void check_error(const Result<MeshFile>& read, int line, const std::string& message) {
  REQUIRE(!read);
  INFO(read.error().text());
  CHECK(read.error().file == "bad");
  CHECK(read.error().line == line);
  CHECK_THAT(read.error().message, contains(message));
  CHECK(!read.error().hint.empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a PLY file in text") {
  const auto read = parse_ply(square_ply, "square.ply");
  REQUIRE(read);
  const Mesh& mesh = *read->mesh;
  CHECK(mesh.positions == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0.5}});
  CHECK(mesh.normals == std::vector<Vec3d>(4, Vec3d(0, 0, 1)));
  CHECK(mesh.uv == std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(mesh.triangles == std::vector<Mesh::Corners>{{0, 1, 2}, {0, 2, 3}});
  CHECK(read->materials == nullptr);
}

TEST_CASE("binary PLY files of both endiannesses") {
  for (const bool big : {false, true}) {
    const auto read = parse_ply(binary_ply(big), "three.ply");
    REQUIRE(read);
    CHECK(read->mesh->positions == std::vector<Vec3d>{{0, 0, -300}, {0.1, 0, -300}, {0, 2.5, -300}});
    CHECK(read->mesh->triangles == std::vector<Mesh::Corners>{{0, 1, 2}});
  }
}

TEST_CASE("an OBJ file with its materials") {
  TemporaryFolder folder;
  put(folder.file("square.obj"), square_obj);
  put(folder.file("square.mtl"),
      "newmtl red\nKa 0.1 0 0\nKd 0.9 0.1 0\nKs 0.5\nNs 60\nNi 1.3\nd 0.75\nillum 7\nmap_Kd a.png\n");
  const auto read = read_mesh(folder.file("square.obj"));
  REQUIRE(read);
  const Mesh& mesh = *read->mesh;
  CHECK(mesh.triangles.size() == 3);
  CHECK(mesh.materials == std::vector<std::int32_t>{0, 0, -1});
  const auto corner = [&](std::size_t t, std::size_t c) { return static_cast<std::size_t>(mesh.triangles[t][c]); };
  CHECK(mesh.positions[corner(1, 2)] == Vec3d(0, 2, 0.5));
  CHECK(mesh.normals[corner(1, 2)] == Vec3d(0, 0, 1));
  CHECK(mesh.uv[corner(0, 1)] == Vec2d(1, 0));
  CHECK(mesh.normals[corner(2, 0)] == Vec3d(0.0));
  CHECK(corner(0, 0) == corner(1, 0));
  CHECK(corner(2, 0) != corner(0, 0));
  REQUIRE(read->materials);
  const Material& red = read->materials->front();
  CHECK(red.ambient == Rgbd(0.1, 0, 0));
  CHECK(red.diffuse == 0.75 * Rgbd(0.9, 0.1, 0));
  CHECK(red.transmission == Rgbd(0.25));
  CHECK(red.reflection == Rgbd(0.5));
  CHECK(red.shininess == 60);
  CHECK(red.ior == 1.3);
  CHECK(red.dielectric);
}

TEST_CASE("a concave face is covered once by its triangles, and a notch stays open") {
  // The corners of each in the plan; the last joins a hole to its outline, there and back.
  const std::vector<std::vector<Vec2d>> faces{
      {{2, 1}, {0, 3}, {0, 0}, {4, 0}, {4, 3}},                  // a roof upside down
      {{0, 3}, {1, 0}, {2, 3}, {3, 0}, {4, 3}, {4, 4}, {0, 4}},  // teeth
      {{0, 0}, {9, 0}, {9, 9}, {1, 9}, {1, 3}, {5, 3}, {5, 6}, {3, 6}, {3, 7}, {6, 7}, {6, 1}, {0, 1}},  // a spiral
      {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {1, 2}, {1, 4}, {0, 4}},  // level corners
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}};
  for (const std::vector<Vec2d>& plan : faces)
    for (std::size_t first = 0; first < plan.size(); ++first) {
      CAPTURE(plan.size(), first);
      std::string obj = "f", vertices, ply = std::to_string(plan.size());
      double area = 0;
      for (std::size_t i = 0; i < plan.size(); ++i) {
        const Vec2d at = plan[(first + i) % plan.size()], next = plan[(first + i + 1) % plan.size()];
        area += 0.5 * cross(at, next);
        vertices += fmt::format("{} {} {}\n", at.x, at.y, at.x + at.y);  // aslant
        obj = "v " + fmt::format("{} {} {}\n", at.x, at.y, at.x + at.y) + obj + fmt::format(" {}", i + 1);
        ply += fmt::format(" {}", i);
      }
      // In OBJ the other way round, as its vertices were put before each other.
      const auto of_obj = parse_obj(obj + "\n", "a.obj");
      const auto of_ply = parse_ply(fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty "
                                                "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                                                "vertex_indices\nend_header\n{}{}\n",
                                                plan.size(), vertices, ply),
                                    "a.ply");
      const auto above = parse_ply(fmt::format("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int "
                                               "vertex_indices\nelement vertex {}\nproperty float x\nproperty float "
                                               "y\nproperty float z\nend_header\n{}\n{}",
                                               plan.size(), ply, vertices),
                                   "above.ply");
      for (const auto* read : {&of_obj, &of_ply, &above}) {
        REQUIRE(*read);
        const Mesh& mesh = *(*read)->mesh;
        CHECK(mesh.triangles.size() == plan.size() - 2);
        const double sense = read == &of_obj ? -1 : 1;
        double covered = 0;
        bool is_upright = true;
        for (const Mesh::Corners& corners : mesh.triangles) {
          const auto at = [&](int i) {
            return mesh.positions[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
          };
          const double twice = sense * cross(at(1) - at(0), at(2) - at(0)).z;
          is_upright = is_upright && twice >= 0;
          covered += twice / 2;
        }
        CHECK(is_upright);
        CHECK(covered == Approx(area));
      }
    }
}

TEST_CASE("a concave face of very many corners is refused, and a convex one becomes a fan") {
  const auto face_of = [](int corners, double first) {
    std::string obj = "v " + std::to_string(first) + " 0 0\n", face = "f 1";
    for (int i = 1; i < corners; ++i) {
      const double angle = 6.283185307179586 * i / corners;
      obj += fmt::format("v {} {} 0\n", std::cos(angle), std::sin(angle));
      face += fmt::format(" {}", i + 1);
    }
    return parse_obj(obj + face + "\n", "bad");
  };
  const auto disk = face_of(10'001, 1);
  REQUIRE(disk);
  CHECK(disk->mesh->triangles.size() == 9'999);
  CHECK(disk->mesh->triangles.back() == Mesh::Corners{0, 9'999, 10'000});
  check_error(face_of(10'001, 2), 10'002, "a concave face of 10001 corners (expected at most 10000)");
}

TEST_CASE("comments, joined lines and Windows folders in OBJ and MTL files") {
  const TemporaryFolder folder;
  put(folder.file("a.mtl"), "newmtl red # the red one\nKd 1 0 0 # red\nNs 30 # shiny\nnewmtl Material #25\nKd 0 1 0\n");
  put(folder.file("a.obj"),
      "mtllib .\\a.mtl\nv 0 0 0 # here\nv 1 0 0\nv 0 1 0\nvt 0 0 # origin\nusemtl red # the red one\nf 1/1 2/1\\\n"
      "3/1 # all\nusemtl Material #25\nf 1 2\\\r\n3\n");
  const auto read = read_mesh(folder.file("a.obj"));
  INFO((read ? "" : read.error().text()));
  REQUIRE(read);
  CHECK(read->warnings.empty());
  CHECK(read->mesh->triangles.size() == 2);
  CHECK(read->mesh->materials == std::vector<std::int32_t>{0, 1});
  CHECK(read->materials->at(0).diffuse == Rgbd(1, 0, 0));
  CHECK(read->materials->at(0).shininess == 30);
}

TEST_CASE("only illum 6 and 7 of an MTL file bend rays, and 4 mirrors") {
  const auto material = [](int kind) {
    const auto read = parse_mtl(fmt::format("newmtl a\nKs 0.5\nd 0.25\nillum {}\n", kind), "a.mtl");
    REQUIRE(read);
    CHECK(read->front().material.transmission == Rgbd(0.75));
    return read->front().material;
  };
  for (const int kind : {0, 1, 2, 3, 4, 8, 9}) CHECK(material(kind).ior == 1);
  for (const int kind : {6, 7}) CHECK(material(kind).ior == Material{}.ior);
  CHECK(material(2).reflection == Rgbd(0.0));
  CHECK(material(4).reflection == Rgbd(0.5));
  for (const int kind : {0, 1}) CHECK(material(kind).specular == Rgbd(0.0));  // no highlight
  CHECK(material(2).specular == Rgbd(0.5));
}

TEST_CASE("that colours of a PLY file's vertices are not read is said") {
  const auto read = parse_ply(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n",
      "a.ply");
  REQUIRE(read);
  CHECK(read->warnings ==
        std::vector<std::string>{
            "a.ply: warning: colours of vertices are not read; the surface shows its material's own colour"});
}

TEST_CASE("an ambient colour of 1 in an MTL file is what exporters write of every surface") {
  const auto materials = parse_mtl("newmtl a\nKa 1 1 1\nKd 0.5 0.5 0.5\nnewmtl b\nKa 0.3 0.3 0.3\n", "a.mtl");
  REQUIRE(materials);
  CHECK(materials->at(0).material.ambient == Rgbd(0.0));
  CHECK(materials->at(1).material.ambient == Rgbd(0.3));
}

TEST_CASE("of a PLY file the line that has too few or too many values is to blame, not where that shows") {
  const auto ply = [](const std::string& from, const std::string& to) {
    return parse_ply(replaced(square_ply, from, to), "bad");
  };
  const auto few = ply("1 0 0 0 0 1 1 0\n", "1 0 0 0 0 1 1\n");
  check_error(few, 19, "vertex 1: its line has 7 values (expected 8, by the header)");
  CHECK_THAT(few.error().hint, contains("up to line 22: face 0: "));
  check_error(ply("1 0 0 0 0 1 1 0\n", "1 0 0 0 0 1 1 0 0\n"), 19, "vertex 1: its line has more than 8 values");
  check_error(ply("1 0 0 0 0 1 1 0\n", "1 0 0 0 0 1 1 O\n"), 19, "vertex 1: t: \"O\" is no finite number");
  check_error(ply("1 2 0 0 0 1 1 1\n", ""), 21, "vertex 3: its line has 6 values (expected 8, by the header)");
  // Lines may be broken anywhere as long as all is there.
  const auto broken = ply("1 0 0 0 0 1 1 0\n1 2 0 0", "1 0\n0 0 0 1 1 0 1\n\n 2 0 0");
  REQUIRE(broken);
  CHECK(*broken->mesh == *parse_ply(square_ply, "square.ply")->mesh);
  const auto none = parse_ply(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\nend_header\n3 0 1 2\n", "bad");
  check_error(none, 6, "names vertex 0 (expected \"element vertex COUNT\" in the header, for there are none)");
}

TEST_CASE("what is wrong with a mesh file is told with its place") {
  const auto ply = [](const std::string& from, const std::string& to) {
    return parse_ply(replaced(square_ply, from, to), "bad");
  };
  check_error(parse_ply("obj\n", "bad"), 1, "does not begin with \"ply\" (expected a PLY file)");
  check_error(ply("ascii", "text"), 2, "format \"text\"");
  check_error(ply("vertex 4", "vertex 4000000000000"), 18, "more than the file can hold");
  check_error(ply("face 1", "face -1"), 13, "without a count");
  check_error(ply("float z", "half z"), 7, "unknown type \"half\"");
  check_error(ply("float z", "float q"), 18, "(expected the properties x, y and z)");
  check_error(ply("1 2 0 0 0", "1 nan 0 0 0"), 20, "vertex 2: y: \"nan\" is no finite number");
  check_error(ply("1 2 0 0 0", "1 2e15 0 0 0"), 20, "vertex 2: y is 2e+15 (expected a finite number, at most 1e+15)");
  check_error(ply("4 0 1 2 3", "4 0 1 2 4"), 22, "face 0: it names vertex 4 (expected a whole number from 0 to 3)");
  check_error(ply("4 0 1 2 3", "4 0 1 2 -3"), 22, "names vertex -3");
  check_error(ply("4 0 1 2 3", "2 0 1 "), 22, "face 0: it has 2 corners");
  check_error(ply("4 0 1 2 3 255", "4 0 1"), 22, "face 0: its line has 3 values (expected more, by the header)");
  check_error(ply("4 0 1 2 3", "99999 0 1 2 3"), 22, "which the file cannot hold");
  check_error(ply("end_header", "end"), 17, "unknown word \"end\"");
  check_error(ply("element face 1", "element vertex 0\nelement face 1"), 13, "the element \"vertex\" twice");
  for (const bool big : {false, true})
    check_error(parse_ply(binary_ply(big, 3, 3), "bad"), 0,
                fmt::format("face 0: it names vertex 3 (expected a whole number from 0 to 2) at byte {}",
                            binary_ply(big).size() - 4));
  std::string spoilt = binary_ply(false);
  spoilt.replace(spoilt.size() - 16 - 17, 8, std::string(6, '\0') + "\xf0\x7f");
  check_error(
      parse_ply(spoilt, "bad"), 0,
      fmt::format("vertex 2: x is inf (expected a finite number, at most 1e+15) at byte {}", spoilt.size() - 33));
  check_error(parse_ply(binary_ply(true, 1000000000), "bad"), 0, "more than the file can hold at byte");
  const std::string whole = binary_ply(true);
  check_error(parse_ply(whole.substr(0, whole.size() - 1), "bad"), 0, "which the file cannot hold at byte");
  check_error(
      parse_ply(whole.substr(0, whole.size() - 19), "bad"), 0,
      fmt::format("vertex 2: extra: the file ends too early (expected 1 more byte) at byte {}", whole.size() - 19));
  const auto obj = [](const std::string& text) { return parse_obj(text, "bad"); };
  check_error(obj("v 0 0 0\nv 1 0 0\nv 0 1\n"), 3, "a number is missing");
  check_error(obj("v 0 0 1e999\n"), 1, "no finite number");
  check_error(obj("v 0 0 0x10\n"), 1, "no finite number");
  check_error(obj("v 0 0 0\nf 1 2 3\n"), 2, "names vertex 2 (expected 1 to 1");
  check_error(obj("v 0 0 0\nf 0 1 1\n"), 2, "names vertex 0");
  check_error(obj("v 0 0 0\nf 1/1 1/1 1/1\n"), 2, "names texture vertex 1");
  check_error(obj("v 0 0 0\nv 1 1 1\nf 1 2\n"), 3, "a face of 2 corners");
  check_error(obj("v 0 0 0\nf 1 1 99999999999999999999\n"), 2, "names vertex");
  check_error(obj("v 0 0 0\n"), 0, "no triangle");
  check_error(obj("mtllib missing.mtl\n"), 1, "its materials cannot be read");
  // What a face names stands above it: where there is nothing, no range is told of.
  const std::string corner = "v 0 0 0\n";
  check_error(obj(corner + "f 1// 1// 1//\n"), 2, "leaves its normal empty (expected a number)");
  check_error(obj(corner + "f /1 /1 /1\n"), 2, "leaves its vertex empty (expected a number)");
  check_error(obj(corner + "f 1//9 1//9 1//9\n"), 2,
              "names normal 9, but the file has none so far (expected \"vn X Y Z\" above it)");
  check_error(obj(corner + "f 1/5 1/5 1/5\n"), 2, "names texture vertex 5, but the file has none so far");
  check_error(obj("f 1 2 3\n"), 1, "names vertex 1, but the file has none so far (expected \"v X Y Z\" above it)");
  check_error(read_mesh("bad").map_error([](Error e) { return e; }), 0, "ending");
  for (const std::string line : {"Kd 1 2000 1", "Tf 1e12", "Ke 1e13", "Ns 1e16"}) {
    const auto bright = parse_mtl("newmtl a\n" + line + "\n", "a.mtl");
    REQUIRE(!bright);
    CHECK(bright.error().line == 2);
    CHECK_THAT(bright.error().message, contains("(expected a number from 0 to "));
  }
  std::string endless;
  for (int i = 0; i < 100'001; ++i) endless += "newmtl a\n";
  const auto many = parse_mtl(endless, "a.mtl");
  REQUIRE(!many);
  CHECK(many.error().line == 100'001);
  CHECK_THAT(many.error().message, contains("too many materials (expected at most 100000)"));
  const auto mtl = parse_mtl("newmtl a\nKd red\n", "a.mtl");
  REQUIRE(!mtl);
  CHECK(mtl.error().line == 2);
  CHECK_THAT(mtl.error().message, contains("found \"red\" (expected a number from 0 to"));
}

TEST_CASE("the materials of an OBJ file lie beside it or below, nowhere else") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("meshes/sub"));
  for (const char* name : {"secret.mtl", "meshes/sub/a..b.mtl"}) put(folder.file(name), "newmtl red\nKd 1 0 0\n");
  const auto read = [&](const std::string& library) {
    put(folder.file("meshes/a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib " + library + "\nusemtl red\nf 1 2 3\n");
    return read_mesh(folder.file("meshes/a.obj"));
  };
  const auto below = read("sub/a..b.mtl");
  REQUIRE(below);
  CHECK(below->materials->size() == 1);
  for (const std::string& elsewhere :
       {folder.file("secret.mtl"), std::string("../secret.mtl"), std::string("sub/../../secret.mtl"),
        std::string("sub\\..\\..\\secret.mtl"), std::string("..")}) {
    const auto refused = read(elsewhere);
    INFO(elsewhere);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().line == 4);
    CHECK_THAT(refused.error().message, contains("(expected a file beside the mesh)"));
    CHECK(!refused.error().hint.empty());
  }
}

TEST_CASE("a mesh file warns of materials that are nowhere, and when nothing of it can be seen") {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto warnings = [](const Result<MeshFile>& read) {
    REQUIRE(read);
    return read->warnings;
  };
  CHECK(warnings(parse_obj(corners + "f 1 2 3\n", "a.obj")).empty());
  CHECK(warnings(parse_ply(square_ply, "a.ply")).empty());
  const auto unknown =
      warnings(parse_obj(corners + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\n", "a.obj"));
  REQUIRE(unknown.size() == 1);
  CHECK_THAT(unknown[0], contains("a.obj:4: warning: no mtllib above has the material \"red\", nor 1 other:"));
  // Some triangles of no area are in every mesh; a mesh of nothing else is a mistake.
  CHECK(warnings(parse_obj(corners + "f 1 2 2\nf 1 2 3\n", "a.obj")).empty());
  const auto flat = warnings(parse_obj(corners + "f 1 2 2\n", "a.obj"));
  REQUIRE(flat.size() == 1);
  CHECK(flat[0] == "a.obj: warning: its only triangle has no area: no ray meets it");
  const auto ply = warnings(parse_ply(replaced(square_ply, "4 0 1 2 3", "4 0 1 1 0"), "a.ply"));
  REQUIRE(ply.size() == 1);
  CHECK_THAT(ply[0], contains("a.ply: warning: none of its 2 triangles has an area"));
}

TEST_CASE("that textures of materials are not read is said once a library, with the first one's place") {
  TemporaryFolder folder;
  put(folder.file("a.obj"), "mtllib a.mtl b.mtl\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\n");
  put(folder.file("a.mtl"),
      "newmtl plain\nKd 1 0 0\nnewmtl wood\nKd 1 1 1\nmap_Kd -s 2 2 2 oak wood.png\nbump bumps.png\n"
      "newmtl brick\nmap_Ks b.png\n");
  put(folder.file("b.mtl"), "map_Kd nobody.png\nnewmtl green\nKd 0 1 0\nillum 2\n");
  const auto read = read_mesh(folder.file("a.obj"));
  REQUIRE(read);
  REQUIRE(read->warnings.size() == 1);
  CHECK(read->warnings[0] ==
        folder.file("a.mtl") +
            ":5: warning: textures of mesh files are not read: the material \"wood\" has map_Kd -s 2 2 2 oak wood.png, "
            "and 1 other material; such surfaces show the material's own colour");
}

TEST_CASE("no part of a mesh file and no changed byte crashes its reader") {
  for (const std::string& whole : {square_ply, square_obj, binary_ply(false), binary_ply(true)}) {
    const auto parse = [&](const std::string& bytes) {
      return whole.front() == 'p' ? parse_ply(bytes, "part") : parse_obj(bytes, "/nowhere/part");
    };
    const auto is_sound = [](const Result<MeshFile>& read) {
      return read ? detail::why_no_mesh(*read->mesh).empty() : !read.error().message.empty();
    };
    int unsound = 0;
    for (std::size_t size = 0; size < whole.size(); ++size) unsound += !is_sound(parse(whole.substr(0, size)));
    for (std::size_t at = 0; at < whole.size(); ++at)
      for (const char to : {'\0', '\xff', '9', '-', ' ', '\n'}) {
        std::string changed = whole;
        changed[at] = to;
        unsound += !is_sound(parse(changed));
      }
    CHECK(unsound == 0);
  }
}
