#pragma once
// A scene in the language of POV-Ray 3.7, so that others can render the same scene, or compare speeds.
//
// POV-Ray's (x, y, z) is our (x, z, y): its axes are left-handed, ours right-handed, and in both the third points away
// from the plan. Colours, positions, rays and Blinn's highlight (`specular` with `roughness` 1 / s) carry over exactly,
// and so do the attenuation of lights as far as POV-Ray has it, spots (a smooth step in the cosine), area lights of n x
// n samples, Fresnel's weights and absorption.
//
// What does not: gloss and translucency, fixed normals, patterns on curved surfaces, image textures, filters, motion,
// light that is scattered inside; those that a scene uses are reported. Under total internal reflection POV-Ray
// reflects a few percent more than our kr + kt.

#include "scene/scene.h"

#include <string>
#include <vector>

namespace raywalk {

struct PovText {
  std::string text;
  /// What is missing or inexact in the text: one clause each, without duplicates.
  std::vector<std::string> left_out;
};

[[nodiscard]] PovText format_pov(const Scene& scene);

}  // namespace raywalk
