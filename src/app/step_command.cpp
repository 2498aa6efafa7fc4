#include "app/step_command.h"

#include "app/idle_options.h"
#include "app/scene_lookup.h"
#include "app/texts.h"
#include "scene/beam_limits.h"
#include "scene/cone_limits.h"
#include "timeline/recorder.h"
#include "trace/outlines.h"
#include "trace/recursion.h"
#include "view/export/export.h"
#include "view/export/slides.h"
#include "view/text/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace raywalk {

namespace {

Result<void> print_json(const Scene& scene, const Timeline& timeline, const StepOptions& options) {
  nlohmann::ordered_json head{{"version", RAYWALK_VERSION},
                              {"scene", scene_path(options.scene)},
                              {"title", scene.title},
                              {"integrator", name_of(scene.render.integrator)},
                              {"depth", scene.limits.depth},
                              {"threshold", scene.limits.threshold},
                              {"precision", name_of(options.precision)},
                              {"numerics", name_of(scene.render.numerics)}};
  if (options.fault) head["fault"] = name_of(*options.fault);
  return write_steps_json(scene, timeline, head, [](const std::string& part) { return print(part); });
}

Result<void> print_text(const Scene& scene, const Timeline& timeline, Language language) {
  for (int position = 1; position <= timeline.steps(); ++position)
    if (const auto printed = print(step_text(scene, timeline, position, language) + "\n"); !printed) return printed;
  return {};
}

/// Why there is no such pixel.
std::optional<Error> why_no_pixel(const StepOptions& options, const Scene& scene, ImageSize size) {
  if (!options.pixel) return std::nullopt;
  const auto no_such = [](const std::string& what, const std::string& expected) {
    return Error{"", 0, 0, "raywalk step: --pixel: there is no " + what + " (expected " + expected + ")",
                 "pixels count from 0; N is a cell of the strip, X,Y a column and a row of the image"};
  };
  if (const auto* cell = std::get_if<Cell>(&*options.pixel)) {
    const int cells = scene.camera.screen.cells;
    if (cell->index < cells) return std::nullopt;
    return no_such(fmt::format("cell {}", cell->index), fmt::format("0 to {}", cells - 1));
  }
  const auto& pixel = std::get<ImagePixel>(*options.pixel);
  if (pixel.column < size.width && pixel.row < size.height) return std::nullopt;
  return no_such(fmt::format("pixel {},{}", pixel.column, pixel.row),
                 fmt::format("columns 0 to {}, rows 0 to {}", size.width - 1, size.height - 1));
}

Timeline record(const StepOptions& options, const Scene& scene, ImageSize size) {
  const Recording how{options.precision, {}, options.fault};
  if (!options.pixel) return record_strip(scene, how);
  if (const auto* cell = std::get_if<Cell>(&*options.pixel)) return record_cell(scene, cell->index, how);
  const auto& pixel = std::get<ImagePixel>(*options.pixel);
  return record_pixel(scene, size, pixel.column, pixel.row, how);
}

/// Why beams that are asked for cannot be walked.
std::optional<Error> why_no_beam(const StepOptions& options, const Scene& scene) {
  if (scene.render.integrator != Integrator::beams) return std::nullopt;
  const bool in_space = options.pixel && std::holds_alternative<ImagePixel>(*options.pixel);
  const std::string why = in_space ? why_no_space_beams(scene) : why_no_beams(scene);
  if (why.empty()) return std::nullopt;
  return Error{options.scene, 0, 0, "beams cannot be followed here: " + why, "--integrator whitted walks rays"};
}

/// Why cones that are asked for cannot be walked.
std::optional<Error> why_no_cone(const StepOptions& options, const Scene& scene) {
  if (scene.render.integrator != Integrator::cones) return std::nullopt;
  const std::string why = why_no_cones(scene);
  if (why.empty()) return std::nullopt;
  return Error{options.scene, 0, 0, "cones cannot be followed here: " + why, "--integrator distributed takes samples"};
}

/// Why a fault that is asked for breaks nothing here.
std::optional<Error> why_no_fault(const StepOptions& options, const Scene& scene) {
  if (!options.fault) return std::nullopt;
  if (options.numerics == Numerics::robust)
    return Error{options.scene, 0, 0, fmt::format("{} breaks naive numerics, not robust ones", name_of(*options.fault)),
                 "leave out --numerics"};
  const Integrator broken = integrator_of(*options.fault), own = scene.render.integrator;
  const bool of_tracer = broken == Integrator::automatic;
  const bool is_walked = of_tracer ? !traits_of(own).is_global && !traits_of(own).has_width : broken == own;
  if (is_walked) return std::nullopt;
  const Integrator its = of_tracer ? Integrator::whitted : broken;
  return Error{options.scene, 0, 0,
               fmt::format("{} breaks the integrator {}, and that of this scene is {}", name_of(*options.fault),
                           name_of(its), name_of(own)),
               fmt::format("--integrator {} walks the scene so", name_of(its))};
}

/// Those of the options that a render has, too.
RenderOptions as_of_render(const StepOptions& options) {
  RenderOptions same;
  same.depth = options.depth;
  same.threshold = options.threshold;
  same.path_length = options.path_length;
  same.numerics = options.numerics;
  same.epsilon = options.epsilon;
  return same;
}

/// More would fill about half a gigabyte.
constexpr double max_steps = 1'000'000;

/// About how many steps the first hits of all pixels take: each of a light's samples is two.
double steps_of_first_hits(const StepOptions& options, const Scene& scene) {
  double of_hit = 8;
  if (!draws_random(integrator_of(scene, 1)))
    for (const Light& light : scene.lights) of_hit += 2 * std::pow(light_grid_of(scene, light), 2);
  return of_hit * (options.pixel ? 1 : scene.camera.screen.cells);
}

/// Records to the scene's depth. The tree of a pixel can double with every level, so a deep limit is approached in
/// steps that cannot overshoot by much, and given up if the tree grows too large.
Result<Timeline> record_within_reason(const StepOptions& options, const Scene& scene, ImageSize size) {
  constexpr int harmless_depth = 5;
  constexpr double worst_growth = 4;  // two rays, their shadow rays and the lines between, per ray of the previous
                                      // level
  const double at_first = steps_of_first_hits(options, scene);
  if (at_first > max_steps)
    return tl::unexpected(
        Error{options.scene, 0, 0,
              fmt::format("the first hits alone take about {:.2g} steps (expected at most {:g})", at_first, max_steps),
              "walk one pixel with --pixel, or take fewer samples of a light with light_grid"});
  Scene limited = scene;
  const int feasible = 1 + static_cast<int>(std::log(max_steps / at_first) / std::log(worst_growth));
  limited.limits.depth = std::min({scene.limits.depth, feasible, harmless_depth});
  for (;;) {
    Timeline timeline = record(options, limited, size);
    if (!timeline.is_cut_off_by_depth() || limited.limits.depth == scene.limits.depth) return timeline;
    const double room = std::log(max_steps / timeline.steps_of_all_rays()) / std::log(worst_growth);
    if (room < 1) {
      return tl::unexpected(
          Error{options.scene, 0, 0,
                fmt::format("there are {:.0f} steps to depth {} already, too many to go on to depth {}",
                            timeline.steps_of_all_rays(), limited.limits.depth, scene.limits.depth),
                fmt::format("go less deep with --depth {}, or only for one pixel with --pixel", limited.limits.depth)});
    }
    limited.limits.depth = std::min(scene.limits.depth, limited.limits.depth + static_cast<int>(room));
  }
}

}  // namespace

