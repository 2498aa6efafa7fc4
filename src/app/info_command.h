#pragma once

#include "app/console.h"
#include "scene/scene.h"

#include <string>

namespace raywalk {

/// What a scene holds, whether it is planar, and the effects it calls for and why, for a person to read.
[[nodiscard]] std::string info_text(const Scene& scene, const std::string& path);

[[nodiscard]] ExitCode info_command(const std::string& scene);

}  // namespace raywalk
