#include "check/invariance.h"

#include "check/family.h"

namespace raywalk::check {

namespace {

template <template <class> class S>
void add(Family& family) {
  for (const Invariance invariance : {Invariance::mirrored, Invariance::scaled}) {
    const std::string name =
        std::string(shape_name(S<double>{})) + (invariance == Invariance::mirrored ? ", mirrored" : ", times 4^k");
    const auto line = [&](const char* scalar, auto run) {
      family.lines.push_back({name,
                              scalar,
                              [run, invariance](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
                                return run(invariance, seed, first, count);
                              },
                              {}});
    };
    line("float", test_invariance<S<float>, float>);
    line("double", test_invariance<S<double>, double>);
  }
}

template <template <class> class... Shapes>
void add_all(Family& family) {
  (add<Shapes>(family), ...);
}

}  // namespace

std::vector<Family> invariance_families() {
  Family family{"laws", "", {}};
  add_all<Sphere, Plane, Disk, Box, Ellipsoid, EllipticParaboloid, Cone, Cylinder, HyperboloidOneSheet,
          HyperboloidTwoSheets>(family);
  return {family};
}

}  // namespace raywalk::check
