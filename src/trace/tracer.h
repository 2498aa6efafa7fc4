#pragma once
// The tracer: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980, with Blinn's highlight
// (1977); distributed: R. Cook, T. Porter and L. Carpenter, "Distributed ray tracing", SIGGRAPH 1984, which sends each
// of the same rays to a place that is drawn: on the light, in the lobe, on the lens, in the shutter's time.
// `main_algorithm` and `shade` are the two procedures that the visualiser shows; every comment of the form of a
// pseudocode line heads the statement that the line names, and a test holds the texts together. What a statement does
// stands in the function it calls, below (trace/tracer_steps.h).

#include "math/stop.h"
#include "trace/media.h"
#include "trace/optics.h"
#include "trace/policy.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"
#include "trace/world.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace raywalk {

template <class Policy>
class Tracer {
 public:
  using T = typename Policy::Scalar;
  using Ray = typename Policy::Ray;
  using Observer = typename Policy::Observer;

  /// `stop` may end the work inside a pixel: `main_algorithm` throws Stopped then.
  Tracer(const World<T>& world, const RayGenerator<T>& camera, Observer& observer, const Stop& stop = {})
      : world_(world),
        camera_(camera),
        observer_(observer),
        stop_(stop),
        last_blockers_(world.lamps.size(), -1),
        nested_(world) {}

  /// MAIN ALGORITHM. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form primary ray
      const Traced primary = form_primary_ray(pixel);
      // Find closest intersection
      const Nearest nearest = find_closest(Line::find_closest_intersection, 0, primary);
      Rgb<T> final = world_.background;
      // If intersect something
      if (decide_intersected(nearest)) {
        // Shade (DEPTH+1, final)
        const int depth = call_shade(Line::shade_final, 0, primary, nearest);
        final = shade(depth, primary, *nearest);
      }
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  /// Place of a ray in the ray tree, which draws are keyed by; only kernels that draw carry it along.
  struct Branch {
    std::uint64_t path = 0;
  };
  /// What a ray travels in, where that is known; only kernels that refract carry it along.
  using Medium = typename World<T>::Medium;
  struct InMedium {
    const Medium* medium = nullptr;
  };
  /// How many rays a ray descends from; only kernels that may forget to count DEPTH carry it along.
  struct Generation {
    int number = 0;
  };
  template <class Member>
  struct Without {};
  template <bool Has, class Member>
  using Only = std::conditional_t<Has, Member, Without<Member>>;
  static constexpr bool draws = Policy::effects.penumbra || Policy::effects.lobes;
  /// Whether what may hide a light with an extent is found once for all its samples; naive rays start elsewhere.
  static constexpr bool culls = Policy::effects.penumbra && std::is_same_v<Ray, raywalk::Ray<T>>;
  /// A ray on its way: what it is, and the largest part of the pixel it can bring.
  struct Traced {
    Traced(const Ray& the_ray, RayKind its_kind, const Rgb<T>& its_share, int its_number)
        : ray(the_ray), kind(its_kind), share(its_share), number(its_number) {}
    Ray ray;
    RayKind kind;
    Rgb<T> share;
    int number;  ///< in the recording; 0 when nobody watches
    [[no_unique_address]] Only<draws, Branch> branch{};
    [[no_unique_address]] Only<Policy::effects.refraction, InMedium> in{};
    [[no_unique_address]] Only<Policy::faulty, Generation> generation{};
  };
  /// A ray to a light.
  struct Shadow {
    Ray ray;
    int number;  ///< as above
    [[no_unique_address]] Only<Policy::effects.refraction, InMedium> in{};
  };
  using Nearest = std::optional<Hit<T>>;
  /// The hit, made ready for SHADE: place, normal and the weights that "If reflective" and "If transparent" test.
  struct Shading;
  /// What all lights together bring; each one's part only when watched.
  struct Direct;

  /// SHADE (DEPTH, RTNSHADE): the light that leaves the hit against the ray's direction.
  Rgb<T> shade(int depth, const Traced& ray, const Hit<T>& hit) {
    const Shading at = prepare(ray, hit);
    Direct direct;
    if constexpr (Policy::effects.shadows) {
      for (const Lamp& lamp : world_.lamps) {
        look_between(at, lamp);
        for (int sample = 0; sample < samples_of(lamp); ++sample) {
          // Form shadow ray
          const auto shadow = form_shadow_ray(depth, at, ray, lamp, sample);
          if (!shadow) {
            add_unlit(direct, lamp);
            continue;
          }
          // Find intersection
          const Rgb<T> visible = find_intersection(depth, *shadow, lamp);
          add_light(direct, at, ray, lamp, shadow->ray, visible);
        }
      }
    }
    Rgb<T> reflected{0}, refracted{0};
    if constexpr (Policy::effects.reflection) {
      // If reflective
      if (decide_reflective(depth, at)) {
        // Form reflect ray
        if (const auto reflect_ray = form_reflect_ray(depth, at, ray)) {
          // Find closest intersect
          const Nearest nearest = find_closest(Line::find_reflect_intersect, depth, *reflect_ray);
          // Shade (DEPTH+1, REFLSHADE)
          const int deeper = call_shade(Line::shade_reflect, depth, *reflect_ray, nearest);
          reflected = at.reflection() * (nearest ? shade(deeper, *reflect_ray, *nearest) : world_.background);
        }
      }
    }
    if constexpr (Policy::effects.refraction) {
      // If transparent
      if (decide_transparent(depth, at)) {
        // Form refract ray
        if (const auto refract_ray = form_refract_ray(depth, at, ray)) {
          // Find closest intersect
          const Nearest nearest = find_closest(Line::find_refract_intersect, depth, *refract_ray);
          // Shade (DEPTH+1, REFRSHADE)
          const int deeper = call_shade(Line::shade_refract, depth, *refract_ray, nearest);
          refracted = at.transmission() * (nearest ? shade(deeper, *refract_ray, *nearest) : world_.background);
        }
      }
    }
    // Compute rtnshade
    return compute_rtnshade(depth, at, direct, reflected, refracted);
  }

