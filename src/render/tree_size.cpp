#include "render/tree_size.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

/// Counts reflect and refract rays, each of which checks for cancellation, and cancels when there are too many.
class RayCounter : public Stopper {
 public:
  RayCounter(int most, const Stop& outer) : most_(most), outer_(outer) { raised = true; }
  bool stops() override { return ++count_ > most_ || outer_.asked(); }
  [[nodiscard]] int count() const { return count_; }

 private:
  int most_, count_ = 0;
  Stop outer_;
};

/// Secondary rays of a pixel's first sample; nothing when there are more than `most`.
template <class T>
std::optional<int> rays_of(const SceneKernel<T>& kernel, const RayGenerator<T>& camera, int column, int row, int most,
                           const Stop& stop) {
  RayCounter counter(most, stop);
  try {
    static_cast<void>(
        kernel(camera, {column, column + 1, row, row + 1, 0, 1, 1, Stop(counter)}, [](const Pixel&, const Rgb<T>&) {}));
  } catch (const Stopped&) {
    stop.check();
    return std::nullopt;
  }
  return counter.count();
}

}  // namespace

template <class T>
std::optional<TreeSize> endless_tree(World<T>& world, const SceneKernel<T>& kernel, const RayGenerator<T>& camera,
                                     ImageSize size, int samples, const Stop& stop) {
  constexpr int probes = 5, most = 20'000;  // per side; rays of one probe
  constexpr double patience = 1e6;
  const int depth = world.depth;
  if (depth < 3) return std::nullopt;
  TreeSize found{0, 1, depth, samples, 0};
  for (const auto& light : world.lights) found.shadow_rays += light.samples();
  for (int i = 0; i < probes * probes; ++i) {
    const int column = (2 * (i % probes) + 1) * size.width / (2 * probes);
    const int row = (2 * (i / probes) + 1) * size.height / (2 * probes);
    double rays = 0;
    if (const auto all = rays_of(kernel, camera, column, row, most, stop)) {
      rays = *all, found.growth = std::pow(1.0 + *all, 1.0 / depth);
    } else {
      // Level by level as far as feasible, then extrapolated from the last growth.
      int before = 1, now = 1, level = 2;
      for (; level < depth; ++level) {
        world.depth = level;
        const auto here = rays_of(kernel, camera, column, row, most, stop);
        if (!here) break;
        before = std::max(1, std::exchange(now, std::max(1, *here)));
      }
      world.depth = depth;
      found.growth = std::max(1.0, static_cast<double>(now) / before);
      rays = std::max(static_cast<double>(most), now * std::pow(found.growth, depth - (level - 1)));
    }
    found.rays = (1 + rays) * (1.0 + found.shadow_rays) * samples;
    if (found.rays > patience) return found;
  }
  return std::nullopt;
}

template std::optional<TreeSize> endless_tree(World<float>&, const SceneKernel<float>&, const RayGenerator<float>&,
                                              ImageSize, int, const Stop&);
template std::optional<TreeSize> endless_tree(World<double>&, const SceneKernel<double>&, const RayGenerator<double>&,
                                              ImageSize, int, const Stop&);

}  // namespace raywalk
