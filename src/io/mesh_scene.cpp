#include "io/mesh_scene.h"

#include "io/mesh_file.h"

#include <algorithm>
#include <filesystem>

namespace raywalk {

Result<SceneDocument> scene_of_mesh(const std::string& path) {
  const auto file = read_mesh(path);
  if (!file) return tl::unexpected(file.error());
  const std::string name = std::filesystem::path(path).filename().string();
  SceneDocument document;
  document.warnings = file->warnings;
  Scene& scene = document.scene;
  scene.title = name;
  scene.image = {640, 480};
  scene.background = {0.55, 0.65, 0.75};

  const Bounds<double> box = bounds(*file->mesh);
  const Vec3d middle = box.min + 0.5 * (box.max - box.min);
  const double radius = std::max(length(box.max - box.min) / 2, 1e-9);
  constexpr double degrees = 40, inside = 0.30;  // sine of half the smaller angle of the picture, with a margin
  scene.camera.eye = middle + radius / inside * normalize(Vec3d(0.45, 0.35, 1));
  scene.camera.look_at = middle;
  scene.camera.up = {0, 1, 0};
  scene.camera.screen.width.reset();
  scene.camera.fov = FieldOfView{degrees, FovAxis::x};

  MeshShape shape;
  shape.file = name;  // beside the scene, unless that would be another file
  shape.mesh = file->mesh;
  shape.materials = file->materials;
  Material clay;
  clay.ambient = Rgbd(0.15);
  clay.diffuse = Rgbd(0.7);
  scene.objects = {{"Mesh", shape, clay}};
  scene.lights = {{"Sun", Rgbd(0.85), DirectionalLight{{-0.6, 1, 0.9}}},
                  {"Sky", Rgbd(0.3), DirectionalLight{{1, 0.4, 0.5}}}};
  return document;
}

}  // namespace raywalk
