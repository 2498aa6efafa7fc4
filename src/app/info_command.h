#pragma once

#include "app/console.h"
#include "scene/scene.h"
#include "study/effect_costs.h"

#include <string>

namespace raywalk {

/// What a scene holds, whether it is planar, and the effects it calls for and why, for a person to read.
[[nodiscard]] std::string info_text(const Scene& scene, const std::string& path);

/// What its effects cost, for a person to read.
[[nodiscard]] std::string cost_text(const study::SceneCost& cost);

/// `with_cost`: also measures what its effects cost, which takes some seconds.
[[nodiscard]] ExitCode info_command(const std::string& scene, bool with_cost);

}  // namespace raywalk
