#pragma once

#include "app/options.h"

namespace raywalk {

struct CompareOptions {
  std::string test, reference;
  std::optional<std::string> difference{};  ///< file for the picture of the difference
};

[[nodiscard]] ExitCode compare_command(const CompareOptions& options);

void declare_compare(CLI::App& program, Run& run);

}  // namespace raywalk
