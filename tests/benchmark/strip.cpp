// Re-recording after an edit: the timeline of a strip of 401 pixels at depth 5. Prints the median of many recordings.
//
//   benchmark_strip SCENE.toml [REPETITIONS]

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "io/scene_file.h"
#include "timeline/recorder.h"

int main(int argc, char** argv) {
  using namespace raywalk;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 101;
  if (argc < 2 || repetitions < 1) {
    std::fputs("usage: benchmark_strip SCENE.toml [REPETITIONS]\n", stderr);
    return 2;
  }
  auto document = read_scene(argv[1]);
  if (!document) {
    std::fprintf(stderr, "%s\n", document.error().text().c_str());
    return 1;
  }
  Scene& scene = document->scene;
  scene.camera.screen.cells = 401;
  scene.limits.depth = 5;
  std::vector<double> wall, processor;
  int steps = 0;
  for (int i = 0; i < repetitions; ++i) {
    // An edit: every recording is of a scene of its own.
    scene.camera.eye.y += 1e-6;
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t begin_processor = std::clock();
    const Timeline timeline = record_strip(scene);
    processor.push_back(1000.0 * static_cast<double>(std::clock() - begin_processor) / CLOCKS_PER_SEC);
    wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    steps = timeline.steps();
  }
  const auto median = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  std::printf("%d steps recorded in %.2f ms, %.2f ms of processor time (medians of %d; goal: under 16 ms)\n", steps,
              median(wall), median(processor), repetitions);
  return median(processor) < 16 ? 0 : 1;
}
