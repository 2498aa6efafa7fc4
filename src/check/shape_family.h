#pragma once
// All that is asked of a shape. Whoever includes this instantiates many templates, so each shape is asked in one file.

#include "check/family.h"
#include "check/invariance.h"
#include "check/judge.h"
#include "check/normal.h"
#include "check/spawn.h"
#include "check/symmetry.h"

#include <cstdint>
#include <string>
#include <type_traits>

namespace raywalk::check {

/// Lines for both scalar types, with what `run.operator()<S<T>, T>(seed, first, count)` does for a shape.
template <template <class> class S, class Run>
void add_lines(Family& family, const std::string& name, const Run& run) {
  const auto line = [&]<class T>(const char* scalar) {
    family.lines.push_back({name,
                            scalar,
                            [run](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
                              return run.template operator()<S<T>, T>(seed, first, count);
                            },
                            {}});
  };
  line.template operator()<float>("float");
  line.template operator()<double>("double");
}

template <template <class> class S, class T>
void add_strata(Family& family, const char* scalar) {
  for (int i = 0; i < stratum_count; ++i) {
    const auto stratum = static_cast<Stratum>(i);
    const auto run = [stratum](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
      return try_stratum<S<T>, T>(stratum, seed, static_cast<std::uint64_t>(stratum), first, count, audit_every);
    };
    family.lines.push_back({std::string(stratum_name(stratum)), scalar, run, {}});
  }
}

template <template <class> class S>
void add_shape(ShapeFamilies& all) {
  const std::string name(shape_name(S<double>{}));
  Family& own = all.own.emplace_back(Family{name, "", {}});
  add_strata<S, float>(own, "float");
  add_strata<S, double>(own, "double");
  add_lines<S>(std::is_same_v<S<double>, Prism<double>> ? all.spawned_polygon : all.spawned, name,
               []<class Shape, class T>(auto... range) { return spawn<Shape, T>(range...); });
  for (const auto& [family, symmetry] :
       {std::pair(&all.permuted, Symmetry::permuted), {&all.reversed, Symmetry::reversed}})
    add_lines<S>(*family, name, [symmetry]<class Shape, class T>(auto... range) {
      return keep_symmetry<Shape, T>(symmetry, range...);
    });
  add_lines<S>(all.normals, name, []<class Shape, class T>(auto... range) { return try_normals<Shape, T>(range...); });
}

/// Of a shape that stays the same to the last bit when it is mirrored or scaled.
template <template <class> class S>
void add_invariance(ShapeFamilies& all) {
  const std::string name(shape_name(S<double>{}));
  for (const auto& [change, words] :
       {std::pair(Invariance::mirrored, ", mirrored"), {Invariance::scaled, ", times 4^k"}})
    add_lines<S>(all.laws, name + words,
                 [change]<class Shape, class T>(auto... range) { return test_invariance<Shape, T>(change, range...); });
}

template <template <class> class... Shapes>
void add_shapes(ShapeFamilies& all) {
  (add_shape<Shapes>(all), ...);
}
template <template <class> class... Shapes>
void add_invariances(ShapeFamilies& all) {
  (add_invariance<Shapes>(all), ...);
}

}  // namespace raywalk::check
