#pragma once
// Emitting objects as light sources: sampling a point on them from a surface, and its pdf.

#include "math/sampling.h"
#include "trace/world.h"

#include <optional>
#include <vector>

namespace raywalk {

/// All emitting surfaces of a world that can be sampled: spheres (under a similarity), disks, triangles, boxes, prisms
/// and polygons that are convex and without holes. Other emitters are found by BSDF sampling only; their pdf is 0.
///
/// One is chosen in proportion to its area times its radiance; then a sphere is sampled by its subtended cone, a
/// rectangle by its solid angle unless that is tiny, everything else by area.
template <class T>
class Emitters {
 public:
  explicit Emitters(const World<T>& world);

  [[nodiscard]] bool empty() const { return emitters_.empty(); }
  /// Whether there are several to choose from.
  [[nodiscard]] bool several() const { return emitters_.size() > 1; }

  struct Sample {
    int primitive, part;
    Vec3<T> to_light;  ///< from the shaded point to a point on the emitter
    T pdf;             ///< per solid angle, of this direction; > 0
  };
  /// Samples a point on an emitter as seen from `point`. None where the chosen emitter is seen edge-on.
  [[nodiscard]] std::optional<Sample> sample(const Vec3<T>& point, T pick, const Vec2<T>& u) const;
  /// The pdf with which `sample` returns the direction from `point` to `met` on that part of that primitive, where the
  /// unit normal is `normal`; 0 where it never does.
  [[nodiscard]] T pdf(const Vec3<T>& point, int primitive, int part, const Vec3<T>& met, const Vec3<T>& normal) const;

 private:
  enum class Kind { sphere, disk, triangle, parallelogram, rectangle };

 public:
  /// corner + x u + y v: for a disk the centre and two half axes; for a sphere the centre, u.x the radius.
  struct Emitter {
    Kind kind;
    int primitive, part;
    Vec3d corner, u, v;
    double area;
    double probability;               ///< of being chosen
    SphericalRectangle::Axes axes{};  ///< of a rectangle

    [[nodiscard]] bool is_sphere() const { return kind == Kind::sphere; }
    [[nodiscard]] bool is_parallelogram() const { return kind == Kind::parallelogram || kind == Kind::rectangle; }
  };
  [[nodiscard]] const std::vector<Emitter>& all() const { return emitters_; }

  /// Light leaves here: a point on an emitter, uniform in area.
  struct Origin {
    int primitive, part;
    Vec3d point, normal;  ///< normal: unit length, outward or, of what has no inside, to one of its sides
    double pdf;           ///< per area, of this point among those of all emitters; > 0
  };
  [[nodiscard]] Origin sample_origin(double pick, const Vec2d& unit) const;

 private:
  void add(const World<T>& world, int primitive);
  void add_flat(int primitive, int part, Kind kind, const Vec3d& corner, const Vec3d& u, const Vec3d& v);
  /// A convex polygon in one plane.
  void add_polygon(int primitive, int part, const std::vector<Vec3d>& corners);
  [[nodiscard]] const Emitter* emitter_of(int primitive, int part) const;
  [[nodiscard]] const Emitter& picked(double pick) const;

  std::vector<Emitter> emitters_;  ///< ascending by primitive
  std::vector<double> cdf_;        ///< cumulative probabilities, up to and including each emitter
};

extern template class Emitters<float>;
extern template class Emitters<double>;

}  // namespace raywalk
