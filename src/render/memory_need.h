#pragma once

#include "render/render.h"
#include "text/memory.h"

namespace raywalk {

/// The memory for tracing a scene, besides the scene itself: shapes and triangles with all instances expanded, in the
/// structure that the settings ask for, and the picture; the largest of them is named. An estimate from the sizes of
/// the lists and from measured structures, which a scene whose objects all overlap may exceed.
[[nodiscard]] MemoryNeed memory_needed(const Scene& scene, const RenderSettings& settings);

}  // namespace raywalk
