#include "app/info_command.h"

#include "app/interrupt.h"
#include "app/progress_bar.h"
#include "app/scene_lookup.h"
#include "io/key_reference.h"
#include "scene/effects.h"
#include "scene/warnings.h"
#include "text/spelling.h"
#include "trace/dipole_limits.h"
#include "trace/photon_limits.h"
#include "trace/radiosity_kernel.h"
#include "trace/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace raywalk {

namespace {

/// "2 flat polygons", "1 hyperboloid of two sheets".
std::string count_of(std::size_t count, std::string_view what) {
  constexpr std::string_view hyperboloid = "hyperboloid";  // behind it the name says of how many sheets
  std::string words(what.substr(0, what.starts_with(hyperboloid) ? hyperboloid.size() : what.size()));
  const bool hisses = words.ends_with('x') || words.ends_with("sh");
  if (count != 1) words += hisses ? "es" : "s";
  if (what.starts_with(hyperboloid)) words += " of" + std::string(what.substr(hyperboloid.size()));
  std::replace(words.begin(), words.end(), '_', ' ');
  return fmt::format("{} {}", count, words);
}

/// "2 spheres, 1 plane", in order of first occurrence.
std::string counts_of(const std::vector<std::string>& kinds) {
  std::string text;
  std::vector<std::string> named;
  for (const std::string& kind : kinds) {
    if (std::find(named.begin(), named.end(), kind) != named.end()) continue;
    named.push_back(kind);
    const auto count = static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), kind));
    text += (text.empty() ? "" : ", ") + count_of(count, kind);
  }
  return text.empty() ? "none" : text;
}

std::string row(std::string_view name, std::string_view value) { return fmt::format("{:<17} {}\n", name, value); }

std::string point(const Vec3d& p) { return fmt::format("({:g}, {:g}, {:g})", p.x, p.y, p.z); }

/// How the cells of the strip lie in the image.
std::string cells_text(const Scene& scene) {
  const int cells = scene.camera.screen.cells, width = scene.image.width;
  const int multiple = width / cells;
  if (width % cells == 0 && multiple % 2 == 1 && scene.image.height % 2 == 1)
    return count_of(static_cast<std::size_t>(cells), "cell") +
           (multiple == 1 ? ", the pixels of the image's middle row"
                          : fmt::format(", each the middle one of {} pixels in the image's middle row", multiple));
  return count_of(static_cast<std::size_t>(cells), "cell") +
         "; they are no pixels of this image (for that its width is an odd multiple of the cells and its height odd)";
}

/// Describes each accelerator over the scene's primitives; for large scenes only the chosen one.
std::string structures_text(const Scene& scene, const World<double>& chosen) {
  constexpr double few = 20000;
  const AcceleratorKind automatic = chosen.accelerator.kind();
  std::string text = fmt::format(
      "\nstructures over {}; {} is chosen\n",
      count_of(static_cast<std::size_t>(chosen.accelerator.primitives().size()), "primitive"), name_of(automatic));
  text += fmt::format("  {:<15} {:>9} {:>6} {:>11} {:>11} {:>9} {:>8}\n", "", "nodes", "depth", "references", "bytes",
                      "build ms", "SAH cost");
  for (const AcceleratorKind kind : values_of<AcceleratorKind>) {
    const bool shown = kind == automatic || (kind != AcceleratorKind::automatic && entries_of(scene.objects) <= few);
    if (!shown) continue;
    const AcceleratorStatistics s = (kind == automatic ? chosen : World<double>(scene, kind)).accelerator.statistics();
    text += fmt::format("  {:<15} {:>9} {:>6} {:>11} {:>11} {:>9.2f}", name_of(kind), s.nodes, s.depth, s.references,
                        s.bytes, 1000 * s.build_seconds);
    text += s.expected_cost > 0 ? fmt::format(" {:>8.2f}\n", s.expected_cost) : "\n";
  }
  return text;
}

