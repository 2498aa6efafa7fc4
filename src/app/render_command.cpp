#include "app/render_command.h"

#include "app/drawing.h"
#include "app/idle_options.h"
#include "app/interrupt.h"
#include "app/part_file.h"
#include "app/progress_bar.h"
#include "app/scene_lookup.h"
#include "app/statistics_json.h"
#include "image/image_file.h"
#include "image/quick_image.h"
#include "scene/beam_limits.h"
#include "scene/cone_limits.h"
#include "scene/warnings.h"
#include "text/file.h"
#include "trace/dipole_limits.h"
#include "trace/patches.h"
#include "trace/photon_limits.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace raywalk {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::optional<Error> why_too_large(ImageSize size) {
  if (!has_too_many_pixels(size)) return std::nullopt;
  return Error{
      "", 0, 0,
      fmt::format("an image of {} x {} pixels is too large (expected at most {} pixels, such as 16384 x 16384)",
                  size.width, size.height, max_image_pixels),
      "choose a smaller size with --size"};
}

/// Says what this picture will lack.
void warn_of_losses(const std::vector<std::string>& losses) {
  for (const std::string& loss : collected(losses)) note("raywalk render: warning: " + loss);
}

/// A partial image is written to a separate file: the old image stays intact.
ExitCode keep_partial(const RenderOptions& options, const Rendering& rendering, Encoding encoding) {
  const std::string interrupted = fmt::format("interrupted with {:.1f}% done", rendering.done * 100);
  if (rendering.done == 0) return fail({"", 0, 0, "interrupted before anything was done; nothing was written", ""});
  const auto path = new_partial_file(options.image);
  constexpr double soon_written = 1.5e7;  // pixels
  const ImageRows rows = rendering.rows();
  if (static_cast<double>(rows.width) * rows.height > soon_written)
    note("interrupted; writing what is done (once more gives that up)");
  const auto written = path.and_then([&](const std::string& to) { return write_image_quickly(to, rows, encoding); });
  if (!written) {
    note(interrupted);
    std::error_code ignored;
    if (path) fs::remove(*path, ignored);
    return fail(written.error());
  }
  return fail({"", 0, 0, interrupted + ", which is in " + *path, "what is missing there is black"});
}

/// A file's checksum, or why it cannot be read again.
Result<std::string> sum_of(const std::string& path) {
  constexpr std::size_t most = std::size_t{1} << 34;
  return read_file(path, most).map([](const std::string& bytes) { return checksum(bytes); });
}

/// What decides the picture, in words (PicturePart::made_from).
Result<std::vector<std::pair<std::string, std::string>>> made_from(const SceneDocument& document,
                                                                   const RenderReport& report,
                                                                   const RenderOptions& options) {
  const Scene& scene = document.scene;
  const auto text = format_scene(scene);
  if (!text) return tl::unexpected(text.error());
  const Sampling& sampling = report.sampling;
  std::vector<std::pair<std::string, std::string>> all{
      {"version", RAYWALK_VERSION},
      {"size", fmt::format("{}x{}", report.size.width, report.size.height)},
      {"precision", std::string(name_of(report.precision))},
      {"spp", fmt::format("{}", sampling.per_pixel)},
      {"seed", fmt::format("{}", sampling.seed)},
      {"corner samples", sampling.corners ? "yes" : "no"},
      {"integrator", std::string(name_of(scene.render.integrator))},
      {"depth", fmt::format("{}", scene.limits.depth)},
      {"the checksum of the scene with its options", checksum(*text)}};
  if (scene.render.numerics == Numerics::naive) {
    // They may lose what a structure's boxes leave out.
    all.emplace_back("accel", name_of(options.accelerator));
    all.emplace_back("build", name_of(options.build));
  }
  for (const std::string& file : document.files) {
    // Of a scene of our own format the text above says all; a comment changes no picture.
    if (file == document.path && scene_format_of(file) == SceneFormat::toml) continue;
    auto sum = sum_of(file);
    if (!sum) return tl::unexpected(sum.error());
    all.emplace_back("the checksum of " + std::filesystem::path(file).filename().string(), std::move(*sum));
  }
  return all;
}

