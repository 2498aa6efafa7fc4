#pragma once

#include "accel/accelerator.h"
#include "math/inlining.h"
#include "scene/effects.h"
#include "scene/scene.h"
#include "trace/bodies.h"
#include "trace/dipole.h"
#include "trace/fault.h"
#include "trace/microfacets.h"
#include "trace/rough_dielectric.h"
#include "trace/sky_light.h"
#include "trace/surface_maps.h"
#include "trace/texture.h"
#include "trace/texture_pyramid.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

namespace detail {
template <class T, class Kinds>
struct PreparedKinds;
template <class T, class... Kinds>
struct PreparedKinds<T, std::variant<Kinds...>> {
  using type = std::variant<typename Kinds::template Prepared<T>...>;
};
}  // namespace detail
/// A light of any kind, prepared for tracing.
template <class T>
using PreparedLight = typename detail::PreparedKinds<T, AnyLight>::type;

/// How the patterns of a surface are filtered.
struct PatternFilter {
  CheckerFilter checker = CheckerFilter::none;
  TextureFilter texture = TextureFilter::none;
  std::shared_ptr<const TexturePyramid> pyramid{};  ///< null: the texture is not filtered
  [[nodiscard]] bool any() const { return checker != CheckerFilter::none || texture != TextureFilter::none; }
};

/// A scene prepared for tracing in scalar type T: every number rounded once, primitives in their accelerator. The
/// nested types are those of the scene in T. An object becomes primitives: a shape, the triangles of a mesh or the
/// contents of a group.
template <class T>
struct World {
  struct Checker {
    Rgb<T> even, odd;
    T size;
  };

  /// An image on a surface.
  struct ImageTexture {
    std::shared_ptr<const Image> pixels;
    T width, height;  ///< of one copy
    ImageWraps wraps{};

    /// Its colour at a position on the surface.
    [[nodiscard]] Rgb<T> at(const Vec2<T>& uv) const {
      return texture_colour<T>(*pixels, uv.x / width, uv.y / height, wraps);
    }
  };

  /// How a medium scatters.
  struct Scattering {
    Rgb<T> coefficient{0};  ///< per unit of length
    T anisotropy = 0;       ///< g, in -1..1 without the ends
  };

  /// What light travels in; air has none. Small, for every hit looks up a surface.
  struct Medium {
    Rgb<T> extinction{0};          ///< absorption and scattering, per unit of length
    T ior = 1;                     ///< of air; a scene's default is that of Material
    bool absorbs = false;          ///< transmits, and extinction is not black
    bool endless = false;          ///< absorbs, and is unbounded
    std::int32_t scattering = -1;  ///< index into `scatterings`: for paths, which then walk inside
                                   ///< (trace/medium_walk.h); all others lose what scatters
    [[nodiscard]] bool scatters() const { return scattering >= 0; }
  };

  /// A material in T, and the medium behind the surface. Of a mask's two materials, the most of both.
  struct Surface : Medium, SurfaceValues<T> {
    bool dielectric, transmits, filters_shadows;
    bool fixed_normal;     ///< the shading normal does not turn to face the ray
    bool lit_from_behind;  ///< highlights of lights behind it show
    std::optional<Checker> checker;
    std::optional<ImageTexture> texture;
    bool nests = false;     ///< the world has bodies that can nest
    bool seamless = false;  ///< scatters inside, and is itself neither seen nor felt where the indices are equal
    double priority = 0;    ///< where bodies overlap, the highest wins
    Rgb<T> filter{1};       ///< of shadow rays, at each crossing
  };

  /// A light in T, with the answers of its kind (scene/light.h) that every ray needs.
  struct Light {
    int index;          ///< in Scene::lights
    Rgb<T> strength;    ///< not black: black lights are left out
    bool is_distant;    ///< infinitely far away
    bool is_delta;      ///< also an area light that its centre represents
    bool is_isotropic;  ///< shines everywhere with the same strength
    Vec3<T> place;      ///< its centre, or the unit direction from any surface to a distant light
    T constant, linear, quadratic;
    T reach;  ///< radius of a bounding sphere about `place`, its centre
    PreparedLight<T> kind;

    int grid = 1;                       ///< grid * grid points are sampled at a hit
    T sample_weight = 1;                ///< of each: 1 / samples()
    std::uint32_t first_dimension = 0;  ///< of its draws, two per sample

