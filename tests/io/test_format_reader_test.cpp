#include "io/test_format_reader.h"

#include "io/scene_file.h"
#include "support/catch.h"

#include <cmath>
#include <string>

using namespace raywalk;

namespace {

const std::string head = "size 8 6\ncamera 0 0 4 0 0 0 0 1 0 30\n";

Scene read(const std::string& text) {
  const auto document = parse_test_format(text, "scene.test");
  INFO(text << (document ? "" : document.error().text()));
  REQUIRE(document);
  CHECK(document->text.empty());
  return document->scene;
}

Vec3d placed(const Object& object, const Vec3d& point) { return affine_of(object.transform).point(point); }

void check_near(const Vec3d& a, const Vec3d& b) {
  INFO(a.x << " " << a.y << " " << a.z << ", expected " << b.x << " " << b.y << " " << b.z);
  CHECK(length(a - b) < 1e-12);
}

}  // namespace

TEST_CASE("course format: camera, size, depth and what the picture is made of") {
  const Scene scene = read(
      "# comment\r\nsize 640 480\r\n\r\nmaxdepth 3  \r\noutput my picture.png\r\ncamera 0 -4 4 0 -1 0 0 1 1 45\r\n");
  CHECK(scene.image == ImageSize{640, 480});
  CHECK(scene.limits.depth == 4);
  CHECK(scene.camera.eye == Vec3d(0, -4, 4));
  CHECK(scene.camera.look_at == Vec3d(0, -1, 0));
  CHECK(scene.camera.up == Vec3d(0, 1, 1));
  CHECK(scene.camera.fov->degrees == 45);
  CHECK(scene.camera.fov->axis == FovAxis::y);
  CHECK(scene.background == Rgbd(0.0));
  CHECK(scene.ambient == Rgbd(1.0));
  CHECK(scene.encoding == Encoding::truncated);
  CHECK(read(head).limits.depth == 6);  // maxdepth 5
}

TEST_CASE("course format: the state that is current holds for the objects after it") {
  const Scene scene = read(head +
                           "sphere 0 0 0 1\nambient .1 .2 .3\ndiffuse 0.4 0.5 0.6\nspecular .7 .8 .9\nshininess +20\n"
                           "emission 1 2 3\nsphere 1 0 0 2\nambient 0 0 0\nsphere 2 0 0 1\n");
  REQUIRE(scene.objects.size() == 3);
  const Material& first = scene.objects[0].material;
  CHECK(first.ambient == Rgbd(0.2));
  CHECK(first.diffuse == Rgbd(0.0));
  CHECK(first.normal == ShadingNormal::fixed);
  const Material& second = scene.objects[1].material;
  CHECK(second.ambient == Rgbd(0.1, 0.2, 0.3));
  CHECK(second.diffuse == Rgbd(0.4, 0.5, 0.6));
  CHECK(second.specular == Rgbd(0.7, 0.8, 0.9));
  CHECK(second.reflection == second.specular);
  CHECK(second.shininess == 20);
  CHECK(second.emission == Rgbd(1, 2, 3));
  CHECK(scene.objects[2].material.ambient == Rgbd(0.0));
  CHECK(scene.objects[2].material.diffuse == second.diffuse);
}

TEST_CASE("course format: the step written last acts first, and the stack brings matrices back") {
  const Scene scene =
      read(head +
           "translate 1 0 0\npushTransform\nrotate 0 0 1 90\nscale 2 1 1\nsphere 0 0 0 1\npopTransform\n"
           "sphere 0 0 0 1\n");
  REQUIRE(scene.objects.size() == 2);
  check_near(placed(scene.objects[0], {1, 0, 0}), {1, 2, 0});  // doubled, turned, moved
  check_near(placed(scene.objects[0], {0, 1, 0}), {0, 0, 0});
  check_near(placed(scene.objects[1], {1, 0, 0}), {2, 0, 0});
}

TEST_CASE("course format: very many steps come to the same as few") {
  std::string many;
  for (int i = 0; i < 360; ++i) many += "rotate 0 0 1 1\n";
  for (int i = 0; i < 1000; ++i) many += "translate 0.001 0 0\n";
  const Scene scene = read(head + many + "sphere 0 0 0 1\n");
  CHECK(scene.objects[0].transform.size() <= 16);
  CHECK(length(placed(scene.objects[0], {0, 0, 0}) - Vec3d(1, 0, 0)) < 1e-9);
}

TEST_CASE("course format: triangles take the matrix current at tri, and a mirror keeps their front") {
  const Scene scene = read(head + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nscale -1 1 1\ntri 0 1 2\n");
  REQUIRE(scene.objects.size() == 1);
  const auto& triangle = std::get<Triangle<double>>(scene.objects[0].shape);
  const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  CHECK(normal.z > 0);  // by the inverse transpose: mirrored in x, the normal stays +z
  CHECK(triangle.a == Vec3d(0, 0, 0));
  CHECK(((triangle.b == Vec3d(-1, 0, 0)) || (triangle.c == Vec3d(-1, 0, 0))));
}

TEST_CASE("course format: lights, and the attenuation of those after it") {
  const Scene scene =
      read(head + "point 1 2 3 .5 .5 .5\nattenuation 0 0 1\npoint 4 5 6 1 1 1\ndirectional 0 0 2 .1 .2 .3\n");
  REQUIRE(scene.lights.size() == 3);
  CHECK(std::get<PointLight>(scene.lights[0].kind).attenuation == Attenuation{1, 0, 0});
  CHECK(std::get<PointLight>(scene.lights[1].kind).attenuation == Attenuation{0, 0, 1});
  CHECK(scene.lights[0].strength == Rgbd(0.5));
  CHECK(std::get<DirectionalLight>(scene.lights[2].kind).direction == Vec3d(0, 0, 2));
  CHECK(scene.lights[2].strength == Rgbd(0.1, 0.2, 0.3));
}

TEST_CASE("a course scene and an NFF scene, written as our own format, read back the same") {
  const Scene course =
      read(head +
           "point 1 2 3 .5 .5 .5\nspecular .5 .5 .5\ntranslate 1 2 3\nrotate 1 1 0 30\nsphere 0 0 0 1\n"
           "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\ntri 0 1 2\ntri 0 2 1\nvertexnormal 0 0 1 0 0 1\n"
           "vertexnormal 1 0 1 1 0 1\nvertexnormal 0 1 1 0 1 1\ntrinormal 0 1 2\nsphere 1 1 1 1\n");
  const auto text = format_scene(course);
  REQUIRE(text);
  const auto again = parse_scene(*text, "again.toml");
  REQUIRE(again);
  CHECK(again->scene == course);
}

TEST_CASE("the ending of a name tells the format") {
  CHECK(scene_format_of("a/b.nff") == SceneFormat::nff);
  CHECK(scene_format_of("b.NFF") == SceneFormat::nff);
  CHECK(scene_format_of("b.test") == SceneFormat::test);
  CHECK(scene_format_of("b.toml") == SceneFormat::toml);
  CHECK(scene_format_of("b") == SceneFormat::toml);
  CHECK(!has_scene_ending("b.txt"));
  CHECK(!has_scene_ending(".nff"));
  CHECK(has_scene_ending("b.Toml"));
  SceneDocument document{read(head), {}, {}};
  const auto written = write_scene(document, "never.test");
  REQUIRE(!written);
  CHECK_THAT(written.error().message, raywalk::test::contains("expected .toml"));
}
