#pragma once
// What the readers of other formats share: naming what has no name, and checking what no single number can tell.
// Internal to `io`.

#include "io/word_reader.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <string_view>

namespace raywalk::detail {

/// "Sphere 1", "Sphere 2", "Light 1": each kind counts by itself.
class Names {
 public:
  [[nodiscard]] std::string next(std::string_view kind) {
    return std::string(kind) + " " + std::to_string(++counts_[kind]);
  }

 private:
  std::map<std::string_view, int> counts_;  ///< of string literals
};

/// Adds triangles to a scene, and leaves out those without an area: no ray meets them.
class Triangles {
 public:
  void add(Scene& scene, Names& names, const Material& material, const Vec3d& a, const Vec3d& b, const Vec3d& c);
  /// Says how many were left out, if any.
  void warn(WordReader& words) const;

 private:
  int left_out_ = 0;
};

/// Fails at the item taken last unless the camera sees something: eye and look-at apart, up not along the view.
void check_camera(const Camera& camera, WordReader& words);
/// Fails at the word taken last unless an image of this size can be rendered.
void check_image(const ImageSize& image, WordReader& words);

}  // namespace raywalk::detail
