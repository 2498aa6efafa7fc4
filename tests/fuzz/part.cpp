// What the readers of everything else are given by libFuzzer: meshes, materials, pictures, lessons, demo scripts,
// links, and the files that long runs keep. Any bytes: they must be refused with a message, or understood.

// Each is compiled and linked with the floors of its own reader alone: sanitizers take long to compile the others.
#if defined(FUZZ_demo)
#include "view/action_text.h"
#elif defined(FUZZ_link)
#include "io/scene_patch.h"
#include "view/link/link.h"
#elif defined(FUZZ_lesson) || defined(FUZZ_words)
#include "lesson/lesson.h"
#include "lesson/words.h"
#elif defined(FUZZ_state)
#include "check/suite.h"
#else
#include "image/image_file.h"
#include "io/mesh_file.h"
#include "io/packed_text.h"
#include "io/scene_patch.h"
#endif

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

#if defined(FUZZ_link) || defined(FUZZ_patch)
/// What a link changes; of every kind of value that a scene has.
const SceneDocument& changed_scene() {
  static const SceneDocument scene = parse_scene(R"(
title = "Any"
background = [0.1, 0.2, 0.3]
[camera]
eye = [-6, 0, 0]
look_at = [0, 0, 0]
fov = 45
[limits]
depth = 3
[[group]]
name = "Pair"
[[group.object]]
name = "One"
type = "sphere"
centre = [0, 0, 0]
radius = 0.5
[[light]]
name = "Lamp"
type = "point"
position = [0, 4, 0]
[[object]]
name = "Block"
type = "polygon"
corners = [[1, 1], [2, 1], [2, 2]]
height = 1
[object.material.checker]
even = 1
odd = 0
size = 1
[[object]]
name = "Copy"
type = "instance"
group = "Pair"
transform = [["translate", 1, 0, 0]]
)",
                                                 "fuzzed.toml")
                                         .value();
  return scene;
}
#endif
#if defined(FUZZ_link)
/// What is understood is written back as the same, and what it changes is refused or leaves a scene.
void accept(const Link& link) {
  const auto again = read_link(write_link(link));
  require(again.has_value() && *again == link);
  for (const std::string& changes : {link.changes, link.camera})
    if (const auto scene = patched_scene(changed_scene(), changes); !scene) require(!scene.error().message.empty());
}
#elif defined(FUZZ_patch)
/// What differs, differs by its own patch.
void accept(const SceneDocument& changed) {
  const std::string patch = scene_patch(changed_scene().scene, changed.scene);
  const auto again = patched_scene(changed_scene(), patch);
  require(again.has_value() && again->scene == changed.scene);
}
#endif

#if defined(FUZZ_packed)
constexpr std::size_t most_unpacked = 1 << 16;
/// Packed again it may have other letters, for there are many ways to pack a text, but leads back to it.
void accept(const std::string& text) {
  require(text.size() <= most_unpacked);
  const auto again = unpack_text(pack_text(text), most_unpacked);
  require(again.has_value() && *again == text);
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
#elif defined(FUZZ_hdr)
  return decode_hdr(bytes, "fuzzed.hdr");
#elif defined(FUZZ_exr)
  return decode_exr(bytes, "fuzzed.exr");
#elif defined(FUZZ_lesson)
  return parse_lesson(bytes, "lesson.toml");
#elif defined(FUZZ_words)
  return parse_words(bytes, "en.md");
#elif defined(FUZZ_demo)
  return parse_demo(bytes, "fuzzed.demo");
#elif defined(FUZZ_link)
  return read_link(bytes);
#elif defined(FUZZ_patch)
  return patched_scene(changed_scene(), bytes);
#elif defined(FUZZ_packed)
  return unpack_text(bytes, most_unpacked);
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
#if defined(FUZZ_packed)
  accept(std::string(reinterpret_cast<const char*>(data), size));
#endif
  const auto understood = parse({reinterpret_cast<const char*>(data), size});
  if (understood) {
    accept(*understood);
  } else {
    require(!understood.error().message.empty());
    require(understood.error().text().size() < 4000);
  }
  return 0;
}
