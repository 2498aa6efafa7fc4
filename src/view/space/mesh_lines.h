#pragma once

#include "shape/mesh.h"
#include "view/space/outlines.h"

#include <memory>

namespace raywalk {

/// A mesh as lines in object space: all its edges if they are few; else boundary and crease edges, and sections by
/// planes in equal steps along the three axes. Cached for the lifetime of the mesh, because it is needed in every
/// frame; for one thread only.
[[nodiscard]] std::shared_ptr<const std::vector<Polyline>> mesh_lines(const std::shared_ptr<const Mesh>& mesh);

}  // namespace raywalk
