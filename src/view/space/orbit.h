#pragma once
// Interactive cameras: orbit, pan, zoom; and the projection of points into a pane. Pure functions, independent of
// windows.

#include "scene/scene.h"
#include "view/drawing/display_list.h"
#include "view/state.h"

#include <array>
#include <optional>
#include <vector>

namespace raywalk {

/// The box around everything finite in a scene, with lights and EYE; never empty or flat.
[[nodiscard]] Bounds<double> room_of(const Scene& scene);

/// The pivot of a camera: on its axis, beside the middle of the scene. Ahead of the eye.
[[nodiscard]] Vec3d pivot_of(const Scene& scene, const Camera& camera);

/// Turned about `pivot`, which it then looks at: by `angles.x` radians about `up`, so that the view moves to the right,
/// and by `angles.y` so that the view moves down and the eye rises. The eye keeps its distance and never gets exactly
/// above or below. With angles 0 it is unchanged, bit for bit.
[[nodiscard]] Camera orbited(const Camera& camera, const Vec3d& pivot, const Vec2d& angles);

/// Shifted so that `pivot` moves by this fraction of the image width, to the right and down.
[[nodiscard]] Camera shifted(const Camera& camera, const Vec3d& pivot, const Vec2d& parts);

/// The eye at 1/factor of its distance from `pivot`, which it then looks at; factor > 0.
[[nodiscard]] Camera approached(const Camera& camera, const Vec3d& pivot, double factor);

/// A camera that sees the whole scene, with EYE and the lights, from above and beside the scene's own.
[[nodiscard]] Camera overlooking(const Scene& scene, const Viewport& viewport);
/// The same for cached points, which need a pass over all objects.
[[nodiscard]] Camera overlooking(const Scene& scene, const Viewport& viewport, const std::vector<Vec3d>& points);
/// The points to be shown at first: the corners of everything finite (of very many things the outermost ones), EYE, and
/// lights that are not far away.
[[nodiscard]] std::vector<Vec3d> seen_at_first(const Scene& scene);

/// A camera's projection into a pane. The smaller side of the pane spans the camera's angle.
class Projection {
 public:
  Projection(const Camera& camera, const Viewport& viewport);

  /// Pixels; none for a point that is not ahead of the eye.
  [[nodiscard]] std::optional<Vec2d> point(const Vec3d& p) const;
  /// The part of a segment that is ahead of the eye, in pixels.
  [[nodiscard]] std::optional<std::array<Vec2d, 2>> segment(const Vec3d& from, const Vec3d& to) const;
  /// The direction in the pane in which to turn towards a point that is out of sight, of unit length.
  [[nodiscard]] Vec2d towards(const Vec3d& p) const;
  /// Pixels per unit of length at this point.
  [[nodiscard]] double pixels_per_unit(const Vec3d& at) const;

 private:
  [[nodiscard]] Vec3d seen(const Vec3d& p) const;  ///< across, up, ahead
  [[nodiscard]] Vec2d flat(const Vec3d& seen) const;

  Vec3d eye_, right_, up_, forward_;
  Vec2d centre_;
  double scale_, nearest_;
};

}  // namespace raywalk
