#include "io/pov_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>
#include <variant>

namespace raywalk::detail {

std::string pov_number(double value) { return fmt::format("{}", value); }

std::string pov_vector(const Vec3d& v) { return fmt::format("<{}, {}, {}>", v.x, v.z, v.y); }

std::string pov_colour(const Rgbd& colour) {
  if (colour.x == colour.y && colour.y == colour.z) return fmt::format("rgb {}", colour.x);
  return fmt::format("rgb <{}, {}, {}>", colour.x, colour.y, colour.z);
}

std::string pov_matrix(const std::vector<TransformStep>& steps) {
  if (steps.empty()) return {};
  const Affine<double> m = affine_of(steps);
  // Axes are exchanged on both sides: POV-Ray's second axis is our third.
  return fmt::format("  matrix <{}, {}, {},  {}, {}, {},  {}, {}, {},  {}, {}, {}>\n", m.x.x, m.x.z, m.x.y, m.z.x,
                     m.z.z, m.z.y, m.y.x, m.y.z, m.y.y, m.move.x, m.move.z, m.move.y);
}

namespace {

std::string text_of(const Sphere<double>& sphere) {
  return fmt::format("sphere {{ {}, {}", pov_vector(sphere.centre), sphere.radius);
}

std::string text_of(const Plane<double>& plane) {
  const Vec3d normal = normalize(plane.normal);
  return fmt::format("plane {{ {}, {}", pov_vector(normal), dot(normal, plane.point));
}

std::string text_of(const Bounds<double>& box) {
  return fmt::format("box {{ {}, {}", pov_vector(box.min), pov_vector(box.max));
}
std::string text_of(const Box<double>& box) { return text_of(Bounds<double>{box.min, box.max}); }

std::string text_of(const Disk<double>& disk) {
  return fmt::format("disc {{ {}, {}, {}", pov_vector(disk.centre), pov_vector(disk.normal), disk.radius);
}

std::string text_of(const Triangle<double>& triangle) {
  return fmt::format("triangle {{ {}, {}, {}", pov_vector(triangle.a), pov_vector(triangle.b), pov_vector(triangle.c));
}

/// A prism's base is in POV-Ray's x and z, our x and y.
std::string text_of(const Prism<double>& prism) {
  std::string text = fmt::format("prism {{ linear_sweep linear_spline {}, {}, {}", -prism.height / 2, prism.height / 2,
                                 prism.corners.size() + 1);
  for (std::size_t i = 0; i <= prism.corners.size(); ++i) {
    const Vec2d& corner = prism.corners[i % prism.corners.size()];
    text += fmt::format(", <{}, {}>", corner.x, corner.y);
  }
  return text;
}

/// Every loop repeats its first corner.
std::string text_of(const Polygon<double>& polygon) {
  std::size_t count = polygon.outline.size() + 1;
  for (const auto& hole : polygon.holes) count += hole.size() + 1;
  std::string text = fmt::format("polygon {{ {}", count);
  const auto add = [&text](const std::vector<Vec3d>& loop) {
    for (std::size_t i = 0; i <= loop.size(); ++i) text += ", " + pov_vector(loop[i % loop.size()]);
  };
  add(polygon.outline);
  for (const auto& hole : polygon.holes) add(hole);
  return text;
}

template <QuadricKind Kind>
std::string text_of(const Quadric<double, Kind>& quadric) {
  const QuadricEquation e = equation_of(quadric);
  const std::string wall =
      fmt::format("quadric {{ <{}, {}, {}>, <0, 0, 0>, <0, {}, 0>, {} }}", e.xx, e.zz, e.yy, e.linear, e.constant);
  std::string cuts;
  if (std::isfinite(quadric.z_min)) cuts += fmt::format(" plane {{ <0, -1, 0>, {} }}", -quadric.z_min);
  if (std::isfinite(quadric.z_max)) cuts += fmt::format(" plane {{ <0, 1, 0>, {} }}", quadric.z_max);
  if (cuts.empty()) return wall.substr(0, wall.size() - 2);
  if (quadric.capped) return "intersection { " + wall + cuts;
  return wall.substr(0, wall.size() - 2) + " clipped_by { intersection {" + cuts + " } }";
}

}  // namespace

std::string pov_shape(const Shape<double>& shape, PovLosses& losses) {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { text_of(kind); }) return text_of(kind);
        losses.insert(std::string(shape_name(kind)) + " shapes, which become boxes");
        return text_of(bounds(kind));
      },
      shape);
}

std::string pov_mesh(const MeshShape& shape, const std::function<std::string(const Material&)>& texture_of) {
  const Mesh& mesh = *shape.mesh;
  std::vector<std::string> textures;
  const bool dressed = shape.file_materials && shape.materials && !mesh.materials.empty();
  if (dressed)
    for (const Material& material : *shape.materials) textures.push_back(texture_of(material));
  std::string text = "mesh {\n";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::string corners;
    bool smooth = shape.smooth && !mesh.normals.empty();
    for (const std::int32_t corner : mesh.triangles[i])
      smooth = smooth && mesh.normals[static_cast<std::size_t>(corner)] != Vec3d(0.0);
    for (const std::int32_t corner : mesh.triangles[i]) {
      const auto at = static_cast<std::size_t>(corner);
      corners += (corners.empty() ? "" : ", ") + pov_vector(mesh.positions[at]);
      if (smooth) corners += ", " + pov_vector(mesh.normals[at]);
    }
    const std::int32_t material = dressed ? mesh.materials[i] : -1;
    text += fmt::format("  {} {{ {}{} }}\n", smooth ? "smooth_triangle" : "triangle", corners,
                        material < 0 ? "" : " " + textures[static_cast<std::size_t>(material)]);
  }
  return text;
}

std::optional<Shape<double>> plain_shape(const ObjectShape& shape) {
  return std::visit(
      [](const auto& kind) -> std::optional<Shape<double>> {
        if constexpr (std::is_constructible_v<Shape<double>, decltype(kind)>)
          return Shape<double>(kind);
        else
          return std::nullopt;
      },
      static_cast<const ObjectShape::Kinds&>(shape));
}

std::optional<FlatFrame> flat_frame(const Shape<double>& shape) {
  const auto at = [](const Vec3d& origin, const Vec3d& normal) {
    const Vec3d unit = normalize(normal);
    const PlaneAxes<double> frame = plane_axes(unit);
    return FlatFrame{origin, frame.u, frame.v, unit};
  };
  if (const auto* plane = std::get_if<Plane<double>>(&shape)) return at(plane->point, plane->normal);
  if (const auto* disk = std::get_if<Disk<double>>(&shape)) return at(disk->centre, disk->normal);
  if (const auto* polygon = std::get_if<Polygon<double>>(&shape))
    return at(polygon->outline.front(), polygon->area_vector());
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    const Vec3d normal = normalize(cross(triangle->b - triangle->a, triangle->c - triangle->a));
    const Vec3d u = normalize(triangle->b - triangle->a);
    return FlatFrame{triangle->a, u, cross(normal, u), normal};
  }
  return std::nullopt;
}

}  // namespace raywalk::detail
