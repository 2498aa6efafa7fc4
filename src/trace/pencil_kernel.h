#pragma once
// Pencil tracing as the rest of the program runs it: watched. What it puts into pixels is the tracer's, whose kernels
// trace pictures (trace/kernel.h).

#include "trace/kernel.h"

namespace raywalk {

template <class T>
Statistics trace_pencils_watched(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                 const PutPixel<T>& put, Observer& observer);

}  // namespace raywalk