    [[nodiscard]] int samples() const { return grid * grid; }
    /// Maps the unit square to the light, uniformly in area. Kinds with an extent are asked in turn: cheaper than a
    /// visit, which jumps to one of all kinds. All of it inline: otherwise that would depend on the rest of the kernel.
    template <std::size_t I = 0>
    [[nodiscard, RAYWALK_INLINE_WHOLE]] Vec3<T> sample(const Vec2<T>& unit) const {
      if constexpr (I == std::variant_size_v<PreparedLight<T>>) {
        return place;
      } else {
        if constexpr (requires(const std::variant_alternative_t<I, PreparedLight<T>>& light) { light.sample(unit); })
          if (const auto* light = std::get_if<I>(&kind)) return light->sample(unit);
        return sample<I + 1>(unit);
      }
    }
    /// One of `edge` * `edge` points all over it, without random numbers; the mean of all is its centre.
    [[nodiscard]] Vec3<T> regular(int point, int edge) const {
      if (edge == 1) return place;
      return std::visit(
          [&](const auto& light) {
            if constexpr (requires { light.regular(point, edge); }) return light.regular(point, edge);
            const Vec2<T> cell(static_cast<T>(point % edge), static_cast<T>(point / edge));
            return sample((cell + T(0.5)) / static_cast<T>(edge));
          },
          kind);
    }
    /// How far it reaches along a direction of unit length from its centre; 0 of a point.
    template <class S>
    [[nodiscard]] S half_extent(const Vec3<S>& direction) const {
      return std::visit(
          [&](const auto& light) {
            if constexpr (requires { light.sample(Vec2<T>()); }) return light.half_extent(direction);
            return S(0);
          },
          kind);
    }
    /// The radius of a disc of the area that is seen of it along `l`, of unit length; 0 of a point.
    [[nodiscard]] double seen_radius(const Vec3d& l) const {
      return std::visit(
          [&](const auto& light) {
            if constexpr (requires { light.sample(Vec2<T>()); }) return light.seen_radius(l);
            return 0.0;
          },
          kind);
    }
    /// From a surface to a point of the light, which is at t = 1; to a distant one, of unit length.
    [[nodiscard]] Vec3<T> direction_to(const Vec3<T>& point, const Vec3<T>& from) const {
      return is_distant ? place : point - from;
    }
    [[nodiscard]] T t_far() const { return is_distant ? infinity<T> : T(1); }
    [[nodiscard]] T distance(const Vec3<T>& to_light) const { return is_distant ? T(1) : length(to_light); }
    [[nodiscard]] T attenuation(T distance) const { return constant + distance * (linear + distance * quadratic); }
    /// Whether it illuminates the point that `to_light` leads from.
    [[nodiscard]] bool shines_along(const Vec3<T>& to_light) const {
      if (is_isotropic) return true;
      return std::visit(
          [&](const auto& light) {
            if constexpr (requires { light.shines_along(to_light); }) return light.shines_along(to_light);
            return true;
          },
          kind);
    }
    /// The fraction of its strength that goes there; `l`: unit length.
    [[nodiscard]] T falloff(const Vec3<T>& l) const {
      return std::visit(
          [&](const auto& light) {
            if constexpr (requires { light.falloff(l); }) return light.falloff(l);
            return T(1);
          },
          kind);
    }
  };

  /// `fault`: breaks the tracer on purpose; numerics are then naive, whatever the scene says. `build.stop` may cancel
  /// the construction, which then throws Stopped.
  explicit World(const Scene& scene, AcceleratorKind kind = AcceleratorKind::automatic,
                 std::optional<Fault> fault = std::nullopt, const BuildOptions& build = {});

  std::vector<Surface> surfaces;
  std::vector<Scattering> scatterings;  ///< of the media that scatter
  /// The same: by which light comes out of them without a walk. Empty where it walks.
  std::vector<Dipole<T>> dipoles;
  std::vector<Light> lights;
  Rgb<T> background, ambient;
  std::shared_ptr<const SkyLight> sky;  ///< null: the background is the same everywhere
  int depth;                            ///< of the ray tree, at most
  T threshold;                          ///< the least throughput that a ray is formed for
  Effects effects;
  bool absorbs = false;                  ///< whether some surface does
  bool draws;                            ///< lights and lobes are sampled at random; else lights at fixed points
  std::vector<ShadowRole> shadow_roles;  ///< by primitive; empty when all of them stop shadow rays

  /// By primitive: the index of its object in the scene, and of its surface. Empty when primitive i is object i. Those
  /// of copies, from `first_copied` on, are known by their ranges.
  std::vector<std::int32_t> objects, surface_indices;
  std::int32_t first_copied = std::numeric_limits<std::int32_t>::max();
  /// Where the primitives of one shape or mesh begin, ascending. Empty with `objects`.
  struct PrimitiveRange {
    std::int32_t first, name;  ///< `name`: in range_names, or -1
    bool mesh;
    std::int32_t object = -1, surface = -1;  ///< of a copy; -1: each triangle has its own surface
    std::size_t surfaces = 0;                ///< then: where they begin in `copied_surfaces`
  };
  std::vector<PrimitiveRange> ranges;
  std::vector<std::string> range_names;
  std::vector<std::int32_t> copied_surfaces;  ///< by triangle of each mesh with materials that is copied
  /// By surface; empty where the scene filters nothing. Beside the surfaces, whose size each hit pays for.
  std::vector<PatternFilter> pattern_filters;
  std::vector<Microsurface<T>> microsurfaces;  ///< the same; empty where nothing is of metal or rough
  bool has_rough_diffuse = false;              ///< whether one of them is matt
  /// The same: of rough glass, between its index and each that may be on the other side. Empty where there is none.
  std::vector<std::vector<std::shared_ptr<const RoughDielectric<T>>>> rough_dielectrics;
  std::vector<SurfaceMaps<T>> surface_maps;  ///< by surface; empty where nothing is mapped
  Accelerator<T> accelerator;                ///< after the lists above, which building it fills
  std::optional<Fault> fault;
  Numerics numerics;
  bool occludes;  ///< shadow rays are traced
  T epsilon;      ///< offset of naive rays from a surface
  /// Whether a shadow ray first tests the previous blocker of the same light. Only changes the cost.
  bool shadow_cache = false;
  /// The transmitting bodies, where they can nest. Where this is empty, rays enter every body from air.
  Bodies bodies;

