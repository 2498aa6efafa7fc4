// glTF meshes, right ones and wrong ones.

#include "image/image_file.h"
#include "io/mesh_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

#include <cstring>
#include <filesystem>
#include <tuple>

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Four corners of 3 floats, then six indices of 2 bytes.
std::string square_bytes() {
  const float corners[] = {0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0.5F};
  const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
  std::string bytes(sizeof corners + sizeof indices, '\0');
  std::memcpy(bytes.data(), corners, sizeof corners);
  std::memcpy(bytes.data() + sizeof corners, indices, sizeof indices);
  return bytes;
}

const std::string accessors =
    R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                     {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
       "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
       "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1], "metallicFactor": 0.5,
                      "roughnessFactor": 0.5}, "emissiveFactor": [0, 0, 2]}])";

std::string gltf(const std::string& nodes, const std::string& buffer, const std::string& rest = accessors) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + nodes +
         R"(], "buffers": [{)" + buffer + R"("byteLength": 60}], )" + rest + "}";
}

std::string number(std::uint32_t value) { return {reinterpret_cast<const char*>(&value), 4}; }

std::string glb(const std::string& json) {
  const std::string binary = square_bytes();
  const auto size = [](const std::string& text) { return static_cast<std::uint32_t>(text.size()); };
  return "glTF" + number(2) + number(28 + size(json) + size(binary)) + number(size(json)) + "JSON" + json +
         number(size(binary)) + std::string("BIN\0", 4) + binary;
}

const std::string plain_node = R"({"mesh": 0})";

void check_refused(const std::string& bytes, const std::string& message) {
  const auto read = parse_gltf(bytes, "/nowhere/bad.gltf");
  REQUIRE(!read);
  INFO(read.error().text());
  CHECK_THAT(read.error().message, contains(message));
  CHECK(!read.error().hint.empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a GLB file with its buffer inside") {
  const auto read = parse_gltf(glb(gltf(plain_node, "")), "a.glb");
  if (!read) FAIL(read.error().text());
  CHECK(read->mesh->positions == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0.5}});
  CHECK(read->mesh->triangles == std::vector<Mesh::Corners>{{0, 1, 2}, {0, 2, 3}});
  CHECK(read->mesh->materials == std::vector<std::int32_t>{0, 0});
  const Material& material = read->materials->front();
  CHECK(material.diffuse == 0.75 * Rgbd(1, 0.5, 0));
  CHECK(material.reflection == 0.25 * Rgbd(1, 0.5, 0));
  CHECK(material.emission == Rgbd(0, 0, 2));
}

TEST_CASE("a glTF file whose buffer is a file beside it, or in a data URI") {
  TemporaryFolder folder;
  put(folder.file("its buffer.bin"), square_bytes());
  put(folder.file("a.gltf"), gltf(plain_node, R"("uri": "its%20buffer.bin", )"));
  const auto read = read_mesh(folder.file("a.gltf"));
  if (!read) FAIL(read.error().text());
  CHECK(read->mesh->positions[3] == Vec3d(0, 2, 0.5));
  // The first three bytes of the buffer are 0, which is AAAA; one accessor of one byte is enough to see it.
  const std::string small = R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";
  const auto inside = parse_gltf(
      gltf(plain_node, "\"uri\": \"data:application/octet-stream;base64," + std::string(47, 'A') + "/\", ", small),
      "a.gltf");
  if (!inside) FAIL(inside.error().text());
  CHECK(inside->mesh->positions.size() == 3);
  CHECK(inside->mesh->positions[0] == Vec3d(0.0));
}

TEST_CASE("glass of a glTF file is as rough as the square of what it calls roughness") {
  const auto glass = replaced(
      accessors, R"("emissiveFactor": [0, 0, 2])",
      R"("extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": 1.4}})");
  const auto read = parse_gltf(glb(gltf(plain_node, "", glass)), "a.glb");
  if (!read) FAIL(read.error().text());
  const Material& material = read->materials->front();
  CHECK(material.is_rough_glass());
  CHECK(material.roughness == 0.25);
  CHECK(material.ior == 1.4);
}

