#include "accel/search.h"

namespace raywalk {

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
      return Bvh<T>(boxes, primitives, build);
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
