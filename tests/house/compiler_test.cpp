// What the design's exact tests take for granted of the compiler and the flags that CMakeLists.txt gives it: every
// operation is rounded once, to its own type. One inlined copy of a function then gives the same bits as another.
#include <cmath>
#include <limits>

#include "support/catch.h"

namespace {

// Not inlined, and of values unknown until it runs, so that the compiler has to write what the processor does.
[[gnu::noinline]] void through_float(const double* in, double* out) {
  const float x = static_cast<float>(in[0]), y = static_cast<float>(in[1]);
  out[0] = static_cast<double>(x);
  out[1] = static_cast<double>(y);
}

[[gnu::noinline]] double product_less(double a, double b, double c) { return a * b - c; }

[[gnu::noinline]] double scaled_less(double x, double scale) {
  const double scaled = x * scale;
  return scaled / scale - x;
}

}  // namespace

TEST_CASE("a float has a float's digits, also when it is used as a double at once") {
  const volatile double tenth = 0.1;
  const double in[2] = {tenth, 3 * tenth};
  double out[2];
  through_float(in, out);
  CHECK(out[0] == 0x1.99999ap-4);
  CHECK(out[1] == 0x1.333334p-2);
}

TEST_CASE("a product is rounded before it is added to") {
  // (1 + e)(1 - e) = 1 - e^2 rounds to 1; a fused multiply-add would keep the -e^2.
  const volatile double e = std::numeric_limits<double>::epsilon();
  CHECK(product_less(1 + e, 1 - e, 1) == 0);
}

TEST_CASE("arithmetic is not rearranged, and what is not finite stays so") {
  const volatile double third = 1.0 / 3, largest = std::numeric_limits<double>::max();
  CHECK(std::isinf(scaled_less(largest, 2 + third)));
  CHECK(std::isnan(product_less(largest, 2, std::numeric_limits<double>::infinity())));
}
