#include "trace/space_beam_kernel.h"

#include "trace/space_beams.h"

namespace raywalk {

namespace {

template <class T, class Watcher>
Statistics run(const World<T>& world, const BeamFaces& faces, const RayGenerator<T>& camera, const PixelBlock& block,
               const PutPixel<T>& put, Watcher& observer) {
  SpaceBeamTracer<T, Watcher> tracer(world, faces, camera, observer, block.stop);
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

}  // namespace

template <class T>
Statistics trace_space_beams(const World<T>& world, const BeamFaces& faces, const RayGenerator<T>& camera,
                             const PixelBlock& block, const PutPixel<T>& put) {
  NoObserver no_observer;
  return run(world, faces, camera, block, put, no_observer);
}

template <class T>
Statistics trace_space_beams_watched(const World<T>& world, const BeamFaces& faces, const RayGenerator<T>& camera,
                                     const PixelBlock& block, const PutPixel<T>& put, Observer& observer) {
  return run(world, faces, camera, block, put, observer);
}

template Statistics trace_space_beams(const World<float>&, const BeamFaces&, const RayGenerator<float>&,
                                      const PixelBlock&, const PutPixel<float>&);
template Statistics trace_space_beams(const World<double>&, const BeamFaces&, const RayGenerator<double>&,
                                      const PixelBlock&, const PutPixel<double>&);
template Statistics trace_space_beams_watched(const World<float>&, const BeamFaces&, const RayGenerator<float>&,
                                              const PixelBlock&, const PutPixel<float>&, Observer&);
template Statistics trace_space_beams_watched(const World<double>&, const BeamFaces&, const RayGenerator<double>&,
                                              const PixelBlock&, const PutPixel<double>&, Observer&);

std::vector<ShadedPiece<double>> parts_of_picture(const World<double>& world, const BeamFaces& faces,
                                                  const RayGenerator<double>& camera, const Vec2d& from,
                                                  const Vec2d& to, const Stop& stop) {
  NoObserver no_observer;
  return SpaceBeamTracer<double, NoObserver>(world, faces, camera, no_observer, stop).parts_of(from, to);
}

}  // namespace raywalk
