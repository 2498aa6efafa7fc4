#pragma once
// Beam tracing as the rest of the program runs it: of a planar scene's strip.

#include "trace/kernel.h"
#include "trace/outlines.h"

namespace raywalk {

/// The pixels of a strip. `outlines` are those of the world's scene. Samples are not asked for: a beam is all of them.
Statistics trace_beams(const World<double>& world, const std::vector<Outline>& outlines,
                       const RayGenerator<double>& camera, const PixelBlock& block, const PutPixel<double>& put);
/// The same observed by `observer`: same bits.
Statistics trace_beams_watched(
    const World<double>& world, const std::vector<Outline>& outlines, const RayGenerator<double>& camera,
    const PixelBlock& block, Observer& observer, const PutPixel<double>& put = [](const Pixel&, const Rgbd&) {});

}  // namespace raywalk
