// The command line. Commands that share options are declared here, others beside what they do.
#include "app/program.h"

#include "app/check_command.h"
#include "app/compare_command.h"
#include "app/file_commands.h"
#include "app/info_command.h"
#include "app/lesson_command.h"
#include "app/merge_command.h"
#include "app/misuse.h"
#include "app/names.h"
#include "app/options.h"
#include "app/render_command.h"
#include "app/step_command.h"
#include "app/study_command.h"
#include "app/texts.h"
#include "app/window_command.h"
#include "math/stop.h"
#include "render/adaptive.h"
#include "scene/schema_kinds.h"
#include "text/file_ledger.h"
#include "view/action_text.h"
#include "view/appearance/room.h"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace raywalk {

namespace {

void add_precision(CLI::App& command, Precision& target) {
  add_choice<Precision>(command, "--precision", target, "Numbers of 24 or of 53 bits (double when left out)");
}

void add_numerics(CLI::App& command, std::optional<Numerics>& numerics, std::optional<double>& epsilon) {
  add_choice<Numerics>(command, "--numerics", numerics,
                       "How crossings are computed: with error bounds and exact arithmetic, or as books print it");
  add_parsed(command, "--epsilon", epsilon, parse_amount, "X", "a number that is 0 or more",
             "How far off a surface rays start with naive numerics, in scene units");
}

void add_limits(CLI::App& command, std::optional<int>& depth, std::optional<double>& threshold) {
  constexpr auto range = schema::depth_count;
  add_whole(command, "--depth", depth, range.low, range.high, "The deepest SHADE; the primary ray's is 1");
  // Above 1 it would end all rays after the first hit, which is --depth 1.
  add_parsed(command, "--threshold", threshold, parse_share, "X", "a number from 0 to 1",
             "A ray that would bring less than this share of its pixel is not formed");
}

void add_integrator(CLI::App& command, std::optional<Integrator>& integrator, std::optional<int>& path_length) {
  add_choice<Integrator>(command, "--integrator", integrator,
                         "How light is followed: shadows only, mirrors and glass too, soft effects, or everywhere");
  constexpr auto range = schema::path_length_count;
  add_whole(command, "--path-length", path_length, range.low, range.high,
            "With --integrator path: most rays between the eye and a light");
}

void add_samples(CLI::App& command, std::optional<int>& samples) {
  constexpr auto range = schema::sample_count;
  add_whole(command, "--spp", samples, range.low, range.high, "Samples of each pixel");
}

void add_light_grid(CLI::App& command, std::optional<int>& light_grid) {
  constexpr auto points = schema::light_grid_count;
  add_whole(command, "--light-grid", light_grid, points.low, points.high,
            "Of a light with an extent, N x N points are tried from every hit");
}

void add_size(CLI::App& command, std::optional<ImageSize>& size) {
  const std::string most = std::to_string(schema::pixel_count.high);
  add_parsed(command, "--size", size, parse_size, "WxH", "two whole numbers up to " + most + ", such as 640x480",
             "Pixels of the image");
}

void declare_render(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("render", "Render the scene's 3-D image to a file");
  const auto options = std::make_shared<RenderOptions>();
  RenderOptions& to = *options;
  command.add_option("SCENE", to.scene, scene_help)->required()->type_name("");
  add_image(command, to.image,
            "The picture: .png (8-bit), .pfm or .exr (linear float); with --integrator beams also .svg, polygons", true)
      ->required();
  add_size(command, to.size);
  constexpr int max_threads = 1024;
  add_integrator(command, to.integrator, to.path_length);
  add_samples(command, to.samples);
  add_choice<Sampler>(command, "--sampler", to.sampler, "Where samples fall");
  add_light_grid(command, to.light_grid);
  add_parsed(
      command, "--tolerance", to.tolerance, parse_share, "X", "a number from 0 to 1",
      fmt::format("A pixel takes no more samples once it is known to X of what a screen shows from 0 to 1, with\n"
                  "95% confidence, but the first {} always; 0: all",
                  Adaptive<double>::first_look));
  command
      .add_flag("--corner-samples", to.corner_samples,
                "A ray through each corner of the pixels, whose mean is the pixel: as ray counts of NFF scenes have it")
      ->excludes("--spp");
  add_limits(command, to.depth, to.threshold);
  add_whole(command, "--threads", to.threads, 0, max_threads,
            "Threads; 0, as when left out: as many as the machine runs at once");
  add_parsed(command, "--seed", to.seed, parse_seed, "N", "a whole number from 0 to 2^64 - 1",
             "Which random numbers are drawn, where any are (0 when left out)");
  add_choice<AcceleratorKind>(
      command, "--accel", to.accelerator,
      "How the objects that a ray may meet are found; the picture is the same, but by naive numerics");
  add_choice<BuildQuality>(command, "--build", to.build,
                           "How long a tree over meshes may be built, for rays that find their triangle sooner: best\n"
                           "splits triangles, which pays where many overlap; auto, as when left out, is fast for few\n"
                           "rays, else good. The picture is the same");
  auto* cached = command.add_flag_callback(
      "--shadow-cache", [&to] { to.shadow_cache = true; },
      "Shadow rays first try what hid the same light last (when left out: with any --accel but none); the picture is "
      "the same");
  command.add_flag_callback("--no-shadow-cache", [&to] { to.shadow_cache = false; }, "They do not")->excludes(cached);
  add_precision(command, to.precision);
  add_numerics(command, to.numerics, to.epsilon);
  add_file(command, "--stats", to.statistics, "FILE", "Write what was done and how long it took, as JSON",
           to_standard_output);
  add_part(command, to.share, "Render only this share of the picture, into IMAGE.part-I-of-N, for raywalk merge");
  command.add_flag("-q,--quiet", to.quiet, "Say nothing on the terminal but what went wrong");
  command.footer(
      "What is left out is as the scene says. None of --threads, --accel and --build changes a bit of the picture\n"
      "(but --accel with naive numerics).\n"
      "Ctrl-C writes what is done to NAME.partial.png, or NAME.partial-2.png and so on where there is one, and leaves "
      "an\n"
      "old image whole; twice, it ends at once.\n\n"
      "Examples:\n"
      "  raywalk render scenes/classic.toml -o classic.png\n"
      "  raywalk render classic -o large.png --size 1921x1081 --spp 16\n"
      "  raywalk render classic -o classic.pfm --precision float --stats classic.json\n"
      "  raywalk render classic -o classic.svg --integrator beams\n"
      "  raywalk render cornell -o cornell.exr --part 3/7   (and 1/7 to 7/7 elsewhere, then raywalk merge)");
  command.callback([options, &run] { run = [options] { return render_command(*options); }; });
}

void declare_step(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("step", "Write out what the visualiser walks through, step by step");
  const auto options = std::make_shared<StepOptions>();
  StepOptions& to = *options;
  command.add_option("SCENE", to.scene, scene_help)->required()->type_name("");
  add_parsed(command, "--pixel", to.pixel, parse_pixel, "N|X,Y",
             "a cell of the strip, such as 10, or column and row of the image, such as 220,165",
             "Only cell N of the strip, or only the image's pixel in column X and row Y, all from 0");
  add_choice<StepFormat>(
      command, "--format", to.format,
      "One line a step for people (as when left out); all numbers of each step for programs; a page for any "
      "browser that steps offline; the plan after the last step as a drawing");
  add_language(command, to.language,
               "Of the sentences, as text, page or drawing; left out: en. JSON is English always");
  add_size(command, to.size);
  add_integrator(command, to.integrator, to.path_length);
  add_limits(command, to.depth, to.threshold);
  add_precision(command, to.precision);
  add_numerics(command, to.numerics, to.epsilon);
  add_choice<Fault>(command, "--fault", to.fault,
                    "Breaks one line of the tracer on purpose, over naive numerics: lessons/README.md tells which");
  command.footer(
      "A step is one executed line of the pseudocode: its number, its DEPTH in brackets, the line, and what it did.\n"
      "Paths have a pseudocode of their own; in brackets stand the rays of the path so far.\n"
      "--size matters to --pixel X,Y only.\n\n"
      "Examples:\n"
      "  raywalk step classic\n"
      "  raywalk step classic --pixel 10 --depth 2\n"
      "  raywalk step classic --pixel 220,200 --format json\n"
      "  raywalk step classic --format html > classic.html\n"
      "  raywalk step cornell --pixel 100,100 --integrator path");
  command.callback([options, &run] { run = [options] { return step_command(*options); }; });
}

void declare_info(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("info", "Say what a scene holds, the effects it calls for, and why");
  const auto options = std::make_shared<InfoOptions>();
  InfoOptions& to = *options;
  const auto* scene = command.add_option("SCENE", to.scene, scene_help)->type_name("");
  const auto* keys =
      command
          .add_option_function<std::vector<std::string>>(
              "--keys", [&to](const auto& words) { to.keys = words.empty() ? "" : words.front(); },
              "Instead: every key that a scene file may have, or those of NAME: camera, material, sphere...")
          ->expected(0, 1)
          ->allow_extra_args(false)
          ->type_name("NAME");
  command.add_flag("--cost", to.with_cost, "Measure what each effect costs, and what all would cost regardless");
  add_integrator(command, to.integrator, to.path_length);
  add_samples(command, to.samples);
  add_light_grid(command, to.light_grid);
  command.footer(
      "The effects are those of a render with the same options; what is left out is as the scene says.\n\n"
      "Examples:\n"
      "  raywalk info classic\n"
      "  raywalk info my/scene.toml --cost\n"
      "  raywalk info --keys sphere\n"
      "  raywalk info distributed --integrator whitted --spp 9");
  command.callback([options, scene, keys, &command, &run] {
    if (!options->keys && scene->count() == 0) throw CLI::RequiredError("SCENE");
    for (const CLI::Option* option : command.get_options())
      if (options->keys && option != keys && option->count() > 0)
        throw CLI::ExcludesError("--keys does not go with " + (option == scene ? "a scene" : name_of(*option)),
                                 CLI::ExitCodes::ExcludesError);
    run = [options] { return info_command(*options); };
  });
}

ExitCode printed(const std::string& text) {
  const auto result = print(text);
  return result ? ExitCode::done : fail(result.error());
}

/// The hidden ones are for screenshots and tests.
void declare_window(CLI::App& program, FileLedger& ledger, Run& run) {
  struct Asked {
    GuiOptions options;
    ImageSize window{0, 0};
  };
  const auto asked = std::make_shared<Asked>();
  GuiOptions& to = asked->options;
  program
      .add_option("SCENE", to.scene_path,
                  std::string(scene_help) + "; or a link, as the window copies it; left out: the classic scene")
      ->type_name("");
  add_file(program, "--demo", to.demo_path, "FILE", "Replay the actions in a file, one a line");
  const CLI::Option* const demo_help_wanted =
      program.add_flag("--demo-help")->description("Print the actions that such a file may have, and exit");
  add_language(program, to.language, "Of the window; left out: as it was left, else the environment's");
  const auto hide = [](CLI::Option* option) { option->group(""); };
  hide(program.add_option("--state-dir", to.state_dir));
  hide(add_file(program, "--screenshot", to.screenshot_path, "FILE", ""));
  hide(program.add_option("--start-mode", to.start_mode));
  hide(program.add_option("--start-tab", to.start_tab));
  hide(program.add_option("--start-position", to.start_position));
  add_choice<Theme>(program, "--theme", to.theme, "Its colours and letters; left out: as they were left");
  const auto scale = [](const std::string& word) -> std::optional<double> {
    const auto factor = parse_amount(word);
    return factor && *factor >= min_ui_scale && *factor <= max_ui_scale ? factor : std::nullopt;
  };
  add_parsed(program, "--ui-scale", to.ui_scale, scale, "FACTOR",
             fmt::format("a number from {} to {}", min_ui_scale, max_ui_scale),
             "How large letters and buttons are; left out: as it was left");
  hide(add_file(program, "--report", to.report_path, "FILE", ""));
  add_parsed(program, "--window", asked->window, parse_size, "WxH", "two whole numbers, such as 1280x720",
             "The window's size; left out: 1280x720");
  program.callback([asked, demo_help_wanted, &program, &ledger, &run] {
    if (program.get_subcommands().empty() && demo_help_wanted->count() > 0) {
      run = [] { return printed(demo_help()); };
      return;
    }
    if (program.get_subcommands().empty()) {
      asked->options.width = asked->window.width;
      asked->options.height = asked->window.height;
      run = [asked, &program, &ledger] {
        std::vector<std::string> commands;
        for (const CLI::App* command : program.get_subcommands({})) commands.push_back(command->get_name());
        return window_command(asked->options, ledger, commands);
      };
      return;
    }
    for (const CLI::Option* option : program.get_options())
      if (option->count() > 0)
        throw CLI::ExcludesError(name_of(*option) + " belongs to the window and does not go with a command",
                                 CLI::ExitCodes::ExcludesError);
  });
}

ExitCode parse_and_run(int argc, const char* const* argv) {
  CLI::App program("Walk a ray tracer one line of pseudocode at a time: without a command, opens the visualiser.",
                   "raywalk");
  program.set_version_flag("--version", "raywalk " RAYWALK_VERSION, "Print the version and exit");
  program.require_subcommand(0, 1);
  program.footer(
      "Examples:\n"
      "  raywalk                                  opens the visualiser on the classic scene\n"
      "  raywalk my/scene.toml                    opens it on a scene of yours\n"
      "  raywalk render classic -o classic.png    renders the scene's 3-D image\n"
      "  raywalk COMMAND --help                   says all about a command\n\n"
      "Exit codes: 0 done, 1 the input or the machine failed, 2 wrong use.");
  Run run;
  FileLedger ledger;  // for any command
  declare_window(program, ledger, run);
  declare_render(program, run);
  declare_merge(program, run);
  declare_step(program, run);
  declare_info(program, run);
  declare_convert(program, run);
  declare_generate(program, run);
  declare_compare(program, run);
  declare_study(program, run);
  declare_check(program, run);
  declare_lesson(program, run);
  std::vector<std::string> words(argv + 1, argv + argc);
  // "help" and "help render" as --help and "render --help".
  std::error_code unreadable;
  if (!words.empty() && words.front() == "help" && !std::filesystem::exists("help", unreadable)) {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return printed(program.help());
  } catch (const CLI::CallForVersion& version) {
    return printed(version.what() + std::string("\n"));
  } catch (const CLI::ParseError& error) {
    return refuse(misuse(program, error, words));
  }
  const ExitCode code = run();
  // A command that was refused because it would overwrite its own input was used wrongly.
  return code == ExitCode::failed && ledger.has_refused() ? ExitCode::wrong_usage : code;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit is an error like a full disk
  ExitCode code = ExitCode::failed;
  try {
    code = parse_and_run(argc, argv);
  } catch (const Stopped&) {
    code = fail({"", 0, 0, "interrupted", ""});
  } catch (const std::bad_alloc&) {
    code = fail({"", 0, 0, "there is not enough memory for this command",
                 "close other programs, or give it less to do: a smaller scene or picture, fewer rays"});
  } catch (const std::exception& error) {
    code =
        fail({"", 0, 0, std::string("unexpected: ") + error.what(), "this is a defect of Raywalk; please report it"});
  }
  return static_cast<int>(code);
}

}  // namespace raywalk