std::string summary(const std::string& image, const Rendering& rendering, ImageSize size) {
  const Statistics& statistics = rendering.statistics;
  std::uint64_t rays = 0;
  for (const std::uint64_t formed : statistics.rays) rays += formed;
  std::string text = fmt::format("{}: {} x {} pixels, {} rays, {:.2f} s in {} thread{}", image, size.width, size.height,
                                 rays, rendering.trace_seconds, rendering.threads, rendering.threads == 1 ? "" : "s");
  if (rendering.threads > 1) text += fmt::format(", {:.2f} of them busy", rendering.busy_threads());
  const TestCounts& tests = statistics.tests;
  if (rays > 0 && tests.nodes > 0)
    text += fmt::format(", {:.1f} nodes and {:.1f} primitives a ray",
                        static_cast<double>(tests.nodes) / static_cast<double>(rays),
                        static_cast<double>(tests.primitives) / static_cast<double>(rays));
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

Result<std::string> new_partial_file(const std::string& image) {
  const std::size_t dot = image.find_last_of('.');
  const std::string name = image.substr(0, dot) + ".partial", ending = image.substr(dot);
  constexpr int most = 10000;
  for (int i = 1; i < most; ++i) {
    const std::string path = name + (i == 1 ? "" : "-" + std::to_string(i)) + ending;
    const auto made = make_new_file(path);
    if (!made) return tl::unexpected(made.error());
    if (*made) return path;
  }
  return tl::unexpected(Error{name + ending, 0, 0, fmt::format("there are {} of this name already", most),
                              "remove those that you do not need"});
}

ExitCode fail_if_not_finite(const std::string& image, std::size_t pixels, std::uint64_t samples) {
  if (samples == 0 && pixels == 0) return ExitCode::done;
  const std::string which =
      samples > 0 ? fmt::format("{} samples and {} pixels", samples, pixels) : fmt::format("{} pixels", pixels);
  return fail(
      {image, 0, 0,
       which + " are no finite number in a picture's file (a PNG shows NaN in magenta, what is infinite as white)",
       "colours or strengths of this scene may be too large to add up"});
}

ExitCode render_command(const RenderOptions& options) {
  const auto load_start = Clock::now();
  // Warnings are not errors: the picture is the requested one.
  auto document = load_scene(options.scene, options.quiet ? SceneWarnings::kept : SceneWarnings::said);
  if (!document) return fail(document.error());
  Scene& scene = document->scene;
  scene.limits.depth = options.depth.value_or(scene.limits.depth);
  scene.limits.threshold = options.threshold.value_or(scene.limits.threshold);
  RenderChoices& choices = scene.render;
  choices.integrator = options.integrator.value_or(choices.integrator);
  const std::string samples_instead = "--integrator distributed --spp 64 takes samples instead";
  if (const std::string why = why_no_cones(scene); choices.integrator == Integrator::cones && !why.empty())
    return fail({scene_path(options.scene), 0, 0, "cones cannot be followed here: " + why, samples_instead});
  if (const std::string why = why_no_space_beams(scene); choices.integrator == Integrator::beams && !why.empty()) {
    if (options.integrator || is_drawing(options.image))
      return fail({scene_path(options.scene), 0, 0, "beams cannot be followed here: " + why, samples_instead});
    // A scene that is walked by beams in the plan may have a picture of rays.
    if (!options.quiet)
      note("raywalk render: warning: rays make this picture, for beams cannot be followed here: " + why);
  }
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
  if (is_drawing(options.image)) return render_drawing(options, scene, size);
  const std::string image = options.share ? part_path(options.image, *options.share) : options.image;
  if (const auto claimed = claim_output(image); !claimed) return fail(claimed.error());
  PicturePart part;
  if (options.share) {
    auto from = made_from(*document, report, options);
    if (!from) return fail(from.error());
    part.made_from = std::move(*from);
  }
  if (options.statistics)
    if (const auto claimed = claim_output(*options.statistics); !claimed) return fail(claimed.error());
  if (!options.quiet) warn(idle_options("render", options, scene));
  if (!options.quiet) {
    if (cuts_patches(scene)) warn_of_losses(patch_losses(scene));
    warn_of_losses(dipole_losses(scene));
    warn_of_losses(photon_losses(scene));
  }

  const Interrupt interrupt(Patience::full);
  Result<Rendering> rendering;
  {
    ProgressBar bar;
    RenderSettings settings{size, sampling, options.precision, options.accelerator};
    settings.build = options.build;
    settings.threads = options.threads;
    settings.tolerance = choices.tolerance;
    settings.shadow_cache = options.shadow_cache;
    settings.share = options.share;
    if (!options.quiet) settings.progress = [&bar](const Progress& progress) { bar.show(progress); };
    settings.stop = interrupt.stop();
    if (!options.quiet) settings.endless = [](const TreeSize& tree) { note(endless_text(tree)); };
    rendering = render(scene, settings);
  }
  if (!rendering) return fail(rendering.error());
  if (!rendering->finished && options.share)
    return fail({"", 0, 0,
                 fmt::format("interrupted with {:.1f}% of the part done; nothing was written", rendering->done * 100),
                 "the same command renders it once more"});
  if (!rendering->finished) return keep_partial(options, *rendering, scene.encoding);

  const auto write_start = Clock::now();
  if (options.share) {
    part.share = *options.share;
    part.corners = sampling.corners;
    part.encoding = scene.encoding;
    part.size = std::visit([](const auto& film) { return film.size(); }, rendering->film);
    part.film = std::move(rendering->film);
    if (const auto written = write_part(image, part); !written) return fail(written.error());
  } else if (const auto written = write_image(image, rendering->image(), scene.encoding); !written) {
    return fail(written.error());
  }
  report.write_seconds = seconds_since(write_start);
  if (options.statistics)
    if (const auto written = write_file_atomically(*options.statistics, statistics_json(*rendering, report)); !written)
      return fail(written.error());
  if (terminal_width() > 0 && !options.quiet) note(summary(image, *rendering, size));
  if (options.share) return ExitCode::done;  // of the whole, merge says what is no number
  return fail_if_not_finite(options.image, rendering->not_finite_pixels, rendering->statistics.not_finite);
}

}  // namespace raywalk
