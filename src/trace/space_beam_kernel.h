#pragma once
// Beam tracing in space as the rest of the program runs it.

#include "trace/beam_faces.h"
#include "trace/kernel.h"

#include <vector>

namespace raywalk {

/// The pixels of a block. `faces` are those of the world's scene.
template <class T>
Statistics trace_space_beams(const World<T>& world, const BeamFaces& faces, const RayGenerator<T>& camera,
                             const PixelBlock& block, const PutPixel<T>& put);

/// The same observed by `observer`: same bits, same statistics.
template <class T>
Statistics trace_space_beams_watched(const World<T>& world, const BeamFaces& faces, const RayGenerator<T>& camera,
                                     const PixelBlock& block, const PutPixel<T>& put, Observer& observer);

/// A part of a window, and what comes back along its rays.
template <class T>
struct ShadedPiece {
  WindowPiece window;
  Rgb<T> shade{0};
  int object = -1;        ///< that the eye sees there; -1: none
  bool has_mean = false;  ///< of a checker there or in a mirror there: from nearer more can be told apart
};

/// The parts of a rectangle of a picture, in pixels from its upper left corner.
[[nodiscard]] std::vector<ShadedPiece<double>> parts_of_picture(const World<double>& world, const BeamFaces& faces,
                                                                const RayGenerator<double>& camera, const Vec2d& from,
                                                                const Vec2d& to, const Stop& stop = {});

}  // namespace raywalk
