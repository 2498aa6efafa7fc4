// Small pictures by any integrator, for tests of maps.
#pragma once

#include "trace/map_images.h"
#include "trace/pictures.h"
#include "trace/scene_kernel.h"

#include <cmath>
#include <vector>

namespace raywalk::test {

// What a map that is the same all over makes of a material.
inline void multiply(Material& material, MappedParameter of, const Rgbd& colour, double number) {
  switch (of) {
    case MappedParameter::ambient:
      material.ambient *= colour;
      break;
    case MappedParameter::diffuse:
      material.diffuse *= colour;
      break;
    case MappedParameter::diffuse_roughness:
      material.diffuse_roughness *= number;
      break;
    case MappedParameter::specular:
      material.specular *= colour;
      break;
    case MappedParameter::shininess:
      material.shininess *= number;
      break;
    case MappedParameter::reflection:
      material.reflection *= colour;
      break;
    case MappedParameter::transmission:
      material.transmission *= colour;
      break;
    case MappedParameter::roughness:
      material.roughness *= number;
      break;
    case MappedParameter::gloss:
      material.gloss *= number;
      break;
    case MappedParameter::translucency:
      material.translucency *= number;
      break;
    case MappedParameter::emission:
      material.emission *= colour;
      break;
  }
}

template <class T>
Picture<T> drawn_in(const Scene& scene, const World<T>& world, Observer* observer = nullptr) {
  constexpr int width = 21, height = 15;
  const Sampling sampling{2, 7};
  const RayGenerator<T> camera(scene, {width, height}, {width, height}, sampling);
  const SceneKernel<T> kernel(scene, world);
  Picture<T> picture{width, height, std::vector<Rgb<T>>(std::size_t{width} * height), {}};
  const PutPixel<T> put = [&](const Pixel& pixel, const Rgb<T>& shade) {
    picture.pixels[static_cast<std::size_t>(pixel.row * width + pixel.column)] = shade;
  };
  for (int sample = 0; sample < sampling.per_pixel; ++sample) {
    const PixelBlock block{0, width, 0, height, sample};
    picture.statistics += observer ? kernel.watched(camera, block, *observer, put) : kernel(camera, block, put);
  }
  return picture;
}

template <class T>
Picture<T> drawn_by(Scene scene, Integrator integrator, Observer* observer = nullptr) {
  scene.render.integrator = integrator;
  return drawn_in<T>(scene, World<T>(scene), observer);
}

template <class T>
double max_difference(const Picture<T>& a, const Picture<T>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(static_cast<double>(a.pixels[i][c] - b.pixels[i][c])));
  return most;
}

}  // namespace raywalk::test
