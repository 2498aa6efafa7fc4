// The mean of many samples of one ray, and scenes to take it of, for tests against formulas.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "trace/pictures.h"

namespace raywalk::test {

constexpr double degree = std::numbers::pi / 180;

// A closed box as a mesh, two triangles to a face.
inline MeshShape box_mesh(const Vec3d& min, const Vec3d& max) {
  auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < 8; ++i)
    mesh->positions.emplace_back(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z);
  mesh->triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  MeshShape shape;
  shape.mesh = mesh;
  return shape;
}

inline Material lambert() {
  Material material;
  material.diffuse = Rgbd(1.0);
  return material;
}

inline Material glowing(double radiance) {
  Material material = black();
  material.emission = Rgbd(radiance);
  return material;
}

// A floor under one light, which looks straight down from height 2 at the origin.
inline Scene lit_floor(const Light& light) {
  Scene scene;
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, lambert())};
  scene.lights = {light};
  return scene;
}

// The mean of `samples` samples of the ray from `eye` to `target`, their variance and what was done.
struct Sampled {
  double mean, variance;
  Statistics statistics;
  // Half the width within which the mean of independent samples lies but for one time in ten million.
  [[nodiscard]] double tolerance() const {
    return 5.3 * std::sqrt(variance / static_cast<double>(statistics.formed(RayKind::primary)));
  }
};
inline Sampled sample(const Scene& towards, const Vec3d& eye, const Vec3d& target, int samples,
                      std::uint64_t seed = 1) {
  Scene scene = looking(towards, eye, target);
  scene.camera.fov.reset();
  scene.camera.screen = {1, 1e-9, 1};
  const World<double> world(scene);
  const RayGenerator<double> camera(scene, {1, 1}, {1, 1}, {samples, seed});
  Sampled sampled{0, 0, {}};
  for (int i = 0; i < samples; ++i)
    sampled.statistics += trace(world, camera, {0, 1, 0, 1, i}, [&](const Pixel&, const Rgbd& shade) {
      const double step = shade.x - sampled.mean;
      sampled.mean += step / (i + 1);
      sampled.variance += step * (shade.x - sampled.mean);
    });
  sampled.variance /= samples - 1;
  return sampled;
}

}  // namespace raywalk::test
