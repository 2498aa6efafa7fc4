// Free paths in a medium: what is scattered on the way, and what gets through, are what Beer's law says in each
// channel.

#include <cmath>

#include "support/catch.h"
#include "support/effort.h"
#include "trace/drawn.h"
#include "trace/medium_walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// The mean of what is drawn, and of its square.
struct Mean {
  Rgbd sum{0}, squares{0};
  void add(const Rgbd& value) { sum += value, squares += value * value; }
  void check(const Rgbd& exact, int count) const {
    for (int c = 0; c < 3; ++c) {
      const double mean = sum[c] / count, error = std::sqrt((squares[c] / count - mean * mean) / count);
      CAPTURE(c, mean, error, exact[c]);
      CHECK(std::abs(mean - exact[c]) < 4.5 * error + 1e-12);
      CHECK(error < (rounds(8) == 8 ? 5e-3 : 1.5e-2));
    }
  }
};

template <class T>
void check_free_paths(const Rgbd& extinction, const Rgbd& scattering, const Rgbd& throughput, double distance) {
  typename World<T>::Medium medium;
  medium.extinction = Rgb<T>(extinction);
  Mean through, scattered;
  const int samples = rounds(1 << 20);
  for (int i = 0; i < samples; ++i) {
    RandomKey key{};
    key.seed = 3;
    key.sample = static_cast<std::uint32_t>(i);
    const Vec2<T> u = draw_pair<T>(Sampler::random, key, Strata(1));
    const FreePath<T> free(medium, {Rgb<T>(scattering)}, Rgb<T>(throughput), u.x, u.y);
    REQUIRE(free.length >= 0);
    const bool gets_there = free.length >= static_cast<T>(distance);
    through.add(gets_there ? Rgbd(free.transmittance(static_cast<T>(distance)) *
                                  free.weight_at_surface(static_cast<T>(distance)))
                           : Rgbd(0.0));
    scattered.add(gets_there ? Rgbd(0.0) : Rgbd(free.weight_where_scattered()));
  }
  Rgbd left, met;
  for (int c = 0; c < 3; ++c) {
    left[c] = std::exp(-extinction[c] * distance);
    met[c] = extinction[c] > 0 ? scattering[c] / extinction[c] * (1 - left[c]) : 0;
  }
  through.check(left, samples);
  scattered.check(met, samples);
}

}  // namespace

TEST_CASE("free paths bring what Beer's law says, whichever channel is walked", "[odds]") {
  const auto check = []<class T>(T) {
    check_free_paths<T>({1.5, 1.5, 1.5}, {1.2, 0.3, 1.5}, {1, 1, 1}, 0.7);
    check_free_paths<T>({0.5, 2, 3}, {0.4, 1, 3}, {0.4, 1, 0.7}, 0.7);
    check_free_paths<T>({0, 1, 2}, {0, 1, 0.5}, {1, 1, 0.5}, 0.4);    // red meets nothing
    check_free_paths<T>({1, 1, 1}, {0.9, 0.5, 0.2}, {0, 0, 0}, 0.5);  // nothing to bring: all channels alike
  };
  check(1.0);
  check(1.0F);
}

TEST_CASE("a channel that can bring nothing is not walked") {
  World<double>::Medium medium;
  medium.extinction = {1e-3, 5, 1e-3};
  for (double choice = 0; choice < 1; choice += 0.01) {
    const FreePath<double> free(medium, {medium.extinction}, Rgbd(0, 0.5, 0), choice, 0.5);
    CHECK(free.length == Approx(std::log(2) / 5));
    CHECK(free.weight_where_scattered().y == Approx(1));
  }
}
