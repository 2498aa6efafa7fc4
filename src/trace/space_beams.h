#pragma once
// Beam tracing in space: P. Heckbert and P. Hanrahan, "Beam Tracing Polygonal Objects", SIGGRAPH 1984. As in the plan
// (trace/beams.h), a beam is all rays of a pixel at once; faces cut it into parts that see one thing each, shadows into
// parts in one light, checkers of flat things into squares, and a flat mirror makes a beam of a beam. All cuts are
// lines of the pixel's window (trace/beam_window.h), so that its parts are the pixel, whole and once.
//
// A part is shaded in its middle. Of light with an extent each part is shaded by what its middle sees of it, exactly
// where the light is a rectangle. Neither a curved mirror nor glass reflects or bends a beam as a beam: of these a
// single ray is followed, from the middle, as trace/tracer.h does.
//
// `main_algorithm` and `shade_parts` read like trace/pseudocode.h, and a test holds them together; what a statement
// does stands in trace/space_beam_steps.h, and for lights in trace/space_beam_light_steps.h.

#include "math/stop.h"
#include "trace/beam_faces.h"
#include "trace/part_steps.h"
#include "trace/space_beam_kernel.h"
#include "trace/surface_vertex.h"
#include "trace/tracer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

template <class T, class Watcher>
class SpaceBeamTracer {
 public:
  using Observer = Watcher;

  /// `faces` are those of the world's scene. All outlive this.
  SpaceBeamTracer(const World<T>& world, const BeamFaces& faces, const RayGenerator<T>& camera, Observer& observer,
                  const Stop& stop = {});

