#pragma once

#include "scene/scene.h"

namespace raywalk::test {

// Glass balls that see each other: every hit sends out two rays, to a depth that nobody lives to see.
inline Scene exploding_room(Integrator integrator) {
  Scene scene;
  scene.background = Rgbd(0.2);
  scene.camera.eye = {-6, 1.1, 0};
  scene.camera.look_at = {0, 1.1, 0};
  scene.camera.fov = FieldOfView{5};  // all of the picture is a ball
  scene.image = {32, 24};
  scene.limits = {60, 0};
  scene.render.integrator = integrator;
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-5, 3, 2}, {}}}};
  Material glass;
  glass.reflection = Rgbd(0.5);
  glass.transmission = Rgbd(0.5);
  glass.gloss = glass.translucency = 10;
  for (const double y : {-1.1, 1.1})
    scene.objects.push_back({y < 0 ? "Left" : "Right", Sphere<double>{{0, y, 0}, 1}, glass});
  Material wall;
  wall.reflection = Rgbd(0.9);
  scene.objects.push_back({"Room", Sphere<double>{{0, 0, 0}, 50}, wall});
  return scene;
}

}  // namespace raywalk::test
