#pragma once
// The keys of lights and of the sky: see scene/schema.h.

#include "scene/schema_kinds.h"

#include <algorithm>
#include <string_view>

namespace raywalk::schema {

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
        "Across what is lit in full; from there to `angle` the light fades. Left out, it is `angle` where that is "
        "below 40.");
  f.left_out("inner_angle", light.inner_angle, std::min(SpotLight{}.inner_angle, light.angle));
  f.check("inner_angle", light.inner_angle <= light.angle,
          "the inner angle is wider than the angle (expected at most the angle)", "make it narrower, or leave it out");
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

// --- The sky

template <class Fields>
void shines(Fields& f, std::string_view key, bool holds) {
  f.check(key, holds, "the sky is wholly black (expected some light)", "for a scene without a sky, leave [sky] out");
}

template <class Fields>
void describe(Fields& f, GradientSky& sky) {
  f.about("A sky that fades from the horizon to the zenith.");
  f.key("horizon", sky.horizon, light_colour, "Its colour and brightness at the horizon.");
  f.key("zenith", sky.zenith, light_colour,
        "Its colour and brightness straight up. Horizon and zenith are not both 0.");
  shines(f, "zenith", !is_black(sky.horizon) || !is_black(sky.zenith));
}

template <class Fields>
void describe(Fields& f, OvercastSky& sky) {
  f.about("A sky covered with clouds, three times as bright overhead as at the horizon (CIE).");
  f.key("zenith", sky.zenith, light_colour, "Its colour and brightness straight up; not 0.");
  shines(f, "zenith", !is_black(sky.zenith));
}

template <class Fields>
void describe(Fields& f, ClearSky& sky) {
  f.about("A sky without clouds (Hosek and Wilkie 2012). The sun itself is a light: a directional one, say.");
  f.key("elevation", sky.elevation, sun_elevation, "How high the sun stands; it is in the middle of the sky.");
  f.key("turbidity", sky.turbidity, turbidity, "How hazy the air is: 2 is very clear, 6 a moist day, 10 hazy.");
  f.key("albedo", sky.albedo, albedo, "The share of light that the ground sends back into the air.");
  f.key("strength", sky.strength, light_colour,
        "Multiplies all of it, and is not 0; 1 is in units of 683 candela a square metre.");
  shines(f, "strength", !is_black(sky.strength));
}

template <class Fields>
void describe(Fields& f, ImageSky& sky) {
  f.about("A picture of all directions: its columns are longitudes, its rows latitudes, the zenith at the top.");
  f.required(
      "file", sky.file, sky_file_name,
      "A .hdr, .exr, .pfm or .png, twice as wide as high, looked for from the folder of the scene. What a .hdr says "
      "that it was multiplied by (EXPOSURE) is divided out.");
  f.key("strength", sky.strength, light_colour, "Multiplies all of it, and is not 0.");
  shines(f, "strength", !is_black(sky.strength));
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

}  // namespace raywalk::schema
