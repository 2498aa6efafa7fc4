#pragma once
// A picture by beams as a drawing: polygons with one colour each, which are as sharp at any size (SVG).

#include "render/render.h"
#include "scene/scene.h"
#include "text/error.h"

#include <functional>
#include <string>

namespace raywalk {

struct BeamDrawing {
  std::string svg;
  std::size_t polygons = 0;
  bool finished = true;  ///< else it was cancelled, and there is no drawing
};

struct BeamDrawingSettings {
  ImageSize size{640, 480};
  /// Where a colour changes by more, of 255, or is the mean of a checker, a polygon is cut further, down to `finest`
  /// pixels.
  int tolerance = 4;
  double finest = 2;
  std::function<void(const Progress&)> progress{};
  Stop stop{};
};

/// Of a scene with no reason against beams in space (scene/beam_limits.h). Each object's polygons are a group with its
/// name. Fails where there are too many polygons for a drawing.
[[nodiscard]] Result<BeamDrawing> beam_drawing(const Scene& scene, const BeamDrawingSettings& settings);

}  // namespace raywalk
