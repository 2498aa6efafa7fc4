#pragma once
// Path tracing: J. Kajiya, "The Rendering Equation", SIGGRAPH 1986; with the light at every vertex sampled both from
// the lights and along the path, combined by multiple importance sampling (E. Veach and L. Guibas, "Optimally Combining
// Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995), and paths ended by Russian roulette (J. Arvo and D.
// Kirk, SIGGRAPH 1990). `main_algorithm` and `follow_path` read like trace/pseudocode.h, and a test holds them
// together; what a statement does stands in trace/path_steps.h, trace/path_light_steps.h and, inside of
// bodies that scatter light, trace/path_medium_steps.h or trace/path_dipole_steps.h.
//
// Materials are the tracer's: kd / pi is Lambertian, the highlight is a lobe, mirrors and glass are exact. Differences
// from SHADE: surfaces light each other, so `ambient`, which approximates that, is left out. Russian roulette ends
// paths without bias, so the depth limit and the threshold, which lose light, are ignored. Every normal faces the ray:
// a `fixed` one, as in course scenes, would let light through the backs of surfaces.

#include "math/stop.h"
#include "trace/bsdf.h"
#include "trace/emitters.h"
#include "trace/media.h"
#include "trace/medium_walk.h"
#include "trace/pattern_filter.h"
#include "trace/policy.h"
#include "trace/primary_rays.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"
#include "trace/surface_vertex.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace raywalk {

/// How the light of emitters and of the sky is sampled. All but `both` are for studies.
enum class PathStrategy {
  both,        ///< combined by multiple importance sampling
  lights,      ///< light sampling only, wherever these can be sampled
  directions,  ///< BSDF sampling only
};

struct PathSettings {
  int max_length = 0;     ///< maximum number of rays of a path from the eye to a light, the last one included; 0: no
                          ///< limit
  int roulette_from = 4;  ///< number of rays before Russian roulette begins; >= 1
  PathStrategy strategy = PathStrategy::both;
  SkySampling sky = SkySampling::by_brightness;
  bool flat = false;  ///< rays from the eye, and where media scatter them, stay in the plane z = 0
  friend bool operator==(const PathSettings&, const PathSettings&) = default;
};

/// Of the policy's effects (trace/policy.h), only nesting, scattering, dipole, sky, filtering,
/// microfacets and maps matter.
template <class Policy>
class PathTracer {
 public:
  using T = typename Policy::Scalar;
  using Ray = typename Policy::Ray;
  using Observer = typename Policy::Observer;

  PathTracer(const World<T>& world, const Emitters<T>& emitters, const PathSettings& settings,
             const RayGenerator<T>& camera, Observer& observer, const Stop& stop = {})
      : world_(world),
        emitters_(emitters),
        settings_(settings),
        camera_(camera),
        observer_(observer),
        stop_(stop),
        primary_rays_(world, camera),
        nested_(world),
        differential_(world, camera) {}

  /// Allows primary rays of these pixels to be searched before their turn, several at once.
  void look_ahead(const PixelBlock& pixels) {
    if (!settings_.flat && PrimaryRaysAhead<T>::pays(world_)) ahead_.emplace(world_, camera_, pixels);
  }

