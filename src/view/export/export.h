#pragma once
// Exports of a walk for those without the program; the extension selects the contents.

#include "scene/scene.h"
#include "text/error.h"
#include "timeline/timeline.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace raywalk {

struct State;

enum class ExportKind {
  picture,     ///< .png: the window
  animation,   ///< .gif: the window, one frame per step
  plan,        ///< .svg: the plan
  slides,      ///< .html: a page that steps offline
  transcript,  ///< .txt
  steps,       ///< .json
  script,      ///< .script.html: the presenter's script of the open lesson
};
struct ExportEnding {
  std::string_view ending;  ///< ".png"
  ExportKind kind;
};
inline constexpr std::array<ExportEnding, 7> kinds_of_export{{{".html", ExportKind::slides},
                                                              {".png", ExportKind::picture},
                                                              {".gif", ExportKind::animation},
                                                              {".svg", ExportKind::plan},
                                                              {".txt", ExportKind::transcript},
                                                              {".json", ExportKind::steps},
                                                              {".script.html", ExportKind::script}}};
/// By the extension of a path; none for other extensions.
[[nodiscard]] std::optional<ExportKind> export_kind_of(std::string_view path);
/// The path with its extension replaced by that of this kind.
[[nodiscard]] std::string with_ending(const std::string& path, ExportKind kind);

/// A pending export that only the window can write.
struct WindowExport {
  ExportKind kind;  ///< picture or animation
  std::string path;
  friend bool operator==(const WindowExport&, const WindowExport&) = default;
};

/// The positions of an animation: from here to the end of the current pixel, by lines or rays according to the grain;
/// with grain pixel to the end of the walk. At most `max_frames`, always including the last.
inline constexpr int max_frames = 500;
[[nodiscard]] std::vector<int> animation_positions(const State& state);

/// All steps as one JSON object, `head` first. Printed in parts: a strip's may be hundreds of megabytes. Stops when
/// `print` fails.
[[nodiscard]] Result<void> write_steps_json(const Scene& scene, const Timeline& timeline,
                                            const nlohmann::ordered_json& head,
                                            const std::function<Result<void>(const std::string&)>& print);

}  // namespace raywalk
