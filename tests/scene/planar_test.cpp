#include "scene/scene.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

Scene planar_scene() {
  Scene scene;
  scene.camera.eye = {-5, 1, 0};
  scene.camera.look_at = {0, -2, 0};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{1, 2, 0}, {}}}, {"Sun", Rgbd(1.0), DirectionalLight{{1, -1, 0}}}};
  scene.objects = {{"Ball", Sphere<double>{{1, 2, 0}, 1}, {}},
                   {"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, {}},
                   {"Wall", Plane<double>{{5, 0, 0}, {-1, 0.5, 0}}, {}},
                   {"Block", Prism<double>{{{0, 0}, {1, 0}, {0, 1}}, 1}, {}}};
  return scene;
}

std::string why_not(void (*change)(Scene&)) {
  Scene scene = planar_scene();
  change(scene);
  CHECK(is_planar(scene) == why_not_planar(scene).empty());
  return why_not_planar(scene);
}

}  // namespace

TEST_CASE("a scene is planar when its cut by z = 0 is the strip") {
  CHECK(why_not([](Scene&) {}) == "");
  CHECK(why_not([](Scene& s) { s.camera.up = {0, 0, 7}; }) == "");
  CHECK(why_not([](Scene& s) { s.objects[0].shape = Sphere<double>{{0, 0, 1.5}, 1}; }) == "");  // above the plan
  CHECK(why_not([](Scene& s) { s.objects[1].shape = Plane<double>{{0, 0, 2}, {0, 0, -3}}; }) == "");
}

TEST_CASE("each reason not to be planar names what breaks it") {
  CHECK(why_not([](Scene& s) { s.camera.eye.z = 1e-300; }) == "the eye does not lie in z = 0");
  CHECK(why_not([](Scene& s) { s.camera.look_at.z = -1; }) == "the camera does not look along z = 0");
  CHECK(why_not([](Scene& s) { s.camera.up = {0.001, 0, 1}; }) == "up is not +z");
  CHECK(why_not([](Scene& s) { s.camera.up = {0, 0.001, 1}; }) == "up is not +z");
  CHECK(why_not([](Scene& s) { s.camera.up = {0, 0, -1}; }) == "up is not +z");
  CHECK(why_not([](Scene& s) { std::get<PointLight>(s.lights[0].kind).position.z = 1; }) ==
        "Lamp does not lie in z = 0");
  CHECK(why_not([](Scene& s) { std::get<DirectionalLight>(s.lights[1].kind).direction.z = 1; }) ==
        "Sun does not shine along z = 0");
  CHECK(why_not([](Scene& s) { std::get<Sphere<double>>(s.objects[0].shape).centre.z = 0.5; }) ==
        "Ball is cut by z = 0, but not through its centre");
  // Touching from above is meeting, with a normal straight down.
  CHECK(why_not([](Scene& s) { std::get<Sphere<double>>(s.objects[0].shape).centre.z = 1; }) ==
        "Ball is cut by z = 0, but not through its centre");
  CHECK(why_not([](Scene& s) { std::get<Plane<double>>(s.objects[1].shape).normal.x = 1; }) ==
        "Floor meets z = 0 aslant");
  CHECK(why_not([](Scene& s) { std::get<Plane<double>>(s.objects[1].shape).point.z = 0; }) == "Floor lies in z = 0");
  CHECK(why_not([](Scene& s) { std::get<Plane<double>>(s.objects[2].shape).normal.z = 1e-12; }) ==
        "Wall meets z = 0 aslant");
}

TEST_CASE("a relief of normals leaves the plan where the surface meets it") {
  CHECK(why_not([](Scene& s) { s.objects[0].material.bump_map = BumpMap{{"b.png"}, 0.1}; }) ==
        "Ball has a relief of normals and meets z = 0");
  CHECK(why_not([](Scene& s) { s.objects[2].material.normal_map = NormalMap{{"n.png"}, 1}; }) ==
        "Wall has a relief of normals and meets z = 0");
  // Below the plan no ray in it meets the floor; and what else maps change keeps normals as they are.
  CHECK(why_not([](Scene& s) { s.objects[1].material.bump_map = BumpMap{{"b.png"}, 0.1}; }) == "");
  CHECK(why_not([](Scene& s) {
          s.objects[0].material.maps = {{{"m.png"}, MappedParameter::roughness}};
          s.objects[0].material.mask = Mask{{"m.png"}};
        }) == "");
}