TEST_CASE("the strength of a glTF file's light multiplies it, and alpha that is not read is told of") {
  const auto read = [](const std::string& material) {
    auto file = parse_gltf(
        glb(gltf(plain_node, "", replaced(accessors, R"("emissiveFactor")", material + R"("emissiveFactor")"))),
        "a.glb");
    if (!file) FAIL(file.error().text());
    return *file;
  };
  const std::string strong = R"("extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 20}}, )";
  CHECK(read(strong).materials->front().emission == Rgbd(0, 0, 40));
  CHECK(read(R"("alphaMode": "BLEND", )").warnings.empty());  // wholly opaque
  const std::string blended = replaced(accessors, "0.5, 0, 1]", "0.5, 0, 0.5]");
  for (const std::string mode : {"BLEND", "MASK", "OPAQUE"}) {
    const auto file = parse_gltf(
        glb(gltf(plain_node, "", replaced(blended, R"("emissive)", R"("alphaMode": ")" + mode + R"(", "emissive)"))),
        "a.glb");
    REQUIRE(file);
    CHECK(file->warnings.size() == (mode == "OPAQUE" ? 0 : 1));
    for (const std::string& warning : file->warnings)
      CHECK(warning == "a.glb: warning: alpha is not read: that of the material \"0\"; such surfaces are opaque");
  }
}

TEST_CASE("that some of a glTF file's textures are not read is said once, whatever is wrong with them") {
  const auto warnings = [](const std::string& materials) {
    const std::string textures =
        R"(, "textures": [{"source": 1}, {"source": 7}], "images": [{"uri": "a.png"}, {"uri": "wood%20.png"}])";
    const auto read = parse_gltf(
        glb(gltf(plain_node, "",
                 replaced(accessors, R"("emissiveFactor": [0, 0, 2]})", "\"name\": \"wood\"" + materials) + textures)),
        "a.glb");
    if (!read) FAIL(read.error().text());
    return read->warnings;
  };
  const std::string said = "a.glb: warning: some textures of this file are not read: the material \"wood\" has ";
  CHECK(warnings("}").empty());
  CHECK(warnings(R"(, "normalTexture": {"index": 0}})") ==
        std::vector<std::string>{said + "normalTexture wood%20.png; such surfaces show the material's own colour"});
  CHECK(warnings(R"(, "emissiveTexture": {"index": 1}}, {"normalTexture": 3}, {"name": 5, "normalTexture": {}})") ==
        std::vector<std::string>{
            said + "emissiveTexture, and 2 other materials; such surfaces show the material's own colour"});
  CHECK(warnings(R"(, "occlusionTexture": {"index": 1e300}})").size() == 1);
}

TEST_CASE("a glTF file's textures become maps, where its vertices have texture points") {
  const TemporaryFolder folder;
  // As bytes: 128 and 255; 64 is a quarter but for rounding.
  Image picture{2, 1, {}};
  for (const double byte : {128.0, 255.0})
    picture.pixels.emplace_back(static_cast<float>(srgb_decode(byte / 255)),
                                static_cast<float>(srgb_decode(64.0 / 255)), 1.0F);
  REQUIRE(write_image(folder.file("t.png"), picture));
  const std::string uv =
      R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                       {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                       {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"}],
         "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
         "textures": [{"source": 0}], "images": [{"uri": "t.png"}],)";
  const auto material = [&](const std::string& json, bool with_uv = true) {
    const std::string meshes = std::string(R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0)") +
                               (with_uv ? R"(, "TEXCOORD_0": 2)" : "") + R"(}, "indices": 1, "material": 0}]}],)";
    const auto read =
        parse_gltf(glb(gltf(plain_node, "", uv + meshes + R"("materials": [{)" + json + "}]")), folder.file("a.glb"));
    if (!read) FAIL(read.error().text());
    CHECK(read->warnings.empty());
    return read->materials->front();
  };
  const float half = static_cast<float>(srgb_decode(128.0 / 255));
  const std::string base = R"("baseColorTexture": {"index": 0}, "baseColorFactor": [1, 0.5, 0, 1])";
  Material plain = material(R"("pbrMetallicRoughness": {)" + base +
                            R"(, "metallicFactor": 0}, "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0},
                               "normalTexture": {"index": 0, "scale": 0.5})");
  REQUIRE(plain.maps.size() == 2);
  CHECK(plain.maps[0].of == MappedParameter::diffuse);
  CHECK(plain.maps[1].of == MappedParameter::emission);
  CHECK(plain.diffuse == Rgbd(1, 0.5, 0));
  CHECK(plain.maps[0].pixels->at(0, 0).x == half);
  CHECK(plain.maps[0].height == -1);  // its v runs downward
  REQUIRE(plain.normal_map);
  CHECK(plain.normal_map->strength == 0.5);
  CHECK(plain.normal_map->pixels->at(0, 0).x == static_cast<float>(128.0 / 255));
  // Green is roughness, blue metal.
  const Material worn = material(R"("pbrMetallicRoughness": {)" + base +
                                 R"(, "metallicRoughnessTexture": {"index": 0}, "metallicFactor": 0.5})");
  REQUIRE(worn.maps.size() == 2);
  CHECK(worn.maps[0].of == MappedParameter::reflection);
  CHECK(worn.maps[1].of == MappedParameter::diffuse);
  const double mirror = 0.5 * (1 - 64.0 / 255);
  CHECK(static_cast<double>(worn.maps[0].pixels->at(0, 0).x) == Approx(mirror * static_cast<double>(half)));
  CHECK(static_cast<double>(worn.maps[1].pixels->at(1, 0).x) == Approx(1 - mirror));
  CHECK(worn.reflection == Rgbd(1.0));
  // Materials of one look share their maps.
  const std::string look = R"("pbrMetallicRoughness": {)" + base + R"(, "metallicRoughnessTexture": {"index": 0}})";
  const auto two =
      parse_gltf(glb(gltf(plain_node, "",
                          uv + R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 2},
                                                "indices": 1, "material": 0}]}], "materials": [{)" +
                              look + "}, {" + look + "}]")),
                 folder.file("a.glb"));
  if (!two) FAIL(two.error().text());
  REQUIRE(two->materials->at(0).maps.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(two->materials->at(0).maps[i].pixels == two->materials->at(1).maps[i].pixels);
  // Without texture points, its factors alone.
  const Material bare = material(
      R"("pbrMetallicRoughness": {)" + base + R"(, "metallicRoughnessTexture": {"index": 0}, "metallicFactor": 0.5})",
      false);
  CHECK_FALSE(bare.is_mapped());
  CHECK(bare.diffuse == Rgbd(1, 0.5, 0));
}

