#include "trace/beam_kernel.h"

#include "math/overloaded.h"
#include "trace/beams.h"

#include <algorithm>

namespace raywalk {

namespace detail {

double far_from(const Vec2d& eye, const std::vector<Outline>& outlines) {
  double far = 1;
  const auto reach = [&](const Vec2d& point, double beyond = 0) { far = std::max(far, length(point - eye) + beyond); };
  for (const Outline& outline : outlines)
    std::visit(Overloaded{
                   [&](const OutlineSide& side) { reach(side.from), reach(side.to); },
                   [&](const OutlineWall& wall) { reach(wall.point); },
                   [&](const OutlineCircle& circle) { reach(circle.centre, circle.radius); },
               },
               outline.shape);
  return 8 * far;
}

}  // namespace detail

namespace {

template <class Watcher>
Statistics run(const World<double>& world, const std::vector<Outline>& outlines, const RayGenerator<double>& camera,
               const PixelBlock& block, const PutPixel<double>& put, Watcher& observer) {
  BeamTracer<Watcher> tracer(world, outlines, camera, observer, block.stop);
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

}  // namespace

Statistics trace_beams(const World<double>& world, const std::vector<Outline>& outlines,
                       const RayGenerator<double>& camera, const PixelBlock& block, const PutPixel<double>& put) {
  NoObserver no_observer;
  return run(world, outlines, camera, block, put, no_observer);
}

Statistics trace_beams_watched(const World<double>& world, const std::vector<Outline>& outlines,
                               const RayGenerator<double>& camera, const PixelBlock& block, Observer& observer,
                               const PutPixel<double>& put) {
  return run(world, outlines, camera, block, put, observer);
}

}  // namespace raywalk
