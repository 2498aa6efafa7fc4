#pragma once
// The parts of a POV-Ray scene. Internal to `io`; the interface is io/pov_writer.h.

#include "math/transform.h"
#include "scene/scene.h"

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace raywalk::detail {

/// What could not be expressed, without duplicates.
using PovLosses = std::set<std::string>;

/// The shortest text that is read back as the same number.
[[nodiscard]] std::string pov_number(double value);
/// A point or direction, with y and z in POV-Ray's order.
[[nodiscard]] std::string pov_vector(const Vec3d& v);
[[nodiscard]] std::string pov_colour(const Rgbd& colour);
/// "matrix <...>" for an object whose shape is already in POV-Ray's axes; empty without steps.
[[nodiscard]] std::string pov_matrix(const std::vector<TransformStep>& steps);

/// The shape without its closing brace: "sphere { <0, 0, 0>, 1". One that POV-Ray lacks becomes its box, which `losses`
/// then say.
[[nodiscard]] std::string pov_shape(const Shape<double>& shape, PovLosses& losses);
/// The same of a mesh. `texture_of` gives the texture of a triangle for a material of the mesh.
[[nodiscard]] std::string pov_mesh(const MeshShape& mesh,
                                   const std::function<std::string(const Material&)>& texture_of);
/// The shape of an object; nothing for a mesh or an instance.
[[nodiscard]] std::optional<Shape<double>> plain_shape(const ObjectShape& shape);
/// The (u, v) axes of a flat shape and their origin; nothing for a curved shape.
struct FlatFrame {
  Vec3d origin, u, v, normal;
};
[[nodiscard]] std::optional<FlatFrame> flat_frame(const Shape<double>& shape);

/// "texture { ... }" blocks, one per layer, and "interior { ... }" if it transmits light.
[[nodiscard]] std::string pov_texture(const Material& material, const std::optional<FlatFrame>& frame,
                                      PovLosses& losses);
[[nodiscard]] std::string pov_interior(const Material& material);

}  // namespace raywalk::detail
