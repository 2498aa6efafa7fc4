#pragma once

#include "app/render_command.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A line for each option that was given and cannot change this render or walk, with the reason. `command`: whose
/// options they are. `scene` is the one rendered: the options are already applied.
[[nodiscard]] std::vector<std::string> idle_options(std::string_view command, const RenderOptions& given,
                                                    const Scene& scene);

}  // namespace raywalk
