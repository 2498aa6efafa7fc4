#pragma once
// What an object of a scene may be: one shape, a mesh, or a group of objects used once more.

#include "scene/material.h"
#include "shape/mesh.h"
#include "shape/shape.h"

#include <memory>
#include <string>

namespace raywalk {

/// A mesh from a file of its own, or one whose vertices stand in the scene.
struct MeshShape {
  std::string file;            ///< as the scene names it; empty when the vertices stand in the scene itself
  bool smooth = true;          ///< whether normals between the vertices are interpolated, where vertices have them
  bool file_materials = true;  ///< whether triangles have the materials that the file gives them, if it does
  std::shared_ptr<const Mesh> mesh;                          ///< null until the file is read
  std::shared_ptr<const std::vector<Material>> materials{};  ///< those of the file
  /// The same mesh, but not what its file holds now.
  friend bool operator==(const MeshShape& a, const MeshShape& b) {
    const bool same_mesh = !a.file.empty() || a.mesh == b.mesh || (a.mesh && b.mesh && *a.mesh == *b.mesh);
    return a.file == b.file && a.smooth == b.smooth && a.file_materials == b.file_materials && same_mesh;
  }
};

struct GroupContent;

/// A group of objects, put once more into the scene.
struct Instance {
  std::string group;                            ///< the group's name
  std::shared_ptr<const GroupContent> content;  ///< null until it is looked up
  friend bool operator==(const Instance& a, const Instance& b) { return a.group == b.group; }
};

constexpr std::string_view shape_name(const MeshShape& /*shape*/) { return "mesh"; }
constexpr std::string_view shape_name(const Instance& /*shape*/) { return "instance"; }

namespace detail {
template <class Variant, class... More>
struct Extended;
template <class... Kinds, class... More>
struct Extended<std::variant<Kinds...>, More...> {
  using type = std::variant<Kinds..., More...>;
};
}  // namespace detail

struct ObjectShape : detail::Extended<Shape<double>, MeshShape, Instance>::type {
  using Kinds = detail::Extended<Shape<double>, MeshShape, Instance>::type;
  using Kinds::variant;
  using Kinds::operator=;
  ObjectShape() = default;
  ObjectShape(const Shape<double>& shape);  // NOLINT: a shape is an object's shape
  friend bool operator==(const ObjectShape&, const ObjectShape&) = default;
};

[[nodiscard]] std::string_view shape_name(const ObjectShape& shape);

/// In the object's own space. Empty for what has not been read or looked up.
[[nodiscard]] Bounds<double> bounds(const MeshShape& shape);
[[nodiscard]] Bounds<double> bounds(const Instance& shape);
[[nodiscard]] Bounds<double> bounds(const ObjectShape& shape);

}  // namespace raywalk
