#pragma once
// Beam tracing in the plan: P. Heckbert and P. Hanrahan, "Beam Tracing Polygonal Objects", SIGGRAPH 1984. A beam is all
// rays of a pixel at once; outlines cut it into parts that see one thing each (trace/unfolded_plan.h), and the edges of
// shadows into parts in one light, so that a pixel of parts with one shade each is exactly its mean. `main_algorithm`
// and `shade_parts` read like trace/pseudocode.h, and a test holds them together; what a statement does stands in
// trace/beam_steps.h.
//
// Lines of checkers and the rims of spot lights cut parts, too (trace/plan_marks.h). A part is shaded by one ray, in
// its middle: along it the shade is taken as constant, which is exact where it is; by how much it is not, a walk says.
// To a light with an extent all rays go from there at once, and its width is cut as a pixel's is. A flat mirror
// reflects a beam as a beam. Of curved mirrors and glass a single ray is followed, from the middle, as trace/tracer.h
// does.
//
// Flat glass refracts a beam as the paper approximates it: small angles' sines are their tangents, and by
// n1 tan = n2 tan' the rays beyond seem to come from one point again, which is the eye moved along the face's normal.
// Here its distance grows by tan / tan' of the middle ray (n2 / n1 of one along the normal): that ray is Snell's, and
// how far those at the ends are off his law, a walk says. No part goes beyond the critical angle: there it is cut.
//
// The world is flat: everything is endless along z, and what lies above or below the plan is not there.

#include "math/stop.h"
#include "trace/kernel.h"
#include "trace/part_steps.h"
#include "trace/surface_vertex.h"
#include "trace/tracer.h"
#include "trace/unfolded_plan.h"

#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

namespace detail {
[[nodiscard]] inline Vec3d in_plan(const Vec2d& at) { return {at.x, at.y, 0}; }
}  // namespace detail

template <class Watcher>
class BeamTracer {
 public:
  using Observer = Watcher;

  /// `outlines` are those of the world's scene, and `camera` forms the rays of its strip. All outlive this.
  BeamTracer(const World<double>& world, const std::vector<Outline>& outlines, const RayGenerator<double>& camera,
             Observer& observer, const Stop& stop = {});

  /// BEAM TRACING. `pixels` yields Pixel, of the strip; `put(pixel, shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form beam of the pixel
      const Beam beam = form_beam(pixel);
      // Cut beam by outlines and shadows
      const std::vector<Part> parts = cut(Line::cut_beam, 0, beam);
      // Shade parts (DEPTH+1, final)
      const int depth = call_shade_parts(Line::shade_parts, 0, beam);
      const Rgbd final = shade_parts(depth, beam, parts);
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  using AllEffects = Policy<double>;
  using Medium = World<double>::Medium;
  using Light = World<double>::Light;
  /// Rays between two places of a pixel, directly or by mirrors.
  struct Beam {
    std::shared_ptr<const UnfoldedPlan> plan;  ///< as these rays see it
    PixelFan fan;
    Place begin, end;
    Rgbd throughput;
    int number;             ///< in the recording; 0 without an observer
    Departure departure{};  ///< from the mirror
    const Medium* medium = nullptr;
  };
  /// A part of a beam, which sees one thing.
  struct Part : BeamPart {
    Ray<double> ray{};  ///< in its middle
    int number = 0;     ///< as above
    int object = -1;
    std::optional<SurfaceVertex<double>> at{};  ///< what that ray meets
    Rgbd ambient{0.0};                          ///< of the surface
    bool keeps_beam = false;                    ///< refracts it as a beam
    bool has_mean = false;                      ///< of its checker, whose squares are too many to be cut
  };
  static constexpr double most_squares = 64;  ///< of a checker that a part is cut into
  /// A ray to a light; to one with an extent, all rays at once.
  struct Shadow {
    Ray<double> ray;
    int number;
    const Medium* medium;
    std::optional<PixelFan> fan{};  ///< then: to both ends of what lies before the surface
    double share = 1;               ///< of the light, which that is
  };
  /// What of a light lies before a surface: its middle, and of a light with an extent both ends, seen from the surface.
  struct LightSeen {
    Vec3d to_light;  ///< not of unit length; it may still face away
    std::optional<PixelFan> fan;
    double share = 1;
  };
  /// What lights bring; each one's term only when observed.
  struct DirectLighting {
    Rgbd sum{0.0};
    std::vector<LightTerm> terms{};
  };
  struct MiddleRay {
    Ray<double> ray;
    RayKind kind;
    int number;
    const Medium* medium;
  };