TEST_CASE("a glTF file's samplers wrap its textures; their filters and colours of vertices are not read, and told of") {
  const TemporaryFolder folder;
  Image picture{1, 1, {{1, 1, 1}}};
  REQUIRE(write_image(folder.file("t.png"), picture));
  const std::string base_alone = R"("metallicFactor": 0, "baseColorTexture": {"index": 0})";
  const auto read = [&](const std::string& attribute, const std::string& samplers, const std::string& pbr) {
    const std::string json =
        R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                         {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                         {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"}],
           "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
           "textures": [{"source": 0, "sampler": 0}, {"source": 0, "sampler": 1}], "images": [{"uri": "t.png"}],
           "samplers": [{)" +
        samplers + R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0)" + attribute +
        R"(}, "indices": 1, "material": 0}]}],
           "materials": [{"pbrMetallicRoughness": {)" +
        pbr + R"(}, "normalTexture": {"index": 0}}])";
    auto file = parse_gltf(glb(gltf(plain_node, "", json)), folder.file("a.glb"));
    if (!file) FAIL(file.error().text());
    return *std::move(file);
  };
  const auto warnings = [&](const std::string& attribute, const std::string& sampler) {
    return read(attribute, sampler, base_alone).warnings;
  };
  const std::string uv = R"(, "TEXCOORD_0": 2)";
  CHECK(warnings(uv, "").empty());
  CHECK(warnings(uv, R"("wrapS": 10497, "wrapT": 10497, "magFilter": 9729)").empty());
  CHECK(warnings("", R"("magFilter": 9728)").empty());  // its texture lies nowhere
  const auto nearest = warnings(uv, R"("magFilter": 9728)");
  REQUIRE(nearest.size() == 1);
  CHECK_THAT(nearest.front(), contains("samplers are not read in full: that of a baseColorTexture blends no pixels"));
  using enum ImageWrap;
  for (const auto& [sampler, u, v] : {std::tuple{R"("wrapS": 33071)", clamp, repeat},
                                      {R"("wrapT": 33648)", repeat, mirror},
                                      {R"("wrapS": 33648, "wrapT": 33071)", mirror, clamp},
                                      {R"("wrapS": 33071, "wrapT": 33071)", clamp, clamp},
                                      {R"("wrapS": 10497, "wrapT": 1)", repeat, repeat}}) {
    INFO(sampler);
    const MeshFile file = read(uv, sampler, base_alone);
    CHECK(file.warnings.empty());
    const Material& material = file.materials->front();
    REQUIRE(material.maps.size() == 1);
    REQUIRE(material.normal_map);
    CHECK(material.maps[0].wraps() == ImageWraps{u, v});
    CHECK(material.normal_map->wraps() == ImageWraps{u, v});
  }
  // Both are computed into one map, which wraps like the first.
  const std::string both = R"("baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1})";
  const MeshFile alike = read(uv, R"("wrapS": 33071}, {"wrapS": 33071)", both),
                 unlike = read(uv, R"("wrapS": 33071}, {"wrapS": 33648)", both);
  CHECK(alike.warnings.empty());
  REQUIRE(unlike.warnings.size() == 1);
  CHECK_THAT(unlike.warnings.front(), contains("wraps otherwise than the baseColorTexture"));
  for (const ParameterMap& map : unlike.materials->front().maps) CHECK(map.wraps() == ImageWraps{clamp, repeat});
  const auto told = warnings(uv + R"(, "COLOR_0": 0)", "");
  REQUIRE(told.size() == 1);
  CHECK_THAT(told.front(), contains("a.glb: warning: colours of vertices are not read"));
}

TEST_CASE("nodes put a mesh where they say, mirrored ones too") {
  const auto place = [](const std::string& nodes) {
    const auto read = parse_gltf(glb(gltf(nodes, "")), "a.glb");
    if (!read) FAIL(read.error().text());
    return *read->mesh;
  };
  // A quarter turn about z, twice the size, then moved.
  const Mesh turned = place(R"({"children": [1], "translation": [10, 0, 0]},
      {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 2, 2]})");
  CHECK(length(turned.positions[1] - Vec3d(10, 2, 0)) < 1e-12);
  CHECK(length(turned.positions[3] - Vec3d(6, 0, 1)) < 1e-12);
  const Mesh mirrored = place(R"({"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]})");
  CHECK(mirrored.positions[2] == Vec3d(4, 8, 7));
  CHECK(mirrored.triangles[0] == Mesh::Corners{0, 2, 1});
  CHECK(place(R"({"children": [1, 1]}, {"mesh": 0})").triangles.size() == 4);
}

