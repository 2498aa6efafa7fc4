#include "app/drawing.h"

#include "app/idle_options.h"
#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "app/scene_lookup.h"
#include "render/beam_drawing.h"
#include "scene/effects.h"
#include "text/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace raywalk {

bool is_drawing(const std::string& image) {
  constexpr std::string_view ending = ".svg";
  if (image.size() <= ending.size()) return false;
  return std::equal(ending.begin(), ending.end(), image.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char a, char b) { return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b))); });
}

ExitCode render_drawing(const RenderOptions& options, const Scene& scene, ImageSize size) {
  if (integrator_of(scene) != Integrator::beams)
    return refuse({options.image, 0, 0, "only beams make a drawing of a picture (expected --integrator beams, or .png)",
                   "other integrators know pixels, not what lies between them"});
  if (options.share || options.statistics)
    return refuse({options.image, 0, 0,
                   fmt::format("a drawing has no {}", options.share ? "parts" : "statistics of rays"),
                   fmt::format("leave out {}", options.share ? "--part" : "--stats")});
  if (const auto claimed = claim_output(options.image); !claimed) return fail(claimed.error());
  if (!options.quiet) warn(idle_options("render", options, scene));
  const Interrupt interrupt(Patience::full);
  Result<BeamDrawing> drawing;
  {
    ProgressBar bar;
    BeamDrawingSettings settings;
    settings.size = size;
    settings.stop = interrupt.stop();
    if (!options.quiet) settings.progress = [&bar](const Progress& progress) { bar.show(progress); };
    drawing = beam_drawing(scene, settings);
  }
  if (!drawing) {
    drawing.error().file = options.image;
    return fail(drawing.error());
  }
  if (!drawing->finished) return fail({"", 0, 0, "interrupted; nothing was written", "the same command begins again"});
  if (const auto written = write_file_atomically(options.image, drawing->svg); !written) return fail(written.error());
  if (terminal_width() > 0 && !options.quiet)
    note(fmt::format("{}: {} x {}, {} polygons", options.image, size.width, size.height, drawing->polygons));
  return ExitCode::done;
}

}  // namespace raywalk
