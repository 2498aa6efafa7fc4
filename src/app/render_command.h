#pragma once

#include "app/console.h"
#include "render/render.h"

#include <optional>
#include <string>

namespace raywalk {

/// What `raywalk render` was asked for; what is absent is the scene's own.
struct RenderOptions {
  bool quiet = false;        ///< no warnings, notes or progress, nor what was done: only what went wrong
  std::string scene, image;  ///< paths, as is the next one
  std::optional<std::string> statistics{};
  std::optional<ImageSize> size{};
  std::optional<int> depth{};
  std::optional<double> threshold{};
  std::optional<Integrator> integrator{};
  std::optional<int> samples{};
  std::optional<Sampler> sampler{};
  std::optional<Numerics> numerics{};
  std::optional<double> epsilon{};
  std::optional<int> light_grid{};
  std::optional<int> path_length{};
  std::optional<double> tolerance{};
  std::optional<std::uint64_t> seed{};
  bool corner_samples = false;
  int threads = 0;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  std::optional<bool> shadow_cache{};
  Precision precision = Precision::double_;
};

[[nodiscard]] ExitCode render_command(const RenderOptions& options);

/// NAME.partial.EXT, where an interrupted render leaves what is done of NAME.EXT, or the first of NAME.partial-2.EXT,
/// NAME.partial-3.EXT ... that is free: an empty file, made so that no one else takes it. `image` has an ending.
[[nodiscard]] Result<std::string> new_partial_file(const std::string& image);

}  // namespace raywalk