TEST_CASE("what is wrong with a glTF file is told") {
  const std::string good = gltf(plain_node, "");
  const auto changed = [&](const std::string& from, const std::string& to) { return glb(replaced(good, from, to)); };
  check_refused("", "the file is empty (expected a glTF 2.0 file)");
  const auto no_text = parse_gltf(std::string("PK\3\4\0\0", 6), "a.glb");
  REQUIRE_FALSE(no_text);
  CHECK_THAT(no_text.error().text(), contains("a.glb: the file does not begin with \"glTF\" (expected a binary glTF"));
  check_refused("[]", "its JSON is a list (expected an object)");
  check_refused("\"a\"", "its JSON is \"a\" (expected an object)");
  check_refused("{}", "it has no version (expected \"asset\": {\"version\": \"2.0\"})");
  check_refused("gl", "ends in its header (expected 20 bytes or more) at byte 2");
  check_refused("glTF", "ends in its header (expected 20 bytes or more) at byte 4");
  check_refused(changed("\"2.0\"", "\"1.0\""), "its version is \"1.0\" (expected \"2.0\")");
  check_refused(changed("\"2.0\"", "2"), "its version is 2 (expected \"2.0\")");
  check_refused(glb(good).substr(0, glb(good).size() - 8), "goes over the end of the file");
  check_refused(replaced(glb(good), number(2), number(3)), "version 3 (expected 2) at byte 4");
  check_refused(changed("\"count\": 4", "\"count\": 4000000000"), "go over the end of their view");
  check_refused(changed("\"count\": 4", "\"count\": -4"), "its count does not fit");
  check_refused(changed("\"byteOffset\": 48", "\"byteOffset\": 50"), "goes over the end of its buffer");
  check_refused(changed("\"byteLength\": 48", "\"byteLength\": 1e300"),
                "\"byteLength\": found 1e+300 (expected a whole number, at most 4e9)");
  check_refused(changed("\"count\": 4", "\"count\": []"), "\"count\": found a list (expected a finite number)");
  check_refused(changed("\"VEC3\"", "3"), "\"type\": found 3 (expected a text)");
  check_refused(changed("\"nodes\": [0]", "\"nodes\": [-1]"),
                "\"nodes\": found -1 (expected a whole number, 0 or more)");
  check_refused(changed("\"mesh\": 0", "\"mesh\": 0, \"scale\": 2"), "found 2 (expected a list of 3 numbers)");
  check_refused(changed("5126", "5127"), "unknown component type");
  check_refused(changed("\"mesh\": 0", "\"mesh\": 7"), "number 7 of \"meshes\" (expected 0 to 0)");
  check_refused(changed("\"material\": 0", "\"material\": 3"), "names material 3");
  check_refused(changed("\"indices\": 1", "\"indices\": 0"), "its type is not the one expected");
  check_refused(changed("5123", "5122"), "the indices of a mesh are no whole numbers");
  check_refused(changed("5123, \"count\": 6", "5126, \"count\": 3"), "the indices of a mesh are no whole numbers");
  check_refused(changed("{\"mesh\": 0}", "{\"children\": [0]}"), "in a circle");
  for (const std::string extension : {"KHR_draco_mesh_compression", "KHR_materials_clearcoat"})
    check_refused(changed("\"asset\"", "\"extensionsRequired\": [\"" + extension + "\"], \"asset\""),
                  "needs the extension \"" + extension + "\" (expected");
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');  // a walk through it needs a stack
  check_refused(changed("\"asset\"", "\"extensionsRequired\": [" + deep + "], \"asset\""), "needs the extension");
  check_refused(gltf(plain_node, "\"uri\": \"http://example.org/a.bin\", "), "expected a file beside the mesh");
  check_refused(gltf(plain_node, "\"uri\": \"/etc/passwd\", "), "expected a file beside the mesh");
  check_refused(gltf(plain_node, "\"uri\": \"missing.bin\", "), "its buffer \"missing.bin\"");
  check_refused(gltf(plain_node, "\"uri\": \"data:;base64,!!!!\", "), "not base64");
  std::string wrong_corner = glb(good);
  wrong_corner[wrong_corner.size() - 1] = 1;
  check_refused(wrong_corner, "names vertex 259 (expected 0 to 3)");
}

