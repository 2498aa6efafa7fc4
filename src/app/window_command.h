#pragma once

#include "app/console.h"
#include "gui/gui.h"

#include <string>
#include <vector>

namespace raywalk {

/// Opens the visualiser. `options.data_dir` is filled in here, and `scene_path` may be the name of a shipped scene.
/// `commands`: of the program, one of which a scene that is not there may have been meant for.
[[nodiscard]] ExitCode window_command(GuiOptions options, FileLedger& ledger, const std::vector<std::string>& commands);

}  // namespace raywalk