  /// SHADE PARTS (DEPTH, RTNSHADE): the mean of the light that comes back along a beam.
  Rgbd shade_parts(int depth, const Beam& beam, const std::vector<Part>& parts) {
    Rgbd mean{0.0};
    // For each part
    for (const Part& part : parts) {
      begin(depth, parts, part);
      DirectLighting direct;
      for (const Light& light : detail::lights_on(world_, part)) {
        // Form shadow ray
        const std::optional<Shadow> shadow = form_shadow_ray(depth, part, beam, light);
        if (!shadow) {
          add_unlit(direct, light);
          continue;
        }
        // Find intersection
        const Rgbd visible = find_intersection(depth, part, *shadow, light);
        add_light(direct, part, light, *shadow, visible);
      }
      // Shade its middle
      const Rgbd local = shade_middle(depth, part, direct);
      Rgbd reflected{0.0}, refracted{0.0};
      // If flat mirror
      if (decide_flat_mirror(depth, part)) {
        // Form mirrored beam
        if (const std::optional<Beam> mirrored = form_mirrored_beam(depth, part, beam)) {
          // Cut it by outlines and shadows
          const std::vector<Part> seen = cut(Line::cut_mirrored_beam, depth, *mirrored);
          // Shade parts (DEPTH+1, REFLSHADE)
          const int deeper = call_shade_parts(Line::shade_mirrored_parts, depth, *mirrored);
          reflected = part.at->bsdf.mirror * shade_parts(deeper, *mirrored, seen);
        }
      }
      // If flat glass
      if (decide_flat_glass(depth, part)) {
        // Form refracted beam
        if (const std::optional<Beam> bent = form_refracted_beam(depth, part, beam)) {
          // Cut it by outlines and shadows
          const std::vector<Part> seen = cut(Line::cut_refracted_beam, depth, *bent);
          // Shade parts (DEPTH+1, REFRSHADE)
          const int deeper = call_shade_parts(Line::shade_refracted_parts, depth, *bent);
          refracted = part.at->bsdf.transparent * shade_parts(deeper, *bent, seen);
        }
      }
      // If curved mirror or glass
      if (decide_curved_or_glass(depth, part)) {
        for (const RayKind kind : {RayKind::reflect, RayKind::refract}) {
          if (!sends(part, kind)) continue;
          // Form ray from its middle
          const std::optional<MiddleRay> ray = form_middle_ray(depth, part, beam, kind);
          if (!ray) continue;
          // Follow it as a ray
          const Rgbd light = follow_middle_ray(depth, *ray);
          (kind == RayKind::reflect ? reflected : refracted) = detail::weight_of(*part.at, kind) * light;
        }
      }
      // Add shade, times coverage
      add_part(mean, depth, beam, part, local, reflected, refracted);
    }
    return mean;
  }

