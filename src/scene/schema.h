#pragma once
// The schema of a scene: every key of its file once, in the order of writing, with the kind of its value and a
// description. The default of a key is that of its struct member.
//
// `Fields` visits each table: one kind of Fields reads it from TOML (io/scene_reader.h), one makes the tree for writing
// (io/scene_values.cpp), one the reference of the format (io/key_reference.cpp). It is called with
//   about(sentence)                         what it is; first of all
//   key(name, member, kind, sentence)       a key that may be left out; tables bring their sentence with them
//   required(name, member, kind, sentence)  one that may not
//   type(variant, sentence)                 the key `type`, which says what further keys there are
//   together(optional)                      members that stand in this very table, all or none of them
//   check(name, holds, message, hint)       a rule over several members, told at this key when it is broken
//   check(name, why, hint)                  the same; `why()` takes its time, and is "" or the message
//   complete(value)                         all keys of a value are told that needs more than its keys
// A new key needs a member of its struct and a line here.

#include "scene/schema_kinds.h"

#include <string_view>
#include <variant>

namespace raywalk::schema {

template <class Fields>
void describe(Fields& f, FieldOfView& fov) {
  f.required("fov", fov.degrees, view_angle,
             "How wide the view is: the angle across the whole picture. Either this or `width` of [screen].");
  f.key("fov_axis", fov.axis, fov_axes, "Which way `fov` runs: from left to right (x) or from bottom to top (y).");
}

template <class Fields>
void describe(Fields& f, Camera& camera) {
  f.about(
      "Where the picture is seen from. If eye, look_at and lights lie in z = 0 and up is [0, 0, 1], the scene is "
      "planar: its plan shows what the middle row of its picture is made of.");
  f.required("eye", camera.eye, point, "EYE: where all primary rays start.");
  f.required("look_at", camera.look_at, point, "A point straight ahead of the eye.");
  f.key("up", camera.up, direction, "What is up in the picture.");
  f.together(camera.fov);
  f.key("aperture", camera.aperture, extent_or_zero,
        "Radius of the lens: what is not at the right distance blurs; 0 is a pinhole.");
  f.key("focus", camera.focus, extent,
        "Distance from the eye, along the view, of what is sharp; left out, that of look_at.");
  std::array<double, 2> shutter{camera.shutter_open, camera.shutter_close};
  f.key("shutter", shutter, open_and_close, "When the shutter opens and closes, in the time of what moves.");
  camera.shutter_open = shutter[0];
  camera.shutter_close = shutter[1];
  f.check("shutter", camera.shutter_open <= camera.shutter_close,
          "the shutter closes before it opens (expected [open, close] with open at most close)",
          "[0, 0.5] is open from the time 0 to the time 0.5; equal times freeze all motion");
}

template <class Fields>
void describe(Fields& f, Screen& screen) {
  f.about("SCREEN of the plan: a segment across the view.");
  f.key("distance", screen.distance, extent, "From the eye to SCREEN, along the view.");
  f.key("width", screen.width, extent,
        "Length of SCREEN: what the whole width of the picture sees there. Either this or `fov` of [camera].");
  f.key("cells", screen.cells, cell_count, "Pixels of SCREEN.");
}

/// The members of a scene in [image].
struct ImageTable {
  ImageSize size;
  Encoding encoding = Scene{}.encoding;
};

template <class Fields>
void describe(Fields& f, ImageTable& image) {
  f.about("The picture.");
  f.key("width", image.size.width, pixel_count,
        "An odd multiple of the screen's cells makes each cell a pixel of the picture too.");
  f.key("height", image.size.height, pixel_count, "An odd one has a middle row.");
  f.key("encoding", image.encoding, encodings,
        "Of 8-bit pictures: the sRGB curve, or no curve and cut off instead of rounded, as course scenes want it.");
}

template <class Fields>
void describe(Fields& f, TraceLimits& limits) {
  f.about("Where recursion ends.");
  f.key("depth", limits.depth, depth_count, "The deepest call of SHADE; the primary ray's has depth 1.");
  f.key("threshold", limits.threshold, not_negative,
        "A ray that would add less than this share to its pixel is not formed.");
}

template <class Fields>
void describe(Fields& f, PhotonChoices& photons) {
  f.about("Of the photons integrator: light is sent from the lights, and found where it arrived.");
  f.key("count", photons.count, photon_count, "Photons that are sent.");
  f.key("nearest", photons.nearest, nearest_count,
        "k: the light at a point is that of the photons in the circle that reaches to the k-th nearest.");
  f.key("radius", photons.radius, extent, "Of the largest circle; left out, a twentieth of the scene.");
  f.key("gather", photons.gather, yes_or_no,
        "Indirect light is looked for by one more ray, and taken from the photons only where that ends.");
  f.key("progressive", photons.progressive, yes_or_no,
        "Every sample sends photons of its own, and has smaller circles than the sample before it.");
}

template <class Fields>
void describe(Fields& f, RadiosityChoices& radiosity) {
  f.about("Of the radiosity integrator: surfaces are cut into patches, which shoot their light at each other.");
  f.key("patch", radiosity.patch, extent, "No side of a patch is longer; left out, a twelfth of the scene.");
  f.key("tolerance", radiosity.tolerance, not_negative, "This share of the first light may stay unshot.");
  f.key("shots", radiosity.shots, shot_count, "After as many shots it ends in any case.");
  f.key("as_ambient", radiosity.as_ambient, yes_or_no,
        "Of whitted and distributed: light between surfaces, by patches, in place of ka times the ambient light.");
}

template <class Fields>
void describe(Fields& f, RenderChoices& render) {
  f.about("How the picture is made; what `raywalk render` is told comes before it.");
  f.key("integrator", render.integrator, integrators, integrator_sentence());
  f.key("samples", render.samples, sample_count, "Samples of each pixel; one lies in its middle.");
  f.key("sampler", render.sampler, samplers, "Where samples fall.");
  f.key("light_grid", render.light_grid, light_grid_count,
        "For the samples of every light with an extent; left out, each has its own.");
  f.key("tolerance", render.tolerance, not_negative,
        "A pixel that is known this well takes no more samples; 0: all samples.");
  f.key("path_length", render.path_length, path_length_count,
        "Of the path integrator: most rays between the eye and a light; left out, no limit.");
  f.key("subsurface", render.subsurface, subsurfaces,
        "Of the path integrator, inside of what scatters light: a walk, or the dipole of Jensen et al. (2001).");
  f.key("photons", render.photons, table);
  f.key("radiosity", render.radiosity, table);
  f.key("numerics", render.numerics, numerics,
        "How crossings are computed: with error bounds, or as books print them, to see where they fail.");
  f.key("epsilon", render.epsilon, extent_or_zero, "Of naive numerics: how far from a surface rays start.");
}

// --- Lights

template <class Fields>
void attenuation(Fields& f, Attenuation& terms) {
  f.key("attenuation", terms, attenuation_terms,
        "At distance r the light is weakened to 1 / (constant + linear r + quadratic r^2).");
  f.check("attenuation", terms != Attenuation{0, 0, 0},
          "all three terms are 0, which makes the light infinite (expected at least one above 0)",
          "[1, 0, 0] is a light that does not weaken with distance");
}

template <class Fields>
void light_samples(Fields& f, int& samples) {
  f.key("samples", samples, light_grid_count, "N: from every hit N x N of the light's points are tried.");
}

template <class Fields>
void describe(Fields& f, PointLight& light) {
  f.about("All light leaves one point.");
  f.required("position", light.position, point, "Where it stands.");
  attenuation(f, light.attenuation);
}

template <class Fields>
void describe(Fields& f, DirectionalLight& light) {
  f.about("A light infinitely far away.");
  f.required("direction", light.direction, direction, "Towards the light; its length does not matter.");
}

template <class Fields>
void describe(Fields& f, SpotLight& light) {
  f.about("A point that shines into a cone only.");
  f.required("position", light.position, point, "The tip of the cone.");
  f.required("look_at", light.look_at, point, "A point in the middle of its light.");
  f.check("look_at", length(light.look_at - light.position) >= 1 / max_magnitude,
          "the spot looks at its own position (expected another point)",
          "look_at is a point in the middle of its light");
  f.key("angle", light.angle, cone_angle, "Across the whole cone.");
  f.key("inner_angle", light.inner_angle, inner_cone_angle,
        "Across what is lit in full; from there to `angle` the light fades.");
  f.check("inner_angle", light.inner_angle <= light.angle,
          "the inner angle is wider than the angle (expected at most the angle)",
          "give both when you make the cone narrower than 40 degrees");
  attenuation(f, light.attenuation);
}

template <class Fields>
void describe(Fields& f, SphereLight& light) {
  f.about("A light with an extent, so that shadows have soft edges. It is not seen itself.");
  f.required("position", light.position, point, "Its centre.");
  f.required("radius", light.radius, extent_or_zero, "0 makes it a point.");
  light_samples(f, light.samples);
  attenuation(f, light.attenuation);
}

template <class Fields>
void describe(Fields& f, RectangleLight& light) {
  f.about("A flat light with an extent, which shines to both sides. It is not seen itself.");
  f.required("corner", light.corner, point, "One of its corners.");
  f.required("u", light.u, point, "The edge that leads from the corner to the next one.");
  f.required("v", light.v, point, "The other edge at the corner.");
  light_samples(f, light.samples);
  attenuation(f, light.attenuation);
}

template <class Fields>
void describe(Fields& f, Light& light) {
  f.about("A light; as many as you like.");
  f.required("name", light.name, own_name, "Every light, object and group needs a name of its own.");
  f.type(light.kind, "What kind of light it is, which says what further keys it has.");
  f.key("strength", light.strength, light_colour, "Colour and brightness.");
}

// --- Shapes

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
  f.key("holes", polygon.holes, holes, "Each a list of corners in the same plane.");
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
  f.about("A group of objects once more.");
  f.required("group", instance, group_name, "The name of a [[group]] that stands above.");
}

