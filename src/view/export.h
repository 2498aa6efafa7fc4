#pragma once
// A walk written down for those who do not have the program: what a file holds, the ending of its name says.

#include "io/error.h"
#include "scene/scene.h"
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
  film,        ///< .gif: the window, a frame a step
  plan,        ///< .svg: the plan
  slides,      ///< .html: a page that steps offline
  transcript,  ///< .txt
  steps,       ///< .json
  script,      ///< .script.html: the open lesson as its presenter reads it
};
struct ExportEnding {
  std::string_view ending;  ///< ".png"
  ExportKind kind;
};
inline constexpr std::array<ExportEnding, 7> kinds_of_export{{{".html", ExportKind::slides},
                                                              {".png", ExportKind::picture},
                                                              {".gif", ExportKind::film},
                                                              {".svg", ExportKind::plan},
                                                              {".txt", ExportKind::transcript},
                                                              {".json", ExportKind::steps},
                                                              {".script.html", ExportKind::script}}};
/// By the ending of a path; none for other endings.
[[nodiscard]] std::optional<ExportKind> export_kind_of(std::string_view path);
/// The path with the ending of this kind in place of the one that it has.
[[nodiscard]] std::string with_ending(const std::string& path, ExportKind kind);

/// What only the window can write, until it has.
struct WindowExport {
  ExportKind kind;  ///< picture or film
  std::string path;
  friend bool operator==(const WindowExport&, const WindowExport&) = default;
};

/// The positions that a film shows: from here to the end of the pixel under way, by lines or rays as the grain says;
/// with the grain of pixels to the end of the walk. At most `most_frames`, the last one always.
inline constexpr int most_frames = 500;
[[nodiscard]] std::vector<int> film_positions(const State& state);

namespace action {
struct AskExport {};
struct Export {
  std::string path;
};  ///< its ending says what
struct FinishExport {
  std::string why_not;
};  ///< the window has written what it was asked for, or says why not
}  // namespace action

/// All steps as one JSON object, `head` first. Handed over in parts as they are put together: a strip's may be hundreds
/// of megabytes. Stops when `print` fails.
[[nodiscard]] Result<void> write_steps_json(const Scene& scene, const Timeline& timeline,
                                            const nlohmann::ordered_json& head,
                                            const std::function<Result<void>(const std::string&)>& print);

namespace detail {
void export_walk(State& state, const std::string& path);
/// Whatever stands at the path is written over.
void export_over(State& state, const std::string& path);
void finish_export(State& state, const std::string& why_not);
}  // namespace detail

}  // namespace raywalk
