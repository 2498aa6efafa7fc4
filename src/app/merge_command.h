#pragma once

#include "app/options.h"

#include <string>
#include <vector>

namespace raywalk {

struct MergeOptions {
  std::vector<std::string> parts;
  std::string image;
};

[[nodiscard]] ExitCode merge_command(const MergeOptions& options);

void declare_merge(CLI::App& program, Run& run);

}  // namespace raywalk
