#pragma once
// The keys of [camera], [screen], [image], [limits] and [render]: see scene/schema.h.

#include "scene/schema_kinds.h"

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

}  // namespace raywalk::schema