// --- Materials

template <class Fields>
void describe(Fields& f, Checker& checker) {
  f.about("Squares in two colours, which multiply ambient and diffuse.");
  f.key("even", checker.even, share, "The colour of every second square.");
  f.key("odd", checker.odd, share, "The colour of those between.");
  f.key("size", checker.size, extent, "Edge of a square.");
  f.key("filter", checker.filter, checker_filters,
        "Whether far squares are seen by their mean over the ray's footprint (closed), so that they do not flicker.");
}

template <class Fields>
void describe(Fields& f, ImageTexture& texture) {
  f.about("An image laid over the surface and repeated, instead of or on top of the checker.");
  f.required("file", texture.file, file_name,
             "A PNG or JPEG, looked for from the folder of the scene; it multiplies ambient and diffuse.");
  f.key("width", texture.width, extent, "How wide one copy is on the surface.");
  f.key("height", texture.height, extent, "How high one copy is on the surface.");
  f.key("filter", texture.filter, texture_filters,
        "Whether far copies are seen blurred, as wide as the ray's footprint is long (trilinear) or by its ellipse "
        "(ewa).");
}

template <class Fields>
void map_size(Fields& f, MapImage& image) {
  f.key("width", image.width, extent, "How wide one copy is on the surface.");
  f.key("height", image.height, extent, "How high one copy is on the surface.");
}

