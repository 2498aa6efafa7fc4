#pragma once

#include "app/options.h"
#include "render/tiles.h"

namespace raywalk {

struct StudyCommandOptions {
  std::vector<std::string> names;  ///< of experiments; none: all
  std::string folder;
  bool quick = false, list = false;
  int threads = 0;
  std::optional<Share> share{};  ///< --part: only these rounds
};

[[nodiscard]] ExitCode study_command(const StudyCommandOptions& options);

void declare_study(CLI::App& program, Run& run);

}  // namespace raywalk
