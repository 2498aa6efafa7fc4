#include "scene/names.h"
#include "view/document/document.h"
#include "view/text/text.h"

#include <algorithm>

namespace raywalk {

bool is_taken(const Scene& scene, std::string_view name, std::string_view shown, Language language) {
  const auto has_it = [&](const auto& thing) {
    return thing.name == name || shown_name(scene, thing.name, language) == shown;
  };
  return std::any_of(scene.objects.begin(), scene.objects.end(), has_it) ||
         std::any_of(scene.lights.begin(), scene.lights.end(), has_it);
}

std::string unique_name(const Scene& scene, const std::string& wanted, Language language) {
  const auto taken = [&](const std::string& name) {
    return is_taken(scene, name, shown_name(std::vector<std::string>{name}, name, language), language);
  };
  std::string name = wanted;
  for (int number = 2; taken(name); ++number) name = wanted + " " + std::to_string(number);
  return name;
}

/// The initial scene: EYE, SCREEN, a light, a sphere, and a floor below the plan for the picture.
Scene new_scene(Language language) {
  const Language english = language.others().english();
  Scene scene;
  scene.title = text("scene.new_title", language);
  scene.background = Rgbd(0.16, 0.20, 0.30);
  scene.camera.eye = Vec3d(-7, 0, 0);
  scene.camera.look_at = Vec3d(0.0);
  scene.camera.screen = Screen{2.5, 2.5, 21};

  Light light;
  light.name = text("name.Light Source", english);
  light.kind = PointLight{Vec3d(-2.5, 4.2, 0), {}};
  scene.lights.push_back(light);

  Object sphere;
  sphere.name = text("name.Solid Sphere", english);
  sphere.shape = Sphere<double>{Vec3d(1, 0.5, 0), 1.4};
  sphere.material.ambient = Rgbd(0.09, 0.02, 0.01);
  sphere.material.diffuse = Rgbd(0.65, 0.16, 0.08);
  scene.objects.push_back(sphere);

  Object floor;
  floor.name = text("name.Floor", english);
  floor.shape = Plane<double>{Vec3d(0, 0, -1.4), Vec3d(0, 0, 1)};
  floor.material.ambient = Rgbd(0.1);
  floor.material.checker = Checker{Rgbd(0.95, 0.93, 0.88), Rgbd(0.35, 0.42, 0.40), 1.0};
  scene.objects.push_back(floor);
  scene.translated = {light.name, sphere.name, floor.name};
  return scene;
}

}  // namespace raywalk
