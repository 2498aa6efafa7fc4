#include "render/tree_size.h"

#include "math/elementary.h"

#include <algorithm>
#include <utility>

namespace raywalk {

namespace {

/// Cancels a trace after `most` checks: where a tree grows, each of its rays is one.
class FewChecks : public Stopper {
 public:
  FewChecks(int most, const Stop& outer) : left_(most), outer_(outer) { raised = true; }
  bool stops() override { return --left_ < 0 || outer_.asked(); }

 private:
  int left_;
  Stop outer_;
};

/// Reflect and refract rays of a pixel's first sample, and beams and cones; nothing when there are many more than
/// `most`.
template <class T>
std::optional<int> rays_of(const SceneKernel<T>& kernel, const RayGenerator<T>& camera, int column, int row, int most,
                           const Stop& stop) {
  FewChecks few(most, stop);
  try {
    const Statistics statistics =
        kernel(camera, {column, column + 1, row, row + 1, 0, 1, 1, Stop(few)}, [](const Pixel&, const Rgb<T>&) {});
    return static_cast<int>(statistics.formed(RayKind::reflect) + statistics.formed(RayKind::refract) +
                            statistics.formed(RayKind::beam));
  } catch (const Stopped&) {
    stop.check();
    return std::nullopt;
  }
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
      rays = *all, found.growth = portable::pow(1.0 + *all, 1.0 / depth);
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
      rays = std::max(static_cast<double>(most), now * portable::pow(found.growth, depth - (level - 1)));
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
