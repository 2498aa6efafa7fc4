// Small pictures and single rays for the tracer's tests.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "trace/kernel.h"

namespace raywalk::test {

struct Recording final : Observer {
  std::vector<Event> events;
  void record(Event&& event) override { events.push_back(std::move(event)); }

  // The details of all events of one kind.
  template <class Detail>
  [[nodiscard]] std::vector<Detail> all() const {
    std::vector<Detail> found;
    for (const Event& event : events)
      if (const auto* detail = std::get_if<Detail>(&event.detail)) found.push_back(*detail);
    return found;
  }
  // Whether some ray met an object, or was stopped by it.
  [[nodiscard]] bool meets(int object) const {
    return std::any_of(events.begin(), events.end(), [&](const Event& event) {
      const auto* found = std::get_if<Found>(&event.detail);
      return found != nullptr && found->object == object;
    });
  }
};

template <class T>
struct Picture {
  int width = 0, height = 0;
  std::vector<Rgb<T>> pixels;  // row by row; the last sample where there are several
  Statistics statistics;
  [[nodiscard]] const Rgb<T>& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row * width + column)];
  }
};

template <class T>
bool same_bits(const Picture<T>& a, const Picture<T>& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Rgb<T>)) == 0;
}

inline bool same_counts(const Statistics& a, const Statistics& b) {
  return a.rays == b.rays && a.ended == b.ended && a.tests.nodes == b.tests.nodes &&
         a.tests.primitives == b.tests.primitives && a.random_draws() == b.random_draws() && a.draws == b.draws &&
         a.not_finite == b.not_finite;
}

// `run(world, camera, block, put)` is one of the kernels.
template <class T, class Run>
Picture<T> picture_by(const Scene& scene, int width, int height, Sampling sampling, Run run,
                      const BuildOptions& build = {}) {
  const World<T> world(scene, AcceleratorKind::automatic, std::nullopt, build);
  const RayGenerator<T> camera(scene, {width, height}, {width, height}, sampling);
  Picture<T> picture{width, height, std::vector<Rgb<T>>(static_cast<std::size_t>(width * height)), {}};
  const PutPixel<T> put = [&](const Pixel& pixel, const Rgb<T>& shade) {
    picture.pixels[static_cast<std::size_t>(pixel.row * width + pixel.column)] = shade;
  };
  for (int sample = 0; sample < sampling.per_pixel; ++sample)
    picture.statistics += run(world, camera, PixelBlock{0, width, 0, height, sample}, put);
  return picture;
}

template <class T>
Picture<T> picture(const Scene& scene, int width, int height, Sampling sampling = {}, const BuildOptions& build = {}) {
  return picture_by<T>(
      scene, width, height, sampling, [](const auto&... arguments) { return trace(arguments...); }, build);
}

template <class T>
Picture<T> watched_picture(const Scene& scene, int width, int height, Observer& observer, Sampling sampling = {}) {
  return picture_by<T>(scene, width, height, sampling,
                       [&](const auto&... arguments) { return trace_watched(arguments..., observer); });
}

inline Scene looking(Scene scene, const Vec3d& eye, const Vec3d& target) {
  scene.camera.eye = eye;
  scene.camera.look_at = target;
  const Vec3d view = target - eye;
  scene.camera.up = view.x == 0 && view.y == 0 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  return scene;
}

// What a single ray from `eye` through `target` brings.
template <class T = double>
Rgb<T> shade_along(const Scene& scene, const Vec3d& eye, const Vec3d& target) {
  return picture<T>(looking(scene, eye, target), 1, 1).at(0, 0);
}

// The same, watched.
inline Recording record_along(const Scene& scene, const Vec3d& eye, const Vec3d& target) {
  Recording recording;
  static_cast<void>(watched_picture<double>(looking(scene, eye, target), 1, 1, recording));
  return recording;
}

// Reflects and emits nothing, and absorbs all.
inline Material black() {
  Material material;
  material.diffuse = Rgbd(0.0);
  return material;
}

inline Object object(std::string name, Shape<double> shape, const Material& material) {
  return {std::move(name), std::move(shape), material};
}

inline Light lamp(const Vec3d& position, double strength = 1, Attenuation attenuation = {}) {
  return {"Lamp", Rgbd(strength), PointLight{position, attenuation}};
}

// A scene in which everything happens: mirrors, glass of both kinds, a checkered floor, filtered shadows, a prism,
// lights of both kinds.
inline Scene busy_scene() {
  Scene scene;
  scene.background = {0.1, 0.2, 0.4};
  scene.ambient = {0.5, 0.5, 0.6};
  scene.camera.eye = {-6, 0, 0.5};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 1.2, 21};
  scene.limits.depth = 6;
  Material matte;
  matte.ambient = Rgbd(0.2);
  matte.diffuse = {0.8, 0.3, 0.2};
  matte.specular = Rgbd(0.4);
  matte.shininess = 40;
  Material floor = matte;
  floor.checker = Checker{{0.9, 0.9, 0.9}, {0.1, 0.2, 0.1}, 0.7};
  floor.reflection = Rgbd(0.1);
  Material mirror = matte;
  mirror.diffuse = Rgbd(0.1);
  mirror.reflection = {0.8, 0.7, 0.6};
  Material glass = black();
  glass.specular = Rgbd(0.5);
  glass.transmission = {0.8, 0.9, 0.8};
  glass.ior = 1.5;
  Material crystal = glass;
  crystal.dielectric = true;
  crystal.reflection = Rgbd(0.05);
  crystal.ior = 2.0;
  crystal.shadow = ShadowKind::filtered;
  Material glow = matte;
  glow.emission = {0.3, 0.2, 0.1};
  scene.objects = {object("Matte", Sphere<double>{{0.5, 1.6, 0}, 0.8}, matte),
                   object("Mirror", Sphere<double>{{1, 0, 0.2}, 0.7}, mirror),
                   object("Glass", Sphere<double>{{-1, -1.2, 0}, 0.9}, glass),
                   object("Crystal", Prism<double>{{{-2, 0.2}, {-1, 0.4}, {-1.2, 1.2}, {-1.5, 0.7}}, 1.2}, crystal),
                   object("Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, floor),
                   object("Wall", Plane<double>{{4, 0, 0}, {-1, 0.2, 0}}, glow)};
  scene.lights = {lamp({-3, 3, 2}, 1.2, {0.5, 0.1, 0.05}),
                  {"Sun", {0.4, 0.4, 0.3}, DirectionalLight{{-1, -1, 1}}},
                  {"Dark", Rgbd(0.0), PointLight{}}};
  return scene;
}

}  // namespace raywalk::test
