#include "io/nff_reader.h"

#include "shape/object_transform.h"
#include "support/catch.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

using namespace raywalk;

namespace {

const std::string view = "v\nfrom 0 -5 1\nat 0 0 1\nup 0 0 1\nangle 40\nhither 1\nresolution 640 480\n";

Scene read(const std::string& text) {
  const auto document = parse_nff(text, "scene.nff");
  INFO(text << (document ? "" : document.error().text()));
  REQUIRE(document);
  CHECK(document->text.empty());
  return document->scene;
}

template <class S>
const S& shape(const Scene& scene, std::size_t index) {
  const auto* found = std::get_if<S>(&scene.objects.at(index).shape);
  REQUIRE(found != nullptr);
  return *found;
}

/// Whether the object's surface passes through `point`: the ray from `from` through it ends there.
void check_meets(const Object& object, const Vec3d& from, const Vec3d& point) {
  const auto place = object_transform<double>(affine_of(object.transform));
  REQUIRE(place);
  const Ray<double> ray = into_object_space(*place, Ray<double>{from, point - from});
  const auto* cylinder = std::get_if<Cylinder<double>>(&object.shape);
  const auto* cone = std::get_if<Cone<double>>(&object.shape);
  REQUIRE((cylinder != nullptr || cone != nullptr));
  const auto crossing =
      cylinder != nullptr ? intersect(*cylinder, ray, infinity<double>) : intersect(*cone, ray, infinity<double>);
  INFO(point.x << " " << point.y << " " << point.z);
  REQUIRE(crossing);
  CHECK(std::abs(crossing->t - 1) < 1e-12);
}

}  // namespace

TEST_CASE("NFF: the view becomes the camera, the picture and the depth of the ray counts") {
  const Scene scene = read("# a comment\nb 0.1 0.2 0.3 # the sky\n" + view);
  CHECK(scene.camera.eye == Vec3d(0, -5, 1));
  CHECK(scene.camera.look_at == Vec3d(0, 0, 1));
  CHECK(scene.camera.up == Vec3d(0, 0, 1));
  REQUIRE(scene.camera.fov);
  CHECK(scene.camera.fov->degrees == 40);
  CHECK(scene.camera.fov->axis == FovAxis::y);
  CHECK(!scene.camera.screen.width);
  CHECK(scene.image == ImageSize{640, 480});
  CHECK(scene.background == Rgbd(0.1, 0.2, 0.3));
  CHECK(scene.limits.depth == 5);
  CHECK(scene.limits.threshold == 0);
}

TEST_CASE("NFF: items may stand in any number of lines, and the view's in any order") {
  const Scene scene =
      read("v resolution 8 4 angle 90 up 0\n0 1 at 0 0 0\nfrom 1\n2\n3 l 1 2 3 f 1 1 1 1 0 0 0 0 s 1 1 1\n2");
  CHECK(scene.camera.eye == Vec3d(1, 2, 3));
  CHECK(scene.image == ImageSize{8, 4});
  REQUIRE(scene.objects.size() == 1);
  CHECK(shape<Sphere<double>>(scene, 0).radius == 2);
}

TEST_CASE("NFF: n lights and the ambient one have the strength sqrt(n) / (2n)") {
  const Scene scene = read(view + "l 1 2 3\nl 4 5 6 1 0.5 0\nl 7 8 9\nl 0 0 9\n");
  REQUIRE(scene.lights.size() == 4);
  CHECK(scene.ambient == Rgbd(0.25));
  CHECK(scene.lights[0].strength == Rgbd(0.25));
  CHECK(scene.lights[1].strength == Rgbd(0.25, 0.125, 0));
  CHECK(std::get<PointLight>(scene.lights[1].kind).position == Vec3d(4, 5, 6));
  CHECK(std::get<PointLight>(scene.lights[1].kind).attenuation == Attenuation{});
  CHECK(scene.lights[0].name != scene.lights[1].name);
  CHECK(read(view).ambient == Rgbd(1.0));
}

