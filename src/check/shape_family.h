#pragma once

#include "check/family.h"
#include "check/judge.h"

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

}  // namespace raywalk::check
