#pragma once

#include "app/console.h"
#include "render/render.h"

#include <optional>
#include <string>

namespace raywalk {

/// The options of `raywalk render`; absent ones are taken from the scene.
struct RenderOptions {
  bool quiet = false;        ///< no warnings, notes, progress or summary: only errors
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
  BuildQuality build = BuildQuality::automatic;
  std::optional<bool> shadow_cache{};
  Precision precision = Precision::double_;
  std::optional<Share> share{};  ///< --part: only this one, for `raywalk merge`
};

[[nodiscard]] ExitCode render_command(const RenderOptions& options);

/// Fails, with what to do about it, if a picture has numbers that its file cannot say, of so many samples and pixels.
[[nodiscard]] ExitCode fail_if_not_finite(const std::string& image, std::size_t pixels, std::uint64_t samples = 0);

/// Creates NAME.partial.EXT for the partial image of NAME.EXT, or the first free one of NAME.partial-2.EXT,
/// NAME.partial-3.EXT ... `image` has an extension.
[[nodiscard]] Result<std::string> new_partial_file(const std::string& image);

}  // namespace raywalk
