#include "io/generate.h"

#include "io/scene_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene generated(const GenerateOptions& options, const std::string& name) {
  const TemporaryFolder folder;
  const auto made = generate(options, folder.file(name));
  REQUIRE(made);
  CHECK(folder.entries() == 1);
  const auto document = read_scene(folder.file(name));
  INFO((document ? "" : document.error().text()));
  REQUIRE(document);
  CHECK(document->warnings.empty());
  return document->scene;
}

std::vector<Sphere<double>> spheres_of(const Scene& scene) {
  std::vector<Sphere<double>> spheres;
  for (const Object& object : scene.objects)
    if (const auto* sphere = std::get_if<Sphere<double>>(&object.shape)) spheres.push_back(*sphere);
  return spheres;
}

}  // namespace

TEST_CASE("strewn spheres are as many as asked for, inside their cube, and the same for the same seed") {
  const GenerateOptions options{GeneratedKind::spheres, 500, 0, 3};
  const auto spheres = spheres_of(generated(options, "a.nff"));
  CHECK(spheres.size() == 500);
  Vec3d sum(0.0);
  for (const auto& sphere : spheres) {
    CHECK(max_component(Vec3d(std::abs(sphere.centre.x), std::abs(sphere.centre.y), std::abs(sphere.centre.z))) <= 1);
    sum += sphere.centre;
  }
  CHECK(length(sum / 500.0) < 0.15);  // three sigma of the mean of 500 uniform draws, in space
  CHECK(spheres_of(generated(options, "b.nff")) == spheres);
  CHECK(spheres_of(generated(options, "b.toml")) == spheres);
  CHECK(spheres_of(generated({GeneratedKind::spheres, 500, 0, 4}, "c.nff")) != spheres);
}

TEST_CASE("a sphereflake has nine more spheres on each, which touch it") {
  const Scene scene = generated({GeneratedKind::flake, 0, 2}, "flake.nff");
  const auto spheres = spheres_of(scene);
  CHECK(spheres.size() == 1 + 9 + 81);
  CHECK(scene.objects.size() == 92);  // and a floor
  CHECK(scene.lights.size() == 3);
  int touching = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      const double gap = length(spheres[i].centre - spheres[j].centre) - spheres[i].radius - spheres[j].radius;
      CHECK(gap > -1e-8);  // no two overlap
      const bool parent = std::abs(spheres[i].radius / spheres[j].radius - 3) < 1e-6 ||
                          std::abs(spheres[j].radius / spheres[i].radius - 3) < 1e-6;
      if (parent && gap < 1e-8) ++touching;
    }
  CHECK(touching >= 90);
}

TEST_CASE("what is generated is the same scene in both formats") {
  for (const GeneratedKind kind : {GeneratedKind::flake, GeneratedKind::spheres}) {
    const GenerateOptions options{kind, 20, 1, 3};
    const Scene nff = generated(options, "a.nff"), toml = generated(options, "a.toml");
    CHECK(nff.ambient == toml.ambient);  // to the bit, as all that pictures are made of
    REQUIRE(nff.lights.size() == toml.lights.size());
    for (std::size_t i = 0; i < nff.lights.size(); ++i) CHECK(nff.lights[i].strength == toml.lights[i].strength);
    REQUIRE(nff.objects.size() == toml.objects.size());
    for (std::size_t i = 0; i < nff.objects.size(); ++i) {
      const Material &a = nff.objects[i].material, &b = toml.objects[i].material;
      for (const auto& [one, other] : {std::pair{a.ambient, b.ambient}, std::pair{a.diffuse, b.diffuse},
                                       std::pair{a.specular, b.specular}, std::pair{a.reflection, b.reflection}})
        CHECK(one == other);
      CHECK(a.shininess == b.shininess);
    }
  }
}

TEST_CASE("a generated mesh is closed: each edge is shared by two triangles that run along it opposite ways") {
  const TemporaryFolder folder;
  for (const int count : {8, 500, 2000}) {
    REQUIRE(generate({GeneratedKind::mesh, count, 0, 1}, folder.file("ball.ply")));
    const std::string bytes = contents(folder.file("ball.ply"));
    const std::string end = "end_header\n";
    const std::size_t body = bytes.find(end) + end.size();
    std::istringstream header(bytes.substr(0, body));
    std::size_t vertices = 0, faces = 0;
    for (std::string line; std::getline(header, line);) {
      if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
      if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
    }
    INFO(count << ": " << vertices << " vertices, " << faces << " faces");
    REQUIRE(bytes.size() == body + vertices * 24 + faces * 13);
    CHECK(static_cast<double>(faces) > 0.7 * count);
    CHECK(static_cast<double>(faces) < 2.1 * count);
    CHECK(2 * vertices == faces + 4);  // Euler's formula for a ball
    const auto vertex = [&](std::int32_t index, std::size_t first) {
      float xyz[3];
      std::memcpy(xyz, bytes.data() + body + static_cast<std::size_t>(index) * 24 + first, 12);
      return Vec3d(xyz[0], xyz[1], xyz[2]);
    };
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    int outwards = 0, with_normal = 0;
    for (std::size_t i = 0; i < faces; ++i) {
      const char* face = bytes.data() + body + vertices * 24 + i * 13;
      REQUIRE(face[0] == 3);
      std::int32_t c[3];
      std::memcpy(c, face + 1, 12);
      for (int k = 0; k < 3; ++k) ++edges[{c[k], c[(k + 1) % 3]}];
      const Vec3d a = vertex(c[0], 0), normal = cross(vertex(c[1], 0) - a, vertex(c[2], 0) - a);
      if (dot(normal, a) > 0) ++outwards;
      if (dot(normal, vertex(c[0], 12)) > 0) ++with_normal;
    }
    CHECK(outwards == static_cast<int>(faces));
    CHECK(with_normal == static_cast<int>(faces));
    for (const auto& [edge, times] : edges) {
      CHECK(times == 1);
      CHECK(edges.count({edge.second, edge.first}) == 1);
    }
  }
}

