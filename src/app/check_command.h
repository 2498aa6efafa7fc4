#pragma once

#include "app/options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace raywalk {

/// The options of `raywalk check numerics`.
struct CheckOptions {
  std::vector<std::string> names;  ///< families; none: all
  bool full = false;
  bool list = false;
  int rays = 0;  ///< per family; 0: according to `full`
  std::uint64_t seed = 1;
  int threads = 0;
  std::string state;  ///< empty: a file of a fixed name for a full run, else none
};

[[nodiscard]] ExitCode check_numerics_command(const CheckOptions& options);

void declare_check(CLI::App& program, Run& run);

}  // namespace raywalk
