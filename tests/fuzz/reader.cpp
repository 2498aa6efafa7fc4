// What a reader is given by libFuzzer: any bytes. It must refuse them with a message that a person can act on, or make
// a scene of them that can be written and read again.

#include "io/nff_reader.h"
#include "io/scene_file.h"
#include "io/test_format_reader.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

using namespace raywalk;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

Result<SceneDocument> parse(std::string_view text) {
#if defined(FUZZ_toml)
  return parse_scene(text, "fuzzed");
#elif defined(FUZZ_nff)
  return parse_nff(text, "fuzzed");
#elif defined(FUZZ_test)
  return parse_test_format(text, "fuzzed");
#endif
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto document = parse({reinterpret_cast<const char*>(data), size});
  if (!document) {
    require(!document.error().message.empty());
    require(document.error().text().size() < 4000);
    return 0;
  }
  const Scene& scene = document->scene;
  require(scene.camera.fov.has_value() != scene.camera.screen.width.has_value());
  require(scene.image.width >= 1 && scene.image.height >= 1 && scene.limits.depth >= 1);
  constexpr std::size_t few = 20;  // writing takes longer than reading
  if (scene.objects.size() + scene.lights.size() <= few) {
    const auto text = format_scene(scene);
    // What another format makes may go beyond ours in size alone, and then is refused with a message.
    require(text || !text.error().message.empty());
    if (text) require(parse_scene(*text, "written").has_value());
  }
  return 0;
}
