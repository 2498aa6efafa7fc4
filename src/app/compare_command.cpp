#include "app/compare_command.h"

#include "image/image_file.h"
#include "study/flip.h"
#include "study/image_metrics.h"
#include "text/file.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace raywalk {

namespace {

std::string metrics_text(const CompareOptions& options, const Image& image, const ImageMetrics& m) {
  std::string text =
      fmt::format("{} against {}, {} x {} pixels\n", options.test, options.reference, image.width, image.height);
  const auto row = [&](std::string_view name, const std::string& value, std::string_view what) {
    text += fmt::format("  {:<7} {:>11}   {}\n", name, value, what);
  };
  row("MSE", fmt::format("{:.4g}", m.mse), "mean squared difference, in linear light");
  row("relMSE", fmt::format("{:.4g}", m.rel_mse), "the same, each over the square of the second picture + 0.01");
  row("PSNR", std::isinf(m.psnr) ? "inf" : fmt::format("{:.2f} dB", m.psnr), "of what a screen shows; equal: inf");
  row("FLIP", fmt::format("{:.4f}", m.flip),
      fmt::format("what an eye sees of it, 0 to 1, at {:.0f} pixels a degree", default_pixels_per_degree));
  row("99%", fmt::format("{:.4g}", m.percentile99), "of the pixels differ by no more, in linear light");
  row("largest", fmt::format("{:.4g}", m.worst),
      m.worst > 0 ? fmt::format("difference, in column {} of row {}", m.worst_column, m.worst_row)
                  : std::string("difference: the pictures are equal"));
  return text;
}

}  // namespace

ExitCode compare_command(const CompareOptions& options) {
  const auto test = read_image(options.test);
  if (!test) return fail(test.error());
  const auto reference = read_image(options.reference);
  if (!reference) return fail(reference.error());
  if (auto why = why_not_comparable(*test, *reference)) {
    why->message = options.test + " and " + options.reference + ": " + why->message;
    return fail(*why);
  }
  if (options.difference)
    if (const auto claimed = claim_output(*options.difference); !claimed) return fail(claimed.error());
  const ImageMetrics metrics = compare_images(*test, *reference);
  if (options.difference) {
    const bool seen = *image_format_of(*options.difference) == ImageFormat::png;  // checked on the command line
    const Image difference = seen ? flip_image(*test, *reference) : difference_image(*test, *reference);
    if (const auto written = write_image(*options.difference, difference); !written) return fail(written.error());
  }
  const auto printed = print(metrics_text(options, *test, metrics));
  return printed ? ExitCode::done : fail(printed.error());
}

void declare_compare(CLI::App& program, Run& run) {
  CLI::App& command = *program.add_subcommand("compare", "Say how far one picture is from another");
  const auto options = std::make_shared<CompareOptions>();
  CompareOptions& to = *options;
  command.add_option("A", to.test, "The picture in question: .png, .pfm, .exr or .hdr")->required()->type_name("");
  command.add_option("B", to.reference, "The picture that it should be, of the same size")->required()->type_name("");
  add_image(command, to.difference,
            "Write the difference: as .png what an eye sees of it (FLIP), from dark blue (0) to yellow (1);\n"
            "as .pfm or .exr A - B in linear light");
  command.footer(
      "A .png holds 256 steps a channel and nothing above 1; to compare what was computed, use .pfm or .exr.\n\n"
      "Examples:\n"
      "  raywalk compare noisy.pfm clean.pfm\n"
      "  raywalk compare noisy.png clean.png -o seen.png");
  command.callback([options, &run] { run = [options] { return compare_command(*options); }; });
}

}  // namespace raywalk