template <class Fields>
void describe(Fields& f, ParameterMap& map) {
  f.about(
      "An image that multiplies one of the parameters. It is seen by the point that a ray meets, and repeated like the "
      "texture.");
  f.required("of", map.of, mapped_parameters, "Which parameter.");
  f.required("file", map.file, map_file_name,
             "A .png, .jpg, .pfm, .exr or .hdr, looked for from the folder of the scene. For colours, its bytes are "
             "decoded from sRGB; for numbers, they are the numbers from 0 to 1.");
  map_size(f, map);
  f.key("channel", map.channel, map_channels, "Where the image holds a number; of a colour all three count.");
}

template <class Fields>
void describe(Fields& f, NormalMap& map) {
  f.about(
      "An image of normals as glTF has it: red is along the surface to the right, green upward, blue outward, each "
      "from "
      "-1 to 1. Light is shaded by them; the shape stays as it is.");
  f.required("file", map.file, map_file_name, "Like that of a map of numbers.");
  map_size(f, map);
  f.key("strength", map.strength, not_negative, "How much they lean: a factor of red and green.");
}

template <class Fields>
void describe(Fields& f, BumpMap& map) {
  f.about("An image of heights, of which only the normals are seen (Blinn); the shape stays as it is.");
  f.required("file", map.file, map_file_name, "Like that of a map of numbers.");
  map_size(f, map);
  f.key("relief", map.relief, coordinate_along_normal, "How far white lies above black; below 0, under it.");
  f.key("channel", map.channel, map_channels, "Where the image holds the height.");
}

