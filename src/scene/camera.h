#pragma once

#include "math/elementary.h"
#include "math/vec.h"
#include "math/words.h"

#include <numbers>
#include <optional>

namespace raywalk {

enum class FovAxis { x, y };
template <>
inline constexpr Word<FovAxis> words_of<FovAxis>[] = {{FovAxis::x, "x"}, {FovAxis::y, "y"}};

/// A full view angle.
struct FieldOfView {
  double degrees = 45;  ///< 0 < degrees < 180
  FovAxis axis = FovAxis::x;
  friend bool operator==(const FieldOfView&, const FieldOfView&) = default;
};

/// SCREEN: a segment across the view in the plan; its length is the image's width.
struct Screen {
  double distance = 1;          ///< from EYE along the view, > 0
  std::optional<double> width;  ///< length across the view, > 0; absent when the camera states an angle
  int cells = 21;               ///< pixels of the strip, >= 1
  friend bool operator==(const Screen&, const Screen&) = default;
};

/// EYE's position and view. Exactly one of `screen.width` and `fov` is present.
struct Camera {
  Vec3d eye{0.0};
  Vec3d look_at{1.0, 0.0, 0.0};  ///< differs from eye
  Vec3d up{0.0, 0.0, 1.0};       ///< not parallel to the view
  std::optional<FieldOfView> fov;
  Screen screen{.width = 1.0};
  double aperture = 0;          ///< radius of the lens, in scene units; 0: a pinhole
  std::optional<double> focus;  ///< distance from the eye, along the view, to the plane in focus; absent: look_at
  double shutter_open = 0, shutter_close = 1;  ///< in the time of the objects' motion; open <= close
  friend bool operator==(const Camera&, const Camera&) = default;

  [[nodiscard]] double focus_distance() const { return focus ? *focus : length(look_at - eye); }
  /// Half the extent of the image plane at distance 1 along the axis that `extent_axis` names.
  [[nodiscard]] double half_extent() const {
    if (!fov) return *screen.width / 2 / screen.distance;
    const auto [sin, cos] = portable::sin_cos(fov->degrees * (std::numbers::pi / 360));
    return sin / cos;
  }
  [[nodiscard]] FovAxis extent_axis() const { return fov ? fov->axis : FovAxis::x; }
  /// Length of SCREEN as drawn on the plan. With an angle along y, the strip is taken as one row of a square image.
  [[nodiscard]] double screen_width() const { return fov ? 2 * screen.distance * half_extent() : *screen.width; }
};

/// Whether eye and look_at differ, by more than what scene files can hold rounds away.
[[nodiscard]] inline bool looks_somewhere(const Camera& camera) { return length(camera.look_at - camera.eye) >= 1e-15; }
/// Whether `up` is no direction across the view: then nothing is up in the picture.
[[nodiscard]] inline bool looks_along_up(const Camera& camera) {
  constexpr double least_sine = 1e-9;
  return !(length(camera.up) > 0) ||
         length(cross(normalize(camera.look_at - camera.eye), normalize(camera.up))) < least_sine;
}

}  // namespace raywalk
