#pragma once
// Selects and instantiates the kernels of one scalar type; included by kernel_*.cpp alone.

#include "trace/kernel.h"
#include "trace/tracer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>
#include <utility>

namespace raywalk::detail {

template <class Policy, class T>
Statistics run_tracer(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put, typename Policy::Observer& observer) {
  Tracer<Policy> tracer(world, camera, observer, block.stop, block.bounced);
  if constexpr (std::is_same_v<typename Policy::Ray, Ray<T>> && !few_kernels) {
    if (PrimaryRaysAhead<T>::pays(world)) {
      PrimaryRaysAhead<T> ahead(world, camera, block);
      tracer.main_algorithm(block, put, ahead);
      return tracer.statistics();
    }
  }
  tracer.main_algorithm(block, put);
  return tracer.statistics();
}

/// With all effects: these are for study, need not be fast, and give the same bits. In a .cpp of their own, as are the
/// faulty kernels.
template <class T>
Statistics run_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                            const PutPixel<T>& put);
template <class T>
Statistics run_watched_naive_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                    const PutPixel<T>& put, Observer& observer);
template <class T>
Statistics run_faulty_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                             const PutPixel<T>& put);
template <class T>
Statistics run_watched_faulty_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                                     const PutPixel<T>& put, Observer& observer);

/// Carries differentials: with the effects that most scenes have that filter, with all but maps, or with all.
template <class T>
Kernel<T> filtering_kernel(const World<T>& world);

template <class T, HitEffects Set>
Statistics run_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                      const PutPixel<T>& put) {
  NoObserver no_observer;
  return run_tracer<Policy<T, NoObserver, Set>>(world, camera, block, put, no_observer);
}

/// What a kernel for these effects does besides: there is no refraction without reflection (total internal reflection),
/// nor lobes without it, nor nesting without refraction, nor penumbras without shadows.
[[nodiscard]] constexpr HitEffects widened(HitEffects set) {
  set.refraction = set.refraction || set.nesting;
  set.reflection = set.reflection || set.refraction || set.lobes;
  set.shadows = set.shadows || set.penumbra;
  return set;
}

/// Each set that a kernel is compiled for: seven ways to scatter, each with or without textures, and with shadows,
/// shadows and penumbras, or neither: forty-two. One more leaves out shadow rays; one has a sky, which none
/// of those has, nor scattering, which is for paths; one has metals and small mirrors too. Nesting is a set of its own:
/// where nothing nests, a mere test at each hit would cost more than 0.1%. So would one for differentials, or for maps:
/// what filters or is mapped has kernels apart, beside which those here stay as the compiler makes them without. Where
/// there are to be few, what has sharp rays and sharp shadows alone, as Whitted's scene, takes one, and all else the
/// other.
inline constexpr auto kernel_sets = [] {
  if constexpr (few_kernels) {
    return std::array{sharp_rays, no_filtering};
  } else {
    constexpr bool no = false, yes = true;
    struct Scattering {
      bool reflection, refraction, lobes, nesting;
    };
    constexpr std::array<Scattering, 7> scatterings{{{no, no, no, no},
                                                     {yes, no, no, no},
                                                     {yes, yes, no, no},
                                                     {yes, no, yes, no},
                                                     {yes, yes, yes, no},
                                                     {yes, yes, no, yes},
                                                     {yes, yes, yes, yes}}};
    constexpr std::array<std::pair<bool, bool>, 3> lights{{{no, no}, {yes, no}, {yes, yes}}};  // shadows, penumbras
    std::array<HitEffects, scatterings.size() * 2 * lights.size() + 3> sets{};
    std::size_t at = 0;
    for (const Scattering& to : scatterings)
      for (const auto& [shadows, penumbra] : lights)
        for (const bool textures : {no, yes}) {
          HitEffects set = sharp_rays;
          set.reflection = to.reflection, set.refraction = to.refraction, set.lobes = to.lobes;
          set.nesting = to.nesting, set.textures = textures, set.shadows = shadows, set.penumbra = penumbra;
          if (set == widened(set)) sets[at++] = set;
        }
    sets[at++] = no_occlusion;  // for looking, and need not be fast
    sets[at++] = no_filtering_nor_facets;
    sets[at] = no_filtering;
    return sets;
  }
}();

/// The smallest of these that holds a world's effects; but for filtering and maps, which have kernels of their own.
[[nodiscard]] constexpr std::size_t kernel_set_for(HitEffects set) {
  if (few_kernels) {  // they ask the world for occlusion
    set = set.penumbra || set.lobes || set.scattering || set.sky || set.microfacets ? no_filtering : sharp_rays;
  } else if (!set.occlusion) {
    set = no_occlusion;
  } else if (set.microfacets) {
    set = no_filtering;
  } else if (set.sky || set.scattering) {
    set = no_filtering_nor_facets;
  } else {
    set.filtering = set.maps = set.dipole = set.bounced = false;
  }
  return static_cast<std::size_t>(std::find(kernel_sets.begin(), kernel_sets.end(), widened(set)) -
                                  kernel_sets.begin());
}
static_assert(
    [] {
      // Each of the last ones, from occlusion on, decides alone: all together would be too many for a compiler.
      constexpr std::size_t combined = 7;
      for (unsigned bits = 0; bits < 1u << combined; ++bits)
        for (std::size_t last = combined; last < sizeof(HitEffects); ++last) {
          std::array<bool, sizeof(HitEffects)> set{};
          for (std::size_t i = 0; i < combined; ++i) set[i] = (bits >> i & 1) != 0;
          set[last] = true;
          for (const bool occlusion : {false, true}) {
            set[combined] = occlusion;
            if (kernel_set_for(std::bit_cast<HitEffects>(set)) == kernel_sets.size()) return false;
          }
        }
      return true;
    }(),
    "every combination of effects has a kernel");

template <class T>
Kernel<T> fitting_kernel(const World<T>& world) {
  if (world.numerics == Numerics::naive) return &run_naive_kernel<T>;
  // Single precision is for comparing: where there are to be few kernels, the largest does.
  if constexpr (few_kernels && std::is_same_v<T, float>) {
    return filtering_kernel(world);
  } else {
    static constexpr auto kernels = []<std::size_t... I>(std::index_sequence<I...>) {
      return std::array<Kernel<T>, sizeof...(I)>{&run_kernel<T, kernel_sets[I]>...};
    }(std::make_index_sequence<kernel_sets.size()>());
    HitEffects set = hit_effects(world.effects, world.lights.size(), !world.bodies.empty());
    set.occlusion = world.occludes;
    if ((set.filtering || set.maps || set.bounced) && (set.occlusion || few_kernels)) return filtering_kernel(world);
    return kernels[kernel_set_for(set)];
  }
}

template <class T>
Statistics run_watched_kernel(const World<T>& world, const RayGenerator<T>& camera, const PixelBlock& block,
                              const PutPixel<T>& put, Observer& observer) {
  if (world.numerics == Numerics::naive) return run_watched_naive_kernel(world, camera, block, put, observer);
  return run_tracer<Policy<T, Observer>>(world, camera, block, put, observer);
}

}  // namespace raywalk::detail
