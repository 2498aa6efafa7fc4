#pragma once

#include "app/options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace raywalk {

/// What `raywalk check numerics` was asked for.
struct CheckOptions {
  std::vector<std::string> names;  ///< families; none: all
  bool full = false;
  bool list = false;
  int rays = 0;  ///< a family; 0: as `full` says
  std::uint64_t seed = 1;
  int threads = 0;
  std::string state;  ///< empty: for a full run a file of a fixed name, else none
};

[[nodiscard]] ExitCode check_numerics_command(const CheckOptions& options);

void declare_check(CLI::App& program, Run& run);

}  // namespace raywalk
