#include "accel/search.h"

#include <algorithm>

namespace raywalk {

namespace {

/// Whether at least half of the primitives, and eight packs of them, are triangles that packs hold.
template <class T>
bool mostly_mesh(const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives) {
  const auto triangles =
      std::count_if(boxes.bounded.begin(), boxes.bounded.end(), [&](int id) { return primitives.still_triangle(id); });
  return triangles >= 8 * static_cast<std::ptrdiff_t>(tree_width) &&
         2 * triangles >= static_cast<std::ptrdiff_t>(boxes.bounded.size());
}

}  // namespace

template <class T>
AnyStructure<T> build_structure(AcceleratorKind kind, const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives,
                                const BuildOptions& build) {
  switch (kind) {
    case AcceleratorKind::automatic:
    case AcceleratorKind::none:
      break;
    case AcceleratorKind::spheres:
      return BoundingVolumes<T>(boxes, primitives, VolumeKind::sphere, build.stop);
    case AcceleratorKind::ellipsoids:
      return BoundingVolumes<T>(boxes, primitives, VolumeKind::ellipsoid, build.stop);
    case AcceleratorKind::boxes:
      return BoundingVolumes<T>(boxes, primitives, VolumeKind::box, build.stop);
    case AcceleratorKind::bvh:
      // Packs and the lanes of a wide node pay only where they are filled. A ray costs MeshBvh more before its first
      // box, which the rays of a scene of a few shapes, whose own tests are the most of their time, do not win back.
      if (mostly_mesh(boxes, primitives) || !primitives.triangles().copies().empty())
        return MeshBvh<T>(boxes, primitives, build);
      return Bvh<T>(boxes, build);
    case AcceleratorKind::grid:
      return Grid<T>(boxes, build);
    case AcceleratorKind::octree:
      return Octree<T>(boxes, build);
    case AcceleratorKind::kdtree:
      return KdTree<T>(boxes, build);
  }
  return List<T>(primitives.size());
}

template AnyStructure<float> build_structure(AcceleratorKind, const PrimitiveBounds<float>&, const Primitives<float>&,
                                             const BuildOptions&);
template AnyStructure<double> build_structure(AcceleratorKind, const PrimitiveBounds<double>&,
                                              const Primitives<double>&, const BuildOptions&);

}  // namespace raywalk
