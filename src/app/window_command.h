#pragma once

#include "app/console.h"
#include "gui/gui.h"

namespace raywalk {

/// Opens the visualiser. `options.data_dir` is filled in here, and `scene_path` may be the name of a shipped scene.
[[nodiscard]] ExitCode window_command(GuiOptions options, FileLedger& ledger);

}  // namespace raywalk
