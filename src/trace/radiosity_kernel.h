#pragma once
// Radiosity as the rest of the program runs it: light is shot first, then pixels look it up.

#include "trace/kernel.h"
#include "trace/radiosity_pass.h"

#include <memory>
#include <optional>

namespace raywalk {

/// Of a scene, in space or in the plane.
[[nodiscard]] RadiositySettings radiosity_settings_of(const Scene& scene, bool flat = false);

/// Shoots the light of patches. `stop` may cancel that, which then throws Stopped.
[[nodiscard]] RadiosityState shoot_light(FormFactors& factors, const RadiositySettings& settings,
                                         const Shooting& shooting = {}, const Stop& stop = {});

/// The light of one scene, shot and looked up. Which thread computes what changes no bit, nor does the scalar: light is
/// shot in double.
template <class T>
class RadiosityKernel {
 public:
  /// The scene's `world` outlives this. No light has been shot yet.
  RadiosityKernel(const Scene& scene, const World<T>& world, const RadiositySettings& settings)
      : scene_(scene), world_(world), settings_(settings), camera_(scene, {1, 1}, {1, 1}) {}

  [[nodiscard]] bool solved() const { return solved_; }
  /// Shoots the light. `stop` may cancel that, which then throws Stopped.
  void solve(const Stop& stop = {}, const Shooting& shooting = {});
  /// After `solve`.
  [[nodiscard]] const RadiosityState& state() const { return state_; }
  [[nodiscard]] const std::shared_ptr<const Patches>& patches() const { return patches_; }
  [[nodiscard]] const RadiositySettings& settings() const { return settings_; }
  [[nodiscard]] const BouncedLight& bounced() const { return bounced_; }

  Statistics operator()(const RayGenerator<T>& camera, const PixelBlock& block, const PutPixel<T>& put) const;
  /// The same observed by `observer`: same bits, same statistics.
  Statistics watched(const RayGenerator<T>& camera, const PixelBlock& block, Observer& observer,
                     const PutPixel<T>& put) const;
  /// All light again, observed.
  void watch_shots(const Shooting& shooting, Observer& observer, const Stop& stop = {}) const;

 private:
  template <class Watcher>
  Statistics run(const RayGenerator<T>& camera, const Shooting* shooting, const PixelBlock& block,
                 const PutPixel<T>& put, Watcher& observer) const;

  Scene scene_;
  const World<T>& world_;
  RadiositySettings settings_;
  RayGenerator<T> camera_;
  std::shared_ptr<const Patches> patches_;
  std::unique_ptr<FormFactors> factors_;
  RadiosityState state_;
  PatchIrradiance irradiance_;
  BouncedLight bounced_;
  bool solved_ = false;
};

extern template class RadiosityKernel<float>;
extern template class RadiosityKernel<double>;

}  // namespace raywalk
