#pragma once
// The tracer: T. Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980, with Blinn's highlight
// (1977); distributed: R. Cook, T. Porter and L. Carpenter, "Distributed ray tracing", SIGGRAPH 1984, which samples the
// target of each of the same rays: on the light, in the lobe, on the lens, in the shutter's time. `main_algorithm` and
// `shade` are the two procedures that the visualiser shows; every comment that is a line of pseudocode heads the
// statement that the line names, and a test keeps the texts together. What a statement does is in the function that it
// calls (trace/tracer_steps.h).

#include "math/stop.h"
#include "trace/media.h"
#include "trace/optics.h"
#include "trace/pattern_filter.h"
#include "trace/policy.h"
#include "trace/primary_rays.h"
#include "trace/radiosity_pass.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"
#include "trace/world.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace raywalk {

template <class Policy>
class Tracer {
 public:
  using T = typename Policy::Scalar;
  using Ray = typename Policy::Ray;
  using Observer = typename Policy::Observer;

  /// `stop` may cancel inside a pixel: `main_algorithm` then throws Stopped. `bounced`: in the place of ambient light.
  Tracer(const World<T>& world, const RayGenerator<T>& camera, Observer& observer, const Stop& stop = {},
         const BouncedLight* bounced = nullptr)
      : world_(world),
        camera_(camera),
        observer_(observer),
        stop_(stop),
        primary_rays_(world, camera),
        last_blockers_(world.lights.size(), -1),
        nested_(world) {
    if constexpr (Policy::effects.bounced) bounced_.light = bounced;
  }

