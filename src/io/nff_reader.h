#pragma once
// The Neutral File Format: E. Haines, "A proposal for standard graphics environments", IEEE Computer Graphics and
// Applications 7(11), 1987, in version 3.9 of its text.
//
// What the format leaves to the renderer is defined here:
// - Each of n lights has the strength sqrt(n) / (2n) times its colour, and so has the ambient light; without a light
//   the ambient light is 1. Lights do not fade with distance.
// - The colour weighs the diffuse part (with Kd), the ambient one (as the diffuse) and what is transmitted (with T).
//   Highlights and mirror images (Ks) stay white.
// - A material with T > 0 and Ks = 0 shares T between reflection and refraction by Fresnel's equations, so that every
//   transmitter reflects, as the format's known ray counts have it.
// - Everything is two-sided; the sign of a radius is ignored. `hither` is not used.
// - `angle` is that of the picture's height, between its outer edges. With a ray in each corner of the pixels
//   (--corner-samples) that is the angle between the outermost rays, as in the counts.
// - The depth limit is 5, as in the counts, and no ray is dropped for its weight.

#include "io/scene_file.h"

namespace raywalk {

/// `file_name` is for messages, and names the scene.
[[nodiscard]] Result<SceneDocument> parse_nff(std::string_view text, const std::string& file_name);

}  // namespace raywalk
