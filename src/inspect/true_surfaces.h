#pragma once
// The true surfaces of a scene, accurate far below the spacing of the numbers that it is traced in.
//
// The scene's numbers are those of a tracer of either precision, and are searched in double by the robust code, whose t
// has a small relative error however short it is. So every query becomes rays from nearby points that are exact in
// double. Under a transform the truth is known only to the rounding of a double, because the ray is first transformed
// into object space.

#include "math/double_double.h"
#include "trace/world.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

/// A line of a drawing: the cut of an object's surfaces with an axis-aligned plane.
struct SurfaceCut {
  int object = -1;              ///< index in Scene::objects
  std::vector<Vec2d> points;    ///< from the middle of the drawing, scene units, along its two axes
  std::vector<Vec2d> outwards;  ///< unit normals there, within the plane of the drawing
};

/// The two axes of a drawing, right and up: 0 x, 1 y, 2 z. Its plane is perpendicular to the third.
using DrawnAxes = std::array<int, 2>;

class TrueSurfaces {
 public:
  /// Those of `world` at a time. In a float world nothing moves.
  template <class T>
  TrueSurfaces(const std::shared_ptr<const World<T>>& world, T time);

  /// Signed distance of a point from a primitive's surface, in scene units: above 0 outside. `normal`: the approximate
  /// surface normal; `spacing`: of the point's numbers. None if the surface is not near.
  [[nodiscard]] std::optional<double> distance(int primitive, const Vec3d& place, const Vec3d& normal,
                                               double spacing) const;

  /// t of a ray's true first intersection with a primitive; none if it misses. `spacing`: as above.
  [[nodiscard]] std::optional<DoubleDouble> crossing(int primitive, const Ray<double>& ray, double spacing) const;

  /// A ray's true closest hit in (0, t_max).
  [[nodiscard]] std::optional<Hit<double>> closest(Ray<double> ray, double t_max) const;

  /// The cuts within `reach` of `middle` on either side, sampled by `lines` lines along each axis.
  [[nodiscard]] std::vector<SurfaceCut> cut(const Vec3d& middle, const DrawnAxes& axes, const Vec2d& reach,
                                            const std::array<int, 2>& lines) const;

 private:
  /// The surface beside a point: its distance along an axis, and its outward normal.
  struct NearbySurface {
    double way;
    Vec3d normal;
  };
  [[nodiscard]] std::optional<NearbySurface> beside(int primitive, const Vec3d& place, int axis, double spacing) const;

  /// An intersection of a line of the drawing.
  struct LineHit {
    Vec2d at, outwards;  ///< first across the line, then along it
    int object;
    int cut = -1;  ///< the cut it ends; -1: none, or it has been continued
    /// The one on the previous line, within `width`, that belongs to the same surface.
    [[nodiscard]] LineHit* nearest_in(std::vector<LineHit>& others, double width) const;
  };
  [[nodiscard]] std::vector<LineHit> met_along(Ray<double> line, const Vec3d& middle, int order, int axis,
                                               double reach) const;

  std::shared_ptr<const Accelerator<double>> accelerator_;
  std::function<int(int)> object_of_;  ///< of a primitive: index in Scene::objects
  double time_;
};

extern template TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<float>>&, float);
extern template TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<double>>&, double);

/// The ray's point at t, minus `from`: accurate to the last digits of a double, however close the two are.
[[nodiscard]] Vec3d place_on(const Ray<double>& ray, const DoubleDouble& t, const Vec3d& from);

}  // namespace raywalk
