#pragma once
// Path tracing: J. Kajiya, "The Rendering Equation", SIGGRAPH 1986; with the light of every vertex drawn both from the
// lights and along the path itself, and the two weighted (E. Veach and L. Guibas, "Optimally Combining Sampling
// Techniques for Monte Carlo Rendering", SIGGRAPH 1995), and paths ended by Russian roulette (J. Arvo and D. Kirk,
// SIGGRAPH 1990). `main_algorithm` and `follow_path` read like trace/pseudocode.h, and a test holds them together;
// what a statement does stands in trace/path_steps.h and trace/path_light_steps.h.
//
// Materials are the tracer's: kd / pi scatters evenly, the highlight is a lobe, mirrors and glass are exact. What
// differs from SHADE: surfaces light each other, so that `ambient`, which stands for that light, is left out. Russian
// roulette ends paths without bias, so that neither the depth limit nor the threshold, which lose light, is heeded.
// Every normal faces the ray: a `fixed` one, which course scenes have, would let light through the backs of surfaces.

#include "math/stop.h"
#include "trace/media.h"
#include "trace/path_lights.h"
#include "trace/path_lobes.h"
#include "trace/policy.h"
#include "trace/ray_generator.h"
#include "trace/statistics.h"

#include <optional>
#include <vector>

namespace raywalk {

/// Where the light of objects that emit is looked for. All but `both` are for studies.
enum class PathStrategy {
  both,        ///< weighted so that together they vary least
  lights,      ///< at points of lights, wherever these can be drawn
  directions,  ///< where paths happen to lead
};

struct PathSettings {
  int max_length = 0;     ///< of a path from the eye to a light, in rays, the one to the light included; 0: no limit
  int roulette_from = 4;  ///< rays that every path may have before Russian roulette begins; >= 1
  PathStrategy strategy = PathStrategy::both;
  friend bool operator==(const PathSettings&, const PathSettings&) = default;
};

/// Of the policy's effects (trace/policy.h), only nesting is heeded.
template <class Policy>
class PathTracer {
 public:
  using T = typename Policy::Scalar;
  using Ray = typename Policy::Ray;
  using Observer = typename Policy::Observer;

  PathTracer(const World<T>& world, const PathLights<T>& lights, const PathSettings& settings,
             const RayGenerator<T>& camera, Observer& observer, const Stop& stop = {})
      : world_(world),
        lights_(lights),
        settings_(settings),
        camera_(camera),
        observer_(observer),
        stop_(stop),
        nested_(world) {}

  /// PATH TRACING. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form primary ray
      const Traced primary = form_primary_ray(pixel);
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
  /// A ray on its way.
  struct Traced {
    Ray ray;
    RayKind kind;
    Rgb<T> share;                    ///< of the pixel, that the light along the ray has
    int length;                      ///< rays of the path, this one included
    T density;                       ///< with which its direction was chosen, by solid angle; 0: it was the only one
    int number;                      ///< in the recording; 0 when nobody watches
    const Medium* medium = nullptr;  ///< that it travels in, where that is known
  };
  using Nearest = std::optional<Hit<T>>;
  /// The hit, made ready: place and lobes.
  struct Vertex;
  /// One light as tried from a vertex.
  struct Way;
  using Choice = typename Lobes<T>::Choice;

  /// FOLLOW PATH (RTNSHADE): the light that comes along the ray, against its direction.
  Rgb<T> follow_path(std::optional<Traced> ray) {
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
      // Add emission, weighted
      add_emission(shade, *ray, at);
      for (int light = 0; light < lights_at(at); ++light) {
        // Form shadow ray
        const std::optional<Way> way = form_shadow_ray(*ray, at, light);
        if (!way) continue;
        // Find intersection
        const Rgb<T> visible = find_intersection(*ray, *way);
        // Add light, weighted
        add_light(shade, *ray, *way, visible);
      }
      // Choose direction
      const std::optional<Choice> choice = choose_direction(*ray, at);
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

  std::optional<Traced> call(const Traced& primary);
  void begin(const Pixel& pixel);
  Traced form_primary_ray(const Pixel& pixel);
  bool there_is(const std::optional<Traced>& ray);
  Nearest find_closest(const Traced& ray);
  bool decide_missed(const Traced& ray, const Nearest& nearest);
  Rgb<T> add_background(const Rgb<T>& shade, const Traced& ray);
  Vertex prepare(const Traced& ray, const Hit<T>& hit);
  void add_emission(Rgb<T>& shade, const Traced& ray, const Vertex& at);
  [[nodiscard]] int lights_at(const Vertex& at) const;
  std::optional<Way> form_shadow_ray(const Traced& ray, const Vertex& at, int light);
  std::optional<Ending> aim_at_lamp(Way& way, const Vertex& at);
  std::optional<Ending> aim_at_object(Way& way, const Vertex& at);
  [[nodiscard]] Rgb<T> left_of(const Way& way, const Hit<T>& hit) const;
  Rgb<T> find_intersection(const Traced& ray, const Way& way);
  void add_light(Rgb<T>& shade, const Traced& ray, const Way& way, const Rgb<T>& visible);
  std::optional<Choice> choose_direction(const Traced& ray, const Vertex& at);
  T decide_survival(const Traced& ray, const Vertex& at, const std::optional<Choice>& choice);
  Traced form_next_ray(const Vertex& at, const Choice& choice, T survival);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  /// Of a draw at the end of the path's `length`-th ray.
  [[nodiscard]] RandomKey key_at(int length, std::uint32_t dimension, Effect effect = Effect::indirect_light) const {
    RandomKey key = key_;
    key.effect = static_cast<std::uint32_t>(effect);
    key.path = static_cast<std::uint64_t>(length);
    key.dimension = dimension;
    return key;
  }

  template <class Make>
  void note(Line line, int length, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, length, make()});
  }

  const World<T>& world_;
  const PathLights<T>& lights_;
  const PathSettings& settings_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  typename RayGenerator<T>::PixelDraws pixel_draws_;
  std::vector<int> filters_met_;  ///< kept so that no shadow ray allocates
  RandomKey key_;                 ///< of the pixel's present sample
  int rays_formed_ = 0;           ///< numbers the rays of a recording
  [[no_unique_address]] std::conditional_t<Policy::effects.nesting, NestedMedia<T>, NothingNests<T>> nested_;
};

}  // namespace raywalk

#include "trace/path_light_steps.h"
#include "trace/path_steps.h"
