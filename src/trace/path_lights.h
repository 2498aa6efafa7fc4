#pragma once
// Objects that emit, as lights: which point of them to try from a surface, and with which density.

#include "trace/world.h"

#include <optional>
#include <vector>

namespace raywalk {

/// All surfaces of a world that emit and that points can be drawn from: spheres (through a similarity), disks,
/// triangles, boxes, prisms and polygons that are convex and have no holes. What else emits is found by chance only;
/// its density is 0.
///
/// One is picked by its area times its radiance; then a sphere is drawn by the cone in which it is seen, a rectangle by
/// its solid angle unless that is tiny, everything else by area.
template <class T>
class PathLights {
 public:
  explicit PathLights(const World<T>& world);

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  /// Whether one must be picked among several.
  [[nodiscard]] bool several() const { return pieces_.size() > 1; }

  struct Sample {
    int primitive, part;
    Vec3<T> way;  ///< from the point to one on the light
    T density;    ///< by solid angle, of this direction among all that `draw` may answer; > 0
  };
  /// A way to a light from `point`. None where the one picked is seen edge on.
  [[nodiscard]] std::optional<Sample> draw(const Vec3<T>& point, T pick, const Vec2<T>& u) const;
  /// The density with which `draw` answers with the way from `point` to `met` on that part of that primitive, where the
  /// unit normal is `normal`; 0 where it never does.
  [[nodiscard]] T density(const Vec3<T>& point, int primitive, int part, const Vec3<T>& met,
                          const Vec3<T>& normal) const;

 private:
  enum class Kind { sphere, disk, triangle, parallelogram, rectangle };
  /// corner + x u + y v: for a disk the centre and two half axes; for a sphere the centre, u.x the radius.
  struct Piece {
    Kind kind;
    int primitive, part;
    Vec3d corner, u, v;
    double area;
    double chance;  ///< of being picked
  };
  void add(const World<T>& world, int primitive);
  void add_flat(int primitive, int part, Kind kind, const Vec3d& corner, const Vec3d& u, const Vec3d& v);
  /// A convex polygon in one plane.
  void add_polygon(int primitive, int part, const std::vector<Vec3d>& corners);
  [[nodiscard]] const Piece* piece_of(int primitive, int part) const;

  std::vector<Piece> pieces_;  ///< ascending by primitive
  std::vector<double> picks_;  ///< sums of the chances up to and including each piece
};

extern template class PathLights<float>;
extern template class PathLights<double>;

}  // namespace raywalk
