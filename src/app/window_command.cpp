#include "app/window_command.h"

#include "app/scene_lookup.h"
#include "app/texts.h"
#include "math/stop.h"
#include "view/link/link.h"

#include <filesystem>
#include <utility>

namespace raywalk {

ExitCode window_command(GuiOptions options, [[maybe_unused]] FileLedger& ledger) {
  options.data_dir = data_dir();
  if (is_link(options.scene_path) && !std::filesystem::exists(options.scene_path)) {
    const auto link = read_link(options.scene_path);
    if (!link) return fail(link.error());
    options.link = std::exchange(options.scene_path, {});
  }
  if (!options.scene_path.empty()) options.scene_path = scene_path(options.scene_path);
#if RAYWALK_GUI
  options.languages = texts().languages;
  options.broken_texts = texts().broken;
  warn_of_broken_texts();
  try {
    const Result<void> closed = run_gui(options, ledger);
    return closed ? ExitCode::done : fail(closed.error());
  } catch (const Stopped&) {
    return ExitCode::done;  // closed before it was shown
  }
#else
  const std::string scene = options.scene_path.empty() ? "classic" : options.scene_path;
  return fail({"", 0, 0, "this raywalk was built without the window",
               "render the scene instead: raywalk render " + scene + " -o picture.png"});
#endif
}

}  // namespace raywalk
