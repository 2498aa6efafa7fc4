#pragma once
// Path tracing's compiled kernels, as trace/kernel.h has them for the tracer.

#include "trace/kernel.h"
#include "trace/path.h"

namespace raywalk {

/// Runs PATH TRACING over a block.
[[nodiscard]] Statistics trace_paths(const World<float>& world, const PathLights<float>& lights,
                                     const PathSettings& settings, const RayGenerator<float>& camera,
                                     const PixelBlock& block, const PutPixel<float>& put);
[[nodiscard]] Statistics trace_paths(const World<double>& world, const PathLights<double>& lights,
                                     const PathSettings& settings, const RayGenerator<double>& camera,
                                     const PixelBlock& block, const PutPixel<double>& put);

/// The same, watched by `observer`: same bits, same statistics.
Statistics trace_paths_watched(const World<float>& world, const PathLights<float>& lights, const PathSettings& settings,
                               const RayGenerator<float>& camera, const PixelBlock& block, const PutPixel<float>& put,
                               PathObserver& observer);
Statistics trace_paths_watched(const World<double>& world, const PathLights<double>& lights,
                               const PathSettings& settings, const RayGenerator<double>& camera,
                               const PixelBlock& block, const PutPixel<double>& put, PathObserver& observer);

}  // namespace raywalk
