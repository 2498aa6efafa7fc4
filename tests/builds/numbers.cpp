// What every build must compute alike, in one small program: the hard-case suite, and the shipped scenes' pictures.
//
//   numbers suite RAYS [FAMILY...]   RAYS of each family; prints the table, exits with 1 when a goal is broken
//   numbers pictures SCENE...        a line a scene and precision: a checksum of all bits of a small picture

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "check/suite.h"
#include "io/scene_file.h"
#include "render/render.h"

namespace {

using namespace raywalk;

int suite(std::uint64_t rays, const std::vector<std::string>& names) {
  std::vector<check::Family> families;
  for (check::Family& family : check::all_families())
    if (names.empty() || std::find(names.begin(), names.end(), family.name) != names.end())
      families.push_back(std::move(family));
  check::SuiteOptions options;
  options.rays = rays;
  options.threads = 0;
  const auto result = check::run_suite(families, options);
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().text().c_str());
    return 2;
  }
  std::printf("%s", check::table_text(families, *result).c_str());
  return result->good() ? 0 : 1;
}

/// G. Fowler, L. C. Noll and K.-P. Vo's hash (FNV-1a), over the bits of all numbers.
std::uint64_t checksum(const Rendering& rendering) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  std::visit(
      [&](const auto& film) {
        for (const auto& pixel : film.pixels())
          for (int channel = 0; channel < 3; ++channel) {
            const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(pixel[channel]));
            for (unsigned shift = 0; shift < 64; shift += 8) sum = (sum ^ (bits >> shift & 0xffU)) * 0x100000001b3U;
          }
      },
      rendering.film);
  return sum;
}

int pictures(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const auto document = read_scene(path);
    if (!document) {
      std::fprintf(stderr, "%s\n", document.error().text().c_str());
      return 2;
    }
    for (const Precision precision : {Precision::double_, Precision::float_}) {
      RenderSettings settings;
      settings.size = ImageSize{42, 31};
      settings.precision = precision;
      const auto rendering = render(document->scene, settings);
      if (!rendering) {
        std::fprintf(stderr, "%s\n", rendering.error().text().c_str());
        return 2;
      }
      std::printf("%016llx %s %s\n", static_cast<unsigned long long>(checksum(*rendering)), path.c_str(),
                  precision == Precision::double_ ? "double" : "float");
    }
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  const std::string what = arguments.empty() ? "" : arguments[0];
  if (what == "suite" && arguments.size() >= 2)
    return suite(std::strtoull(arguments[1].c_str(), nullptr, 10), {arguments.begin() + 2, arguments.end()});
  if (what == "pictures" && arguments.size() >= 2) return pictures({arguments.begin() + 1, arguments.end()});
  std::fprintf(stderr, "numbers suite RAYS [FAMILY...] or numbers pictures SCENE...\n");
  return 2;
}
