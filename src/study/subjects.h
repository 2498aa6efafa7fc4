#pragma once
// Pictures whose every pixel is known in closed form. All are seen from (0, 0, 2) looking down, and show the floor's
// square from -1 to 1.

#include "study/reference.h"
#include "study/shot.h"

#include <string>

namespace raywalk::study {

struct Subject {
  std::string name;
  Scene scene;
  std::function<double(const Rectangle& pixel)> truth;  ///< mean over a pixel's square of the floor z = 0
  bool only_edges = false;                              ///< only pixels that are neither 0 nor 1 count
};

/// A floor under a point light: over a pixel, light and cosine change smoothly.
[[nodiscard]] Subject smooth_subject();
/// A glowing disk: its edge crosses pixels at all slopes.
[[nodiscard]] Subject edge_subject();
/// The straight edge of an emitter, nearer than the plane of focus.
[[nodiscard]] Subject lens_subject();

/// Inside a glowing ball that reflects, as a mirror or diffusely: furnace() of study/reference.h says what is seen.
[[nodiscard]] Scene glowing_room(double albedo, bool mirror, int round);

/// A pixel's square in a picture `edge` pixels wide.
[[nodiscard]] Rectangle pixel_at(int column, int row, int edge);

/// Calls visit(shown, truth) for each pixel that counts.
void for_each_pixel(const Subject& subject, const Film<double>& film,
                    const std::function<void(double shown, double truth)>& visit);

}  // namespace raywalk::study
