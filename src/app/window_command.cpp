#include "app/window_command.h"

#include "app/scene_lookup.h"
#include "app/texts.h"
#include "math/stop.h"
#include "view/link/link.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace raywalk {

namespace {

/// Why the window cannot begin with this link, as far as that shows without one.
std::optional<Error> why_not_opened(const std::string& letters, const std::string& data) {
  const auto link = read_link(letters);
  if (!link) return link.error();
  if (link->bug > 0) return std::nullopt;
  if (link->lesson.empty()) {
    const auto scene = linked_scene(*link, data + "/scenes/" + link->scene + ".toml");
    return scene ? std::nullopt : std::optional(scene.error());
  }
  std::error_code unreadable;
  if (std::filesystem::is_directory(data + "/lessons/" + link->lesson, unreadable)) return std::nullopt;
  return Error{"", 0, 0, "there is no lesson " + link->lesson, "raywalk lesson list says which there are"};
}

}  // namespace

ExitCode window_command(GuiOptions options, [[maybe_unused]] FileLedger& ledger,
                        [[maybe_unused]] const std::vector<std::string>& commands) {
  options.data_dir = data_dir();
  std::error_code no_path;
  if (is_link(options.scene_path) && !std::filesystem::exists(options.scene_path, no_path)) {
    if (auto why = why_not_opened(options.scene_path, options.data_dir)) {
      why->message = "this link cannot be opened: " + why->message;
      return fail(*why);
    }
    options.link = std::exchange(options.scene_path, {});
  }
  [[maybe_unused]] const std::string given = options.scene_path;
  if (!given.empty()) options.scene_path = scene_path(given);
#if RAYWALK_GUI
  options.languages = texts().languages;
  options.broken_texts = texts().broken;
  warn_of_broken_texts();
  try {
    const Result<void> closed = run_gui(options, ledger);
    if (closed) return ExitCode::done;
    return fail(given.empty() ? closed.error() : with_names(closed.error(), given, commands));
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
