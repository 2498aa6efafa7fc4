// The phase function: what is drawn follows its density, in space and in the plan, in both precisions.

#include "trace/phase.h"

#include <vector>

#include "support/catch.h"
#include "support/effort.h"
#include "trace/drawn.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr int bins = 40;

// Chi-square of the cosines (in the plan: angles) drawn, against the integrals of the density over equal bins.
template <class T>
double chi_square(T g, bool flat, int samples) {
  const PhaseFunction<T> phase{normalize(flat ? Vec3<T>(T(0.6), T(-0.8), 0) : Vec3<T>(T(0.3), T(-0.5), T(0.8))), g,
                               flat};
  std::vector<double> expected(bins, 0), found(bins, 0);
  constexpr int steps = 2000;
  const auto turn_of = [](const Vec3<T>& a, const Vec3<T>& b) { return std::atan2(a.x * b.y - a.y * b.x, dot(a, b)); };
  for (int bin = 0; bin < bins; ++bin)
    for (int i = 0; i < steps; ++i) {
      const double at = (bin + (i + 0.5) / steps) / bins;
      const double density = flat ? phase.value(static_cast<T>(std::cos(2 * pi_v<double> * at - pi_v<double>)))
                                  : phase.value(static_cast<T>(2 * at - 1));
      expected[static_cast<std::size_t>(bin)] += samples * density * (flat ? 2 : 4) * pi_v<double> / (bins * steps);
    }
  double turned = 0;
  for (int i = 0; i < samples; ++i) {
    RandomKey key{};
    key.seed = 7;
    key.sample = static_cast<std::uint32_t>(i);
    const Vec2<T> u = draw_pair<T>(Sampler::random, key, Strata(1));
    const Vec3<T> direction = phase.sample(u);
    REQUIRE(std::abs(length(direction) - 1) < 1e-6);
    if (flat) REQUIRE(direction.z == 0);
    const double at = flat ? (turn_of(phase.axis, direction) + pi_v<double>) / (2 * pi_v<double>)
                           : (dot(phase.axis, direction) + 1) / 2.0;
    found[static_cast<std::size_t>(std::clamp(static_cast<int>(at * bins), 0, bins - 1))] += 1;
    turned += dot(phase.axis, direction);
  }
  CHECK(turned / samples == Approx(g).margin(5 / std::sqrt(samples)));  // its mean cosine is g
  double sum = 0, few_expected = 0, few_found = 0;
  const auto add = [&sum](double one, double other) { sum += (one - other) * (one - other) / other; };
  for (std::size_t bin = 0; bin < bins; ++bin) {
    few_expected += expected[bin], few_found += found[bin];
    if (few_expected < 10) continue;
    add(few_found, few_expected);
    few_expected = few_found = 0;
  }
  return sum;
}

// Of at most 40 bins: one time in a million it is above this.
constexpr double rare = 92;

}  // namespace

TEST_CASE("directions of the phase function pass the chi-square test", "[odds]") {
  const int samples = rounds(200'000);
  for (const bool flat : {false, true})
    for (const double g : {-0.9, -0.4, 0.0, 0.3, 0.75, 0.95}) {
      CAPTURE(flat, g);
      CHECK(chi_square<double>(g, flat, samples) < rare);
      CHECK(chi_square<float>(static_cast<float>(g), flat, samples) < rare);
    }
}

TEST_CASE("the phase function is positive and finite up to its last value of g") {
  const auto holds = []<class T>(T most) {
    for (const bool flat : {false, true})
      for (const T g : {-most, T(-1e-9), T(0), T(1e-9), most}) {
        const PhaseFunction<T> phase{{0, 1, 0}, g, flat};
        for (const T u : {T(0), T(1e-7), T(0.5), 1 - std::numeric_limits<T>::epsilon()}) {
          const Vec3<T> direction = phase.sample({u, u});
          CHECK(length(direction) == Approx(1).epsilon(1e-6));
          CHECK(phase(direction) > 0);
          CHECK(std::isfinite(phase(direction)));
        }
        CHECK(std::isfinite(phase.value(1)));
        CHECK(std::isfinite(phase.value(-1)));
      }
  };
  holds(1 - std::numeric_limits<double>::epsilon());
  holds(1 - std::numeric_limits<float>::epsilon());
}
