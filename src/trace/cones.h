#pragma once
// Cone tracing: J. Amanatides, "Ray Tracing with Cones", SIGGRAPH 1984. A pixel is one cone, and so is what a surface
// reflects or refracts of it, as wide as the surface's curvature and roughness make it (trace/ray_cone.h). What covers
// a cone is known as a share of it (trace/cone_cover.h), so that one cone is antialiased, one shadow cone to a light
// with an extent makes a penumbra, and one reflected cone a gloss. `main_algorithm` and `shade_cone` read like
// trace/pseudocode.h, and a test holds them together; what a statement does stands in trace/cone_steps.h.
//
// Where it errs: shares of several objects are multiplied as if they had nothing to do with each other; a part is
// shaded in one place, in its middle; a shadow cone starts as wide as the part and ends as wide as what is seen of the
// light, a disc of its area (in the plan: as wide as it is) whatever its shape, and how much of that is uncovered says
// nothing of where; a cone bent by a curved surface is right near its axis only, and always round; small facets
// scatter evenly in a cone, without the tails that they have, and as much of a metal's or a glass's light as one facet
// does. It draws no random numbers.
//
// With n samples a pixel is n cones, each for its own share of the pixel.

#include "math/stop.h"
#include "trace/cone_cover.h"
#include "trace/kernel.h"
#include "trace/part_steps.h"
#include "trace/surface_vertex.h"

#include <optional>
#include <vector>

namespace raywalk {

template <class T, class Watcher, bool with_maps = true>
class ConeTracer {
 public:
  using Observer = Watcher;

  /// `bodies`: of the world's scene; `flat`: in a flat world, of a planar scene's strip. All outlive this.
  ConeTracer(const World<T>& world, const ConeBodies& bodies, bool flat, const RayGenerator<T>& camera,
             Observer& observer, const Stop& stop = {});

  /// CONE TRACING. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form cone of the pixel
      const Cone cone = form_cone(pixel);
      // Find what covers it, and how much
      const std::vector<Part> parts = find_cover(Line::find_cover, 0, cone);
      // Shade cone (DEPTH+1, final)
      const int depth = call_shade_cone(Line::shade_cone, 0, cone);
      const Rgb<T> final = shade_cone(depth, cone, parts);
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  using AllEffects = Policy<T, NoObserver, with_maps ? all_hit_effects : no_maps>;
  using Vertex = SurfaceVertex<T, true, with_maps>;
  using Medium = typename World<T>::Medium;
  using Light = typename World<T>::Light;
  struct Cone {
    RayCone shape;
    Rgb<T> throughput;
    int number;  ///< in the recording; 0 without an observer
    Departure departure{};
    ConeLeaves leaves{};
    const Medium* medium = nullptr;
  };
  /// What one object, or one face of it, covers of a cone.
  struct Part : ConePart {
    Ray<T> ray{};       ///< in its middle
    ConeWidth width{};  ///< of what it covers, where that ray ends
    int number = 0;     ///< as above
    int object = -1;
    std::optional<Vertex> at{};  ///< what that ray meets
    double slope = 0;            ///< that half of the surface's small facets exceed; 0: it is smooth
    std::optional<decltype(Vertex::bsdf)> facets{};  ///< of a surface that is not: what shows its highlights
    Rgb<T> ambient{0};                               ///< of the surface
  };
  struct Shadow {
    RayCone cone;
    Vec3<T> to_light;  ///< to the middle of what is seen of it, at t = 1; to a distant light of unit length
    detail::LightPoints<T> points;
    int number;
  };
  /// What lights bring; each one's term only when observed.
  struct DirectLighting {
    Rgb<T> sum{0};
    std::vector<LightTerm> terms{};
  };