  void begin(const Pixel& pixel);
  Beam form_beam(const Pixel& pixel);
  std::vector<Part> cut(Line line, int depth, const Beam& beam);
  void meet(Part& part, const Beam& beam, const Place& place);
  void divide(std::vector<Part>& pieces, const Beam& beam, const BeamPart& seen);
  [[nodiscard]] bool is_lit(int outline) const;
  [[nodiscard]] std::vector<Place> edges_of_light(const Beam& beam, const BeamPart& part) const;
  [[nodiscard]] std::vector<Place> edges_of_total_reflection(const Beam& beam, const Part& whole);
  [[nodiscard]] std::optional<std::vector<Place>> edges_of_squares(const Beam& beam, const BeamPart& part) const;
  [[nodiscard]] std::vector<Rgbd> look_of(const Beam& beam, const Part& piece);
  [[nodiscard]] BeamArea area_of(const Beam& beam, const BeamPart& part) const;
  int call_shade_parts(Line line, int depth, const Beam& beam);
  void begin(int depth, const std::vector<Part>& parts, const Part& part);
  [[nodiscard]] Shadow shadow_to(const SurfaceVertex<double>& at, const LightSeen& seen, int number) const;
  std::optional<Shadow> form_shadow_ray(int depth, const Part& part, const Beam& beam, const Light& light);
  [[nodiscard]] Rgbd shade_beside(int depth, const Part& beside, const Rgbd& mirrored, const Rgbd& beyond);
  Rgbd find_intersection(int depth, const Part& part, const Shadow& shadow, const Light& light);
  [[nodiscard]] LightSeen seen_of(const Light& light, const SurfaceVertex<double>& at) const;
  [[nodiscard]] detail::PartLight<double> light_on(const Part& part, const Light& light, const Shadow& shadow,
                                                   const Rgbd& visible) const;
  [[nodiscard]] std::optional<PixelFan> fan_to(const Light& light, const Vec3d& from) const;
  [[nodiscard]] Found light_through(const Part& part, const Shadow& shadow, const Light& light);
  [[nodiscard]] Found find_uncovered(const Part& part, const Shadow& shadow, const Light& light);
  void add_unlit(DirectLighting& direct, const Light& light);
  void add_light(DirectLighting& direct, const Part& part, const Light& light, const Shadow& shadow,
                 const Rgbd& visible);
  Rgbd shade_middle(int depth, const Part& part, const DirectLighting& direct);
  [[nodiscard]] bool is_straight(const Part& part) const;
  bool decide_flat_mirror(int depth, const Part& part);
  std::optional<Beam> form_mirrored_beam(int depth, const Part& part, const Beam& beam);
  bool decide_flat_glass(int depth, const Part& part);
  std::optional<Beam> form_refracted_beam(int depth, const Part& part, const Beam& beam);
  bool decide_curved_or_glass(int depth, const Part& part);
  [[nodiscard]] bool sends(const Part& part, RayKind kind) const;
  std::optional<MiddleRay> form_middle_ray(int depth, const Part& part, const Beam& beam, RayKind kind);
  Rgbd follow_middle_ray(int depth, const MiddleRay& ray);
  [[nodiscard]] double off_near_ends(int depth, const Beam& beam, const Part& part, const Rgbd& shade,
                                     const Rgbd& reflected, const Rgbd& refracted);
  void add_part(Rgbd& mean, int depth, const Beam& beam, const Part& part, const Rgbd& local, const Rgbd& reflected,
                const Rgbd& refracted);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgbd& final, Put& put);

  template <class Make>
  void note(Line line, int depth, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, depth, make()});
  }

  const World<double>& world_;
  const std::vector<Outline>& outlines_;
  const RayGenerator<double>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  std::shared_ptr<const UnfoldedPlan> plan_;  ///< as EYE sees it
  std::vector<int> primitives_;               ///< the first of each object
  double far_;                                ///< outside of everything that is drawn
  int rays_formed_ = 0;                       ///< numbers the rays of a recording
  std::vector<int> filters_met_;
  NestedMedia<double> nested_;
  NoObserver no_observer_;
  Tracer<AllEffects> tracer_;  ///< follows single rays
};

}  // namespace raywalk

#include "trace/beam_light_steps.h"
#include "trace/beam_steps.h"