  /// BEAM TRACING. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade.
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
      const Shades final = shade_parts(depth, beam, parts);
      // Put final shade in pixel
      put_in_pixel(pixel, final.mean, put);
    }
  }

  /// The parts of a rectangle of the picture, in pixels from its upper left corner.
  [[nodiscard]] std::vector<ShadedPiece<T>> parts_of(const Vec2d& from, const Vec2d& to);

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  using AllEffects = Policy<T>;
  using Vertex = SurfaceVertex<T>;
  using Medium = typename World<T>::Medium;
  using Light = typename World<T>::Light;
  /// Rays through a window, directly or by mirrors.
  struct Beam {
    BeamView view;
    WindowPiece window;
    double pixel = 1;  ///< the area of the pixel's window, of which this may be a part
    Rgb<T> throughput{1};
    int number = 0;                    ///< in the recording; 0 without an observer
    const BeamFace* mirror = nullptr;  ///< that it leaves
    Departure departure{};
    const Medium* medium = nullptr;
  };
  /// A part of a beam, which sees one thing in one light.
  struct Part : SeenFace {
    std::uint64_t stopped = 0;   ///< by light: something stops it
    std::uint64_t unsure = 0;    ///< by light: a ray has to tell
    bool has_mean = false;       ///< of its checker, whose squares are too many to be cut
    int number = 0;              ///< as above
    Ray<T> ray{};                ///< in its middle
    std::optional<Vertex> at{};  ///< what that ray meets
    Rgb<T> ambient{0};           ///< of the surface
  };
  static constexpr std::size_t most_divided = 64;  ///< lights
  static constexpr double most_squares = 8;        ///< of a checker that are cut, each way
  struct Shadow {
    Ray<T> ray;
    int number;
  };
  /// What of a light reaches the middle of a part, from one place or from several.
  struct Arriving {
    Vec3<T> to_light;
    Rgb<T> share;
  };
  /// What lights bring; each one's term only when observed.
  struct DirectLighting {
    Rgb<T> sum{0};
    std::vector<LightTerm> terms{};
  };
  struct MiddleRay {
    Ray<T> ray;
    RayKind kind;
    int number;
    const Medium* medium;
  };
  /// The shades of a beam's parts, as mirrors have cut them further, and their mean.
  struct Shades {
    std::vector<ShadedPiece<T>> pieces;
    Rgb<T> mean{0};
    double area = 0;
  };

  /// SHADE PARTS (DEPTH, RTNSHADE): the light that comes back along a beam.
  Shades shade_parts(int depth, const Beam& beam, const std::vector<Part>& parts) {
    Shades shades;
    // For each part
    for (const Part& part : parts) {
      begin(depth, beam, parts, part);
      DirectLighting direct;
      for (const Light& light : detail::lights_on(world_, part)) {
        // Form shadow ray
        const std::optional<Shadow> shadow = form_shadow_ray(depth, part, beam, light);
        if (!shadow) {
          add_unlit(direct, light);
          continue;
        }
        // Find intersection
        const std::vector<Arriving> arriving = find_intersection(depth, part, *shadow, light);
        add_light(direct, part, light, arriving);
      }
      // Shade its middle
      const Rgb<T> local = shade_middle(depth, part, direct);
      std::optional<Shades> reflected;
      Rgb<T> followed[2] = {Rgb<T>(0), Rgb<T>(0)};
      // If flat mirror
      if (decide_flat_mirror(depth, part)) {
        // Form mirrored beam
        if (const std::optional<Beam> mirrored = form_mirrored_beam(depth, part, beam)) {
          // Cut it by outlines and shadows
          const std::vector<Part> seen = cut(Line::cut_mirrored_beam, depth, *mirrored);
          // Shade parts (DEPTH+1, REFLSHADE)
          const int deeper = call_shade_parts(Line::shade_mirrored_parts, depth, *mirrored);
          reflected = shade_parts(deeper, *mirrored, seen);
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
          const Rgb<T> light = follow_middle_ray(depth, *ray);
          followed[kind == RayKind::refract] = detail::weight_of(*part.at, kind) * light;
        }
      }
      // Add shade, times coverage
      add_part(shades, depth, beam, parts, part, local, reflected, followed[0], followed[1]);
    }
    return shades;
  }

  void begin(const Pixel& pixel);
  Beam form_beam(const Pixel& pixel);
  [[nodiscard]] Beam beam_between(const Vec2d& from, const Vec2d& to);
  std::vector<Part> cut(Line line, int depth, const Beam& beam);
  [[nodiscard]] std::vector<Part> divided_by_shadows(const Beam& beam, const Part& whole);
  void divide_by_squares(std::vector<Part>& parts, const Beam& beam, Part&& whole) const;
  [[nodiscard]] bool shows_shadows(const BeamFace& face) const;
  /// Of a beam's window.
  [[nodiscard]] static T share_of(const Part& part, const Beam& beam) {
    return static_cast<T>(area_of(part.window) / area_of(beam.window));
  }
  void meet(Part& part, const Beam& beam, const Vec2d& place);
  /// As drawn: the two sides that are widest apart in the plan, or beside each other, and all corners.
  [[nodiscard]] BeamArea drawn_area(const Beam& beam, const SeenFace& part) const;
  int call_shade_parts(Line line, int depth, const Beam& beam);
  void begin(int depth, const Beam& beam, const std::vector<Part>& parts, const Part& part);
  [[nodiscard]] bool faces(const Vertex& at, const Light& light) const;
  std::optional<Shadow> form_shadow_ray(int depth, const Part& part, const Beam& beam, const Light& light);
  std::vector<Arriving> find_intersection(int depth, const Part& part, const Shadow& shadow, const Light& light);
  [[nodiscard]] std::vector<Arriving> arriving_from(const Part& part, const Light& light);
  [[nodiscard]] std::vector<Arriving> arriving_from(const Part& part, const Light& light,
                                                    const RectangleLight::Prepared<T>& rectangle);
  /// How much of a light arrives from there, as a shadow ray finds it.
  [[nodiscard]] Rgb<T> transmittance(const Part& part, const Light& light, const Vec3<T>& to_light);
  void add_unlit(DirectLighting& direct, const Light& light);
  void add_light(DirectLighting& direct, const Part& part, const Light& light, const std::vector<Arriving>& arriving);
  Rgb<T> shade_middle(int depth, const Part& part, const DirectLighting& direct);
  [[nodiscard]] bool is_flat(const Part& part) const;
  bool decide_flat_mirror(int depth, const Part& part);
  std::optional<Beam> form_mirrored_beam(int depth, const Part& part, const Beam& beam);
  [[nodiscard]] bool sends(const Part& part, RayKind kind) const;
  bool decide_curved_or_glass(int depth, const Part& part);
  std::optional<MiddleRay> form_middle_ray(int depth, const Part& part, const Beam& beam, RayKind kind);
  Rgb<T> follow_middle_ray(int depth, const MiddleRay& ray);
  [[nodiscard]] double off_near_border(int depth, const Beam& beam, const Part& part, const Rgb<T>& shade);
  [[nodiscard]] Rgb<T> unmirrored_shade(int depth, const Part& part);
  void add_part(Shades& shades, int depth, const Beam& beam, const std::vector<Part>& parts, const Part& part,
                const Rgb<T>& local, std::optional<Shades>& reflected, const Rgb<T>& curved, const Rgb<T>& refracted);
  template <class Put>
  void put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put);

  template <class Make>
  void note(Line line, int depth, Make&& make) {
    if constexpr (Observer::watches) observer_.record(Event{line, depth, make()});
  }

  const World<T>& world_;
  const BeamFaces& faces_;
  const RayGenerator<T>& camera_;
  Observer& observer_;
  Stop stop_;
  Statistics statistics_;
  double far_;           ///< outside of everything that is drawn
  int rays_formed_ = 0;  ///< numbers the rays of a recording
  std::vector<int> filters_met_;
  NestedMedia<T> nested_;
  NoObserver no_observer_;
  Tracer<AllEffects> tracer_;  ///< follows single rays
};

}  // namespace raywalk

#include "trace/space_beam_light_steps.h"
#include "trace/space_beam_steps.h"
