#pragma once
// The keys of the scene format, listed once, in the order in which they are written. `Fields` is told of every member
// by its key and its rule: one kind of Fields reads them from TOML (scene_reader.cpp), one lists their values for
// writing (scene_values.cpp), one only lists the keys (tests). A new member of a scene is one line here.

#include "io/scene_words.h"

namespace raywalk::scene_keys {

template <class Fields>
void describe(Fields& f, FieldOfView& fov) {
  f.number("fov", fov.degrees, view_angle, required);
  f.choice("fov_axis", fov.axis);
}

template <class Fields>
void describe(Fields& f, Camera& camera) {
  f.point("eye", camera.eye, required);
  f.point("look_at", camera.look_at, required);
  f.direction("up", camera.up, optional);
  f.together(camera.fov);
  f.number("aperture", camera.aperture, not_negative, optional);
  f.number_or_nothing("focus", camera.focus, above_zero);
  f.pair("shutter", camera.shutter_open, camera.shutter_close, coordinate, "[open, close]");
  f.check(camera.shutter_open <= camera.shutter_close, "shutter",
          "the shutter closes before it opens (expected [open, close] with open at most close)",
          "[0, 0.5] is open from the time 0 to the time 0.5; equal times freeze all motion");
}

template <class Fields>
void describe(Fields& f, Screen& screen) {
  f.number("distance", screen.distance, above_zero, optional);
  f.number_or_nothing("width", screen.width, above_zero);
  f.whole("cells", screen.cells, cell_count);
}

/// The members of a scene that [image] holds.
struct ImageTable {
  ImageSize size;
  Encoding encoding = Encoding::srgb;
};

template <class Fields>
void describe(Fields& f, ImageTable& image) {
  f.whole("width", image.size.width, pixel_count);
  f.whole("height", image.size.height, pixel_count);
  f.choice("encoding", image.encoding);
}

template <class Fields>
void describe(Fields& f, TraceLimits& limits) {
  f.whole("depth", limits.depth, depth_count);
  f.number("threshold", limits.threshold, not_negative, optional);
}

template <class Fields>
void describe(Fields& f, PointLight& light) {
  f.point("position", light.position, required);
  f.attenuation("attenuation", light.attenuation);
}

template <class Fields>
void describe(Fields& f, DirectionalLight& light) {
  f.direction("direction", light.direction, required);
}

template <class Fields>
void describe(Fields& f, SpotLight& light) {
  f.point("position", light.position, required);
  f.point("look_at", light.look_at, required);
  f.check(length(light.look_at - light.position) >= 1 / most_magnitude, "look_at",
          "the spot looks at its own position (expected another point)",
          "look_at is a point in the middle of its light");
  f.number("angle", light.angle, cone_angle, optional);
  f.number("inner_angle", light.inner_angle, inner_cone_angle, optional);
  f.check(light.inner_angle <= light.angle, "inner_angle",
          "the inner angle is wider than the angle (expected at most the angle)",
          "give both when you make the cone narrower than 40 degrees");
  f.attenuation("attenuation", light.attenuation);
}

template <class Fields>
void describe(Fields& f, SphereLight& light) {
  f.point("position", light.position, required);
  f.number("radius", light.radius, not_negative, required);
  f.whole("samples", light.samples, light_grid_count);
  f.attenuation("attenuation", light.attenuation);
}

template <class Fields>
void describe(Fields& f, RectangleLight& light) {
  f.point("corner", light.corner, required);
  f.point("u", light.u, required);
  f.point("v", light.v, required);
  f.whole("samples", light.samples, light_grid_count);
  f.attenuation("attenuation", light.attenuation);
}

template <class Fields>
void describe(Fields& f, Light& light) {
  f.name("name", light.name);
  f.type("type", light.kind);
  f.colour("strength", light.strength);
}

template <class Fields>
void describe(Fields& f, Sphere<double>& sphere) {
  f.point("centre", sphere.centre, required);
  f.number("radius", sphere.radius, above_zero, required);
}

template <class Fields>
void describe(Fields& f, Plane<double>& plane) {
  f.point("point", plane.point, required);
  f.direction("normal", plane.normal, required);
}

template <class Fields>
void describe(Fields& f, Prism<double>& prism) {
  f.corners("corners", prism.corners);
  f.number("height", prism.height, above_zero, optional);
}

template <class Fields>
void describe(Fields& f, Box<double>& box) {
  f.point("min", box.min, required);
  f.point("max", box.max, required);
  f.check(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z, "max",
          "a corner of the box is beyond the other (expected max at or above min in x, y and z)",
          "min holds the smallest x, y and z of the box, max the largest");
}

template <class Fields, QuadricKind Kind>
void describe(Fields& f, Quadric<double, Kind>& quadric) {
  f.lengths("radii", quadric.radii);
  f.limit("z_min", quadric.z_min);
  f.limit("z_max", quadric.z_max);
  f.check(quadric.z_min < quadric.z_max, "z_max", "nothing is left between z_min and z_max (expected z_min < z_max)",
          "leave them out to cut nothing off");
  f.yes_or_no("capped", quadric.capped);
}

template <class Fields>
void describe(Fields& f, Disk<double>& disk) {
  f.point("centre", disk.centre, required);
  f.direction("normal", disk.normal, required);
  f.number("radius", disk.radius, above_zero, required);
}

template <class Fields>
void describe(Fields& f, Polygon<double>& polygon) {
  f.points("corners", polygon.outline);
  f.holes("holes", polygon.holes);
  const std::string why = why_not_flat(polygon);
  f.check(why.empty(), "corners", why, "a flat polygon has an area, and all its corners lie in one plane");
}

template <class Fields>
void describe(Fields& f, Triangle<double>& triangle) {
  f.point("a", triangle.a, required);
  f.point("b", triangle.b, required);
  f.point("c", triangle.c, required);
  f.check(cross(triangle.b - triangle.a, triangle.c - triangle.a) != Vec3d(0.0), "c",
          "the three corners lie on one line (expected a triangle with an area)", "move one of the corners");
}

/// The vertices stand in a file of its own or in the scene.
template <class Fields>
void describe(Fields& f, MeshShape& mesh) {
  f.mesh_file("file", mesh);
  f.vertices("vertices", "triangles", "normals", "uv", mesh);
  f.yes_or_no("smooth", mesh.smooth);
  f.yes_or_no("file_materials", mesh.file_materials);
}

template <class Fields>
void describe(Fields& f, Instance& instance) {
  f.group_name("group", instance);
}

/// A share of the light, which goes on at every surface that a ray meets.
template <class Fields>
void share(Fields& f, std::string_view key, Rgbd& colour) {
  f.colour(key, colour);
  f.check(max_component(colour) <= reflectance.high, key,
          "more than a thousand times the light would go on (expected at most 1000)", reflectance.hint);
}

template <class Fields>
void describe(Fields& f, Checker& checker) {
  share(f, "even", checker.even);
  share(f, "odd", checker.odd);
  f.number("size", checker.size, above_zero, optional);
}

template <class Fields>
void describe(Fields& f, ImageTexture& texture) {
  f.file("file", texture.file);
  f.number("width", texture.width, above_zero, optional);
  f.number("height", texture.height, above_zero, optional);
}

template <class Fields>
void describe(Fields& f, Material& material) {
  share(f, "ambient", material.ambient);
  share(f, "diffuse", material.diffuse);
  share(f, "specular", material.specular);
  f.number("shininess", material.shininess, not_negative, optional);
  share(f, "reflection", material.reflection);
  share(f, "transmission", material.transmission);
  f.number("ior", material.ior, above_zero, optional);
  f.yes_or_no("dielectric", material.dielectric);
  f.number("gloss", material.gloss, lobe_angle, optional);
  f.number("translucency", material.translucency, lobe_angle, optional);
  f.colour("absorption", material.absorption);
  f.number("priority", material.priority, any_priority, optional);
  f.choice("shadow", material.shadow);
  f.choice("normal", material.normal);
  f.check(material.normal == ShadingNormal::facing || !material.transmits(), "normal",
          "a fixed normal does not go with transmission (expected \"facing\")",
          "light is refracted at the side that it comes from");
  f.colour("emission", material.emission);
  f.table_or_nothing("checker", material.checker);
  f.table_or_nothing("texture", material.texture);
}

template <class Fields>
void describe(Fields& f, Object& object) {
  f.name("name", object.name);
  f.type("type", object.shape);
  f.steps("transform", object.transform);
  f.motion("motion", object.motion);
  f.table("material", object.material, optional);
  f.check(!std::holds_alternative<Instance>(object.shape) || object.material == Material{}, "material",
          "an instance has the materials of the objects in its group (expected none of its own)",
          "give the material to the objects of [[group]]");
}

template <class Fields>
void describe(Fields& f, Group& group) {
  f.name("name", group.name);
  f.tables("object", group.objects);
  f.define(group);
}

template <class Fields>
void describe(Fields& f, RenderChoices& render) {
  f.choice("integrator", render.integrator);
  f.whole("samples", render.samples, sample_count);
  f.choice("sampler", render.sampler);
  f.whole_or_nothing("light_grid", render.light_grid, light_grid_count);
  f.number("tolerance", render.tolerance, not_negative, optional);
  f.whole_or_nothing("path_length", render.path_length, path_length_count);
  f.choice("numerics", render.numerics);
  f.number("epsilon", render.epsilon, not_negative, optional);
}

template <class Fields>
void describe(Fields& f, Scene& scene) {
  f.text("title", scene.title);
  f.text("description", scene.description);
  f.colour("background", scene.background);
  f.colour("ambient", scene.ambient);
  f.table("camera", scene.camera, required);
  f.table("screen", scene.camera.screen, optional);
  ImageTable image{scene.image, scene.encoding};
  f.table("image", image, optional);
  scene.image = image.size;
  scene.encoding = image.encoding;
  f.table("limits", scene.limits, optional);
  f.table("render", scene.render, optional);
  f.tables("group", scene.groups);
  f.tables("light", scene.lights);
  f.tables("object", scene.objects);
}

}  // namespace raywalk::scene_keys
