#pragma once

#include "app/arguments.h"
#include "app/console.h"
#include "app/names.h"
#include "text/language.h"

#include <optional>
#include <string>

namespace raywalk {

/// The options of `raywalk step`; absent ones are taken from the scene.
struct StepOptions {
  std::string scene;
  std::optional<PixelChoice> pixel{};  ///< absent: the whole strip
  std::optional<ImageSize> size{};     ///< of the image that contains the pixel
  std::optional<Integrator> integrator{};
  std::optional<int> path_length{};
  std::optional<int> depth{};
  std::optional<double> threshold{};
  Precision precision = Precision::double_;
  std::optional<Numerics> numerics{};
  std::optional<double> epsilon{};
  std::optional<Fault> fault{};      ///< injected into the tracer
  std::optional<Language> language;  ///< of text, page and picture; absent: English
  StepFormat format = StepFormat::text;
};

[[nodiscard]] ExitCode step_command(const StepOptions& options);

}  // namespace raywalk
