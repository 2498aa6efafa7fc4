// Traces a scene with nobody watching, for hooks.sh to count the instructions of. Compiled twice: as it stands, and by
// without.cmake with the hooks taken out of the tracer's source.
//
//   benchmark_hooks SCENE.toml [WIDTHxHEIGHT [OTHER.toml ROUNDS]]
//
// With another scene: traces the two in turn, and prints the median over the rounds of how many times the other's
// processor time the first takes.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

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

namespace {

using namespace raywalk;

struct Traced {
  explicit Traced(const Scene& scene, const ImageSize& size) : world(scene), camera(scene, size, size) {}
  void trace(const PixelBlock& block) const { raywalk_trace_phase(world, camera, block); }

  World<double> world;
  RayGenerator<double> camera;
};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A few rows at a time, so that whatever else the machine does slows both.
double ratio_of_times(const Traced& one, const Traced& other, const ImageSize& size) {
  double of_one = 0, of_other = 0;
  for (int top = 0; top < size.height; top += 8) {
    const PixelBlock rows{0, size.width, top, std::min(top + 8, size.height)};
    const double start = processor_seconds();
    one.trace(rows);
    const double between = processor_seconds();
    other.trace(rows);
    of_one += between - start, of_other += processor_seconds() - between;
  }
  return of_one / of_other;
}

}  // namespace

int main(int argc, char** argv) {
  ImageSize size{200, 200};
  if (argc < 2 || argc == 4 || (argc > 2 && std::sscanf(argv[2], "%dx%d", &size.width, &size.height) != 2)) {
    std::fputs("usage: benchmark_hooks SCENE.toml [WIDTHxHEIGHT [OTHER.toml ROUNDS]]\n", stderr);
    return 2;
  }
  std::vector<Scene> scenes;
  for (const char* path : {argv[1], argc > 4 ? argv[3] : argv[1]}) {
    const auto document = read_scene(path);
    if (!document) {
      std::fprintf(stderr, "%s\n", document.error().text().c_str());
      return 1;
    }
    scenes.push_back(document->scene);
  }
  const Traced traced(scenes[0], size);
  traced.trace({0, size.width, 0, size.height});
  if (argc > 4) {
    const Traced other(scenes[1], size);
    std::vector<double> ratios;
    for (int round = std::max(std::atoi(argv[4]), 1); round > 0; --round)
      ratios.push_back(ratio_of_times(traced, other, size));
    std::ranges::sort(ratios);
    std::printf("%.3f\n", ratios[ratios.size() / 2]);
    return 0;
  }
  std::printf("%.17g %.17g %.17g\n", sum.x, sum.y, sum.z);
  return 0;
}