  /// MAIN ALGORITHM. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade. `from_eye`: PrimaryRays, or
  /// what has their interface.
  template <class Pixels, class Put, class FromEye>
  void main_algorithm(const Pixels& pixels, Put&& put, FromEye& from_eye) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form primary ray
      const TreeRay primary = form_primary_ray(from_eye, pixel);
      // Find closest intersection
      const Nearest nearest = find_closest(from_eye, primary);
      Rgb<T> final = background_of(primary, nearest);
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
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    main_algorithm(pixels, put, primary_rays_);
  }

  /// What comes back along one ray, whose hit SHADE shades at this depth. `medium`: that it starts in, if known.
  Rgb<T> radiance_along(const Ray& ray, int depth, const typename World<T>::Medium* medium) {
    TreeRay followed(ray, RayKind::reflect, Rgb<T>(1), 0);
    if constexpr (Policy::effects.refraction) followed.in.medium = medium;
    const Nearest nearest = find_closest(Line::find_reflect_intersect, depth, followed);
    return nearest ? shade(depth, followed, *nearest) : background_along(followed);
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  /// Counts from nothing again.
  Statistics take_statistics() { return std::exchange(statistics_, {}); }

 protected:  // for pencil tracing, which follows a pencil's axis so (trace/pencils.h)
  /// The position of a ray in the ray tree, which keys its draws; only in kernels that draw.
  struct Branch {
    std::uint64_t path = 0;
  };
  /// The medium that a ray travels in, if known; only in kernels that refract.
  using Medium = typename World<T>::Medium;
  struct InMedium {
    const Medium* medium = nullptr;
  };
  /// The number of ancestors of a ray; only in kernels that may fail to count DEPTH.
  struct Generation {
    int number = 0;
  };
  /// The rays formed before the current pixel; only in the same kernels, which give a pixel so many.
  struct Formed {
    int rays = 0;
  };
  /// The differential of a ray that was spawned, or of any that has arrived at a hit; only in kernels that filter and
  /// spawn rays.
  struct Neighbours {
    RayDifferential<T> differential;
  };
  /// What is in the place of ambient light, if anything is; only in kernels that look it up.
  struct Bounced {
    const BouncedLight* light = nullptr;
  };
  template <class Member>
  struct Without {};
  template <bool Has, class Member>
  using Only = std::conditional_t<Has, Member, Without<Member>>;
  static constexpr bool draws = Policy::effects.penumbra || Policy::effects.lobes;
  static constexpr bool carries_differentials =
      Policy::effects.filtering && (Policy::effects.reflection || Policy::effects.refraction);
  /// Whether the possible blockers of an area light are found once for all its samples; not with naive rays, whose
  /// origins differ.
  static constexpr bool culls = Policy::effects.penumbra && std::is_same_v<Ray, raywalk::Ray<T>>;
  /// A ray of the ray tree, with its state.
  struct TreeRay {
    TreeRay(const Ray& the_ray, RayKind its_kind, const Rgb<T>& its_throughput, int its_number)
        : ray(the_ray), kind(its_kind), throughput(its_throughput), number(its_number) {}
    Ray ray;
    RayKind kind;
    Rgb<T> throughput;
    int number;  ///< in the recording; 0 without an observer
    [[no_unique_address]] Only<draws, Branch> branch{};
    [[no_unique_address]] Only<Policy::effects.refraction, InMedium> in{};
    [[no_unique_address]] Only<Policy::faulty, Generation> generation{};
    [[no_unique_address]] Only<carries_differentials, Neighbours> neighbours{};
  };
  /// A ray to a light.
  struct Shadow {
    Ray ray;
    int number;  ///< as above
    [[no_unique_address]] Only<Policy::effects.refraction, InMedium> in{};
  };
  using Nearest = std::optional<Hit<T>>;
  /// The hit, prepared for SHADE: position, normals and the weights that "If reflective" and "If transparent" test.
  struct ShadingPoint;
  /// Of small facets one is chosen at random, whose weight the reflect or the refract ray then has.
  using ShadedPoint = std::conditional_t<Policy::effects.microfacets, ShadingPoint, const ShadingPoint>;
  /// The sum over all lights; each one's term only when observed.
  struct DirectLighting;

  /// SHADE (DEPTH, RTNSHADE): the light that leaves the hit against the ray's direction.
  Rgb<T> shade(int depth, const TreeRay& ray, const Hit<T>& hit) {
    ShadedPoint at = prepare(ray, hit);
    DirectLighting direct;
    if constexpr (Policy::effects.shadows) {
      for (const Light& light : world_.lights) {
        set_shadow_hints(at, light);
        for (int sample = 0; sample < samples_of(light); ++sample) {
          // Form shadow ray
          const auto shadow = form_shadow_ray(depth, at, ray, light, sample);
          if (!shadow) {
            add_unlit(direct, light);
            continue;
          }
          // Find intersection
          const Rgb<T> visible = find_intersection(depth, *shadow, light);
          add_light(direct, at, ray, light, shadow->ray, visible);
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
          reflected =
              at.reflection() * (nearest ? shade(deeper, *reflect_ray, *nearest) : background_along(*reflect_ray));
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
          refracted =
              at.transmission() * (nearest ? shade(deeper, *refract_ray, *nearest) : background_along(*refract_ray));
        }
      }
    }
    // Compute rtnshade
    return compute_rtnshade(depth, at, direct, reflected, refracted);
  }

  using Light = typename World<T>::Light;
  using Surface = typename World<T>::Surface;

  void begin(const Pixel& pixel);
  template <class FromEye>
  TreeRay form_primary_ray(FromEye& from_eye, const Pixel& pixel);
  std::optional<Shadow> form_shadow_ray(int depth, const ShadingPoint& at, const TreeRay& ray, const Light& light,
                                        int sample);
  std::optional<TreeRay> form_reflect_ray(int depth, ShadedPoint& at, const TreeRay& ray);
  std::optional<TreeRay> form_refract_ray(int depth, ShadedPoint& seen, const TreeRay& ray);
  template <class Draw>
  std::optional<TreeRay> form_secondary_ray(Line line, int depth, const ShadingPoint& at, const TreeRay& parent,
                                            RayKind kind, const Vec3<T>& sharp, const Rgb<T>& weight,
                                            Draw draw_direction);
  template <class FromEye>
  Nearest find_closest(FromEye& from_eye, const TreeRay& primary);
  Nearest find_closest(Line line, int depth, const TreeRay& ray);
  /// Counts and tells how a ray ended that was followed to its closest intersection.
  void end(Line line, int depth, const TreeRay& ray, const Nearest& nearest);
  /// What a ray brings back that leaves the scene; without a sky in the kernel, the same for every ray.
  [[nodiscard]] Rgb<T> background_along(const TreeRay& ray) const {
    if constexpr (Policy::effects.sky)
      if (world_.sky) return Rgb<T>(world_.sky->radiance(Vec3d(ray.ray.direction)));
    return world_.background;
  }
  /// The same, which a kernel with a sky looks up only where nothing was met.
  [[nodiscard]] Rgb<T> background_of(const TreeRay& ray, const Nearest& nearest) const {
    if constexpr (Policy::effects.sky)
      if (nearest) return Rgb<T>(0);
    return background_along(ray);
  }
  Rgb<T> find_intersection(int depth, const Shadow& shadow, const Light& light);
  [[nodiscard]] RayDifferential<T> differential_after(const ShadingPoint& at, const TreeRay& ray, RayKind kind,
                                                      const Vec3<T>& direction) const;
  [[nodiscard]] static const Medium* medium_on_side(const ShadingPoint& at, const TreeRay& ray, bool refracted);
  void set_shadow_hints(const ShadingPoint& at, const Light& light);
  [[nodiscard]] static int samples_of(const Light& light);
  [[nodiscard]] RandomKey light_key(const TreeRay& ray) const;
  [[nodiscard]] static Vec3<T> sample_light(const Light& light, const Vec2<T>& unit);
  [[nodiscard]] static Vec3<T> regular_on_light(const Light& light, int sample);
  Vec3<T> light_point(const ShadingPoint& at, const TreeRay& ray, const Light& light, int sample);
  Vec3<T> sample_cone(const TreeRay& ray, const Vec3<T>& direction, T one_minus_cos, const Vec3<T>& facing_normal,
                      Effect effect);
  Vec3<T> sample_rough(const TreeRay& ray, const Vec3<T>& direction, T one_minus_cos, const Vec3<T>& facing_normal,
                       Effect effect);
  /// Whether the reflect or the refract ray is drawn at random from small facets.
  [[nodiscard]] bool draws_facet(const ShadingPoint& at, RayKind kind) const;
  Vec3<T> sample_facet(ShadedPoint& at, const TreeRay& ray, RayKind kind);
  /// A scattering function times the cosine, and the density of a direction that is drawn.
  struct FacetValue {
    Rgb<T> weight{0}, value{0};  ///< kr of mirrors, of which `value` is the rest
    T pdf = 0;
  };
  /// Of small facets, for light from a unit direction; 0 of others.
  [[nodiscard]] static FacetValue evaluate_facets(const ShadingPoint& at, const TreeRay& ray, const Vec3<T>& to_light);
  bool decide_intersected(const Nearest& nearest);
  bool decide_reflective(int depth, const ShadingPoint& at);
  bool decide_transparent(int depth, const ShadingPoint& at);
  /// The DEPTH of the SHADE that is called.
  int call_shade(Line line, int depth, const TreeRay& ray, const Nearest& nearest);
  ShadingPoint prepare(const TreeRay& ray, const Hit<T>& hit);
  void add_unlit(DirectLighting& direct, const Light& light);
  void add_light(DirectLighting& direct, const ShadingPoint& at, const TreeRay& ray, const Light& light,
                 const Ray& shadow, const Rgb<T>& visible);
  Rgb<T> compute_rtnshade(int depth, const ShadingPoint& at, const DirectLighting& direct, const Rgb<T>& reflected,
                          const Rgb<T>& refracted);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  /// Passes what `make` returns to the observer; without an observer, `make` is not compiled into the kernel.
  template <class Make>
  void note(Line line, int depth, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, depth, make()});
  }

  /// A copy of what a fault may change; without faults, a reference to it.
  template <class Value>
  using Faultable = std::conditional_t<Policy::faulty, Value, const Value&>;
  [[nodiscard]] bool runs_away(const TreeRay& parent) const;
  /// Not inlined: it would cost small trees, which never ask, a register.
  [[gnu::noinline]] void check_stop() const { stop_.check(); }

  const World<T>& world_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  PrimaryRays<T> primary_rays_;
  [[no_unique_address]] Only<draws, RandomKey> key_{};  ///< of the current sample
  [[no_unique_address]] Only<Policy::effects.bounced, Bounced> bounced_{};
  int rays_formed_ = 0;  ///< numbers the rays of a recording
  [[no_unique_address]] Only<Policy::faulty, Formed> before_pixel_{};
  std::vector<int> filters_met_;        ///< kept so that no shadow ray allocates
  std::vector<int> last_blockers_;      ///< by light: the shadow cache
  std::vector<int> possible_blockers_;  ///< primitives that may occlude the current light from the current hit
  ShadowHints hints_;                   ///< for the shadow rays between these two
  [[no_unique_address]] std::conditional_t<Policy::effects.nesting, NestedMedia<T>, NoNestedMedia<T>> nested_;
};

}  // namespace raywalk

#include "trace/tracer_draws.h"
#include "trace/tracer_shading.h"
#include "trace/tracer_steps.h"