TEST_CASE("NFF: a material holds for the objects after it, and its numbers mean what they are called") {
  const Scene scene = read(view +
                           "f 1 0.5 0.25 0.8 0.2 30 0 0\ns 0 0 0 1\nf 1 1 0.5 0.1 0.3 9 0.6 1.5\ns 1 0 0 1\ns 2 0 0 1\n"
                           "f 1 1 0.5 0 0 0 0.5 1.25\ns 3 0 0 1\n");
  REQUIRE(scene.objects.size() == 4);
  const Material& dull = scene.objects[0].material;
  CHECK(dull.diffuse == 0.8 * Rgbd(1, 0.5, 0.25));
  CHECK(dull.ambient == dull.diffuse);
  CHECK(dull.specular == Rgbd(0.2));
  CHECK(dull.reflection == Rgbd(0.2));
  CHECK(dull.shininess == 30);
  CHECK(!dull.transmits());
  const Material& glass = scene.objects[1].material;
  CHECK(glass.transmission == 0.6 * Rgbd(1, 1, 0.5));
  CHECK(glass.reflection == Rgbd(0.3));
  CHECK(glass.ior == 1.5);
  CHECK(!glass.dielectric);
  CHECK(scene.objects[2].material == glass);
  // Every transmitter reflects: one without a mirror weight does so by Fresnel's equations.
  CHECK(scene.objects[3].material.dielectric);
}

TEST_CASE("NFF: cylinders and cones stand where their two circles are, and are open") {
  const Scene scene = read(
      view + "f 1 1 1 1 0 0 0 0\nc 1 2 3 0.5  1 2 6 0.5\nc 0 0 0 2  3 4 0 1\nc 0 0 0 1  0 0 -2 0\nc 5 5 5 1 5 5 4 2\n");
  REQUIRE(scene.objects.size() == 4);
  const auto& cylinder = shape<Cylinder<double>>(scene, 0);
  CHECK(!cylinder.capped);
  check_meets(scene.objects[0], {9, 2, 3.5}, {1.5, 2, 3.5});
  check_meets(scene.objects[0], {9, 2, 5.5}, {1.5, 2, 5.5});
  // Along (0.6, 0.8, 0), radius 2 at the origin and 1 at distance 5: at half the way it is 1.5.
  CHECK(!shape<Cone<double>>(scene, 1).capped);
  check_meets(scene.objects[1], {1.5, 2, 9}, {1.5, 2, 1.5});
  check_meets(scene.objects[1], {0.3, 0.4, 9}, {0.3, 0.4, 1.9});
  check_meets(scene.objects[1], {2.7, 3.6, 9}, {2.7, 3.6, 1.1});
  check_meets(scene.objects[2], {9, 0, -1}, {0.5, 0, -1});  // points down, to its tip
  check_meets(scene.objects[3], {9, 5, 4.5}, {6.5, 5, 4.5});
  // Nothing of the wall lies beyond the circles.
  const auto place = object_transform<double>(affine_of(scene.objects[0].transform));
  const Ray<double> beyond = into_object_space(*place, Ray<double>{{9, 2, 6.01}, {-1, 0, 0}});
  CHECK(!intersect(cylinder, beyond, infinity<double>));
}

TEST_CASE("NFF: polygons stay whole where they are flat; bent ones become triangles") {
  const Scene scene = read(view +
                           "f 1 1 1 1 0 0 0 0\np 3 0 0 0 1 0 0 0 1 0\np 5 0 0 0 2 0 0 2 2 0 1 1 0 0 2 0\n"
                           "p 4 0 0 0 1 0 0 1 1 1 0 1 0\n");
  REQUIRE(scene.objects.size() >= 3);
  CHECK(shape<Polygon<double>>(scene, 1).outline.size() == 5);
}

