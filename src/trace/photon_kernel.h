#pragma once
// Photon mapping as the rest of the program runs it: photons first, then pixels.

#include "trace/kernel.h"
#include "trace/photon_lights.h"
#include "trace/photon_pass.h"
#include "trace/run_all.h"

#include <functional>
#include <memory>
#include <vector>

namespace raywalk {

/// Of a scene, in space or in the plane.
[[nodiscard]] PhotonSettings photon_settings_of(const Scene& scene, bool flat = false);

/// The photons of one scene, sent and found again. Which thread sends which photon changes no bit.
template <class T>
class PhotonKernel {
 public:
  /// `world` and `emitters` outlive this. No photon has been sent yet.
  PhotonKernel(const Scene& scene, const World<T>& world, const Emitters<T>& emitters, const PhotonSettings& settings);

  [[nodiscard]] const PhotonSettings& settings() const { return settings_; }
  /// Whether the samples from `first` to before `last` of each pixel have their photons, drawn from this seed.
  [[nodiscard]] bool ready_for(std::uint64_t seed, int first, int last) const;
  /// Sends the photons for these samples, and forgets those of others. `stop` may cancel that, which then throws
  /// Stopped; `sent(photons)` is told how many more have been sent, by whoever sent them.
  Statistics send(std::uint64_t seed, int first, int last, const Stop& stop = {}, const RunAll& run_all = {},
                  const std::function<void(int photons)>& sent = {});
  /// What the photons have left, by pass.
  [[nodiscard]] const std::vector<PhotonMaps>& maps() const { return *maps_; }
  [[nodiscard]] std::shared_ptr<const std::vector<PhotonMaps>> shared_maps() const { return maps_; }

  Statistics operator()(const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put) const;
  /// The same observed by `observer`: same bits, same statistics.
  Statistics watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer,
                     const PutPixel<T>& put) const;
  /// The first `most` photons again, observed, and the others in one event.
  void watch_photons(int most, Observer& observer, const Stop& stop = {}) const;

 private:
  template <class Watcher, class Use>
  Statistics run(const RayGenerator<T>& camera, const PhotonRange& photons, const PixelBlock& block,
                 const PutPixel<T>& put, Watcher& observer, Use use) const;
  Statistics send_pass(int pass, const Stop& stop, const RunAll& run_all, const std::function<void(int)>& sent,
                       PhotonMaps& maps) const;

  const World<T>& world_;
  const Emitters<T>& emitters_;
  PhotonSettings settings_;
  PhotonLights<T> lights_;
  RayGenerator<T> camera_;  ///< of photons, for the time at which they are sent
  std::shared_ptr<const std::vector<PhotonMaps>> maps_ = std::make_shared<std::vector<PhotonMaps>>();
  int first_pass_ = 0;
  bool sent_ = false;
};

extern template class PhotonKernel<float>;
extern template class PhotonKernel<double>;

}  // namespace raywalk
