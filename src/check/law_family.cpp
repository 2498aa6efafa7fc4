#include "check/law.h"

#include "check/family.h"

namespace raywalk::check {

namespace {

template <template <class> class S>
void add(Family& family) {
  for (const Law law : {Law::mirrored, Law::scaled}) {
    const std::string name =
        std::string(shape_name(S<double>{})) + (law == Law::mirrored ? ", mirrored" : ", times 4^k");
    const auto line = [&](const char* scalar, auto run) {
      family.lines.push_back({name,
                              scalar,
                              [run, law](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
                                return run(law, seed, first, count);
                              },
                              {}});
    };
    line("float", obey<S<float>, float>);
    line("double", obey<S<double>, double>);
  }
}

}  // namespace

std::vector<Family> law_families() {
  Family family{"laws", "", {}};
  add<Sphere>(family);
  add<Plane>(family);
  add<Disk>(family);
  add<Box>(family);
  add<Ellipsoid>(family);
  add<EllipticParaboloid>(family);
  add<Cone>(family);
  add<Cylinder>(family);
  add<HyperboloidOneSheet>(family);
  add<HyperboloidTwoSheets>(family);
  return {family};
}

}  // namespace raywalk::check
