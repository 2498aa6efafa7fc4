#pragma once

#include "app/options.h"

namespace raywalk {

struct StudyCommandOptions {
  std::vector<std::string> names;  ///< of experiments; none: all
  std::string folder;
  bool quick = false, list = false;
  int threads = 0;
};

[[nodiscard]] ExitCode study_command(const StudyCommandOptions& options);

void declare_study(CLI::App& program, Run& run);

}  // namespace raywalk
