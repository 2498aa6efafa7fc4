#pragma once

#include "shape/mesh.h"
#include "view/outlines.h"

#include <memory>

namespace raywalk {

/// A mesh as lines in its own space: all its edges where these are few. Else the edges at which it is open or bends
/// sharply, and its sections by planes in equal steps along the three axes. Kept for as long as the mesh lives, because
/// it is asked for in every frame; from one thread only.
[[nodiscard]] std::shared_ptr<const std::vector<Curve>> mesh_lines(const std::shared_ptr<const Mesh>& mesh);

}  // namespace raywalk
