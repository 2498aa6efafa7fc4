#pragma once

#include "app/console.h"
#include "scene/scene.h"
#include "study/effect_costs.h"

#include <optional>
#include <string>

namespace raywalk {

/// What a scene holds, whether it is planar, and the effects it calls for and why, for a person to read.
[[nodiscard]] std::string info_text(const Scene& scene, const std::string& path);

/// What its effects cost, for a person to read.
[[nodiscard]] std::string cost_text(const study::SceneCost& cost);

/// What `raywalk info` was asked for; what is absent is the scene's own.
struct InfoOptions {
  std::string scene;
  std::optional<std::string> keys{};  ///< instead of a scene: the keys that this one of its tables has, "" for all
  bool with_cost = false;             ///< also measures what its effects cost, which takes some seconds
  std::optional<Integrator> integrator{};
  std::optional<int> path_length{};
  std::optional<int> samples{};
  std::optional<int> light_grid{};
};

[[nodiscard]] ExitCode info_command(const InfoOptions& options);

}  // namespace raywalk
