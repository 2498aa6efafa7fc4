#include "app/file_commands.h"

#include "app/scene_lookup.h"
#include "io/pov_writer.h"
#include "text/file.h"
#include "text/file_path.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <memory>

namespace raywalk {

namespace {

Result<void> write_pov(const Scene& scene, const std::string& path) {
  const PovText pov = format_pov(scene);
  if (const auto written = write_file_atomically(path, pov.text); !written) return written;
  for (const std::string& what : pov.left_out) note(path + ": POV-Ray renders without: " + what);
  return {};
}

}  // namespace

ExitCode convert_command(const std::string& in, const std::string& out) {
  auto document = load_scene(in);
  if (!document) return fail(document.error());
  if (const auto claimed = claim_output(out); !claimed) return fail(claimed.error());
  const auto written = ending_of(out) == ".pov" ? write_pov(document->scene, out) : write_scene(*document, out);
  return written ? ExitCode::done : fail(written.error());
}

ExitCode generate_command(const GenerateOptions& options, const std::string& out) {
  if (const auto error = why_not_generated(options, out)) return refuse(*error);
  if (const auto claimed = claim_output(out); !claimed) return fail(claimed.error());
  const auto written = generate(options, out);
  return written ? ExitCode::done : fail(written.error());
}

void declare_convert(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("convert", "Write a scene in another format");
  struct Files {
    std::string in, out;
  };
  const auto files = std::make_shared<Files>();
  command.add_option("IN", files->in, scene_help)->required()->type_name("");
  const auto ending = [](const std::string& path) {
    const std::string is = ending_of(path);
    if (is == ".toml" || is == ".pov") return std::string();
    return path + (is.empty() ? ": the file name has no ending" : ": no scene is written as \"" + is + "\"") +
           " (expected .toml or .pov)";
  };
  add_file(command, "OUT", files->out, "", "The scene: .toml (Raywalk's own) or .pov (POV-Ray 3.7)")
      ->required()
      ->check(CLI::Validator(ending, "", "ending"));
  command.footer(
      "A .toml scene holds everything, and of a .toml scene also its comments. Meshes and textures stay where they "
      "are\n"
      "and are named from the new file's folder. What POV-Ray cannot show is said.\n\n"
      "Examples:\n"
      "  raywalk convert balls.nff balls.toml\n"
      "  raywalk convert whitted whitted.pov");
  command.callback([files, &run] { run = [files] { return convert_command(files->in, files->out); }; });
}

void declare_generate(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("generate", "Write a scene or mesh of any size");
  struct Asked {
    GenerateOptions options;
    std::string out;
  };
  const auto asked = std::make_shared<Asked>();
  GenerateOptions& to = asked->options;
  using enum GeneratedKind;
  add_choice<GeneratedKind>(
      command, "KIND", to.kind,
      "spheres (strewn at random), flake (spheres on spheres), mesh (a bumpy ball of triangles) or forest (copies "
      "of a mesh)")
      ->required();
  const auto* count = add_whole(command, "--count", to.count, 1, std::numeric_limits<int>::max(),
                                "About how many spheres, triangles or copies (1000 when left out)");
  const auto* levels = add_whole(command, "--levels", to.levels, 0, 9,
                                 "Of a flake: how often each sphere grows nine more; 6 makes 597871 (3 when left out)");
  const auto* seed = add_parsed(command, "--seed", to.seed, parse_seed, "N", "a whole number from 0 to 2^64 - 1",
                                "Which random numbers are drawn (0 when left out)");
  const auto* copied =
      add_file(command, "--mesh", to.mesh, "FILE", "Of a forest: what it has copies of (.ply, .obj, .gltf or .glb)");
  const auto* up = add_choice<UpAxis>(command, "--up", to.up,
                                      "Of a forest: the axis of the mesh that points upwards (z when left out)");
  add_file(command, "-o,--output", asked->out, "FILE", "Scenes: .nff or .toml; meshes: .ply, .obj or .nff")->required();
  command.footer(
      "The same options give the same file. It is written as it is made: a billion triangles take no more memory than "
      "ten.\n\n"
      "Examples:\n"
      "  raywalk generate spheres --count 1000000 -o million.nff\n"
      "  raywalk generate flake --levels 4 -o flake.nff\n"
      "  raywalk generate mesh --count 2000 --seed 7 -o ball.ply\n"
      "  raywalk generate forest --count 10000 --mesh ball.ply -o forest.toml");
  command.callback([=, &run] {
    const GeneratedKind kind = asked->options.kind;
    for (const auto& [option, is_idle] :
         {std::pair(count, kind == flake), std::pair(seed, kind == flake), std::pair(levels, kind != flake),
          std::pair(copied, kind != forest), std::pair(up, kind != forest)})
      if (is_idle && option->count() > 0)
        throw CLI::ExcludesError(fmt::format("{} does not go with {}", option->get_name(), name_of(kind)),
                                 CLI::ExitCodes::ExcludesError);
    run = [asked] { return generate_command(asked->options, asked->out); };
  });
}

}  // namespace raywalk
