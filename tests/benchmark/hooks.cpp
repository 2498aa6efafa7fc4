// Traces a scene with nobody watching, for hooks.sh to count the instructions of. Compiled twice: as it stands, and by
// without.cmake with the hooks taken out of the tracer's source.
//
//   benchmark_hooks SCENE.toml [WIDTHxHEIGHT]

#include <cstdio>
#include <string>

#include "io/scene_file.h"
#include "trace/kernel_of.h"

namespace {

// The sum of all shades, so that no pixel is traced for nothing.
raywalk::Rgbd sum{0.0};

}  // namespace

// What is counted: the trace phase alone. A name of its own for callgrind's --toggle-collect.
extern "C" __attribute__((noinline)) void raywalk_trace_phase(const raywalk::World<double>& world,
                                                              const raywalk::RayGenerator<double>& camera,
                                                              const raywalk::PixelBlock& block) {
  static_cast<void>(raywalk::detail::fitting_kernel(world)(
      world, camera, block, [](const raywalk::Pixel&, const raywalk::Rgbd& shade) { sum += shade; }));
}

int main(int argc, char** argv) {
  using namespace raywalk;
  ImageSize size{200, 200};
  if (argc < 2 || (argc > 2 && std::sscanf(argv[2], "%dx%d", &size.width, &size.height) != 2)) {
    std::fputs("usage: benchmark_hooks SCENE.toml [WIDTHxHEIGHT]\n", stderr);
    return 2;
  }
  const auto document = read_scene(argv[1]);
  if (!document) {
    std::fprintf(stderr, "%s\n", document.error().text().c_str());
    return 1;
  }
  const World<double> world(document->scene);
  const RayGenerator<double> camera(document->scene, size, size);
  raywalk_trace_phase(world, camera, {0, size.width, 0, size.height});
  std::printf("%.17g %.17g %.17g\n", sum.x, sum.y, sum.z);
  return 0;
}
