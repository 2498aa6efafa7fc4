#pragma once
// Photon mapping: H. W. Jensen, "Global Illumination using Photon Maps", EGWR 1996; with circles that shrink from
// sample to sample, T. Hachisuka and H. W. Jensen, "Stochastic Progressive Photon Mapping", SIGGRAPH Asia 2009, in the
// form that needs no memory of the sample before, C. Knaus and M. Zwicker, TOG 30(3), 2011. `main_algorithm`,
// `follow_photon` and `gather_light` read like trace/pseudocode.h, and a test holds them together; what a statement
// does stands in trace/photon_steps.h and trace/gather_steps.h.
//
// A way of light from a source to the eye is counted once. From the last diffuse surface on, the eye's own rays follow
// it, by mirrors, glass and highlights. What reaches that surface straight from a source is found by shadow rays; by
// mirrors, glass and highlights only, by the caustic map; any other way by the other map, or, with final gathering, by
// one more ray, which takes what it needs from the other map where it meets the next diffuse surface. That map then
// holds all photons, those straight from a source too.
//
// Materials are those of trace/path.h, and so are the differences from SHADE. Radiance does not change when it is
// refracted, as Whitted has it; so the power of a photon does, by (n1 / n2)^2. Where it errs: an eye sees through
// translucent glass light that comes at an angle beyond the critical one, if its cone reaches so far; a photon at such
// an angle is reflected.
//
// In a flat world everything is endless along z and light stays in the plane z = 0: angles in place of solid angles, 2
// in place of pi, and the light at a point is k / (2 r_k) in place of k / (pi r_k^2). A rough lobe is sampled in space
// and turned into the plane.

#include "math/stop.h"
#include "trace/bsdf.h"
#include "trace/emitters.h"
#include "trace/media.h"
#include "trace/pattern_filter.h"
#include "trace/photon_lights.h"
#include "trace/photon_pass.h"
#include "trace/policy.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"
#include "trace/surface_vertex.h"

#include <optional>
#include <vector>

namespace raywalk {

/// Of the policy's effects (trace/policy.h), only nesting, filtering, microfacets and maps matter.
template <class Policy>
class PhotonTracer {
 public:
  using T = typename Policy::Scalar;
  using Ray = typename Policy::Ray;
  using Observer = typename Policy::Observer;

  /// `maps`: what the photons of each pass have left; for the pixels. `first_pass`: of the first of these.
  PhotonTracer(const World<T>& world, const Emitters<T>& emitters, const PhotonLights<T>& lights,
               const PhotonSettings& settings, const std::vector<PhotonMaps>& maps, int first_pass,
               const RayGenerator<T>& camera, Observer& observer, const Stop& stop = {})
      : world_(world),
        emitters_(emitters),
        lights_(lights),
        settings_(settings),
        maps_(maps),
        first_pass_(first_pass),
        camera_(camera),
        observer_(observer),
        stop_(stop),
        nested_(world),
        differential_(world, camera) {}

