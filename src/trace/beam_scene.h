#pragma once

#include "math/stop.h"
#include "scene/scene.h"
#include "trace/beam_faces.h"

namespace raywalk {

/// The faces of a scene with no reason against beams in space (scene/beam_limits.h). Boxes, prisms, polygons, triangles
/// and planes are their own faces. What is round is the polygons inscribed in it, with at least 64 sides around: no
/// place of theirs lies further off than an eighth of a percent of a radius. `stop` may cancel it, which then throws
/// Stopped.
[[nodiscard]] BeamFaces beam_faces_of(const Scene& scene, const Stop& stop = {});

}  // namespace raywalk
