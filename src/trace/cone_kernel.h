#pragma once
// Cone tracing as the rest of the program runs it.

#include "trace/cone_cover.h"
#include "trace/kernel.h"

namespace raywalk {

/// The pixels of a block. `bodies` are those of the world's scene (trace/cone_cover.h); `flat`: of a planar scene's
/// strip, in a flat world.
template <class T>
Statistics trace_cones(const World<T>& world, const ConeBodies& bodies, bool flat, const RayGenerator<T>& camera,
                       const PixelBlock& block, const PutPixel<T>& put);
/// The same observed by `observer`: same bits.
template <class T>
Statistics trace_cones_watched(const World<T>& world, const ConeBodies& bodies, bool flat,
                               const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put,
                               Observer& observer);

}  // namespace raywalk
