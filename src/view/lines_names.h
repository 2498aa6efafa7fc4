#pragma once
// Names in the line view. Included by the files of this folder that draw it, and by nobody else.

#include "view/orbit.h"
#include "view/painter.h"

#include <string>

namespace raywalk::detail {

/// A name with its middle there, unless it would cover another one.
void draw_name(Painter& painter, const std::string& what, const Vec2d& at);

/// Those of the objects, each on its own body where that does not put it on a smaller one, else beside it.
void draw_object_names(Painter& painter, const Projection& seen);

}  // namespace raywalk::detail
