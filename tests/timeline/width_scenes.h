// What the walks of beams and of cones are tried on.
#pragma once

#include "timeline/recorder.h"

#include <vector>

namespace raywalk::test {

// Walls of one shade each: what they are is what they give off.
inline Material shining(const Rgbd& colour) {
  Material material;
  material.diffuse = Rgbd(0.0);
  material.emission = colour;
  return material;
}

// Nothing yet, seen by a strip of 16 pixels.
inline Scene plain_scene(Integrator integrator) {
  Scene scene;
  scene.background = {0.1, 0.2, 0.3};
  scene.camera.eye = {-6, 0, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {2, 4.2, 16};
  scene.render.integrator = integrator;
  return scene;
}

inline std::vector<Rgbd> shades_of_strip(const Scene& scene) {
  const Timeline timeline = record_strip(scene);
  std::vector<Rgbd> strip;
  for (const PixelRecord& pixel : timeline.pixels()) strip.push_back(pixel.shade);
  return strip;
}

}  // namespace raywalk::test