template <class Fields>
void describe(Fields& f, SecondMaterial& second) {
  f.about("What there is where the mask is 1. All other keys are those of the first material for both.");
  f.key("ambient", second.ambient, share, "As of the first material.");
  f.key("diffuse", second.diffuse, share, "As of the first material.");
  f.key("diffuse_roughness", second.diffuse_roughness, diffuse_roughness, "As of the first material.");
  f.key("specular", second.specular, share, "As of the first material.");
  f.key("shininess", second.shininess, not_negative, "As of the first material.");
  f.key("reflection", second.reflection, share, "As of the first material.");
  f.key("roughness", second.roughness, roughness, "As of the first material.");
  f.key("emission", second.emission, light_colour, "As of the first material.");
  f.key("map", second.maps, tables);
}

template <class Fields>
void describe(Fields& f, Mask& mask) {
  f.about(
      "How much of a second material there is at each point, from 0 to 1; all parameters are interpolated between the "
      "two.");
  f.key("file", mask.file, map_file_name, "Like that of a map of numbers. Either this or `squares`.");
  map_size(f, mask);
  f.key("channel", mask.channel, map_channels, "Where the image holds the share of the second material.");
  f.key("squares", mask.squares, extent, "Edge of the squares of a checker, every second of which has the second one.");
  f.check("file", mask.file.empty() == mask.squares.has_value(),
          mask.squares ? "a mask has either a file or squares (expected one of them)"
                       : "a mask without a file or squares (expected one of them)",
          "file = \"rust.png\" is an image, squares = 0.5 a checker");
  f.key("second", mask.second, table);
}

template <class Fields>
void describe(Fields& f, Material& material) {
  f.about("How a surface answers light.");
  f.key("ambient", material.ambient, share, "ka: share of the ambient light that is sent back.");
  f.key("diffuse", material.diffuse, share, "kd: share of a light that is sent out evenly in all directions.");
  f.key("diffuse_roughness", material.diffuse_roughness, diffuse_roughness,
        "How rough the matt part is (Oren and Nayar): the rougher, the more light goes back to where it came from.");
  f.key("specular", material.specular, share, "ks: strength of the highlight.");
  f.key("shininess", material.shininess, not_negative, "s: the higher, the smaller the highlight.");
  f.key("reflection", material.reflection, share, "kr: share of what the mirror ray brings.");
  f.key("transmission", material.transmission, share, "kt: share of what the refracted ray brings.");
  f.key("ior", material.ior, above_zero, "Index of refraction inside: 1.33 water, 1.5 glass, 2.4 diamond.");
  f.key("dielectric", material.dielectric, yes_or_no,
        "Whether kr + kt is split between the two rays as in real glass (Fresnel's equations).");
  f.key("gloss", material.gloss, lobe_angle, "Half the angle of the cone that a rough mirror gathers; 0 is sharp.");
  f.key("translucency", material.translucency, lobe_angle, "The same for what shines through.");
  f.key("mirror", material.mirror, mirror_kinds,
        "What reflects: an ideal mirror, or a metal, whose reflectance at each angle multiplies kr (Fresnel's "
        "equations).");
  f.check("mirror", material.mirror == MirrorKind::ideal || !material.transmits(),
          "a metal does not go with transmission (expected \"ideal\")", "metals let no light through");
  f.key("roughness", material.roughness, roughness,
        "alpha: how steep the small facets are that a rough mirror or glass consists of (GGX); 0 is smooth.");
  f.check("roughness", material.roughness == 0 || !material.transmits() || material.dielectric,
          "roughness goes with transmission only where dielectric = true (expected 0)",
          "the facets of rough glass split light as real glass does; for kr and kt there are gloss and translucency");
  f.check("roughness", material.roughness == 0 || material.gloss == 0, "roughness does not go with gloss (expected 0)",
          "both say how a rough mirror spreads light: choose one");
  f.check("roughness", material.roughness == 0 || material.translucency == 0,
          "roughness does not go with translucency (expected 0)", "both say how rough glass spreads light: choose one");
  f.key("absorption", material.absorption, light_colour,
        "Of the light inside, exp(-absorption) is left after each unit of length.");
  f.key("scattering", material.scattering, light_colour,
        "Inside, paths go straight for a unit of length with probability exp(-scattering), then scatter.");
  f.key("anisotropy", material.anisotropy, mean_cosine,
        "g: where light goes that is scattered inside: on (towards 1), back (towards -1), anywhere (0).");
  f.key("priority", material.priority, any_number,
        "Where transparent bodies overlap, the one with the highest counts, and of equal ones that which light entered "
        "last.");
  f.key("shadow", material.shadow, shadow_kinds, "Whether lights shine through, weakened by transmission (filtered).");
  f.key("normal", material.normal, shading_normals,
        "Whether lights shine on the side that is seen, or on the front only (fixed).");
  f.check("normal", material.normal == ShadingNormal::facing || !material.transmits(),
          "a fixed normal does not go with transmission (expected \"facing\")",
          "light is refracted at the side that it comes from");
  f.key("emission", material.emission, light_colour, "Light that the surface gives off by itself.");
  f.key("checker", material.checker, table);
  f.key("texture", material.texture, table);
  f.key("normal_map", material.normal_map, table);
  f.key("bump_map", material.bump_map, table);
  f.check("normal_map", material.normal == ShadingNormal::facing || !material.normal_map,
          "a normal map does not go with a fixed normal (expected normal = \"facing\")",
          "a fixed normal is used as it is given");
  f.check("bump_map", material.normal == ShadingNormal::facing || !material.bump_map,
          "a bump map does not go with a fixed normal (expected normal = \"facing\")",
          "a fixed normal is used as it is given");
  f.key("mask", material.mask, table);
  f.key("map", material.maps, tables);
  f.check(
      material.maps.empty() ? "mask" : "map", [&] { return why_not_mapped(material); },
      "a map multiplies a parameter; a mask mixes two materials in all that the second one has keys for");
}

