#include "render/row_tracer.h"

#include "trace/ray_generator.h"
#include "trace/scene_kernel.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace raywalk {

namespace {

double cost_of(Heat heat, const Statistics& own, double microseconds) {
  switch (heat) {
    case Heat::none:
    case Heat::noise:
      return 0;
    case Heat::rays:
      return static_cast<double>(std::accumulate(own.rays.begin(), own.rays.end(), std::uint64_t{0}));
    case Heat::tests:
      return static_cast<double>(own.tests.nodes + own.tests.primitives);
    case Heat::time:
      return microseconds;
  }
  return 0;
}

}  // namespace

int PreviewSettings::samples_to_take() const {
  if (heat == Heat::noise) return std::max(samples, fewest_for_noise);
  return samples > 1 && heat == Heat::none ? samples : 0;
}

PreviewPass PreviewPass::next() const {
  if (of_centres() && stride > 1) return {stride / 2, -1};
  return {1, sample + 1};
}

PreviewColumns columns_of(const PreviewRow& row) {
  const int stride = row.pass.stride;
  // In a row of the previous grid every second pixel is already traced.
  const bool old_row = row.pass.of_centres() && stride < PreviewPass::coarsest && row.row % (2 * stride) == 0;
  return old_row ? PreviewColumns{stride, 2 * stride} : PreviewColumns{0, stride};
}

class RowTracer::Tracing {
 public:
  Tracing() = default;
  virtual ~Tracing() = default;
  Tracing(const Tracing&) = delete;
  Tracing& operator=(const Tracing&) = delete;
  [[nodiscard]] virtual TracedRow trace(const PreviewRow& row, const Stop& stop) const = 0;
};

template <class T>
class RowTracer::TracingIn final : public RowTracer::Tracing {
 public:
  TracingIn(const Scene& scene, const PreviewSettings& settings, WorldCache& worlds, const Stop& stop)
      : settings_(settings),
        world_(worlds.of<T>(scene, settings.accelerator, settings.fault, stop)),
        kernel_(scene, *world_),
        centres_(scene, settings.size, settings.size) {
    if (settings.samples_to_take() > 0)
      spread_.emplace(scene, settings.size, settings.size, Sampling{settings.samples_to_take()});
  }

  [[nodiscard]] TracedRow trace(const PreviewRow& row, const Stop& stop) const override {
    TracedRow traced{row, {}, {}, {}};
    const auto [begin, step] = columns_of(row);
    const PixelBlock block{begin, settings_.size.width, row.row, row.row + 1, std::max(row.pass.sample, 0), step, 1,
                           stop};
    const RayGenerator<T>& camera = row.pass.of_centres() ? centres_ : *spread_;
    const auto put = [&](const Pixel&, const Rgb<T>& shade) { traced.shades.emplace_back(shade); };
    if (!row.pass.of_centres() || settings_.heat == Heat::none || settings_.heat == Heat::noise) {
      traced.statistics = kernel_(camera, block, put);
      return traced;
    }
    for (const Pixel& pixel : block) {
      const auto begun = std::chrono::steady_clock::now();
      const Statistics own =
          kernel_(camera, {pixel.column, pixel.column + 1, pixel.row, pixel.row + 1, 0, 1, 1, stop}, put);
      const double microseconds =
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count();
      traced.costs.push_back(cost_of(settings_.heat, own, microseconds));
      traced.statistics += own;
    }
    return traced;
  }

 private:
  PreviewSettings settings_;
  std::shared_ptr<const World<T>> world_;
  SceneKernel<T> kernel_;
  RayGenerator<T> centres_;
  std::optional<RayGenerator<T>> spread_;  ///< where samples are to be taken after the centres
};

RowTracer::RowTracer(const Scene& scene, const PreviewSettings& settings, WorldCache& worlds, const Stop& stop) {
  switch (settings.precision) {
    case Precision::float_:
      tracing_ = std::make_unique<TracingIn<float>>(scene, settings, worlds, stop);
      break;
    case Precision::double_:
      tracing_ = std::make_unique<TracingIn<double>>(scene, settings, worlds, stop);
      break;
  }
}
RowTracer::~RowTracer() = default;
RowTracer::RowTracer(RowTracer&&) noexcept = default;
RowTracer& RowTracer::operator=(RowTracer&&) noexcept = default;

TracedRow RowTracer::trace(const PreviewRow& row, const Stop& stop) const { return tracing_->trace(row, stop); }

}  // namespace raywalk
