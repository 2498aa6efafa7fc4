#pragma once
// The numerical microscope: one hit of a recording, to the last digit. Robust and naive numerics are both run on it, as
// in a trace; TrueSurfaces gives their distance from the truth.

#include "inspect/true_surfaces.h"
#include "timeline/timeline.h"
#include "trace/kernel.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// The fate of the rays of one kind that are spawned at the hit.
struct SpawnedRays {
  RayKind kind = RayKind::shadow;
  int count = 0;
  int hit_own = 0;                    ///< immediately hit the surface that they leave
  int astray = 0;                     ///< hit the wrong object, or wrongly miss
  Vec3d origin{0.0}, direction{0.0};  ///< of the first one
};

/// The origin of rays spawned at the hit, on one side of the surface.
struct SpawnPoint {
  Vec3d place{0.0};
  std::optional<double> off{};  ///< how far from the true surface, scene units: above 0 outside
  bool outwards = true;         ///< the side that the rays go to
  /// Whether it is on that side, or on the surface.
  [[nodiscard]] bool right_side() const { return !off || (outwards ? *off >= 0 : *off <= 0); }
};

/// The hit in one kind of numerics.
struct Reading {
  double t = 0;
  int object = -1;                  ///< index in Scene::objects
  Vec3d point{0.0};                 ///< as computed
  std::optional<double> t_error{};  ///< t minus the true t, in ulps of t; none if the ray truly misses the surface
  std::optional<double> off{};      ///< how far the point is from the true surface, scene units: above 0 outside
  std::vector<SpawnPoint> starts;   ///< on the side that the ray came from, then on the other
  std::vector<SpawnedRays> spawned;
};

/// A ray, its hit, and the rays spawned there.
struct Specimen {
  int ray = -1;  ///< index in Timeline::rays()
  RayKind kind = RayKind::primary;
  Precision precision = Precision::double_;
  Vec3d origin{0.0}, direction{0.0};         ///< of the ray
  std::optional<Reading> robust{}, naive{};  ///< none for a miss
  Vec3d focus{0.0};                          ///< the robust point, or else the naive one
  Vec3d normal{0.0};                         ///< unit length, outwards
  DrawnAxes axes{0, 1};                      ///< which show surface and ray best; x and y in planar scenes
  Vec3d spacing{0.0};               ///< by axis: from the focus to the next number of the precision, away from 0
  double ulp = 0;                   ///< the larger of the two drawn
  Vec3d on_ray{0.0};                ///< a point of the ray, exact, relative to the focus
  std::optional<Vec3d> crossing{};  ///< the true intersection, relative to the focus
  /// Half widths of a box about the robust point that contains the true intersection: the rounding errors of the
  /// product and the sum in origin + t direction, the error of t, and how far the point was then moved onto the
  /// surface. (A running error analysis: N. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, 3.3.)
  Vec3d error_box{0.0};
  std::shared_ptr<const TrueSurfaces> surfaces;
  // Of a primary ray that meets nothing, and passes a sphere; the focus is then the point of the sphere next to it.
  int passed = -1;  ///< index in Scene::objects
  double gap = 0;   ///< between ray and sphere, scene units

  /// Index in Scene::objects of what is met or passed.
  [[nodiscard]] int object() const { return robust ? robust->object : naive ? naive->object : passed; }
  /// A distance in ulps of the drawn axes.
  [[nodiscard]] double in_ulps(double way) const { return way / ulp; }
};

/// From |x| to the next larger number of a precision.
[[nodiscard]] double spacing_at(double x, Precision precision);

/// The numbers of a precision within `reach` of `x`, minus x, ascending; empty if there are more than `most`.
[[nodiscard]] std::vector<double> numbers_about(double x, double reach, Precision precision, std::size_t most);

/// Caches what it prepared for the most recent recording.
class Microscope {
 public:
  /// The current hit at a position: of the ray of the line just run or, if that ray misses, of the ray at whose hit it
  /// was formed. Without one, the sphere that the ray passes closest; none if it passes none. `scene`: the recorded
  /// one, as long as `timeline` is the same.
  [[nodiscard]] std::shared_ptr<const Specimen> look(const std::shared_ptr<const Timeline>& timeline, int position,
                                                     const Scene& scene, Precision precision);

 private:
  template <class T>
  struct PreparedScene;
  std::shared_ptr<const Timeline> timeline_;
  std::variant<std::shared_ptr<PreparedScene<float>>, std::shared_ptr<PreparedScene<double>>> prepared_;
  std::vector<std::shared_ptr<const Specimen>> specimens_;  ///< by ray, filled on demand
  std::vector<bool> looked_at_;
};

}  // namespace raywalk