  /// PHOTON MAPPING. Photons of one pass, and then pixels, for which their maps have to be there: `pixels` yields
  /// Pixel; `put(pixel, shade)` receives each final shade. Either may be empty.
  template <class Pixels, class Put>
  void main_algorithm(const PhotonRange& photons, const Pixels& pixels, Put&& put) {
    // For each photon
    for (int photon = photons.begin; photon < photons.end; ++photon) {
      begin(photon, photons.pass);
      // Emit photon
      const PhotonRay emitted = emit_photon();
      // Follow photon (POWER)
      follow_photon(call(emitted));
    }
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form primary ray
      const EyeRay primary = form_primary_ray(pixel);
      // Gather light (final)
      const Rgb<T> final = gather_light(call(primary));
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  /// What was stored, in order.
  [[nodiscard]] StoredPhotons& caustic_photons() { return caustic_photons_; }
  [[nodiscard]] StoredPhotons& other_photons() { return other_photons_; }

 private:
  using Medium = typename World<T>::Medium;
  using Light = typename World<T>::Light;
  using Vertex = SurfaceVertex<T, Policy::effects.microfacets, Policy::effects.maps>;
  using SurfaceBsdf = decltype(Vertex::bsdf);
  using Nearest = std::optional<Hit<T>>;
  using BsdfSample = raywalk::BsdfSample<T>;
  /// A photon on its way.
  struct PhotonRay {
    Ray ray;
    Rgb<T> throughput;  ///< its power
    int length;         ///< rays since the light, this one included
    int number;         ///< in the recording; 0 without an observer
    PhotonHistory history;
    const Light* lamp;               ///< whose law of attenuation applies to the whole way so far; null: none
    T travelled = 0;                 ///< from the lamp to where this ray begins
    const Medium* medium = nullptr;  ///< that it travels in, if known
  };
  /// A ray that light is gathered along.
  struct EyeRay {
    Ray ray;
    RayKind kind;
    Rgb<T> throughput;  ///< the factor with which light along the ray contributes to the pixel
    int length;         ///< rays since the eye, this one included
    int number;
    bool gathers = false;  ///< it left a diffuse surface: final gathering
    const Medium* medium = nullptr;
  };
  /// A light sample as seen from a vertex.
  struct LightSample;

  /// FOLLOW PHOTON (POWER).
  void follow_photon(std::optional<PhotonRay> photon) {
    // While there is a photon
    while (there_is(photon)) {
      // Find closest intersection
      const Nearest nearest = find_closest(*photon);
      if (!nearest) {
        photon.reset();
        continue;
      }
      const Vertex at = arrive(*photon, *nearest);
      // If diffuse
      if (decide_diffuse(*photon, at)) {
        // Store photon
        store_photon(*photon, at);
      }
      // Choose direction
      const std::optional<BsdfSample> choice = choose_photon_direction(*photon, at);
      // If photon survives
      const T survival = decide_photon_survival(*photon, at, choice);
      if (!(survival > 0)) {
        photon.reset();
        continue;
      }
      // Form next ray
      photon = form_next_photon(*photon, at, *choice, survival);
    }
  }

  /// GATHER LIGHT (RTNSHADE): the light that arrives along the ray, against its direction.
  Rgb<T> gather_light(std::optional<EyeRay> ray) {
    Rgb<T> shade{0};
    // While there is a ray
    while (there_is(ray)) {
      // Find closest intersection
      const Nearest nearest = find_closest(*ray);
      // If intersect nothing
      if (decide_missed(*ray, nearest)) {
        // Add background and end
        return add_background(shade, *ray);
      }
      const Vertex at = prepare(*ray, *nearest);
      // Add emission
      add_emission(shade, *ray, at);
      for (int light = 0; light < light_count_at(*ray, at); ++light) {
        // Form shadow ray
        const std::optional<LightSample> light_sample = form_shadow_ray(*ray, at, light);
        if (!light_sample) continue;
        // Find intersection
        const Rgb<T> visible = find_intersection(*ray, *light_sample);
        // Add light
        add_light(shade, *ray, *light_sample, visible);
      }
      // Find nearest photons
      const PhotonsFound photons = find_nearest_photons(*ray, at);
      // Add light of photons
      add_light_of_photons(shade, *ray, at, photons);
      // Choose direction
      const std::optional<BsdfSample> choice = choose_direction(*ray, at);
      // If path survives
      const T survival = decide_survival(*ray, at, choice);
      if (!(survival > 0)) {
        ray.reset();
        continue;
      }
      // Form next ray
      ray = form_next_ray(*ray, at, *choice, survival);
    }
    return shade;
  }

  void begin(int photon, int pass);
  void begin(const Pixel& pixel);
  PhotonRay emit_photon();
  std::optional<PhotonRay> call(const PhotonRay& emitted);
  bool there_is(const std::optional<PhotonRay>& photon);
  Nearest find_closest(const PhotonRay& photon);
  Vertex arrive(const PhotonRay& photon, const Hit<T>& hit);
  /// In a flat world matt surfaces are Lambert's: what there is for rough ones is for all three dimensions.
  void take_flat(Vertex& at) const {
    if constexpr (Policy::effects.microfacets)
      if (settings_.flat) at.bsdf.matt = nullptr;
  }
  Vertex prepare(const EyeRay& ray, const Hit<T>& hit) {
    Vertex at = prepare_vertex<Policy>(world_, nested_, ray, hit, statistics_, differential_);
    take_flat(at);
    return at;
  }
  bool decide_diffuse(const PhotonRay& photon, const Vertex& at);
  void store_photon(const PhotonRay& photon, const Vertex& at);
  std::optional<BsdfSample> choose_photon_direction(const PhotonRay& photon, const Vertex& at);
  /// Inlined, for each photon asks it at each hit.
  [[nodiscard, gnu::always_inline]] inline T adjoint(const Vertex& at, Lobe lobe, const Vec3<T>& direction) const;
  T decide_photon_survival(const PhotonRay& photon, const Vertex& at, const std::optional<BsdfSample>& choice);
  PhotonRay form_next_photon(const PhotonRay& photon, const Vertex& at, const BsdfSample& choice, T survival);

  EyeRay form_primary_ray(const Pixel& pixel);
  std::optional<EyeRay> call(const EyeRay& primary);
  bool there_is(const std::optional<EyeRay>& ray);
  Nearest find_closest(const EyeRay& ray);
  bool decide_missed(const EyeRay& ray, const Nearest& nearest);
  Rgb<T> add_background(const Rgb<T>& shade, const EyeRay& ray);
  void add_emission(Rgb<T>& shade, const EyeRay& ray, const Vertex& at);
  [[nodiscard]] int light_count_at(const EyeRay& ray, const Vertex& at) const;
  std::optional<LightSample> form_shadow_ray(const EyeRay& ray, const Vertex& at, int light);
  std::optional<Ending> aim_at_light(LightSample& light_sample, const Vertex& at);
  std::optional<Ending> aim_at_emitter(LightSample& light_sample, const Vertex& at);
  std::optional<Ending> aim_at_environment(LightSample& light_sample, const Vertex& at);
  Rgb<T> find_intersection(const EyeRay& ray, const LightSample& light_sample);
  [[nodiscard]] Rgb<T> transmittance_to(const LightSample& light_sample) const;
  void add_light(Rgb<T>& shade, const EyeRay& ray, const LightSample& light_sample, const Rgb<T>& visible);
  PhotonsFound find_nearest_photons(const EyeRay& ray, const Vertex& at);
  /// Adds to what a rough matt surface answers.
  [[nodiscard]] PhotonCircle circle_of(const PhotonMap& map, const Vertex& at, PhotonsFound& found) const;
  void add_light_of_photons(Rgb<T>& shade, const EyeRay& ray, const Vertex& at, const PhotonsFound& photons);
  std::optional<BsdfSample> choose_direction(const EyeRay& ray, const Vertex& at);
  T decide_survival(const EyeRay& ray, const Vertex& at, const std::optional<BsdfSample>& choice);
  EyeRay form_next_ray(const EyeRay& ray, const Vertex& at, const BsdfSample& choice, T survival);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  /// A direction of this lobe alone, and its weight without the chance of the lobe.
  [[nodiscard]] BsdfSample sample_alone(const SurfaceBsdf& bsdf, Lobe lobe, const Vec2<T>& unit, T chosen_by = 0) const;
  /// Whether what it transmits is refracted and scattered.
  [[nodiscard]] static bool bends_translucently(const Vertex& at) {
    return at.bsdf.transparent_width > 0 && !at.bsdf.by_facets() && at.refraction.n1 != at.refraction.n2;
  }
  /// The same of such a lobe, with what `adjoint` takes into account.
  [[nodiscard]] BsdfSample bent_translucently(const Vertex& at, const Vec2<T>& unit) const;
  /// The integral of the cosine over all directions above a surface.
  [[nodiscard]] T cosines() const { return settings_.flat ? T(2) : pi_v<T>; }

  /// The key of a draw at the end of the `length`-th ray of what is under way.
  [[nodiscard]] RandomKey key_at(int length, std::uint32_t dimension, Effect effect = Effect::indirect_light) const {
    return key_.at(static_cast<std::uint32_t>(effect), static_cast<std::uint64_t>(length), dimension);
  }

  template <class Make>
  void note(Line line, int length, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, length, make()});
  }

  const World<T>& world_;
  const Emitters<T>& emitters_;
  const PhotonLights<T>& lights_;
  const PhotonSettings& settings_;
  const std::vector<PhotonMaps>& maps_;
  int first_pass_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  typename RayGenerator<T>::PixelDraws pixel_draws_;
  RandomKey key_;         ///< of the current photon, or of the pixel's current sample
  std::size_t pass_ = 0;  ///< of that sample, in maps_
  int rays_formed_ = 0;   ///< numbers the rays of a recording
  StoredPhotons caustic_photons_, other_photons_;
  [[no_unique_address]] std::conditional_t<Policy::effects.nesting, NestedMedia<T>, NoNestedMedia<T>> nested_;
  [[no_unique_address]] std::conditional_t<Policy::effects.filtering, FollowedDifferential<T>, NoDifferential<T>>
      differential_;  ///< of the eye's ray: photons see patterns by points
};

}  // namespace raywalk

#include "trace/gather_steps.h"
#include "trace/photon_steps.h"
