#pragma once

#include "check/family.h"
#include "check/judge.h"

#include <cstdint>
#include <string>
#include <utility>

namespace raywalk::check {

template <class S, class T>
void add_strata(Family& family, const char* scalar, const Goals& goals) {
  for (int i = 0; i < stratum_count; ++i) {
    const auto stratum = static_cast<Stratum>(i);
    const auto run = [stratum](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
      return try_stratum<S, T>(stratum, seed, static_cast<std::uint64_t>(stratum), first, count, audit_every);
    };
    family.lines.push_back({std::string(stratum_name(stratum)), scalar, run, goals});
  }
}

/// Goals A and B for one shape: all strata in both scalar types.
template <template <class> class S>
[[nodiscard]] Family shape_family(const Goals& goals = {}, std::string instead = {}) {
  Family family{std::string(shape_name(S<double>{})), std::move(instead), {}};
  add_strata<S<float>, float>(family, "float", goals);
  add_strata<S<double>, double>(family, "double", goals);
  return family;
}

/// A line for each scalar type, with what `run.operator()<S<T>, T>(seed, first, count)` does for a shape.
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

/// Calls `add.operator()<S>()` for each shape that has an exact truth, in the order of the tables.
template <class Add>
void for_each_shape(const Add& add) {
  add.template operator()<Sphere>();
  add.template operator()<Plane>();
  add.template operator()<Disk>();
  add.template operator()<Box>();
  add.template operator()<Triangle>();
  add.template operator()<Polygon>();
  add.template operator()<Prism>();
  add.template operator()<Ellipsoid>();
  add.template operator()<EllipticParaboloid>();
  add.template operator()<Cone>();
  add.template operator()<Cylinder>();
  add.template operator()<HyperboloidOneSheet>();
  add.template operator()<HyperboloidTwoSheets>();
}

}  // namespace raywalk::check
