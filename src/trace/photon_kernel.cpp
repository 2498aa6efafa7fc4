#include "trace/photon_kernel.h"

#include "trace/photons.h"

#include <atomic>
#include <cmath>
#include <utility>

namespace raywalk {

double PhotonSettings::squared_radius(int pass) const {
  double squared = radius * radius;
  for (int i = 1; i <= pass; ++i) squared *= (i + alpha) / (i + 1);
  return squared;
}

PhotonSettings photon_settings_of(const Scene& scene, bool flat) {
  const PhotonChoices& choices = scene.render.photons;
  PhotonSettings settings;
  settings.count = choices.count;
  settings.nearest = choices.nearest;
  settings.radius = choices.radius.value_or(infinity<double>);
  settings.gather = choices.gather;
  settings.progressive = choices.progressive;
  settings.flat = flat;
  return settings;
}

template <class T>
PhotonKernel<T>::PhotonKernel(const Scene& scene, const World<T>& world, const Emitters<T>& emitters,
                              const PhotonSettings& settings)
    : world_(world),
      emitters_(emitters),
      settings_(settings),
      lights_(world, emitters, settings.flat),
      camera_(scene, {1, 1}, {1, 1}) {
  constexpr double share = 0.1;  // of the radius of the scene
  if (std::isinf(settings_.radius) && lights_.radius() > 0) settings_.radius = share * lights_.radius();
}

template <class T>
template <class Watcher, class Use>
Statistics PhotonKernel<T>::run(const RayGenerator<T>& camera, const PhotonRange& photons, const PixelBlock& block,
                                const PutPixel<T>& put, Watcher& observer, Use use) const {
  const auto run_with = [&]<class Chosen>() {
    PhotonTracer<Chosen> tracer(world_, emitters_, lights_, settings_, *maps_, first_pass_, camera, observer,
                                block.stop);
    tracer.main_algorithm(photons, block, put);
    use(tracer.caustic_photons(), tracer.other_photons());
    return tracer.statistics();
  };
  if constexpr (few_kernels && !Watcher::watches) {
    if (world_.numerics == Numerics::naive) {
      ForgetfulObserver forgetful;
      return run<Observer>(camera, photons, block, put, forgetful, use);
    }
  } else if (world_.numerics == Numerics::naive) {
    return run_with.template operator()<Policy<T, Watcher, all_hit_effects, Numerics::naive, true>>();
  }
  if constexpr (!Watcher::watches && !few_kernels) {
    if (world_.surface_maps.empty())
      return world_.filters() || !world_.microsurfaces.empty()
                 ? run_with.template operator()<Policy<T, Watcher, no_maps>>()
                 : run_with.template operator()<Policy<T, Watcher, no_filtering_nor_facets>>();
  }
  return run_with.template operator()<Policy<T, Watcher>>();
}

template <class T>
bool PhotonKernel<T>::ready_for(std::uint64_t seed, int first, int last) const {
  if (!sent_ || seed != settings_.seed) return false;
  return !settings_.progressive || (first >= first_pass_ && last <= first_pass_ + static_cast<int>(maps_->size()));
}

template <class T>
Statistics PhotonKernel<T>::send(std::uint64_t seed, int first, int last, const Stop& stop, const RunAll& run_all,
                                 const std::function<void(int)>& sent) {
  Statistics statistics;
  settings_.seed = seed;
  const int passes = settings_.progressive ? last - first : 1;
  auto maps = std::make_shared<std::vector<PhotonMaps>>(static_cast<std::size_t>(passes));
  first_pass_ = settings_.progressive ? first : 0;
  sent_ = false;
  if (!lights_.empty())
    for (int i = 0; i < passes; ++i)
      statistics += send_pass(first_pass_ + i, stop, run_all, sent, (*maps)[static_cast<std::size_t>(i)]);
  maps_ = std::move(maps);
  sent_ = true;
  return statistics;
}

template <class T>
Statistics PhotonKernel<T>::send_pass(int pass, const Stop& stop, const RunAll& run_all,
                                      const std::function<void(int)>& sent, PhotonMaps& maps) const {
  // The same chunks whoever sends them, put together in their order.
  constexpr int chunk = 4096;
  const int chunks = (settings_.count + chunk - 1) / chunk;
  struct Stored {
    StoredPhotons caustic, other;
    Statistics statistics;
  };
  std::vector<Stored> stored(static_cast<std::size_t>(chunks));
  std::atomic<bool> stopped{false};
  const auto body = [&](int i) {
    if (stopped) return;
    Stored& own = stored[static_cast<std::size_t>(i)];
    const PhotonRange range{i * chunk, std::min(settings_.count, (i + 1) * chunk), pass};
    PixelBlock none;
    none.stop = stop;
    NoObserver no_observer;
    try {
      own.statistics = run(camera_, range, none, {}, no_observer, [&](auto& caustic, auto& other) {
        own.caustic = std::move(caustic);
        own.other = std::move(other);
      });
    } catch (const Stopped&) {
      stopped = true;
      return;
    }
    if (sent) sent(range.end - range.begin);
  };
  for_all(run_all, chunks, body);
  if (stopped) throw Stopped{};
  StoredPhotons caustic, other;
  const auto append = [](StoredPhotons& to, const StoredPhotons& more) {
    to.photons.insert(to.photons.end(), more.photons.begin(), more.photons.end());
    to.incidents.insert(to.incidents.end(), more.incidents.begin(), more.incidents.end());
  };
  Statistics statistics;
  for (Stored& each : stored) {
    append(caustic, each.caustic);
    append(other, each.other);
    statistics += each.statistics;
    each = {};
  }
  maps.caustic = PhotonMap(caustic, stop);
  maps.other = PhotonMap(other, stop);
  return statistics;
}

template <class T>
Statistics PhotonKernel<T>::operator()(const RayGenerator<T>& camera, const PixelBlock& block,
                                       const PutPixel<T>& put) const {
  NoObserver no_observer;
  return run(camera, {}, block, put, no_observer, [](const auto&, const auto&) {});
}

template <class T>
Statistics PhotonKernel<T>::watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer,
                                    const PutPixel<T>& put) const {
  return run(camera, {}, block, put, observer, [](const auto&, const auto&) {});
}

template <class T>
void PhotonKernel<T>::watch_photons(int most, Observer& observer, const Stop& stop) const {
  if (lights_.empty()) return;
  const int shown = std::min(most, settings_.count);
  PixelBlock none;
  none.stop = stop;
  static_cast<void>(run(camera_, {0, shown, 0}, none, {}, observer, [](const auto&, const auto&) {}));
  if (shown < settings_.count)
    observer.record(Event{Line::for_each_photon, 0, PhotonBegun{shown, settings_.count, settings_.count - shown}});
}

template class PhotonKernel<float>;
template class PhotonKernel<double>;

}  // namespace raywalk
