#pragma once

#include "io/memory.h"
#include "render/render.h"

namespace raywalk {

/// What tracing a scene takes beside the scene itself: shapes and triangles with all instances spelt out, in the
/// structure that the settings ask for, and the picture; the largest of them is named. An estimate from what the lists
/// hold and from measured structures, which a scene whose objects all overlap may exceed.
[[nodiscard]] MemoryNeed memory_needed(const Scene& scene, const RenderSettings& settings);

}  // namespace raywalk
