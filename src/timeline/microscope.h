#pragma once
// The numerical microscope: one hit of a recording, looked at to the last digit of its numbers. What robust and what
// naive numerics make of it their own searches say, as in a trace; how far that is from the truth, TrueSurfaces.

#include "timeline/timeline.h"
#include "timeline/true_surfaces.h"
#include "trace/kernel.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// What becomes of the rays of one kind that leave from the hit.
struct LeavingRays {
  RayKind kind = RayKind::shadow;
  int count = 0;
  int hit_own = 0;                    ///< meet at once the surface that they leave
  int astray = 0;                     ///< meet something else than what is truly there, or nothing where something is
  Vec3d origin{0.0}, direction{0.0};  ///< of the first of them
};

/// Where rays start that leave from the hit, on one side of the surface.
struct Start {
  Vec3d place{0.0};
  std::optional<double> off{};  ///< how far from the true surface, scene units: above 0 outside
  bool outwards = true;         ///< the way of the rays
  /// Whether it is on the side that the rays go to, or on the surface.
  [[nodiscard]] bool right_side() const { return !off || (outwards ? *off >= 0 : *off <= 0); }
};

/// The hit as one kind of numerics has it.
struct Reading {
  double t = 0;
  int object = -1;                  ///< index in Scene::objects
  Vec3d point{0.0};                 ///< as computed
  std::optional<double> t_error{};  ///< t less the true one, in ulps of t; none where the ray truly misses the surface
  std::optional<double> off{};      ///< how far the point is from the true surface, scene units: above 0 outside
  std::vector<Start> starts;        ///< of rays that leave: on the side that the ray came from, then on the other
  std::vector<LeavingRays> leaving;
};

/// A ray, what it meets, and what starts there.
struct Specimen {
  int ray = -1;  ///< index in Timeline::rays()
  RayKind kind = RayKind::primary;
  Precision precision = Precision::double_;
  Vec3d origin{0.0}, direction{0.0};         ///< of the ray
  std::optional<Reading> robust{}, naive{};  ///< none where nothing is met
  Vec3d focus{0.0};                          ///< the robust point; the naive one where there is no other
  Vec3d normal{0.0};                         ///< unit length, outwards
  DrawnAxes axes{0, 1};                      ///< in which surface and ray are seen best; x and y in planar scenes
  Vec3d spacing{0.0};               ///< by axis: from the focus to the next number of the precision, away from 0
  double ulp = 0;                   ///< the larger of the two drawn
  Vec3d on_ray{0.0};                ///< a place of the ray, exactly, less the focus
  std::optional<Vec3d> crossing{};  ///< where the ray truly crosses the surface, less the focus
  /// Half widths of a box about the robust point that holds the true crossing: what the roundings of the product and of
  /// the sum in origin + t direction can do, what t's own error does, and how far the point was then pulled onto the
  /// surface. (A running error analysis: N. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, 3.3.)
  Vec3d error_box{0.0};
  std::shared_ptr<const TrueSurfaces> surfaces;

  /// A distance in ulps of the drawn axes.
  [[nodiscard]] double in_ulps(double way) const { return way / ulp; }
};

/// From |x| to the next larger number of a precision.
[[nodiscard]] double spacing_at(double x, Precision precision);

/// The numbers of a precision within `reach` of `x`, less x, ascending; empty where they are more than `most`.
[[nodiscard]] std::vector<double> numbers_about(double x, double reach, Precision precision, std::size_t most);

/// Keeps what it made ready for the recording that it looked at last.
class Microscope {
 public:
  /// The hit in hand at a position: of the ray of the line just run or, where that has met nothing yet and never does,
  /// of the ray at whose hit it was formed. None before anything is met. `scene`: as it was recorded, so long as
  /// `timeline` is the same.
  [[nodiscard]] std::shared_ptr<const Specimen> look(const std::shared_ptr<const Timeline>& timeline, int position,
                                                     const Scene& scene, Precision precision);

 private:
  template <class T>
  struct Bench;
  std::shared_ptr<const Timeline> timeline_;
  std::variant<std::shared_ptr<Bench<float>>, std::shared_ptr<Bench<double>>> bench_;
  std::vector<std::shared_ptr<const Specimen>> specimens_;  ///< by ray, as far as looked at
  std::vector<bool> looked_at_;
};

}  // namespace raywalk
