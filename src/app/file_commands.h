#pragma once

#include "app/options.h"
#include "io/generate.h"

#include <string>

namespace raywalk {

void declare_convert(CLI::App& program, Run& run);
void declare_generate(CLI::App& program, Run& run);

/// Writes the scene `in` in the format that the extension of `out` names: .toml or .pov.
[[nodiscard]] ExitCode convert_command(const std::string& in, const std::string& out);

[[nodiscard]] ExitCode generate_command(const GenerateOptions& options, const std::string& out);

}  // namespace raywalk
