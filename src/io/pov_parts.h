#pragma once
// The pieces that a POV-Ray scene is put together from. Internal to `io`; the interface is io/pov_writer.h.

#include "math/transform.h"
#include "scene/scene.h"

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace raywalk::detail {

/// What could not be said, each once.
using PovLosses = std::set<std::string>;

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string pov_number(double value);
/// A point or direction, with y and z in POV-Ray's places.
[[nodiscard]] std::string pov_vector(const Vec3d& v);
[[nodiscard]] std::string pov_colour(const Rgbd& colour);
/// "matrix <...>" for an object whose shape already stands in POV-Ray's axes; empty for no map.
[[nodiscard]] std::string pov_matrix(const std::vector<TransformStep>& steps);

/// The shape without its closing brace: "sphere { <0, 0, 0>, 1".
[[nodiscard]] std::string pov_shape(const Shape<double>& shape);
/// The same of a mesh. `texture_of` gives what stands in the braces of a triangle of the mesh's own material.
[[nodiscard]] std::string pov_mesh(const MeshShape& mesh,
                                   const std::function<std::string(const Material&)>& texture_of);
/// The shape of an object that is one shape; nothing for a mesh and an instance.
[[nodiscard]] std::optional<Shape<double>> plain_shape(const ObjectShape& shape);
/// The two directions of a flat shape's own (u, v) and the point where they begin; nothing for a curved shape.
struct FlatFrame {
  Vec3d origin, u, v, normal;
};
[[nodiscard]] std::optional<FlatFrame> flat_frame(const Shape<double>& shape);

/// "texture { ... }" blocks, one a layer, and "interior { ... }" where light enters.
[[nodiscard]] std::string pov_texture(const Material& material, const std::optional<FlatFrame>& frame,
                                      PovLosses& losses);
[[nodiscard]] std::string pov_interior(const Material& material);

}  // namespace raywalk::detail
