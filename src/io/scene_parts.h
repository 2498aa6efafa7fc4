#pragma once
// What the readers of other formats share: naming the unnamed, gathering triangles, and checks that involve several
// numbers. Internal to `io`.

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

/// "Sphere 1", "Sphere 2", "Light 1": counted per kind.
class UniqueNames {
 public:
  [[nodiscard]] std::string next(std::string_view kind) {
    return std::string(kind) + " " + std::to_string(++counts_[kind]);
  }

 private:
  std::map<std::string_view, int> counts_;  ///< of string literals
};

/// A corner of a triangle; normal 0 for a flat surface.
struct MeshCorner {
  Vec3d position, normal{0.0};
};

/// Combines consecutive triangles of one material into meshes, and drops those without area: no ray hits them. A single
/// one becomes a triangle.
class TriangleGatherer {
 public:
  void add(Scene& scene, UniqueNames& names, const Material& material, const std::array<MeshCorner, 3>& corners);
  /// Adds the gathered triangles to the scene. To be called before any other object or material, and at the end.
  void put(Scene& scene, UniqueNames& names);
  /// Warns how many were dropped, if any.
  void warn(WordReader& words) const;

 private:
  Mesh gathered_;
  bool smooth_ = false;
  Material material_;
  int left_out_ = 0;
};

/// Estimates the memory for the scene of a text from the first words of its lines: of objects, and of corners and
/// triangles of meshes. Called before reading; reserves the objects.
[[nodiscard]] std::optional<Error> make_room(Scene& scene, std::string_view text, const std::string& file,
                                             const std::vector<std::string_view>& object_words,
                                             const std::vector<std::string_view>& triangle_words);

/// Fails at the last item unless the camera is valid: eye and look-at distinct, up not parallel to the view.
void check_camera(const Camera& camera, WordReader& words);
/// Fails at the last word unless an image of this size can be rendered.
void check_image(const ImageSize& image, WordReader& words);

}  // namespace raywalk::detail
