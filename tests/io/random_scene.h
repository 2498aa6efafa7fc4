// Random scenes and edits for property tests. Everything follows from the generator's seed.
#pragma once

#include <random>
#include <string>

#include "scene/scene.h"

namespace raywalk::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// From 0 to below `count`.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool chance(double probability) { return unit() < probability; }
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Small round numbers, full 53-bit ones, huge and tiny ones, and both zeros.
  double number();
  double positive();

 private:
  std::mt19937_64 engine_;
};

/// Keeps every rule of the format.
Scene random_scene(Random& random);
Object random_object(Random& random, const std::string& name);
Light random_light(Random& random, const std::string& name);
Material random_material(Random& random);

/// Changes one thing: a number, a colour, a material, a shape's kind, the corners, the camera, fov to width and back.
void change_something(Scene& scene, Random& random);

/// Equal in every bit, so that 0 and -0 differ.
bool same_bits(const Scene& a, const Scene& b);

}  // namespace raywalk::test