ExitCode step_command(const StepOptions& options) {
  auto document = load_scene(options.scene);
  if (!document) return fail(document.error());
  Scene& scene = document->scene;
  scene.render.integrator = options.integrator.value_or(scene.render.integrator);
  if (options.path_length) scene.render.path_length = options.path_length;
  scene.limits.depth = options.depth.value_or(scene.limits.depth);
  scene.limits.threshold = options.threshold.value_or(scene.limits.threshold);
  scene.render.numerics = options.numerics.value_or(scene.render.numerics);
  scene.render.epsilon = options.epsilon.value_or(scene.render.epsilon);
  if (options.fault) scene.render.numerics = Numerics::naive;  // which the fault is injected into
  const ImageSize size = options.size.value_or(scene.image);
  if (const auto error = why_no_pixel(options, scene, size)) return refuse(*error);

  if (const auto error = why_no_fault(options, scene)) return refuse(*error);
  if (const auto error = why_no_beam(options, scene)) return fail(*error);
  if (const auto error = why_no_cone(options, scene)) return fail(*error);
  if (const auto error = why_too_deep(scene.limits.depth)) return fail(*error);
  if (const auto error = why_no_room(scene, scene_path(options.scene), options.precision)) return fail(*error);
  warn(idle_options("step", as_of_render(options), scene));
  Result<Timeline> recorded = record_within_reason(options, scene, size);
  if (!recorded) return fail(recorded.error());
  const auto kept = std::make_shared<const Timeline>(std::move(*recorded));
  const Timeline& timeline = *kept;
  if (options.format == StepFormat::html && timeline.steps() > max_slides)
    return fail({options.scene, 0, 0,
                 fmt::format("{} steps are too many for a page (expected at most {})", timeline.steps(), max_slides),
                 "take one pixel with --pixel, or go less deep with --depth"});
  const auto language = [&] {
    warn_of_broken_texts();
    return options.language.value_or(texts().languages->english());
  };
  const auto printed = [&] {
    switch (options.format) {
      case StepFormat::text:
        return print_text(scene, timeline, language());
      case StepFormat::json:
        return print_json(scene, timeline, options);
      case StepFormat::html:
        return print(slides_page(scene, kept, language(), Theme::projector, document->ink));
      case StepFormat::svg:
        return print(plan_picture(scene, kept, language(), Theme::projector, document->ink));
    }
    return Result<void>();
  }();
  return printed ? ExitCode::done : fail(printed.error());
}

}  // namespace raywalk