/// "distributed, 16 samples per pixel, jittered".
std::string render_text(const Scene& scene) {
  const RenderChoices& choices = scene.render;
  const Integrator taken = integrator_of(scene, choices.samples);
  const bool chosen = taken == choices.integrator;
  std::string text(name_of(taken));
  text += chosen ? "" : ", as what it holds calls for";
  if (choices.samples > 1) text += fmt::format(", {} samples a pixel, {}", choices.samples, name_of(choices.sampler));
  if (!chosen && choices.integrator == Integrator::beams) text += "; beams in the plan";
  if (choices.integrator == Integrator::path && choices.path_length)
    text += fmt::format(", at most {} a path", count_of(static_cast<std::size_t>(*choices.path_length), "ray"));
  if (choices.integrator == Integrator::photons) {
    const PhotonChoices& photons = choices.photons;
    text += fmt::format(", {} photons{}, {} nearest{}", photons.count, photons.progressive ? " a sample" : "",
                        photons.nearest, photons.gather ? ", final gathering" : "");
  }
  if (cuts_patches(scene))
    text += fmt::format(", {}until {:g} of the light is unshot",
                        choices.integrator == Integrator::radiosity ? "" : "ambient light by radiosity ",
                        choices.radiosity.tolerance);
  if (choices.integrator == Integrator::path && choices.subsurface == Subsurface::dipole)
    text += ", light inside by the dipole";
  if (choices.tolerance > 0) text += fmt::format(", fewer where known to {:g}", choices.tolerance);
  if (choices.numerics == Numerics::naive) text += fmt::format(", naive numerics with epsilon {:g}", choices.epsilon);
  return text;
}

/// What radiosity makes of the scene, and what it refuses or leaves out.
std::string patches_text(const Scene& scene) {
  std::string text = "\npatches\n";
  if (const auto error = why_no_patches(scene))
    return text + row("  refused", error->message) + row("  instead", error->hint);
  const int count = Patches(scene, radiosity_settings_of(scene).patches).size();
  text += row("  count", std::to_string(count));
  text += row("  memory", fmt::format("at most {:.1f} MB of form factors", 16e-6 * count * count));
  for (const std::string& loss : collected(patch_losses(scene))) text += row("  left out", loss);
  return text;
}

/// What SCREEN shows of a planar scene.
std::string strip_text(const Scene& scene) {
  switch (integrator_of(scene)) {
    case Integrator::photons:
    case Integrator::radiosity:
    case Integrator::beams:
    case Integrator::cones:
      return "the strip is of a flat world, endless along z, which the image is not";
    case Integrator::automatic:
    case Integrator::cast:
    case Integrator::whitted:
    case Integrator::distributed:
    case Integrator::path:
    case Integrator::pencils:
      break;
  }
  return scene.render.samples == 1 ? "the strip is the middle row of the image"
                                   : "the strip is the middle row of the image with one sample a pixel";
}

}  // namespace

std::string info_text(const Scene& scene, const std::string& path) {
  std::string text = path + "\n";
  if (!scene.title.empty()) text += row("title", scene.title);
  if (!scene.description.empty()) text += row("description", scene.description);

  const std::string slanted = why_not_planar(scene);
  text += row("planar", slanted.empty() ? "yes: " + strip_text(scene) : "no: " + slanted);
  text += row("eye", point(scene.camera.eye) + ", looking at " + point(scene.camera.look_at));
  text += row("image", fmt::format("{} x {} pixels", scene.image.width, scene.image.height));
  text += row("screen", cells_text(scene));
  text += row("render", render_text(scene));
  text += row("limits", fmt::format("depth {}, threshold {:g}", scene.limits.depth, scene.limits.threshold));

  std::vector<std::string> kinds;
  for (const Object& object : scene.objects) kinds.emplace_back(shape_name(object.shape));
  text += row("objects", counts_of(kinds));
  kinds.assign(scene.groups.size(), "group");
  if (!kinds.empty()) text += row("groups", counts_of(kinds));
  kinds.clear();
  for (const Light& light : scene.lights)
    kinds.push_back(std::visit([](const auto& kind) { return std::string(light_name(kind)) + " light"; }, light.kind));
  text += row("lights", counts_of(kinds));

  text += "\neffects\n";
  const Effects effects = effects_of(scene, scene.render.samples);
  const World<double> world(scene);
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    const EffectUse& use = effects[effect];
    text += row("  " + std::string(name_of(effect)), (use.used ? "used: " : "") + use.why);
    if (effect == Effect::refraction && !world.bodies.empty())
      text += row("", "bodies may lie in one another or hold the eye: rays know all that they are inside of");
  }
  if (const std::vector<std::string> losses = collected(dipole_losses(scene)); !losses.empty()) {
    text += "\ndipole\n";
    for (const std::string& loss : losses) text += row("  wrong", loss);
  }
  if (const std::vector<std::string> losses = collected(photon_losses(scene)); !losses.empty()) {
    text += "\nphotons\n";
    for (const std::string& loss : losses) text += row("  left out", loss);
  }
  if (cuts_patches(scene)) text += patches_text(scene);
  return text + structures_text(scene, world);
}