// --- The sky

template <class Fields>
void describe(Fields& f, GradientSky& sky) {
  f.about("A sky that fades from the horizon to the zenith.");
  f.key("horizon", sky.horizon, light_colour, "Its colour and brightness at the horizon.");
  f.key("zenith", sky.zenith, light_colour, "Its colour and brightness straight up.");
  f.check("zenith", !is_black(sky.horizon) || !is_black(sky.zenith), "the sky is wholly black (expected some light)",
          "for a scene without a sky, leave [sky] out");
}

template <class Fields>
void describe(Fields& f, OvercastSky& sky) {
  f.about("A sky covered with clouds, three times as bright overhead as at the horizon (CIE).");
  f.key("zenith", sky.zenith, light_colour, "Its colour and brightness straight up.");
  f.check("zenith", !is_black(sky.zenith), "the sky is wholly black (expected some light)",
          "for a scene without a sky, leave [sky] out");
}

template <class Fields>
void describe(Fields& f, ClearSky& sky) {
  f.about("A sky without clouds (Hosek and Wilkie 2012). The sun itself is a light: a directional one, say.");
  f.key("elevation", sky.elevation, sun_elevation, "How high the sun stands; it is in the middle of the sky.");
  f.key("turbidity", sky.turbidity, turbidity, "How hazy the air is: 2 is very clear, 6 hazy.");
  f.key("albedo", sky.albedo, albedo, "The share of light that the ground sends back into the air.");
  f.key("strength", sky.strength, light_colour, "Multiplies all of it; 1 is in units of 683 candela a square metre.");
  f.check("strength", !is_black(sky.strength), "the sky is wholly black (expected some light)",
          "for a scene without a sky, leave [sky] out");
}

template <class Fields>
void describe(Fields& f, ImageSky& sky) {
  f.about("A picture of all directions: its columns are longitudes, its rows latitudes, the zenith at the top.");
  f.required("file", sky.file, sky_file_name,
             "A .hdr, .exr, .pfm or .png, twice as wide as high, looked for from the folder of the scene.");
  f.key("strength", sky.strength, light_colour, "Multiplies all of it.");
  f.check("strength", !is_black(sky.strength), "the sky is wholly black (expected some light)",
          "for a scene without a sky, leave [sky] out");
}

template <class Fields>
void describe(Fields& f, Sky& sky) {
  f.about(
      "What rays meet that leave the scene, by their direction; paths are lit by it. Below its horizon they meet the "
      "background, unless it is an image.");
  f.type(sky.kind, "What kind of sky it is, which says what further keys it has.");
  f.key("up", sky.up, direction, "Towards the zenith; [0, 1] stands the sky up in the plan.");
  f.key("rotation", sky.rotation, azimuth,
        "Where the middle of the sky is (of an image its middle, else the sun): 0 is along x, 90 to the left of it.");
}

