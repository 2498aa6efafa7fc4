#pragma once
// Radiosity (C. Goral, K. Torrance, D. Greenberg and B. Battaile, SIGGRAPH 1984) by progressive refinement (M. Cohen,
// S. Chen, J. Wallace and D. Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image Generation",
// SIGGRAPH 1988): the patch with most unshot light sends it to all others, until little is left. `main_algorithm` and
// `shoot_light` read like trace/pseudocode.h, and a test holds them together; what a statement does stands in
// trace/radiosity_steps.h.
//
// All light of a pixel is that of patches, what lamps send straight too: it counts once. Surfaces are matt; the light
// of a lamp L at distance r arrives as pi L / a(r), as trace/photon_lights.h has it.
//
// In a flat world everything is endless along z: patches are edges, form factors crossed strings, 2 stands for pi.

#include "math/stop.h"
#include "trace/pattern_filter.h"
#include "trace/policy.h"
#include "trace/radiosity_pass.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"
#include "trace/surface_vertex.h"

#include <optional>

namespace raywalk {

template <class Policy>
class RadiosityTracer {
 public:
  using T = typename Policy::Scalar;
  using Ray = typename Policy::Ray;
  using Observer = typename Policy::Observer;

  /// `irradiance`: what has been shot, for the pixels.
  RadiosityTracer(const World<T>& world, FormFactors& factors, const RadiositySettings& settings,
                  const PatchIrradiance& irradiance, const RayGenerator<T>& camera, Observer& observer,
                  const Stop& stop = {})
      : world_(world),
        factors_(factors),
        patches_(factors.patches()),
        settings_(settings),
        irradiance_(irradiance),
        camera_(camera),
        observer_(observer),
        stop_(stop),
        nested_(world),
        differential_(world, camera) {}

  /// RADIOSITY. Light is shot if `shooting` is not null; `pixels`, which yields Pixel, may be empty; `put(pixel,
  /// shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Shooting* shooting, const Pixels& pixels, Put&& put) {
    shooting_ = shooting;
    // Cut surfaces into patches
    cut_patches();
    // Give patches their own light
    light_patches();
    // While there is unshot light
    while (there_is_unshot_light()) {
      // Take patch with most of it
      const int patch = take_patch();
      // Shoot light (PATCH)
      shoot_light(call(patch));
    }
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form primary ray
      const EyeRay primary = form_primary_ray(pixel);
      // Find closest intersection
      const Nearest nearest = find_closest(primary);
      // Look up light of patches
      const Rgb<T> final = look_up_light(primary, nearest);
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  [[nodiscard]] const RadiosityState& state() const { return state_; }

 private:
  using Medium = typename World<T>::Medium;
  using Nearest = std::optional<Hit<T>>;
  struct EyeRay {
    Ray ray;
    Rgb<T> throughput;
    int length, number;
    const Medium* medium = nullptr;
  };

  /// SHOOT LIGHT (PATCH).
  void shoot_light(int patch) {
    // For each patch in front
    for (const FormFactors::Entry& other : row_of(patch)) {
      begin(other);
      // Compute form factor
      const double factor = compute_form_factor(patch, other);
      // Add what arrives
      add_what_arrives(patch, other.other, factor);
    }
    // Forget unshot light
    forget_unshot_light(patch);
  }

  void cut_patches();
  void light_patches();
  bool there_is_unshot_light();
  int take_patch();
  int call(int patch);
  const std::vector<FormFactors::Entry>& row_of(int patch);
  void begin(const FormFactors::Entry& other);
  double compute_form_factor(int patch, const FormFactors::Entry& other);
  void add_what_arrives(int patch, int other, double factor);
  void forget_unshot_light(int patch);

  void begin(const Pixel& pixel);
  EyeRay form_primary_ray(const Pixel& pixel);
  Nearest find_closest(const EyeRay& ray);
  Rgb<T> look_up_light(const EyeRay& ray, const Nearest& nearest);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  [[nodiscard]] double power_of(int patch) const;
  [[nodiscard]] PatchLight& light_of(int patch) { return state_.lights[static_cast<std::size_t>(patch)]; }
  /// Whether the current shot is recorded line by line, and whether in a step of its own.
  [[nodiscard]] bool walks() const { return state_.shots < shooting_->walked; }
  [[nodiscard]] bool shows() const { return state_.shots < shooting_->walked + shooting_->single; }
  /// The first of those that are shot together is announced too.
  [[nodiscard]] bool announces() const { return state_.shots <= shooting_->walked + shooting_->single; }

  template <class Make>
  void note(Line line, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, 0, make()});
  }

  const World<T>& world_;
  FormFactors& factors_;
  const Patches& patches_;
  const RadiositySettings& settings_;
  const PatchIrradiance& irradiance_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  const Shooting* shooting_ = nullptr;
  RadiosityState state_;
  Statistics statistics_;
  typename RayGenerator<T>::PixelDraws pixel_draws_;
  int rays_formed_ = 0;    ///< numbers the rays of a recording
  int shot_together_ = 0;  ///< of these shots there is one event
  int first_together_ = 0;
  [[no_unique_address]] std::conditional_t<Policy::effects.nesting, NestedMedia<T>, NoNestedMedia<T>> nested_;
  [[no_unique_address]] std::conditional_t<Policy::effects.filtering, FollowedDifferential<T>, NoDifferential<T>>
      differential_;  ///< patches have the colours of points
};

}  // namespace raywalk

#include "trace/radiosity_steps.h"
