// A live frame: EYE is dragged through a scene with the rays of the whole strip shown, and each place of the pointer
// records the walk and describes the plan anew; nothing is drawn. Prints the median and the slowest of many frames, in
// processor time, so that a busy machine does not matter.
//
//   benchmark_live SCENE.toml [FRAMES]

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

#include "io/scene_file.h"
#include "view/action.h"
#include "view/plan/plan_view.h"
#include "view/state.h"

int main(int argc, char** argv) {
  using namespace raywalk;
  constexpr double goal = 8;  // milliseconds: half of a frame at 60 a second
  const int frames = argc > 2 ? std::atoi(argv[2]) : 400;
  if (argc < 2 || frames < 1) {
    std::fputs("usage: benchmark_live SCENE.toml [FRAMES]\n", stderr);
    return 2;
  }
  auto document = read_scene(argv[1]);
  if (!document) {
    std::fprintf(stderr, "%s\n", document.error().text().c_str());
    return 1;
  }
  State state = make_state(std::move(*document), argv[1]);
  update(state, action::ResizePlan{{1360, 860}});
  update(state, action::SetMode{Mode::move});
  update(state, action::SetLiveRays{LiveRays::strip});
  const Vec2d eye = to_pixels(state.plan.camera, state.plan.viewport, plan(state.scene().camera.eye));
  update(state, action::PointerMoved{eye});
  update(state, action::PointerPressed{eye});
  update(state, action::PointerMoved{eye + Vec2d(20, 12)});
  std::vector<double> times;
  std::size_t items = 0;
  std::uint64_t revision = state.document.revision;
  for (int i = 0; i < frames; ++i) {
    // To and fro, never twice at the same place in a row.
    const Vec2d at = eye + Vec2d(i % 80 < 40 ? i % 80 : 80 - i % 80, i % 60 < 30 ? i % 60 : 60 - i % 60) + Vec2d(1);
    const std::clock_t begin = std::clock();
    update(state, action::PointerMoved{at});
    items = plan_view(state).size();
    times.push_back(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (std::exchange(revision, state.document.revision) == state.document.revision) {
      std::fprintf(stderr, "EYE did not follow the pointer in frame %d\n", i);
      return 1;
    }
  }
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2], most = times.back();
  std::printf("%zu items in a live frame: %.2f ms of processor time, at most %.2f ms (of %d; goal: at most %g ms)\n",
              items, median, most, frames, goal);
  return most <= goal ? 0 : 1;
}