TEST_CASE("NFF: a notch stays open in a concave patch, and in a concave polygon that is bent") {
  // A roof upside down, from each of its corners; the last time its tip is bent up.
  const std::array<Vec3d, 5> roof{Vec3d(2, 1, 0), Vec3d(0, 3, 0), Vec3d(0, 0, 0), Vec3d(4, 0, 0), Vec3d(4, 3, 0)};
  for (std::size_t first = 0; first < 2 * roof.size(); ++first) {
    const bool smooth = first < roof.size();
    std::string item = smooth ? "pp 5" : "p 5";
    for (std::size_t i = 0; i < roof.size(); ++i) {
      Vec3d at = roof[(first + i) % roof.size()];
      if (!smooth && at.y == 1) at.z = 0.5;
      item += fmt::format(" {} {} {}", at.x, at.y, at.z) + (smooth ? " 0 0 1" : "");
    }
    const Scene scene = read(view + "f 1 1 1 1 0 0 0 0\n" + item + "\n");
    const Mesh& mesh = *shape<MeshShape>(scene, 0).mesh;
    REQUIRE(mesh.triangles.size() == 3);
    double covered = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto at = [&](std::int32_t i) { return mesh.positions[static_cast<std::size_t>(i)]; };
      const double twice = cross(at(b) - at(a), at(c) - at(a)).z;
      CHECK(twice > 0);
      covered += twice / 2;
    }
    CHECK(covered == Approx(8));
  }
}

TEST_CASE("NFF: triangles of one material become a mesh; patches keep the normals of their corners") {
  const std::string flat = "p 3 0 0 0 1 0 0 0 1 0\n", smooth = "pp 3 0 0 0 0 0 1 1 0 0 1 0 1 0 1 0 0 1 1\n";
  const Scene scene =
      read(view + "f 1 1 1 1 0 0 0 0\n" + flat + smooth + "s 0 0 0 1\n" + flat + flat + "f 1 0 0 1 0 0 0 0\n" + flat);
  REQUIRE(scene.objects.size() == 4);
  const auto& mesh = shape<MeshShape>(scene, 0);
  REQUIRE(mesh.mesh);
  CHECK(mesh.smooth);
  CHECK(mesh.file.empty());
  REQUIRE(mesh.mesh->triangles.size() == 2);
  const auto corner = [&](std::size_t triangle, std::size_t i) {
    return static_cast<std::size_t>(mesh.mesh->triangles[triangle][i]);
  };
  CHECK(mesh.mesh->normals.at(corner(0, 1)) == Vec3d(0.0));
  CHECK(mesh.mesh->normals.at(corner(1, 0)) == Vec3d(0, 0, 1));
  CHECK(mesh.mesh->normals.at(corner(1, 1)) == Vec3d(1, 0, 1));
  CHECK(mesh.mesh->positions.at(corner(1, 2)) == Vec3d(0, 1, 0));
  CHECK(shape<MeshShape>(scene, 2).mesh->triangles.size() == 2);
  CHECK(!shape<MeshShape>(scene, 2).smooth);
  CHECK(shape<Triangle<double>>(scene, 3).b == Vec3d(1, 0, 0));
  CHECK(scene.objects[3].material.diffuse == Rgbd(1, 0, 0));
  CHECK(scene.objects[2].material.diffuse == Rgbd(1.0));
}

TEST_CASE("NFF: a negative radius counts without its sign, and what has no area is left out with a word") {
  const auto document =
      parse_nff(view + "f 1 1 1 1 0 0 0 0\ns 0 0 0 -2\nc 0 0 0 -1 0 0 1 -1\np 3 0 0 0 1 1 1 2 2 2\n", "s.nff");
  REQUIRE(document);
  CHECK(document->scene.objects.size() == 2);
  CHECK(shape<Sphere<double>>(document->scene, 0).radius == 2);
  REQUIRE(document->warnings.size() == 1);
  CHECK_THAT(document->warnings[0], raywalk::test::contains("without an area"));
}
