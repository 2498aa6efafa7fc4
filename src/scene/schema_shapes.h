#pragma once
// The keys of shapes: see scene/schema.h.

#include "scene/schema_kinds.h"

#include <string_view>

namespace raywalk::schema {

template <class Fields>
void describe(Fields& f, Sphere<double>& sphere) {
  f.about("The plan shows a sphere as the circle in which it is cut.");
  f.required("centre", sphere.centre, point, "With a z the sphere lies above or below the plan.");
  f.required("radius", sphere.radius, extent, "From the centre to the surface.");
}

template <class Fields>
void describe(Fields& f, Plane<double>& plane) {
  f.about("Flat and without end.");
  f.required("point", plane.point, point, "Any point of it.");
  f.required("normal", plane.normal, direction, "Across it, towards its front.");
}

template <class Fields>
void describe(Fields& f, Prism<double>& prism) {
  f.about("A polygon of the plan, which stands up as a solid (a prism).");
  f.required("corners", prism.corners, plan_corners, "Once around, in either direction; edges must not cross.");
  f.check(
      "corners",
      [&] {
        const std::string why = why_not_polygon(prism.corners);
        return why.empty() ? why : why + " (expected " + plan_corners.expected() + " whose edges do not cross)";
      },
      plan_corners.hint);
  f.key("height", prism.height, extent, "It reaches from -height/2 to height/2.");
}

template <class Fields>
void describe(Fields& f, Box<double>& box) {
  f.about("A box with edges along the axes.");
  f.required("min", box.min, point, "Its corner with the smallest x, y and z.");
  f.required("max", box.max, point, "Its corner with the largest x, y and z.");
  f.check("max", box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z,
          "a corner of the box is beyond the other (expected max at or above min in x, y and z)",
          "min holds the smallest x, y and z of the box, max the largest");
}

constexpr std::string_view equation_of(QuadricKind kind) {
  switch (kind) {
    case QuadricKind::ellipsoid:
      return "x^2/rx^2 + y^2/ry^2 + z^2/rz^2 = 1";
    case QuadricKind::elliptic_paraboloid:
      return "x^2/rx^2 + y^2/ry^2 = z";
    case QuadricKind::cone:
      return "x^2/rx^2 + y^2/ry^2 = z^2, both halves unless cut";
    case QuadricKind::cylinder:
      return "x^2/rx^2 + y^2/ry^2 = 1";
    case QuadricKind::hyperboloid_one_sheet:
      return "x^2/rx^2 + y^2/ry^2 - z^2/rz^2 = 1";
    case QuadricKind::hyperboloid_two_sheets:
      return "x^2/rx^2 + y^2/ry^2 - z^2/rz^2 = -1";
  }
  return "";
}

template <class Fields, QuadricKind Kind>
void describe(Fields& f, Quadric<double, Kind>& quadric) {
  f.about(equation_of(Kind));
  f.required("radii", quadric.radii, radii, "rx, ry and rz.");
  f.key("z_min", quadric.z_min, coordinate, "Cut off below.");
  f.key("z_max", quadric.z_max, coordinate, "Cut off above.");
  f.check("z_max", quadric.z_min < quadric.z_max, "nothing is left between z_min and z_max (expected z_min < z_max)",
          "leave them out to cut nothing off");
  f.key("capped", quadric.capped, yes_or_no, "Whether the cuts are closed.");
}

template <class Fields>
void describe(Fields& f, Disk<double>& disk) {
  f.about("A flat round plate without thickness.");
  f.required("centre", disk.centre, point, "Its middle.");
  f.required("normal", disk.normal, direction, "Across it, towards its front.");
  f.required("radius", disk.radius, extent, "From the centre to the rim.");
}

template <class Fields>
void describe(Fields& f, Polygon<double>& polygon) {
  f.about("A polygon without thickness, anywhere in space.");
  f.required("corners", polygon.outline, corners, "Once around, all in one plane.");
  f.key("holes", polygon.holes, holes,
        "Each a list of corners in the same plane. By the even-odd rule a point is solid if an odd number of outline "
        "and holes enclose it: a hole within a hole is an island, and what reaches out of the outline is solid.");
  f.check(
      "corners", [&] { return why_not_flat(polygon); },
      "a flat polygon has an area, and all its corners lie in one plane");
}

template <class Fields>
void describe(Fields& f, Triangle<double>& triangle) {
  f.about("A flat triangle without thickness.");
  f.required("a", triangle.a, point, "Its first corner.");
  f.required("b", triangle.b, point, "Its second corner.");
  f.required("c", triangle.c, point, "Its third corner.");
  f.check("c", cross(triangle.b - triangle.a, triangle.c - triangle.a) != Vec3d(0.0),
          "the three corners lie on one line (expected a triangle with an area)", "move one of the corners");
}

template <class Fields>
void describe(Fields& f, MeshShape& mesh) {
  f.about("Many triangles that share corners, in a file of their own or in `vertices` and `triangles`.");
  f.key("file", mesh.file, mesh_file_name,
        "An .obj (with its .mtl), .ply, .gltf or .glb, looked for from the folder of the scene.");
  f.key("vertices", mesh, vertex_rows, "The corners, where there is no file.");
  f.key("triangles", mesh, triangle_rows, "Three vertices each, counted from 0, counter-clockwise seen from outside.");
  f.key("normals", mesh, normal_rows, "One a vertex, if the mesh is to look smooth.");
  f.key("uv", mesh, uv_rows, "One a vertex: where it lies on checker and texture.");
  f.key("smooth", mesh.smooth, yes_or_no, "Whether normals between the corners are interpolated where these have one.");
  f.key("file_materials", mesh.file_materials, yes_or_no,
        "Whether triangles have the materials that the file gives them (Ka 1 1 1 of an .mtl counts as none: exporters "
        "write it of all surfaces).");
  f.complete(mesh);
}

template <class Fields>
void describe(Fields& f, Instance& instance) {
  f.about("A group of objects once more, in the materials that these have: it has no key `material`.");
  f.required("group", instance, group_name, "The name of a [[group]]; inside of a group, of one that stands above.");
}

}  // namespace raywalk::schema
