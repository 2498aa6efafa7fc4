#pragma once

#include "app/arguments.h"
#include "app/console.h"
#include "app/names.h"
#include "text/language.h"

#include <optional>
#include <string>

namespace raywalk {

/// What `raywalk step` was asked for; what is absent is the scene's own.
struct StepOptions {
  std::string scene;
  std::optional<PixelChoice> pixel{};  ///< absent: the whole strip
  std::optional<ImageSize> size{};     ///< of the image that a pixel is of
  std::optional<Integrator> integrator{};
  std::optional<int> path_length{};
  std::optional<int> depth{};
  std::optional<double> threshold{};
  Precision precision = Precision::double_;
  std::optional<Numerics> numerics{};
  std::optional<double> epsilon{};
  std::optional<Fault> fault{};      ///< breaks the tracer on purpose
  std::optional<Language> language;  ///< of text, page and picture; left out: English
  StepFormat format = StepFormat::text;
};

[[nodiscard]] ExitCode step_command(const StepOptions& options);

}  // namespace raywalk