std::string cost_text(const study::SceneCost& cost) {
  const auto percent = [](double share) { return fmt::format("{:.0f}%", std::round(100 * share) + 0.0); };
  const auto rays = [](const study::Cost& of) { return static_cast<double>(of.rays); };
  std::string text = fmt::format("\ncost of each effect, by {} x {} pixels with and without it ({} times in turns)\n",
                                 cost.size.width, cost.size.height, cost.repetitions);
  text += fmt::format("  {:<15} {:>9} {:>9}   {}\n", "", "of rays", "of time", "95% interval of the time");
  for (const study::EffectCost& e : cost.effects)
    text += fmt::format("  {:<15} {:>9} {:>9}   {} to {}\n", name_of(e.effect), percent(e.rays_share),
                        percent(e.seconds_share), percent(e.seconds_low), percent(e.seconds_high));
  if (cost.whole.rays > 0)
    text += fmt::format("  {:<15} {:>9}             of all rays; lights without shadows are not to be had\n",
                        "shadow rays", percent(static_cast<double>(cost.shadow_rays) / rays(cost.whole)));
  text += fmt::format("  {:<15} {} rays, {:.3g} s\n", "all together", cost.whole.rays, cost.whole.seconds);
  if (const auto& everything = cost.everything)
    text += fmt::format("  {:<15} {} rays, {:.3g} s: {:.3g} times the rays, {:.3g} times the time\n", "regardless",
                        everything->rays, everything->seconds, rays(*everything) / std::max(1.0, rays(cost.whole)),
                        everything->seconds / std::max(cost.whole.seconds, 1e-9));
  else
    text += fmt::format("  {:<15} not measured: its rays double at every depth, and the scene's exceeds {}\n",
                        "regardless", study::deepest_everything);
  return text +
         fmt::format(
             "Shares overlap: what one effect sends out, another one multiplies. \"regardless\" is a tracer that does\n"
             "not ask what the scene calls for: at every hit both a reflect and a refract ray, each drawn from a "
             "lobe,\n"
             "{0} x {0} shadow rays to every lamp; for every primary ray a point of the lens and a moment of the "
             "shutter.\n",
             cost.everything_grid);
}

namespace {

ExitCode print_or_fail(const std::string& text) {
  const auto printed = print(text);
  return printed ? ExitCode::done : fail(printed.error());
}

/// The reference of the tables of this name, or of all.
ExitCode print_keys(const std::string& name) {
  std::vector<KeyTable> tables = key_tables();
  if (name.empty()) return print_or_fail(reference_text(tables));
  std::vector<std::string_view> names;
  for (const KeyTable& table : tables)  // a kind of table has an entry for each of its places
    if (std::find(names.begin(), names.end(), table.name) == names.end()) names.push_back(table.name);
  const std::string nearest = nearest_word(name, names);
  Error unknown{"", 0, 0, fmt::format("there are no keys of \"{}\" (expected {})", name, one_of(names)),
                nearest.empty() ? "raywalk info --keys explains them all" : "did you mean " + nearest + "?"};
  std::erase_if(tables, [&](const KeyTable& table) { return table.name != name; });
  return tables.empty() ? refuse(unknown) : print_or_fail(reference_text(tables));
}

}  // namespace

ExitCode info_command(const InfoOptions& options) {
  if (options.keys) return print_keys(*options.keys);
  auto document = load_scene(options.scene);
  if (!document) return fail(document.error());
  RenderChoices& choices = document->scene.render;
  choices.integrator = options.integrator.value_or(choices.integrator);
  choices.samples = options.samples.value_or(choices.samples);
  if (options.path_length) choices.path_length = options.path_length;
  if (options.light_grid) choices.light_grid = options.light_grid;
  const std::string path = scene_path(options.scene);
  if (const auto error = why_no_room(document->scene, path, Precision::double_)) return fail(*error);
  std::string text = info_text(document->scene, path);
  if (options.with_cost) {
    const Interrupt interrupt(Patience::brief);
    std::optional<study::SceneCost> cost;
    {
      ProgressBar bar;
      constexpr int samples = 8000, repetitions = 7;
      const auto show = [&bar](double done) {
        Progress progress{};
        progress.done = done;
        bar.show(progress);
      };
      cost = study::scene_cost(document->scene, samples, repetitions, show, interrupt.stop());
    }
    if (!cost) return fail({"", 0, 0, "interrupted before all was measured", ""});
    text += cost_text(*cost);
  }
  return print_or_fail(text);
}

}  // namespace raywalk