  /// PATH TRACING. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form primary ray
      const PathRay primary = form_primary_ray(pixel);
      // Follow path (final)
      const Rgb<T> final = follow_path(call(primary));
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  using Medium = typename World<T>::Medium;
  using Surface = typename World<T>::Surface;
  /// Whether media may scatter (trace/path_medium_steps.h).
  static constexpr bool media = Policy::effects.scattering;
  /// Whether they may let light out without a walk (trace/path_dipole_steps.h).
  static constexpr bool dipoles = media && Policy::effects.dipole;
  struct Nothing {};
  struct NoExit {};
  /// A ray of the path, with its state.
  struct PathRay {
    Ray ray;
    RayKind kind;
    Rgb<T> throughput;               ///< the factor with which light along the ray contributes to the pixel
    int length;                      ///< rays of the path, this one included
    T pdf;                           ///< of its direction, per solid angle; 0: it was the only one possible
    int number;                      ///< in the recording; 0 without an observer
    const Medium* medium = nullptr;  ///< that it travels in, if known
    /// Where it got its direction: its origin, or further back where surfaces were seamless.
    [[no_unique_address]] std::conditional_t<media, Vec3<T>, Nothing> scattered_at{};
    /// Where light comes out that goes in along it, if that is known.
    [[no_unique_address]] std::conditional_t<dipoles, std::optional<DipoleExit<T>>, NoExit> exit{};
  };
  using Nearest = std::optional<Hit<T>>;
  /// Where a ray got to: a surface, or where a medium scatters it; else it missed everything.
  struct ArrivalInMedium : Nearest {
    bool scattered = false;
  };
  using Arrival = std::conditional_t<media, ArrivalInMedium, Nearest>;
  /// A vertex of the path: the hit, prepared with its BSDF.
  static constexpr bool with_facets = Policy::effects.microfacets, with_maps = Policy::effects.maps;
  using Vertex = std::conditional_t<
      dipoles, DipoleVertex<T, with_facets, with_maps>,
      std::conditional_t<media, MediumVertex<T, with_facets, with_maps>, SurfaceVertex<T, with_facets, with_maps>>>;
  using Free = std::conditional_t<media, FreePath<T>, Nothing>;
  /// A light sample as seen from a vertex.
  struct LightSample;
  using BsdfSample = std::conditional_t<dipoles, DipoleSample<T>, raywalk::BsdfSample<T>>;

  /// FOLLOW PATH (RTNSHADE): the light that arrives along the ray, against its direction.
  Rgb<T> follow_path(std::optional<PathRay> ray) {
    Rgb<T> shade{0};
    // While there is a ray
    while (there_is(ray)) {
      Free free = draw_free_path(*ray);
      // Find closest intersection
      const Arrival arrival = find_closest(*ray, free);
      // If intersect nothing
      if (decide_missed(*ray, arrival)) {
        // Add background and end
        return add_background(shade, *ray);
      }
      const Vertex at = prepare(*ray, arrival, free);
      // Add emission, weighted
      add_emission(shade, *ray, at);
      for (int light = 0; light < light_count_at(at); ++light) {
        // Form shadow ray
        const std::optional<LightSample> light_sample = form_shadow_ray(*ray, at, light);
        if (!light_sample) continue;
        // Find intersection
        const Rgb<T> visible = find_intersection(*ray, *light_sample);
        // Add light, weighted
        add_light(shade, *ray, *light_sample, visible);
      }
      // Choose direction
      const std::optional<BsdfSample> choice = choose_direction(*ray, at);
      // If path survives
      const T survival = decide_survival(*ray, at, choice);
      ray.reset();
      if (survival > 0) {
        // Form next ray
        ray = form_next_ray(at, *choice, survival);
      }
    }
    return shade;
  }

