#pragma once
// What the readers of other formats share: naming what has no name, gathering triangles, and checking what no single
// number can tell. Internal to `io`.

#include "io/word_reader.h"
#include "scene/scene.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A corner of a triangle; a normal of 0 where the surface is flat.
struct MeshCorner {
  Vec3d position, normal{0.0};
};

/// Makes meshes of the triangles that follow each other in one material, and leaves out those without an area: no ray
/// meets them. One that stands alone becomes a triangle.
class Triangles {
 public:
  void add(Scene& scene, Names& names, const Material& material, const std::array<MeshCorner, 3>& corners);
  /// Puts what was gathered into the scene: before any other object, before another material, and at the end.
  void put(Scene& scene, Names& names);
  /// Says how many were left out, if any.
  void warn(WordReader& words) const;

 private:
  Mesh gathered_;
  bool smooth_ = false;
  Material material_;
  int left_out_ = 0;
};

/// About what the scene of a text comes to in memory, by the words at the beginnings of its lines: so many `objects`,
/// and corners and triangles of meshes. Said before it is read; makes room for the objects.
[[nodiscard]] std::optional<Error> make_room(Scene& scene, std::string_view text, const std::string& file,
                                             const std::vector<std::string_view>& object_words,
                                             const std::vector<std::string_view>& triangle_words);

/// Fails at the item taken last unless the camera sees something: eye and look-at apart, up not along the view.
void check_camera(const Camera& camera, WordReader& words);
/// Fails at the word taken last unless an image of this size can be rendered.
void check_image(const ImageSize& image, WordReader& words);

}  // namespace raywalk::detail
