#include "app/render_command.h"

#include "app/idle_options.h"
#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "app/scene_lookup.h"
#include "app/statistics_json.h"
#include "io/file.h"
#include "io/image.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace raywalk {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// What a scene file may ask for (io/scene_file.cpp), and a PNG's encoder take.
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;

std::optional<Error> why_too_large(ImageSize size) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  if (pixels <= most_pixels) return std::nullopt;
  return Error{
      "", 0, 0,
      fmt::format("an image of {} x {} pixels is too large (expected at most {} pixels, such as 16384 x 16384)",
                  size.width, size.height, most_pixels),
      "choose a smaller size with --size"};
}

/// What is done of an interrupted render goes into a file of its own: the old image stays whole.
ExitCode keep_partial(const RenderOptions& options, const Rendering& rendering, Encoding encoding) {
  const std::string interrupted = fmt::format("interrupted with {:.1f}% done", rendering.done * 100);
  if (rendering.done == 0) return fail({"", 0, 0, "interrupted before anything was done; nothing was written", ""});
  const std::string path = partial_path(options.image);
  if (const auto written = write_image(path, rendering.image(), encoding); !written) {
    note(interrupted);
    return fail(written.error());
  }
  return fail({"", 0, 0, interrupted + ", which is in " + path, "what is missing there is black"});
}

std::string summary(const RenderOptions& options, const Rendering& rendering, ImageSize size) {
  const Statistics& statistics = rendering.statistics;
  std::uint64_t rays = 0;
  for (const std::uint64_t formed : statistics.rays) rays += formed;
  std::string text =
      fmt::format("{}: {} x {} pixels, {} rays, {:.2f} s in {} thread{}", options.image, size.width, size.height, rays,
                  rendering.trace_seconds, rendering.threads, rendering.threads == 1 ? "" : "s");
  if (rendering.threads > 1) text += fmt::format(", {:.2f} of them busy", rendering.busy_threads());
  return text;
}

std::string endless_text(const TreeSize& tree) {
  std::string text = fmt::format(
      "warning: a single pixel may take about {:.0e} rays: to depth {}, its ray tree grows {:.1f} times a level",
      tree.rays, tree.depth, tree.growth);
  if (tree.shadow_rays > 1) text += fmt::format(", every hit sends out {} shadow rays", tree.shadow_rays);
  if (tree.samples > 1) text += fmt::format(", and all that for {} samples", tree.samples);
  return text + fmt::format("; lower --depth{}, or raise --threshold", tree.samples > 1 ? " or --spp" : "");
}

}  // namespace

std::string partial_path(const std::string& image) {
  const std::size_t dot = image.find_last_of('.');
  return image.substr(0, dot) + ".partial" + image.substr(dot);
}

std::optional<Error> why_not_writable(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) return Error{path, 0, 0, "cannot write: it is a folder", "give the name of a file"};
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0)
    return Error{path, 0, 0, "cannot write: " + system_message(errno), "choose another name, or make it writable"};
  if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;  // written in its place
  // A link that leads nowhere is written where it points to.
  const fs::path target = fs::weakly_canonical(path, ignored);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  if (!fs::is_directory(folder, ignored))
    return Error{path, 0, 0, "cannot write: there is no folder " + folder.string(), "make it first, or check the path"};
  std::string probe = (folder / ".raywalk-XXXXXX").string();
  const int descriptor = mkstemp(probe.data());
  if (descriptor < 0)
    return Error{path, 0, 0, "cannot write into " + folder.string() + ": " + system_message(errno),
                 "choose a folder that you may write to"};
  close(descriptor);
  unlink(probe.c_str());
  return std::nullopt;
}

ExitCode render_command(const RenderOptions& options) {
  const auto load_start = Clock::now();
  // A warning is nothing that went wrong: the picture is the one that was asked for.
  auto document = load_scene(options.scene, options.quiet ? SceneWarnings::kept : SceneWarnings::said);
  if (!document) return fail(document.error());
  Scene& scene = document->scene;
  scene.limits.depth = options.depth.value_or(scene.limits.depth);
  scene.limits.threshold = options.threshold.value_or(scene.limits.threshold);
  RenderChoices& choices = scene.render;
  choices.integrator = options.integrator.value_or(choices.integrator);
  choices.samples = options.corner_samples ? 1 : options.samples.value_or(choices.samples);
  choices.sampler = options.sampler.value_or(choices.sampler);
  choices.numerics = options.numerics.value_or(choices.numerics);
  choices.epsilon = options.epsilon.value_or(choices.epsilon);
  if (options.light_grid) choices.light_grid = options.light_grid;
  if (options.path_length) choices.path_length = options.path_length;
  choices.tolerance = options.tolerance.value_or(choices.tolerance);
  const Sampling sampling{choices.samples, options.seed.value_or(0), options.corner_samples};
  const ImageSize size = options.size.value_or(scene.image);
  RenderReport report{
      scene_path(options.scene), options.image, size, sampling, choices, scene.limits, options.precision,
      seconds_since(load_start)};
  if (const auto error = why_too_large(size)) return refuse(*error);
  for (const std::string& path : {options.image, options.statistics})
    if (const auto error = path.empty() ? std::nullopt : why_not_writable(path)) return fail(*error);
  if (!options.quiet) warn(idle_options(options, scene));

  const Interrupt interrupt(Patience::full);
  Result<Rendering> rendering;
  {
    ProgressBar bar;
    RenderSettings settings{size, sampling, options.precision, options.accelerator};
    settings.threads = options.threads;
    settings.tolerance = choices.tolerance;
    settings.shadow_cache = options.shadow_cache;
    if (!options.quiet) settings.progress = [&bar](const Progress& progress) { bar.show(progress); };
    settings.stop = interrupt.stop();
    if (!options.quiet) settings.endless = [](const TreeSize& tree) { note(endless_text(tree)); };
    rendering = render(scene, settings);
  }
  if (!rendering) return fail(rendering.error());
  if (!rendering->finished) return keep_partial(options, *rendering, scene.encoding);

  const auto write_start = Clock::now();
  if (const auto written = write_image(options.image, rendering->image(), scene.encoding); !written)
    return fail(written.error());
  report.write_seconds = seconds_since(write_start);
  if (!options.statistics.empty())
    if (const auto written = write_file_atomically(options.statistics, statistics_json(*rendering, report)); !written)
      return fail(written.error());
  if (terminal_width() > 0 && !options.quiet) note(summary(options, *rendering, size));
  if (rendering->statistics.not_finite > 0)
    return fail(
        {options.image, 0, 0,
         fmt::format("{} samples are no finite number (a PNG shows NaN in magenta)", rendering->statistics.not_finite),
         "colours or strengths of this scene may be too large to add up"});
  return ExitCode::done;
}

}  // namespace raywalk
