// Scenes that come with Raywalk, converted and rendered by POV-Ray: nearly the same pictures.

#include "io/file.h"
#include "io/image.h"
#include "io/pov_writer.h"
#include "io/scene_file.h"
#include "png.h"
#include "render/render.h"
#include "support/catch.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Share of the pixels of which a channel is off by more than 2 of 255.
double share_off(const Picture& a, const Picture& b) {
  int off = 0;
  for (std::size_t i = 0; i < a.bytes.size(); i += 3) {
    int most = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel)
      most = std::max(most, std::abs(int{a.bytes[channel]} - int{b.bytes[channel]}));
    if (most > 2) ++off;
  }
  return 3.0 * off / static_cast<double>(a.bytes.size());
}

}  // namespace

TEST_CASE("POV-Ray renders converted scenes to nearly the same pictures") {
  if (std::system("command -v povray >/dev/null 2>&1") != 0) RAYWALK_SKIP("povray is not installed");
  struct Converted {
    std::string scene;
    double most_off;   ///< share of the pixels
    std::string rest;  ///< what the others come from
  };
  const std::vector<Converted> scenes{
      {"whitted", 0.01, "edges, where one pixel's ray just hits and the other's just misses"},
      {"mirrors", 0.02, "edges, many times mirrored"},
      {"shadows", 0.02, "edges"},
      {"quadrics", 0.02, "edges"},
      {"sphereflake", 0.03, "edges, many times mirrored"},
      {"mesh", 0.02, "edges"},
  };
  std::string pattern = (std::filesystem::temp_directory_path() / "raywalk-pov-XXXXXX").string();
  const std::filesystem::path folder = ::mkdtemp(pattern.data());
  for (const Converted& each : scenes) {
    INFO(each.scene);
    auto document = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + each.scene + ".toml");
    REQUIRE(document);
    Scene& scene = document->scene;
    scene.image = {160, 120};
    const auto rendering = render(scene);
    REQUIRE(rendering);
    const Picture ours = decode_png(*encode_png(rendering->image()));
    REQUIRE(write_file_atomically((folder / "scene.pov").string(), format_pov(scene).text));
    const std::string command = "cd '" + folder.string() +
                                "' && povray +Iscene.pov +Oscene.png +W160 +H120 -A +WT1 -D -GA >log 2>&1 || "
                                "{ cat log >&2; exit 1; }";
    REQUIRE(std::system(command.c_str()) == 0);
    const auto bytes = read_file((folder / "scene.png").string(), std::size_t{1} << 26);
    REQUIRE(bytes);
    const Picture theirs = decode_png(*bytes);
    REQUIRE(theirs.bytes.size() == ours.bytes.size());
    const double off = share_off(ours, theirs);
    INFO("off by more than 2/255: " << 100 * off << "% (" << each.rest << ")");
    CHECK(off <= each.most_off);
  }
  std::filesystem::remove_all(folder);
}