// --- The scene

template <class Fields>
void describe(Fields& f, Object& object) {
  f.about("What rays meet; as many as you like.");
  f.required("name", object.name, own_name, "Every light, object and group needs a name of its own.");
  f.type(object.shape, "What shape it has, which says what further keys it has.");
  f.key("transform", object.transform, transform_steps,
        "How it is moved, turned and stretched; the first step is done first.");
  f.key("motion", object.motion, motion_keys,
        "Where it is at a time, seen from where it stands; it moves straight from key to key.");
  f.key("material", object.material, table);
  f.check("material", !std::holds_alternative<Instance>(object.shape) || object.material == Material{},
          "an instance has the materials of the objects in its group (expected none of its own)",
          "give the material to the objects of [[group]]");
  f.check(
      "material", [&] { return why_no_walk_inside(object); },
      "light is scattered inside of what transmits: leave scattering out, or take a closed, bounded shape");
}

template <class Fields>
void describe(Fields& f, Group& group) {
  f.about("Objects that instances put into the scene, as often as you like; it is not seen by itself.");
  f.required("name", group.name, own_name, "What instances call it.");
  f.key("object", group.objects, tables);
  f.complete(group);
}

template <class Fields>
void describe(Fields& f, Scene& scene) {
  f.about("What stands at the top of the file.");
  f.key("title", scene.title, text, "What the scene is called.");
  f.key("description", scene.description, text, "One line about what there is to see.");
  f.key("translated", scene.translated, names,
        "Names that are shown in the language of the window, by [name] of its texts; others are shown as they are.");
  f.key("background", scene.background, light_colour, "What a ray brings back that hits nothing.");
  f.key("sky", scene.sky, table);
  f.key("ambient", scene.ambient, light_colour, "Light from everywhere, multiplied by each material's ambient.");
  f.required("camera", scene.camera, table);
  f.key("screen", scene.camera.screen, table);
  ImageTable image{scene.image, scene.encoding};
  f.key("image", image, table);
  scene.image = image.size;
  scene.encoding = image.encoding;
  f.key("limits", scene.limits, table);
  f.key("render", scene.render, table);
  f.key("group", scene.groups, tables);
  f.key("light", scene.lights, tables);
  f.key("object", scene.objects, tables);
}

// --- Ink

template <class Fields>
void describe(Fields& f, PenStroke& stroke) {
  f.about("A line by hand.");
  f.required("points", stroke.points, pen_points, "What the pen went through.");
}

template <class Fields>
void describe(Fields& f, InkArrow& arrow) {
  f.about("A straight arrow.");
  f.required("from", arrow.from, place, "Where it begins.");
  f.required("to", arrow.to, place, "Its tip.");
}

template <class Fields>
void describe(Fields& f, InkText& note) {
  f.about("A few words.");
  f.required("at", note.at, place, "Where they begin.");
  f.required("text", note.text, ink_text, "What they say.");
}

template <class Fields>
void describe(Fields& f, Ruler& ruler) {
  f.about("A line that says its length.");
  f.required("from", ruler.from, place, "One of its ends.");
  f.required("to", ruler.to, place, "The other end.");
}

template <class Fields>
void describe(Fields& f, Protractor& protractor) {
  f.about("Two arms that say the angle between them.");
  f.required("vertex", protractor.vertex, place, "Where the arms meet.");
  f.required("from", protractor.from, place, "The end of one arm.");
  f.required("to", protractor.to, place, "The end of the other arm.");
}

template <class Fields>
void describe(Fields& f, InkMark& mark) {
  f.about(
      "What is drawn over the plan with Ink; as much as you like. It is no part of the scene, and no ray meets it.");
  f.type(mark.shape, "What kind of mark it is, which says what further keys it has.");
  f.key("colour", mark.colour, ink_colours, "Plain is dark on a light plan and light on a dark one.");
}

/// All that a file holds.
struct SceneFile {
  Scene scene;
  Ink ink;
  friend bool operator==(const SceneFile&, const SceneFile&) = default;
};

template <class Fields>
void describe(Fields& f, SceneFile& file) {
  describe(f, file.scene);
  f.key("ink", file.ink, tables);
}

}  // namespace raywalk::schema
