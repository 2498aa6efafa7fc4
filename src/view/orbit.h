#pragma once
// Cameras moved by hand: turned about a point, shifted, brought nearer; and where a camera puts points of space in a
// pane. All of it is arithmetic on values; nothing here knows of windows.

#include "scene/scene.h"
#include "view/display_list.h"
#include "view/state.h"

#include <array>
#include <optional>
#include <vector>

namespace raywalk {

/// The box around everything of a scene that has an end, lights and EYE included; never empty, never flat.
[[nodiscard]] Bounds<double> room_of(const Scene& scene);

/// The point that a camera is turned about: on its axis, beside the middle of what is to be seen. Ahead of the eye.
[[nodiscard]] Vec3d pivot_of(const Scene& scene, const Camera& camera);

/// Turned about `pivot`, which it then looks at: by `angles.x` radians about `up`, so that what is seen moves to the
/// right, and by `angles.y` so that what is seen moves down and the eye rises. The eye keeps its distance and never
/// comes to stand straight above or below. Turned by nothing it is the same, bit for bit.
[[nodiscard]] Camera orbited(const Camera& camera, const Vec3d& pivot, const Vec2d& angles);

/// Shifted across the view, so that `pivot` moves by this much in the image: parts of its width, to the right and down.
[[nodiscard]] Camera shifted(const Camera& camera, const Vec3d& pivot, const Vec2d& parts);

/// The eye at 1/factor of its distance from `pivot`, which it then looks at; factor > 0.
[[nodiscard]] Camera approached(const Camera& camera, const Vec3d& pivot, double factor);

/// A camera that sees the whole scene, EYE and the lights too, from above and beside the scene's own.
[[nodiscard]] Camera overlooking(const Scene& scene, const Viewport& viewport);
/// The same for whoever keeps the points that it is to see, which walking over all objects finds.
[[nodiscard]] Camera overlooking(const Scene& scene, const Viewport& viewport, const std::vector<Vec3d>& points);
/// What is to be seen at first: the corners of everything that has an end (of very many things the outermost ones),
/// EYE, and the lights that are not far away from them.
[[nodiscard]] std::vector<Vec3d> seen_at_first(const Scene& scene);

/// Where a camera puts points of space in a pane. The smaller side of the pane shows what the camera's angle spans.
class Projection {
 public:
  Projection(const Camera& camera, const Viewport& viewport);

  /// Pixels; none for a point that is not ahead of the eye.
  [[nodiscard]] std::optional<Vec2d> point(const Vec3d& p) const;
  /// The part of a segment that is ahead of the eye, in pixels.
  [[nodiscard]] std::optional<std::array<Vec2d, 2>> segment(const Vec3d& from, const Vec3d& to) const;
  /// Pixels that a length at this place spans.
  [[nodiscard]] double pixels_per_unit(const Vec3d& at) const;

 private:
  [[nodiscard]] Vec3d seen(const Vec3d& p) const;  ///< across, up, ahead
  [[nodiscard]] Vec2d flat(const Vec3d& seen) const;

  Vec3d eye_, right_, up_, forward_;
  Vec2d centre_;
  double scale_, nearest_;
};

}  // namespace raywalk