TEST_CASE("a forest is copies of a mesh, upright on the floor and apart, and the same for the same seed") {
  const TemporaryFolder folder;
  REQUIRE(generate({GeneratedKind::mesh, 300, 0, 1}, folder.file("ball.ply")));
  GenerateOptions options{GeneratedKind::forest, 40, 0, 3};
  options.mesh = folder.file("ball.ply");
  options.up = GENERATE(UpAxis::x, UpAxis::y, UpAxis::z);
  REQUIRE(generate(options, folder.file("a.toml")));
  const auto document = read_scene(folder.file("a.toml"));
  REQUIRE(document);
  CHECK(document->warnings.empty());
  std::vector<Bounds<double>> boxes;
  for (const Object& object : document->scene.objects)
    if (std::holds_alternative<Instance>(object.shape))
      boxes.push_back(image_of(affine_of(object.transform), bounds(object.shape)));
  REQUIRE(boxes.size() == 40);
  for (const Bounds<double>& box : boxes) {
    CHECK(box.min.z == Approx(0).epsilon(0).margin(1e-9));
    CHECK(box.max.z < 3);
  }
  options.seed = 4;
  REQUIRE(generate(options, folder.file("b.toml")));
  CHECK(read_scene(folder.file("b.toml"))->scene.objects != document->scene.objects);
  options.seed = 3;
  REQUIRE(generate(options, folder.file("c.toml")));
  CHECK(read_scene(folder.file("c.toml"))->scene.objects == document->scene.objects);
}

TEST_CASE("a forest says what it lacks") {
  const TemporaryFolder folder;
  GenerateOptions options{GeneratedKind::forest, 4};
  CHECK_THAT(why_not_generated(options, "a.toml")->text(), contains("--mesh FILE"));
  options.mesh = folder.file("none.ply");
  CHECK_THAT(why_not_generated(options, "a.nff")->text(), contains("expected .toml"));
  CHECK_FALSE(why_not_generated(options, "a.toml"));
  CHECK_THAT(generate(options, folder.file("a.toml")).error().text(), contains("none.ply"));
  CHECK(folder.entries() == 0);
  options.count = 200'000;
  CHECK_THAT(why_not_generated(options, "a.toml")->text(), contains("at most 100000"));
}

TEST_CASE("a generated mesh as NFF and OBJ has the triangles that it has as PLY") {
  const TemporaryFolder folder;
  REQUIRE(generate({GeneratedKind::mesh, 200, 0, 1}, folder.file("ball.nff")));
  REQUIRE(generate({GeneratedKind::mesh, 200, 0, 1}, folder.file("ball.obj")));
  const auto count = [](const std::string& text, const std::string& start) {
    std::istringstream lines(text);
    int found = 0;
    for (std::string line; std::getline(lines, line);) found += line.starts_with(start) ? 1 : 0;
    return found;
  };
  const int patches = count(contents(folder.file("ball.nff")), "pp 3");
  CHECK(patches == count(contents(folder.file("ball.obj")), "f "));
  CHECK(patches > 150);
  CHECK(read_scene(folder.file("ball.nff")));
}

TEST_CASE("what cannot be generated is refused, and nothing is written") {
  const TemporaryFolder folder;
  for (const auto& [options, name] :
       {std::pair(GenerateOptions{GeneratedKind::mesh}, "a.toml"),
        std::pair(GenerateOptions{GeneratedKind::spheres}, "a.ply"),
        std::pair(GenerateOptions{GeneratedKind::spheres, 1'000'000}, "a.toml"),
        std::pair(GenerateOptions{GeneratedKind::flake, 0, 6}, "a.toml"), std::pair(GenerateOptions{}, "a")}) {
    const auto made = generate(options, folder.file(name));
    REQUIRE(!made);
    CHECK_THAT(made.error().message, contains("expected"));
    CHECK(!made.error().hint.empty());
  }
  CHECK(folder.entries() == 0);
  CHECK(!generate({}, "/nowhere/at/all.nff"));
}