  /// SHADE CONE (DEPTH, RTNSHADE): the light that comes back along a cone.
  Rgb<T> shade_cone(int depth, const Cone& cone, const std::vector<Part>& parts) {
    Rgb<T> sum{0};
    // For each part, front to back
    for (const Part& part : parts) {
      begin(depth, parts, part);
      DirectLighting direct;
      for (const Light& light : detail::lights_on(world_, part)) {
        // Form shadow cone
        const std::optional<Shadow> shadow = form_shadow_cone(depth, part, cone, light);
        if (!shadow) {
          add_unlit(direct, light);
          continue;
        }
        // Find how much is uncovered
        const Rgb<T> uncovered = find_uncovered(depth, part, *shadow, light);
        add_light(direct, part, light, *shadow, uncovered);
      }
      // Shade its middle
      const Rgb<T> local = shade_middle(depth, part, direct);
      Rgb<T> reflected{0}, refracted{0};
      // If reflective
      if (decide_reflective(depth, part)) {
        // Form reflected cone
        if (const std::optional<Cone> mirrored = form_reflected_cone(depth, part, cone)) {
          // Find what covers it
          const std::vector<Part> seen = find_cover(Line::find_reflected_cover, depth, *mirrored);
          // Shade cone (DEPTH+1, REFLSHADE)
          const int deeper = call_shade_cone(Line::shade_reflected_cone, depth, *mirrored);
          reflected = part.at->bsdf.mirror * shade_cone(deeper, *mirrored, seen);
        }
      }
      // If transparent
      if (decide_transparent(depth, part)) {
        // Form refracted cone
        if (const std::optional<Cone> bent = form_refracted_cone(depth, part, cone)) {
          // Find what covers it
          const std::vector<Part> seen = find_cover(Line::find_refracted_cover, depth, *bent);
          // Shade cone (DEPTH+1, REFRSHADE)
          const int deeper = call_shade_cone(Line::shade_refracted_cone, depth, *bent);
          refracted = part.at->bsdf.transparent * shade_cone(deeper, *bent, seen);
        }
      }
      // Add shade, times its share
      add_share(sum, depth, parts, part, local, reflected, refracted);
    }
    return sum;
  }

  void begin(const Pixel& pixel);
  Cone form_cone(const Pixel& pixel);
  std::vector<Part> find_cover(Line line, int depth, const Cone& cone);
  void meet(Part& part, const Cone& cone);
  [[nodiscard]] BeamArea area_of(const RayCone& cone, const ConePart& part) const;
  int call_shade_cone(Line line, int depth, const Cone& cone);
  void begin(int depth, const std::vector<Part>& parts, const Part& part);
  [[nodiscard]] detail::LightPoints<T> points_of(const Part& part, const Light& light) const;
  std::optional<Shadow> form_shadow_cone(int depth, const Part& part, const Cone& cone, const Light& light);
  Rgb<T> find_uncovered(int depth, const Part& part, const Shadow& shadow, const Light& light);
  [[nodiscard]] int primitive_of(const ConePart& blocker) const {
    return primitives_[static_cast<std::size_t>(bodies_[blocker.body].object)];
  }
  [[nodiscard]] bool filters(const ConePart& blocker) const;
  [[nodiscard]] Rgb<T> transmittance_of(const ConePart& blocker, const Part& part, const Shadow& shadow,
                                        const Light& light, const Medium* medium);
  /// What absorbing bodies leave of the ray in the middle of a shadow cone where it is inside of two at once, of which
  /// only one absorbs; and which these are. None where it is not.
  struct Together {
    Rgb<T> transmittance;
    std::vector<int> primitives;
  };
  [[nodiscard]] std::optional<Together> inside_each_other(const std::vector<ConePart>& blockers, const Part& part,
                                                          const Shadow& shadow, const Light& light,
                                                          const Medium* medium);
  void add_unlit(DirectLighting& direct, const Light& light);
  void add_light(DirectLighting& direct, const Part& part, const Light& light, const Shadow& shadow,
                 const Rgb<T>& uncovered);
  Rgb<T> shade_middle(int depth, const Part& part, const DirectLighting& direct);
  bool decide_reflective(int depth, const Part& part);
  bool decide_transparent(int depth, const Part& part);
  [[nodiscard]] double curvature_at(const Part& part) const;
  std::optional<Cone> form_reflected_cone(int depth, const Part& part, const Cone& cone);
  std::optional<Cone> form_refracted_cone(int depth, const Part& part, const Cone& cone);
  /// From a part, about `axis`; nothing where a limit says so.
  std::optional<Cone> form_next_cone(Line line, int depth, const Part& part, const Cone& cone, const Vec3<T>& axis,
                                     const ConeWidth& width, const Rgb<T>& weight, const Medium* medium);
  void add_share(Rgb<T>& sum, int depth, const std::vector<Part>& parts, const Part& part, const Rgb<T>& local,
                 const Rgb<T>& reflected, const Rgb<T>& refracted);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  template <class Make>
  void note(Line line, int depth, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, depth, make()});
  }

  const World<T>& world_;
  const ConeBodies& bodies_;
  bool flat_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  std::vector<int> primitives_;  ///< the first of each object
  double far_;                   ///< outside of everything that is drawn
  int rays_formed_ = 0;          ///< numbers the rays of a recording
  NestedMedia<T> nested_;
};

}  // namespace raywalk

#include "trace/cone_light_steps.h"
#include "trace/cone_steps.h"
