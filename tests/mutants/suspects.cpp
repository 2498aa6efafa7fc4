// What a mutant of the numeric code has to get past: the hard-case suite, cut down to the shape that the mutant is of
// (-DSUSPECT=...), so that it compiles and runs in seconds. Exits with 1 and says what broke: the mutant is killed.

#include "check/family.h"
#include "check/invariance.h"
#include "check/normal.h"
#include "check/spawn.h"

#include <cstdio>

#define MESH 1
#define ACCEL 2
#define TRANSFORM 3
#define ARITHMETIC 4
#if SUSPECT == MESH || SUSPECT == ACCEL
#include "accel/accelerator.cpp"
#endif
#if SUSPECT == MESH
#include "check/mesh_family.cpp"
#elif SUSPECT == ACCEL
#include "check/accelerator_family.cpp"
#endif

namespace raywalk::check {

namespace {

int broken = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  ++broken;
  std::printf("broken: %s\n", what);
}

void expect_clean(const Tally& tally, const char* what) {
  expect(tally.rays > 0, what);
  expect(tally.leaks + tally.self_hits + tally.sheet_missed + tally.unequal == 0, what);
  expect(tally.missed + tally.false_hits == tally.excused || tally.missed + tally.false_hits == 0, what);
  expect(tally.fast_ulps_by_condition <= 4 && tally.exact_ulps <= 1, what);
}

[[maybe_unused]] void run(const std::vector<Family>& families, std::uint64_t count) {
  for (const Family& family : families)
    for (const TableLine& line : family.lines) expect_clean(line.run(1, 0, count), line.name.c_str());
}

template <class S, class T>
void aimed(std::uint64_t count) {
  for (int i = 0; i < stratum_count; ++i) {
    const auto stratum = static_cast<Stratum>(i);
    const Tally tally = try_stratum<S, T>(stratum, 1, static_cast<std::uint64_t>(i), 0, count, 50);
    if (stratum != Stratum::subnormal) expect(tally.missed + tally.false_hits == 0, "decisions");
    expect_clean(tally, stratum_name(stratum).data());
  }
}

template <template <class> class S>
[[maybe_unused]] void whole_shape(std::uint64_t count) {
  aimed<S<float>, float>(count);
  aimed<S<double>, double>(count);
  expect_clean(try_normals<S<float>, float>(1, 0, count), "normals");
  expect_clean(try_normals<S<double>, double>(1, 0, count), "normals");
  expect_clean(spawn<S<double>, double>(1, 0, count), "spawned");
  expect_clean(test_invariance<S<double>, double>(Invariance::mirrored, 1, 0, count), "mirrored");
  expect_clean(test_invariance<S<double>, double>(Invariance::scaled, 1, 0, count), "scaled");
}

/// Rays that only the full count has come upon, by their numbers.
template <class S>
void replay(Stratum stratum, std::initializer_list<std::uint64_t> numbers) {
  for (const std::uint64_t number : numbers)
    expect_clean(try_stratum<S, double>(stratum, 1, static_cast<std::uint64_t>(stratum), number, 1, 1),
                 stratum_name(stratum).data());
}
template <class S>
[[maybe_unused]] void found_by_the_full_count(const S& /*shape*/) {}
[[maybe_unused]] void found_by_the_full_count(const Prism<double>& /*shape*/) {
  replay<Prism<double>>(Stratum::on_surface, {383477, 1265208, 1601732, 1716318});
}
[[maybe_unused]] void found_by_the_full_count(const Triangle<double>& /*shape*/) {
  replay<Triangle<double>>(Stratum::scales, {59560, 315094, 606702, 818676});
}

/// A mapped normal is across mapped tangents, and outside stays outside; there and back again is where it was.
[[maybe_unused]] void transforms() {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Random random(1, 70, i);
    Affine<double> chain;
    for (int depth = random.whole(1, 3); depth > 0; --depth) chain = transform_step(random) * chain;
    const Vec3d n = random.unit(), t = across(n, random), image = chain.normal(n), along = chain.direction(t);
    expect(std::abs(raywalk::dot(image, along)) <= 1e-9 * length(image) * length(along), "normals");
    expect(raywalk::dot(image, chain.direction(n)) > 0, "outside stays outside");
    const auto back = inverse(chain);
    expect(back.has_value(), "inverse");
    if (!back) continue;
    const Vec3d p = random.in_box(), there = chain.point(p);
    expect(length(back->point(there) - p) <= 1e-9 * (1 + length(chain.move)), "there and back");
  }
}

/// Identities that hold exactly or not at all.
[[maybe_unused]] void arithmetic() {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Random random(1, 71, i);
    const auto number = [&] { return std::ldexp(random.real(), random.whole(-40, 40)); };
    const double a = number(), b = number(), c = number(), d = number();
    const Expansion x = a, y = b, z = c, w = d;
    expect(((x + y) * (z + w) - x * z - x * w - y * z - y * w).sign() == 0, "distributive");
    const Rational exact = Rational(a) * b - Rational(c) * d;
    expect((x * y - z * w).sign() == sign(exact), "sign of an expansion");
    // Each product is rounded by itself, or what lies in the plan would leave it.
    const Vec3d along(a, b, c);
    volatile double again[] = {a, b, c};  // so that the compiler does not see that they are the same
    expect(raywalk::cross(along, Vec3d(again[0], again[1], again[2])) == Vec3d(0.0),
           "a vector has no cross product with itself");
    const Vec3d n(a, b, c), v(b, c, -(a * b + b * c) / c);
    const double slope = intersect_plane(n, Vec3d(1.0), Vec3d(0.0), v).denominator.value;
    expect((slope > 0) - (slope < 0) == sign(Rational(Rational(a) * b + Rational(b) * c + Rational(c) * v.z)),
           "the slope to a plane");
  }
}

}  // namespace

}  // namespace raywalk::check

int main() {
  using namespace raywalk;
  using namespace raywalk::check;
#if SUSPECT == MESH
  run({mesh_family()}, 20000);
#elif SUSPECT == ACCEL
  run({accelerator_family()}, 20000);
#elif SUSPECT == TRANSFORM
  transforms();
#elif SUSPECT == ARITHMETIC
  arithmetic();
  whole_shape<Plane>(1000);
#elif defined(SHAPE)
  whole_shape<SHAPE>(3000);
#elif defined(SHAPE_ALONE)
  aimed<SHAPE_ALONE<float>, float>(3000);
  aimed<SHAPE_ALONE<double>, double>(3000);
  found_by_the_full_count(SHAPE_ALONE<double>{});
#endif
  return broken > 0 ? 1 : 0;
}
