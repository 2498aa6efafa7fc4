#pragma once
// What divides an outline of the plan beside what hides it: the lines of a checker on it, the rims of spot lights, and
// on a circle the edges of shadows (those of straight outlines are exact: UnfoldedPlan::shadow_edges), and where light
// comes to it at the critical angle. All are points of the outline, rounded.

#include "scene/lights/spot_light.h"
#include "trace/unfolded_plan.h"

#include <functional>
#include <optional>
#include <vector>

namespace raywalk {

/// A stretch of an outline, from one point to another by those between: two of a straight one, more of a circle, less
/// than half of it apart.
using OutlineStretch = std::vector<Vec2d>;

/// Where a checker's lines cross a stretch. `uv`: on the surface, at a point of it. None where the squares are more
/// than `most`.
[[nodiscard]] std::optional<std::vector<Vec2d>> checker_lines(const Outline& outline, const OutlineStretch& stretch,
                                                              double size, double most,
                                                              const std::function<Vec2d(const Vec2d&)>& uv);

/// Where the rim of a spot light crosses an outline, and the rim of what it lights in full. `place`: the light's.
[[nodiscard]] std::vector<Vec2d> spot_rims(const Outline& outline, const Vec2d& place,
                                           const SpotLight::Prepared<double>& spot);

/// Where a straight outline is seen from a place at this sine of the angle to its normal.
[[nodiscard]] std::vector<Vec2d> seen_at_sine(const Outline& straight, const Vec2d& from, double sine);

/// Where a circle passes from the light of a light without extent into a shadow, also its own, or back. A superset:
/// outlines that other outlines hide from the light are not left out.
[[nodiscard]] std::vector<Vec2d> shadows_on_circle(const OutlineCircle& circle, const std::vector<Outline>& outlines,
                                                   const PlanLight& light);

}  // namespace raywalk
