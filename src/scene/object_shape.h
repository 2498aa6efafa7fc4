#pragma once
// What an object of a scene may be: a shape, a mesh, or an instance of a group of objects.

#include "scene/material.h"
#include "shape/mesh.h"
#include "shape/shape.h"

#include <memory>
#include <string>

namespace raywalk {

/// A mesh from a file of its own, or with its vertices in the scene.
struct MeshShape {
  std::string file;                  ///< as the scene names it; empty when the vertices are in the scene itself
  bool smooth = true;                ///< whether vertex normals are interpolated, where there are any
  bool file_materials = true;        ///< whether triangles use the materials of the file, if it has any
  std::shared_ptr<const Mesh> mesh;  ///< null until the file is read
  std::shared_ptr<const std::vector<Material>> materials{};  ///< those of the file
  /// Meshes from files are compared by name, not by content.
  friend bool operator==(const MeshShape& a, const MeshShape& b) {
    const bool same_mesh = !a.file.empty() || a.mesh == b.mesh || (a.mesh && b.mesh && *a.mesh == *b.mesh);
    return a.file == b.file && a.smooth == b.smooth && a.file_materials == b.file_materials && same_mesh;
  }
};

struct GroupContent;

/// A group of objects, placed into the scene again.
struct Instance {
  std::string group;                            ///< the group's name
  std::shared_ptr<const GroupContent> content;  ///< null until resolved
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

/// In object space. Empty for what has not been read or resolved.
[[nodiscard]] Bounds<double> bounds(const MeshShape& shape);
[[nodiscard]] Bounds<double> bounds(const Instance& shape);
[[nodiscard]] Bounds<double> bounds(const ObjectShape& shape);

}  // namespace raywalk
