// What the readers of everything else are given by libFuzzer: meshes, materials, pictures, lessons, demo scripts, and
// the files that long runs keep. Any bytes: they must be refused with a message, or understood.

#include "check/suite.h"
#include "image/image_file.h"
#include "io/mesh_file.h"
#include "lesson/expression.h"
#include "lesson/lesson.h"
#include "lesson/words.h"
#include "view/action_text.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

using namespace raywalk;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

#if defined(FUZZ_obj) || defined(FUZZ_ply) || defined(FUZZ_gltf)
/// What a reader let through must be fit to be traced.
void accept(const MeshFile& file) {
  require(file.mesh != nullptr);
  require(detail::why_no_mesh(*file.mesh).empty());
}
#endif

auto parse(const std::string& bytes) {
#if defined(FUZZ_obj)
  return parse_obj(bytes, "fuzzed.obj");
#elif defined(FUZZ_ply)
  return parse_ply(bytes, "fuzzed.ply");
#elif defined(FUZZ_gltf)
  return parse_gltf(bytes, "fuzzed.gltf");
#elif defined(FUZZ_mtl)
  return parse_mtl(bytes, "fuzzed.mtl");
#elif defined(FUZZ_texture)
  return decode_png_or_jpeg(bytes, "fuzzed.png");
#elif defined(FUZZ_pfm)
  return decode_pfm(bytes, "fuzzed.pfm");
#elif defined(FUZZ_exr)
  return decode_exr(bytes, "fuzzed.exr");
#elif defined(FUZZ_lesson)
  return parse_lesson(bytes, "lesson.toml");
#elif defined(FUZZ_words)
  return parse_words(bytes, "en.md");
#elif defined(FUZZ_demo)
  return parse_demo(bytes, "fuzzed.demo");
#elif defined(FUZZ_state)
  check::SuiteOptions of_seed;
  of_seed.rays = 2400;
  return check::read_state("fuzzed", bytes, of_seed);
#endif
}

template <class Understood>
void accept(const Understood&) {}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto understood = parse({reinterpret_cast<const char*>(data), size});
  if (understood) {
    accept(*understood);
  } else {
    require(!understood.error().message.empty());
    require(understood.error().text().size() < 4000);
  }
  return 0;
}
