#include "trace/cone_kernel.h"

#include "math/overloaded.h"
#include "trace/cones.h"

#include <algorithm>

namespace raywalk {

double detail::far_from(const Vec3d& eye, const ConeBodies& bodies) {
  double far = 1;
  const auto reach = [&](const Vec3d& point, double beyond = 0) { far = std::max(far, length(point - eye) + beyond); };
  for (const ConeBody& body : bodies)
    std::visit(Overloaded{
                   [&](const ConeBall& ball) { reach(ball.centre, ball.radius); },
                   [&](const ConeWall& wall) { reach(wall.point); },
                   [&](const ConeFaces& faces) {
                     for (const ConeFace& face : faces.faces)
                       for (const Vec3d& corner : face.loops.front()) reach(corner);
                   },
               },
               body.shape);
  return 8 * far;
}

namespace {

template <class T, class Watcher>
Statistics run(const World<T>& world, const ConeBodies& bodies, bool flat, const RayGenerator<T>& camera,
               const PixelBlock& block, const PutPixel<T>& put, Watcher& observer) {
  const auto run_with = [&]<bool with_maps>() {
    ConeTracer<T, Watcher, with_maps> tracer(world, bodies, flat, camera, observer, block.stop);
    tracer.main_algorithm(block, put);
    return tracer.statistics();
  };
  if constexpr (!Watcher::watches && !few_kernels)
    if (world.surface_maps.empty()) return run_with.template operator()<false>();
  return run_with.template operator()<true>();
}

}  // namespace

template <class T>
Statistics trace_cones(const World<T>& world, const ConeBodies& bodies, bool flat, const RayGenerator<T>& camera,
                       const PixelBlock& block, const PutPixel<T>& put) {
  NoObserver no_observer;
  return run(world, bodies, flat, camera, block, put, no_observer);
}

template <class T>
Statistics trace_cones_watched(const World<T>& world, const ConeBodies& bodies, bool flat,
                               const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put,
                               Observer& observer) {
  return run(world, bodies, flat, camera, block, put, observer);
}

template Statistics trace_cones(const World<float>&, const ConeBodies&, bool, const RayGenerator<float>&,
                                const PixelBlock&, const PutPixel<float>&);
template Statistics trace_cones(const World<double>&, const ConeBodies&, bool, const RayGenerator<double>&,
                                const PixelBlock&, const PutPixel<double>&);
template Statistics trace_cones_watched(const World<float>&, const ConeBodies&, bool, const RayGenerator<float>&,
                                        const PixelBlock&, const PutPixel<float>&, Observer&);
template Statistics trace_cones_watched(const World<double>&, const ConeBodies&, bool, const RayGenerator<double>&,
                                        const PixelBlock&, const PutPixel<double>&, Observer&);

}  // namespace raywalk
