#include "check/symmetry.h"

#include "check/family.h"

namespace raywalk::check {

namespace {

template <template <class> class S>
void add(Family& family, Symmetry symmetry) {
  const std::string name(shape_name(S<double>{}));
  const auto line = [&](const char* scalar, auto run) {
    family.lines.push_back({name,
                            scalar,
                            [run, symmetry](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
                              return run(symmetry, seed, first, count);
                            },
                            {}});
  };
  line("float", keep_symmetry<S<float>, float>);
  line("double", keep_symmetry<S<double>, double>);
}

[[nodiscard]] Family family_of(const char* name, Symmetry symmetry) {
  Family family{name, "", {}};
  add<Sphere>(family, symmetry);
  add<Plane>(family, symmetry);
  add<Disk>(family, symmetry);
  add<Box>(family, symmetry);
  add<Triangle>(family, symmetry);
  add<Polygon>(family, symmetry);
  add<Prism>(family, symmetry);
  add<Ellipsoid>(family, symmetry);
  add<EllipticParaboloid>(family, symmetry);
  add<Cone>(family, symmetry);
  add<Cylinder>(family, symmetry);
  add<HyperboloidOneSheet>(family, symmetry);
  add<HyperboloidTwoSheets>(family, symmetry);
  return family;
}

}  // namespace

std::vector<Family> symmetry_families() {
  return {family_of("permuted", Symmetry::permuted), family_of("reversed", Symmetry::reversed)};
}

}  // namespace raywalk::check
