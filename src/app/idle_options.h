#pragma once

#include "app/render_command.h"

#include <string>
#include <vector>

namespace raywalk {

/// A line for each option that was given and cannot change this render, with the reason. `scene` is the one rendered:
/// the options are already applied.
[[nodiscard]] std::vector<std::string> idle_options(const RenderOptions& given, const Scene& scene);

}  // namespace raywalk
