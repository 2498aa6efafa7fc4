#pragma once
// The geometry of a scene in the plan, in scene units: shared by drawing and dragging.

#include "view/state.h"

#include <cstddef>
#include <optional>

namespace raywalk {

/// SCREEN as seen from above. `forward` and `left` are the plan parts of unit vectors: of unit length in planar scenes.
struct ScreenPlace {
  Vec2d forward, left;
  Vec2d centre;
  Vec2d first, last;  ///< the ends: of cell 0 (the left end as EYE sees it) and of the last cell
  [[nodiscard]] Vec2d at(double t) const { return first + t * (last - first); }  ///< 0 at first, 1 at last
};

[[nodiscard]] ScreenPlace screen_place(const Camera& camera);

/// Radius of the circle of a sphere in the plan: its section, or its outline if it is not cut.
[[nodiscard]] double plan_radius(const Sphere<double>& sphere);
[[nodiscard]] bool meets_plan(const Sphere<double>& sphere);

/// With more objects than this, only those selected or hovered show handles.
inline constexpr std::size_t few_handled = 12;

/// Centre of the area of a simple polygon.
[[nodiscard]] Vec2d centroid(const Prism<double>& prism);

/// A body or one of its handles: `target.index` is then an object's.
[[nodiscard]] bool belongs_to_object(const Target& target);
/// Whether it is a light or the handle of one.
[[nodiscard]] bool belongs_to_light(const Target& target);
/// The radius of a kind of light that has one, which a handle changes; null where there is none.
[[nodiscard]] double* radius_of(Light& light);
[[nodiscard]] bool has_radius(const Light& light);

/// An object's box, with its transform; none if it is empty or infinite.
[[nodiscard]] std::optional<Bounds<double>> footprint_of(const Object& object);

struct PlanLine {
  Vec2d point, along;  ///< `along`: unit length
  [[nodiscard]] Vec2d nearest_to(const Vec2d& at) const { return point + dot(at - point, along) * along; }
};

/// The intersection of a plane, where its transform puts it, with the plan, the front to its left; none if the plane is
/// level, and of any other object.
[[nodiscard]] std::optional<PlanLine> wall_line(const Object& object);

/// The place of a light's symbol. A directional light's is in its direction, within view.
[[nodiscard]] Vec2d light_place(const Scene& scene, const Light& light, const PlanCamera& camera,
                                const Viewport& viewport);

/// The handle position of a target, which must exist. Cells and rays: their middle.
[[nodiscard]] Vec2d place_of(const State& state, const Target& target, const Viewport& viewport);

/// The smallest of 1, 2, 5 times a power of ten that is at least 10 pixels: the snapping step.
[[nodiscard]] double grid_step(const PlanCamera& camera);

/// `from` turned about `pivot` by `angle` radians, counter-clockwise.
[[nodiscard]] Vec2d turned(const Vec2d& from, const Vec2d& pivot, double angle);

/// A drag of a target.
struct Grip {
  const Scene& scene;  ///< before
  Target target;
  Vec2d from, to;          ///< of the pointer, scene units
  bool constrain = false;  ///< Shift: along one axis; lengths to the grid, angles to 15 degrees
  bool snap = false;       ///< Control: places to the grid
  double grid = 0.1;
  double smallest = 0.01;  ///< no length becomes less
  Vec2d sun_pivot{0.0};    ///< about which directional lights turn
};

/// The scene after the drag; none if the target cannot be moved. The result may break rules of the scene format (edges
/// that cross): the caller must check why_refused.
[[nodiscard]] std::optional<Scene> dragged(const Grip& grip);

}  // namespace raywalk