  using Lamp = typename World<T>::Lamp;
  using Surface = typename World<T>::Surface;

  void begin(const Pixel& pixel);
  Traced form_primary_ray(const Pixel& pixel);
  std::optional<Shadow> form_shadow_ray(int depth, const Shading& at, const Traced& ray, const Lamp& lamp, int sample);
  std::optional<Traced> form_reflect_ray(int depth, const Shading& at, const Traced& ray);
  std::optional<Traced> form_refract_ray(int depth, const Shading& at, const Traced& ray);
  template <class Draw>
  std::optional<Traced> form_secondary_ray(Line line, int depth, const Shading& at, const Traced& parent, RayKind kind,
                                           const Vec3<T>& sharp, const Rgb<T>& weight, Draw draw_direction);
  Nearest find_closest(Line line, int depth, const Traced& ray);
  Rgb<T> find_intersection(int depth, const Shadow& shadow, const Lamp& lamp);
  [[nodiscard]] static const Medium* medium_beside(const Shading& at, const Traced& ray, bool refracted);
  void look_between(const Shading& at, const Lamp& lamp);
  [[nodiscard]] static int samples_of(const Lamp& lamp);
  [[nodiscard]] RandomKey light_key(const Traced& ray) const;
  Vec3<T> light_point(const Shading& at, const Traced& ray, const Lamp& lamp, int sample);
  Vec3<T> spread(const Traced& ray, const Vec3<T>& direction, T one_minus_cos, const Vec3<T>& side, Effect effect);
  bool decide_intersected(const Nearest& nearest);
  bool decide_reflective(int depth, const Shading& at);
  bool decide_transparent(int depth, const Shading& at);
  /// The DEPTH of the SHADE that is called.
  int call_shade(Line line, int depth, const Traced& ray, const Nearest& nearest);
  Shading prepare(const Traced& ray, const Hit<T>& hit);
  void add_unlit(Direct& direct, const Lamp& lamp);
  void add_light(Direct& direct, const Shading& at, const Traced& ray, const Lamp& lamp, const Ray& shadow,
                 const Rgb<T>& visible);
  Rgb<T> compute_rtnshade(int depth, const Shading& at, const Direct& direct, const Rgb<T>& reflected,
                          const Rgb<T>& refracted);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  /// Tells the observer what `make` returns; when nobody watches, `make` is not even compiled into the kernel.
  template <class Make>
  void note(Line line, int depth, Make&& make) {
#ifndef RAYWALK_WITHOUT_HOOKS  // set only by the benchmark that measures what the empty observer costs: nothing
    if constexpr (Observer::watches) observer_.record(Event{line, depth, make()});
#else
    static_cast<void>(line), static_cast<void>(depth), static_cast<void>(make);
#endif
  }

  /// The policy's hook for faults: lets the one that the world names spoil what a statement has computed. Where there
  /// are no faults, `spoil` is not even compiled into the kernel.
  template <class Spoil>
  void break_by(Fault fault, Spoil&& spoil) const {
    if constexpr (Policy::faulty) {
      if (world_.fault == fault) spoil();
    }
  }
  /// What a fault may spoil: a copy of it; where there are no faults, the thing itself.
  template <class Value>
  using Spoilable = std::conditional_t<Policy::faulty, Value, const Value&>;
  [[nodiscard]] bool runs_away(const Traced& parent) const;

  const World<T>& world_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  typename RayGenerator<T>::PixelDraws pixel_draws_;
  [[no_unique_address]] Only<draws, RandomKey> key_{};                   ///< of the sample under way
  int rays_formed_ = 0;                                                  ///< numbers the rays of a recording
  [[no_unique_address]] Only<Policy::faulty, Generation> generation_{};  ///< rays formed before the pixel under way
  std::vector<int> filters_met_;                                         ///< kept so that no shadow ray allocates
  std::vector<int> last_blockers_;                                       ///< by lamp: what the shadow cache holds
  std::vector<int> between_;  ///< primitives that may hide the light at hand from the hit at hand
  ShadowHints hints_;         ///< of the rays between those two
  [[no_unique_address]] std::conditional_t<Policy::effects.nesting, NestedMedia<T>, NothingNests<T>> nested_;
};

}  // namespace raywalk

#include "trace/tracer_draws.h"
#include "trace/tracer_shading.h"
#include "trace/tracer_steps.h"
