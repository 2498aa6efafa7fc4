#pragma once

#include "app/console.h"
#include "scene/scene.h"
#include "study/effect_costs.h"

#include <optional>
#include <string>

namespace raywalk {

/// What a scene contains, whether it is planar, and which effects it uses and why, as text.
[[nodiscard]] std::string info_text(const Scene& scene, const std::string& path);

/// What its effects cost, as text.
[[nodiscard]] std::string cost_text(const study::SceneCost& cost);

/// The options of `raywalk info`; absent ones are taken from the scene.
struct InfoOptions {
  std::string scene;
  std::optional<std::string> keys{};  ///< instead of a scene: the keys that this one of its tables has, "" for all
  bool with_cost = false;             ///< also measures the cost of its effects, which takes some seconds
  std::optional<Integrator> integrator{};
  std::optional<int> path_length{};
  std::optional<int> samples{};
  std::optional<int> light_grid{};
};

[[nodiscard]] ExitCode info_command(const InfoOptions& options);

}  // namespace raywalk