  [[nodiscard]] const Surface& surface(int primitive) const {
    if (primitive >= first_copied) return copied_surface(primitive);
    const auto id = static_cast<std::size_t>(primitive);
    return surfaces[surface_indices.empty() ? id : static_cast<std::size_t>(surface_indices[id])];
  }
  /// What a ray brings that leaves the scene.
  [[nodiscard]] Rgb<T> background_along(const Vec3<T>& direction) const {
    return sky ? Rgb<T>(sky->radiance(Vec3d(direction))) : background;
  }
  /// Whether rays need differentials.
  [[nodiscard]] bool filters() const { return !pattern_filters.empty(); }
  [[nodiscard]] bool filters(const Surface& its) const { return filters() && pattern_filter(its).any(); }
  /// Of one of the surfaces; null where it is the same all over.
  [[nodiscard]] const SurfaceMaps<T>* maps(const Surface& its) const {
    if (surface_maps.empty()) return nullptr;
    const SurfaceMaps<T>& found = surface_maps[static_cast<std::size_t>(&its - surfaces.data())];
    return found.any() ? &found : nullptr;
  }
  /// What a surface emits at the point of its part that `to_point` leads to.
  [[nodiscard]] Rgb<T> emission_at(const Departure& of, const Vec3<T>& from, const Vec3<T>& to_point, T time) const {
    const Surface& its = surface(of.primitive);
    const SurfaceMaps<T>* own = maps(its);
    if (own == nullptr || !own->maps_emission()) return its.emission;
    const Primitives<T>& primitives = accelerator.primitives();
    const Ray<T> there{from, to_point, {}, time};
    const SurfacePoint<T> point = primitives.surface_at(of.primitive, there, Intersection<T>{1, of.part});
    return own->mixed(own->at(primitives.uv_at(of.primitive, point, of.part, time))).emission;
  }
  /// Of one of the surfaces; null where its mirror is neither of metal nor rough.
  [[nodiscard]] const Microsurface<T>* microsurface(const Surface& its) const {
    if (microsurfaces.empty()) return nullptr;
    const Microsurface<T>& found = microsurfaces[static_cast<std::size_t>(&its - surfaces.data())];
    return found.metal || found.facets ? &found : nullptr;
  }
  /// The same of a matt surface; null where it is smooth.
  [[nodiscard]] const RoughDiffuse<T>* rough_diffuse(const Surface& its) const {
    if (microsurfaces.empty()) return nullptr;
    const auto& found = microsurfaces[static_cast<std::size_t>(&its - surfaces.data())].matt;
    return found ? &*found : nullptr;
  }
  /// The same of a boundary that transmits, between indices of refraction; null where it is smooth, or bends nothing.
  [[nodiscard]] const RoughDielectric<T>* rough_dielectric(const Surface& its, T n1, T n2) const {
    if (rough_dielectrics.empty()) return nullptr;
    for (const auto& one : rough_dielectrics[static_cast<std::size_t>(&its - surfaces.data())])
      if (one->is_between(n1, n2)) return one.get();
    return nullptr;
  }
  /// Of one of the surfaces.
  [[nodiscard]] const PatternFilter& pattern_filter(const Surface& its) const {
    return pattern_filters[static_cast<std::size_t>(&its - surfaces.data())];
  }
  /// What a primitive is within its object, for display; used by observers only.
  struct Piece {
    int triangle = -1;   ///< of a mesh, in the order of its file, from 0; -1: no mesh
    std::string member;  ///< name of the object inside the group; empty outside groups
  };
  [[nodiscard]] Piece piece(int primitive) const;
  /// Index in Scene::objects.
  [[nodiscard]] int object(int primitive) const {
    if (primitive >= first_copied) return range_of(primitive)->object;
    return objects.empty() ? primitive : objects[static_cast<std::size_t>(primitive)];
  }

 private:
  /// Null where there are none.
  [[nodiscard]] const PrimitiveRange* range_of(int primitive) const;
  [[nodiscard]] const Surface& copied_surface(int primitive) const;
};

extern template struct World<float>;
extern template struct World<double>;

}  // namespace raywalk
