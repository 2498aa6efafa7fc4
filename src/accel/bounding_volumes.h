#pragma once

#include "accel/build_record.h"
#include "accel/search_record.h"
#include "accel/slabs.h"

#include <cmath>

namespace raywalk {

/// What encloses a single object.
enum class VolumeKind { sphere, ellipsoid, box };

/// A bounding volume around each primitive and no hierarchy, as in T. Whitted's tracer (1980) and its first successors.
/// Every ray is tested against every volume, and against the contents of those that it hits. Spheres and ellipsoids
/// circumscribe the primitive's box.
template <class T>
class BoundingVolumes {
 public:
  BoundingVolumes(const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives, VolumeKind kind,
                  const Stop& stop = {})
      : kind_(kind) {
    for (const int id : boxes.bounded) {
      stop.check();
      const Bounds<T>& box = boxes.box(id);
      Volume volume{id, box, Vec3d((Vec3d(box.min) + Vec3d(box.max)) / 2.0), Vec3d(0.0)};
      const Vec3d half = (Vec3d(box.max) - Vec3d(box.min)) / 2.0;
      // Slightly larger than needed: a flat box gets a volume too, and rounding in the tests below does no harm.
      constexpr double ample = 1 + 1e-6;
      const double grain = 1e-6 * length(half) + 1e-300;
      if (const Sphere<T>* sphere = primitives.template plain<Sphere<T>>(id))
        volume.inverse = Vec3d(1 / (ample * static_cast<double>(sphere->radius)));
      else if (kind == VolumeKind::ellipsoid)
        for (int axis = 0; axis < 3; ++axis) volume.inverse[axis] = 1 / (std::sqrt(3.0) * ample * half[axis] + grain);
      else
        volume.inverse = Vec3d(1 / (ample * length(half) + grain));
      volumes_.push_back(volume);
    }
  }

  template <class AnyRay, class Query>
  void search(const AnyRay& ray, const Primitives<T>& primitives, Query& query) const {
    if (kind_ == VolumeKind::box) {
      const auto slabs = slabs_of(ray, primitives);
      for (const Volume& volume : volumes_) {
        query.enter_node();
        const bool missed = clip(slabs, volume.box, {0, query.t_far()}).empty();
        tell(query, volume, missed);
        if (missed) continue;
        if (query.test(primitives, volume.id)) return;
      }
      return;
    }
    const Vec3d origin = wide(ray.origin), direction = wide(ray.direction);
    for (const Volume& volume : volumes_) {
      query.enter_node();
      const bool missed = misses(volume, origin, direction, static_cast<double>(query.t_far()));
      tell(query, volume, missed);
      if (missed) continue;
      if (query.test(primitives, volume.id)) return;
    }
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
    for (const Volume& volume : volumes_)
      if (nodes.size() < most) nodes.push_back({wide(volume.box), 0, true, 1});
  }

  [[nodiscard]] AcceleratorStatistics statistics() const {
    return {volumes_.size(), volumes_.size(), 0, volumes_.size() * sizeof(Volume)};
  }

 private:
  struct Volume {
    int id;
    Bounds<T> box;
    Vec3d centre, inverse;  ///< of the sphere or ellipsoid: 1 / radius along each axis
  };

  template <class Query>
  static void tell([[maybe_unused]] Query& query, [[maybe_unused]] const Volume& volume, [[maybe_unused]] bool missed) {
    if constexpr (Watching<Query>) {
      if (missed)
        query.record().skipped(volume.box, true);
      else
        query.record().entered(volume.box, true, 1);
    }
  }

  /// Whether the ray certainly misses the volume, scaled to a unit sphere, or has it behind it or beyond t_far.
  static bool misses(const Volume& volume, const Vec3d& origin, const Vec3d& direction, double t_far) {
    const Vec3d o = (origin - volume.centre) * volume.inverse, d = direction * volume.inverse;
    const double a = dot(d, d), b = dot(d, o), oo = dot(o, o);
    constexpr double rounding = 1e-6;  // of a float ray transformed into object space: 2e-7 sqrt(oo) <= 1e-6 + 1e-8 oo
    const double c = oo * (1 - rounding) - 1 - rounding;
    if (c <= 0) return false;  // inside
    if (b > 0) return true;
    const Vec3d across = cross(o, d);
    const double square = a * (1 + rounding + 1e-8 * oo) - dot(across, across);
    return square < 0 || -b - std::sqrt(square) > t_far * a * (1 + rounding);
  }

  VolumeKind kind_;
  std::vector<Volume> volumes_;
};

}  // namespace raywalk
