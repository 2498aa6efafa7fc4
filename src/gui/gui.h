#pragma once

#include "text/error.h"
#include "text/file_ledger.h"
#include "text/language.h"
#include "view/drawing/theme.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// Options of the window. Only `data_dir` is required. The fields below `data_dir` are for screenshots and tests; `app`
/// offers them as the hidden options named beside them, each with one value.
struct GuiOptions {
  std::string scene_path;  ///< scene to open; empty: the classic scene of `data_dir`
  std::string link;        ///< a scene and a moment to open instead (view/link/link.h); empty: none
  std::string own_page{};  ///< the page that this runs in, where links lead to; empty: none
  bool embedded = false;   ///< in somebody's page: scene, code and transport alone
  std::string demo_path;   ///< actions to replay, one per line, as written by `view`; empty: none
  std::shared_ptr<const Languages> languages{};  ///< those that can be chosen; null: English alone
  std::vector<Error> broken_texts{};             ///< language files that could not be read, to be reported
  std::string data_dir;  ///< folder that holds `scenes` (and `fonts`, when fonts are shipped along)
  /// Folder for persistent data: settings, recent files, autosaves. Empty: the user's own ($XDG_STATE_HOME/raywalk,
  /// else ~/.local/state/raywalk). --state-dir
  std::string state_dir;

  /// Draws until idle (the 3-D image is refined), writes the window as a PNG and ends. --screenshot
  std::string screenshot_path;
  std::string start_mode;             ///< "move", "trace" or "help"; empty: the default. --start-mode
  std::string start_tab;              ///< "image", "tree", "stack" or "legend"; empty: image. --start-tab
  std::optional<int> start_position;  ///< position on the timeline; negative: counted from the end. --start-position
  std::optional<Language> language;   ///< absent: from the settings, else the environment. --language
  std::optional<Theme> theme;         ///< absent: from the settings. --theme
  double ui_scale = 0;                ///< 1 to 3, times the display's own scale; 0: from the settings. --ui-scale
  int width = 0, height = 0;          ///< of the window in screen coordinates; 0: 1280 x 720. --window WxH

  /// After each handled event, the state is written here as JSON, all or nothing. --report
  std::string report_path;
};

/// Opens the window and runs until it is closed. Fails, with a hint, if there is no display, no OpenGL 3.3, or a file
/// named in `options` cannot be read or written: `app` prints the error and exits with 1. Unsaved work is never lost by
/// a failure: it is in the autosave.
///
/// Files read at the start are noted in `ledger`, which is closed before interaction begins: from then on, replacing a
/// file needs confirmation.
[[nodiscard]] Result<void> run_gui(const GuiOptions& options, FileLedger& ledger);

}  // namespace raywalk
