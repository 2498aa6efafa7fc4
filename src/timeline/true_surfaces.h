#pragma once
// What is true of a scene's surfaces, right far below the spacing of the numbers that it is traced in.
//
// The scene's numbers are taken as a tracer of either precision has them, and met in double by the robust searches,
// whose t is right to its last digits however short it is. So whatever is asked is put into rays that start near by, at
// places that a double holds exactly. Of what stands under a transform the truth is known to the rounding of a double:
// there a ray is taken into the shape's own space first.

#include "math/double_double.h"
#include "trace/world.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

/// A line of a drawing: where surfaces of one object are cut by a plane across an axis.
struct SurfaceCut {
  int object = -1;              ///< index in Scene::objects
  std::vector<Vec2d> points;    ///< from the middle of the drawing, scene units, along its two axes
  std::vector<Vec2d> outwards;  ///< unit normals there, within the plane of the drawing
};

/// The two axes that a drawing shows, across and up: 0 x, 1 y, 2 z. It shows the plane across the third one.
using DrawnAxes = std::array<int, 2>;

class TrueSurfaces {
 public:
  /// Those of `world` at a time. In a float's world nothing moves.
  template <class T>
  TrueSurfaces(const std::shared_ptr<const World<T>>& world, T time);

  /// How far a place is from the surface of a primitive, in scene units: above 0 outside. `normal`: roughly the
  /// surface's own there; `spacing`: of the numbers that the place is made of. None where the surface is not near.
  [[nodiscard]] std::optional<double> distance(int primitive, const Vec3d& place, const Vec3d& normal,
                                               double spacing) const;

  /// t at which a ray truly crosses a primitive first; none where it does not. `spacing`: as above.
  [[nodiscard]] std::optional<DoubleDouble> crossing(int primitive, const Ray<double>& ray, double spacing) const;

  /// What a ray truly meets first in (0, t_max).
  [[nodiscard]] std::optional<Hit<double>> closest(Ray<double> ray, double t_max) const;

  /// All that lies within `reach` of `middle` to either side, found by so many lines along each axis.
  [[nodiscard]] std::vector<SurfaceCut> cut(const Vec3d& middle, const DrawnAxes& axes, const Vec2d& reach,
                                            const std::array<int, 2>& lines) const;

 private:
  /// The surface beside a place: how far along an axis, and its outward normal.
  struct Beside {
    double way;
    Vec3d normal;
  };
  [[nodiscard]] std::optional<Beside> beside(int primitive, const Vec3d& place, int axis, double spacing) const;

  /// A surface met by a line of a drawing.
  struct Met {
    Vec2d at, outwards;  ///< first across the line, then along it
    int object;
    int cut = -1;  ///< what it has been joined to; -1: nothing, or it has been gone on from
    /// The one on the line before, so far away, that is the same surface.
    [[nodiscard]] Met* nearest_in(std::vector<Met>& others, double width) const;
  };
  [[nodiscard]] std::vector<Met> met_along(Ray<double> line, const Vec3d& middle, int order, int axis,
                                           double reach) const;

  std::shared_ptr<const Accelerator<double>> accelerator_;
  std::vector<int> objects_;  ///< by primitive: index in Scene::objects
  double time_;
};

extern template TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<float>>&, float);
extern template TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<double>>&, double);

/// The place on the ray at t, less `from`: right to a double's last digits, however close the two are.
[[nodiscard]] Vec3d place_on(const Ray<double>& ray, const DoubleDouble& t, const Vec3d& from);

}  // namespace raywalk
