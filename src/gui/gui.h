#pragma once

#include "io/error.h"
#include "io/file_ledger.h"
#include "text/language.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// What the window starts with. Only `data_dir` is needed. The fields below `data_dir` serve pictures and tests; `app`
/// offers them as the hidden options named beside them, each taking one value.
struct GuiOptions {
  std::string scene_path;                        ///< scene to open; empty: the classic scene of `data_dir`
  std::string demo_path;                         ///< actions to replay, one a line, as `view` writes them; empty: none
  std::shared_ptr<const Languages> languages{};  ///< those that can be chosen; null: English alone
  std::vector<Error> broken_texts{};             ///< files of languages that could not be read, to be told
  std::string data_dir;  ///< folder that holds `scenes` (and `fonts`, when fonts are shipped along)
  /// Folder for what outlives the window: settings, recent files, autosaves. Empty: the user's own
  /// ($XDG_STATE_HOME/raywalk, else ~/.local/state/raywalk). --state-dir
  std::string state_dir;

  /// Draws until nothing is left to do (the 3-D image is refined), writes the window as a PNG and ends. --screenshot
  std::string screenshot_path;
  std::string start_mode;             ///< "move", "trace" or "help"; empty: as `view` starts. --start-mode
  std::string start_tab;              ///< "image", "tree", "stack" or "legend"; empty: image. --start-tab
  std::optional<int> start_position;  ///< position on the timeline; negative: counted from the end. --start-position
  std::optional<Language> language;   ///< absent: as the settings say, else the environment. --language
  std::string theme;                  ///< "dark" or "projector"; empty: as the settings say. --theme
  double ui_scale = 0;                ///< 1 to 3, on top of the display's own scale; 0: as the settings say. --ui-scale
  int width = 0, height = 0;          ///< of the window in screen coordinates; 0: 1280 x 720. --window WxH

  /// Whenever something has been handled, the state is written here as JSON, all or nothing. --report
  std::string report_path;
};

/// Opens the window and stays until it is closed. Fails, with a hint, when there is no display, no OpenGL 3.3, or a
/// file named in `options` cannot be read or written: `app` prints the error and exits with 1. Unsaved work is never
/// lost by a failure: it stands in the autosave.
///
/// What is read at the start is noted in `ledger`, which is closed before the user takes over: who then replaces a file
/// is asked first.
[[nodiscard]] Result<void> run_gui(const GuiOptions& options, FileLedger& ledger);

}  // namespace raywalk