  std::optional<PathRay> call(const PathRay& primary);
  void begin(const Pixel& pixel);
  PathRay form_primary_ray(const Pixel& pixel);
  bool there_is(const std::optional<PathRay>& ray);
  Free draw_free_path(const PathRay& ray);
  Arrival find_closest(PathRay& ray, Free& free);
  bool scatters_before(PathRay& ray, Free& free, const Nearest& nearest) const;
  Found describe_scattered(const PathRay& ray, const Free& free) const;
  Vertex scatter(const PathRay& ray, const Free& free) const;
  raywalk::BsdfSample<T> sample_phase(const Vertex& at);
  [[nodiscard]] const Dipole<T>* dipole_behind(const Vertex& at, const BsdfSample& choice) const;
  void lead_to_exit(const Vertex& at, std::optional<BsdfSample>& choice);
  Found describe_exit(const PathRay& ray) const;
  Vertex leave(const PathRay& ray) const;
  Nearest closest_through_media(const LightSample& light_sample, Rgb<T>& transmittance);
  bool decide_missed(const PathRay& ray, const Arrival& arrival);
  Rgb<T> add_background(const Rgb<T>& shade, const PathRay& ray);
  Rgb<T> add_sky(const Rgb<T>& shade, const PathRay& ray);
  Vertex prepare(const PathRay& ray, const Arrival& arrival, const Free& free);
  void add_emission(Rgb<T>& shade, const PathRay& ray, const Vertex& at);
  [[nodiscard]] int light_count_at(const Vertex& at) const;
  std::optional<LightSample> form_shadow_ray(const PathRay& ray, const Vertex& at, int light);
  std::optional<Ending> aim_at_light(LightSample& light_sample, const Vertex& at);
  std::optional<Ending> aim_at_emitter(LightSample& light_sample, const Vertex& at);
  std::optional<Ending> aim_at_sky(LightSample& light_sample, const Vertex& at);
  [[nodiscard]] bool samples_sky(const Vertex& at) const;
  [[nodiscard]] static bool is_sky(const LightSample& light_sample) {
    return light_sample.light == nullptr && light_sample.target.primitive < 0;
  }
  [[nodiscard]] Rgb<T> emitter_transmittance(const LightSample& light_sample, const Hit<T>& hit) const;
  Rgb<T> find_intersection(const PathRay& ray, const LightSample& light_sample);
  void add_light(Rgb<T>& shade, const PathRay& ray, const LightSample& light_sample, const Rgb<T>& visible);
  std::optional<BsdfSample> choose_direction(const PathRay& ray, const Vertex& at);
  T decide_survival(const PathRay& ray, const Vertex& at, const std::optional<BsdfSample>& choice);
  PathRay form_next_ray(const Vertex& at, const BsdfSample& choice, T survival);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  /// Where the ray got its direction.
  [[nodiscard]] static const Vec3<T>& seen_from(const PathRay& ray) {
    if constexpr (media)
      return ray.scattered_at;
    else
      return ray.ray.origin;
  }
  // How a vertex scatters, be it at a surface or inside of a medium.
  [[nodiscard]] static bool is_inside(const Vertex& at) {
    if constexpr (media) return at.phase.has_value();
    return false;
  }
  /// The share of the light let out by the dipole that goes in a direction, over the mean of all; elsewhere 1.
  [[nodiscard]] static T leaving(const Vertex& at, const Vec3<T>& direction) {
    if constexpr (dipoles)
      if (at.left_by != nullptr) return at.left_by->leaving(std::max(dot(at.outward_normal, direction), T(0)));
    return 1;
  }
  [[nodiscard]] static bool absorbs(const Vertex& at) {
    return is_inside(at) ? is_black(at.throughput) : at.bsdf.absorbs();
  }
  [[nodiscard]] static bool all_sharp(const Vertex& at) { return !is_inside(at) && at.bsdf.all_sharp(); }
  [[nodiscard]] static BsdfValue<T> evaluate(const Vertex& at, const Vec3<T>& direction) {
    if constexpr (media) {
      if (at.phase) {
        const T value = (*at.phase)(direction);
        return {Rgb<T>(value), value};
      }
    }
    BsdfValue<T> value = at.bsdf.evaluate(direction);
    if constexpr (dipoles) value.value *= leaving(at, direction);
    return value;
  }
  [[nodiscard]] Ray spawn(const Vertex& at, const Vec3<T>& direction) const {
    if (is_inside(at)) return Ray{raywalk::Ray<T>{at.position, direction, {}, at.time}};
    return spawn_ray<Ray>(world_, at.position, at.outward_normal, at.departure, direction, at.time);
  }

  /// The key of a draw at the end of the path's `length`-th ray.
  [[nodiscard]] RandomKey key_at(int length, std::uint32_t dimension, Effect effect = Effect::indirect_light) const {
    return key_.at(static_cast<std::uint32_t>(effect), static_cast<std::uint64_t>(length), dimension);
  }

  template <class Make>
  void note(Line line, int length, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, length, make()});
  }

  const World<T>& world_;
  const Emitters<T>& emitters_;
  const PathSettings& settings_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  PrimaryRays<T> primary_rays_;
  std::optional<PrimaryRaysAhead<T>> ahead_;
  std::vector<int> filters_met_;  ///< kept so that no shadow ray allocates
  RandomKey key_;                 ///< of the pixel's current sample
  int rays_formed_ = 0;           ///< numbers the rays of a recording
  [[no_unique_address]] std::conditional_t<Policy::effects.nesting, NestedMedia<T>, NoNestedMedia<T>> nested_;
  [[no_unique_address]] std::conditional_t<Policy::effects.filtering, FollowedDifferential<T>, NoDifferential<T>>
      differential_;
};

}  // namespace raywalk

#include "trace/path_dipole_steps.h"
#include "trace/path_light_steps.h"
#include "trace/path_medium_steps.h"
#include "trace/path_steps.h"
