#include "trace/pencil_kernel.h"

#include "trace/pencils.h"

namespace raywalk {

namespace {

/// What the tracer's functions say as their own lines is said as those of pencil tracing.
class PencilLines final : public Observer {
 public:
  explicit PencilLines(Observer& to) : to_(to) {}
  void record(Event&& event) override {
    event.line = with_pencil(event.line);
    to_.record(std::move(event));
  }

 private:
  Observer& to_;
};

}  // namespace

template <class T>
Statistics trace_pencils_watched(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                 const PutPixel<T>& put, Observer& observer) {
  PencilLines lines(observer);
  const auto run_with = [&]<class Chosen>() {
    PencilTracer<Chosen> tracer(world, camera, lines, block.stop, block.bounced);
    tracer.main_algorithm(block, put);
    return tracer.statistics();
  };
  // As those that watch the tracer (trace/kernel_of.h).
  if (world.numerics == Numerics::naive)
    return run_with.template operator()<Policy<T, Observer, all_hit_effects, Numerics::naive>>();
  return run_with.template operator()<Policy<T, Observer>>();
}

template Statistics trace_pencils_watched(const World<float>&, const RayGenerator<float>&, const PixelBlock&,
                                          const PutPixel<float>&, Observer&);
template Statistics trace_pencils_watched(const World<double>&, const RayGenerator<double>&, const PixelBlock&,
                                          const PutPixel<double>&, Observer&);

}  // namespace raywalk