TEST_CASE("JSON that is not well formed is told of with its place") {
  const auto text = parse_gltf("{\n  \"asset\": {\"ä\" 1}\n}", "bad.gltf");
  REQUIRE(!text);
  CHECK(text.error().line == 2);
  CHECK(text.error().column == 17);
  CHECK_THAT(text.error().message, contains("not well formed (expected"));
  const auto part = parse_gltf("{\n\n\"asset\":", "bad.gltf");
  REQUIRE(!part);
  CHECK(part.error().line == 3);
  CHECK_THAT(part.error().message, contains("not well formed: it ends too early (expected"));
  const auto infinite = parse_gltf("{\n\"asset\": 1e999}", "bad.gltf");
  REQUIRE(!infinite);
  CHECK(infinite.error().line == 2);
  // The bytes of a GLB file have no lines.
  const auto binary = parse_gltf(glb("{\"asset\" 2}"), "bad.glb");
  REQUIRE(!binary);
  CHECK(binary.error().line == 0);
  CHECK_THAT(binary.error().message, contains("at byte 29"));
}

TEST_CASE("a glTF file's buffers lie beside it or below, nowhere else") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("meshes/sub"));
  for (const char* name : {"secret.bin", "meshes/sub/a..b.bin"}) put(folder.file(name), square_bytes());
  const auto read = [&](const std::string& uri) {
    put(folder.file("meshes/a.gltf"), "\n\n" + gltf(plain_node, "\"uri\": \"" + uri + "\", "));
    return read_mesh(folder.file("meshes/a.gltf"));
  };
  CHECK(read("sub/a..b.bin"));
  for (const char* elsewhere : {"../secret.bin", "sub/../../secret.bin", "%2e%2e/secret.bin", "..%2Fsecret.bin", "..",
                                "..%5csecret.bin", "sub/.."}) {
    const auto refused = read(elsewhere);
    INFO(elsewhere);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().line == 3);
    CHECK_THAT(refused.error().message, contains("(expected a file beside the mesh)"));
    CHECK(!refused.error().hint.empty());
  }
}

TEST_CASE("no part of a GLB file and no changed byte crashes its reader") {
  const std::string whole = glb(gltf(plain_node, ""));
  int unsound = 0;
  const auto try_out = [&](const std::string& bytes) {
    const auto read = parse_gltf(bytes, "/nowhere/part.glb");
    unsound += read ? !detail::why_no_mesh(*read->mesh).empty() : read.error().message.empty();
  };
  for (std::size_t size = 0; size < whole.size(); ++size) try_out(whole.substr(0, size));
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char to : {'\0', '\xff', '9', '-', '"', ']'}) {
      std::string bytes = whole;
      bytes[at] = to;
      try_out(bytes);
    }
  CHECK(unsound == 0);
}
