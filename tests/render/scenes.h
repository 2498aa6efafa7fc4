// Scenes to try the renderer on, and how to compare what it makes.
#pragma once

#include "render/render.h"

#include <cstring>
#include <string>
#include <vector>

namespace raywalk::test {

// Planar, and with everything that a ray can meet: opaque, mirror, dielectric and filtering surfaces, a checker, a
// concave prism, a point light and a sun, every reason to end but path_length.
Scene busy_scene();

struct NamedScene {
  std::string name;
  Scene scene;
};

// Every scene that the project ships and that reads as planar, and the busy one.
std::vector<NamedScene> planar_scenes();

// Pixels whose bits differ: so NaN equals itself and -0 does not equal 0.
template <class T>
std::size_t pixels_that_differ(const Film<T>& a, const Film<T>& b) {
  if (a.pixels().size() != b.pixels().size()) return a.pixels().size() + b.pixels().size();
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    if (std::memcmp(&a.pixels()[i], &b.pixels()[i], sizeof(Rgb<T>)) != 0) ++count;
  return count;
}

inline bool same_pixels(const Rendering& a, const Rendering& b) {
  const Image one = a.image(), other = b.image();
  return one.pixels.size() == other.pixels.size() &&
         std::memcmp(one.pixels.data(), other.pixels.data(), one.pixels.size() * sizeof(one.pixels[0])) == 0;
}

template <class T>
bool same_bits(const Rgb<T>& a, const Rgb<T>& b) {
  return std::memcmp(&a, &b, sizeof(Rgb<T>)) == 0;
}

template <class T>
constexpr Precision precision_of() {
  return sizeof(T) == sizeof(float) ? Precision::float_ : Precision::double_;
}

// All counts in one line, so that equal statistics are equal strings and a difference can be read.
std::string text_of(const Statistics& statistics);

}  // namespace raywalk::test
