#pragma once
// The keys of materials, with their patterns, maps and masks: see scene/schema.h.

#include "scene/schema_kinds.h"

namespace raywalk::schema {

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
void image_wrap(Fields& f, ImageWrap& wrap) {
  f.key("wrap", wrap, image_wraps,
        "How it goes on around its first copy, which begins at a plane's point, or at the first corner of a shape: by "
        "further copies, by the pixels of its edge (clamp), or by copies each of which is the mirror image of its "
        "neighbours.");
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
  image_wrap(f, texture.wrap);
}

template <class Fields>
void map_size(Fields& f, MapImage& image) {
  f.key("width", image.width, extent, "How wide one copy is on the surface.");
  f.key("height", image.height, extent, "How high one copy is on the surface.");
  image_wrap(f, image.wrap);
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
        "Whether lights shine on the side that is seen, or on the front only (fixed); paths, photons and radiosity do "
        "not "
        "ask.");
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

}  // namespace raywalk::schema
