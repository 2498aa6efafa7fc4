// The compiler must round where the program says so; the tracer's bits depend on it (see the flags in CMakeLists.txt).

#include "support/catch.h"

namespace {

struct Doubles {
  double x, y;
};

Doubles through_float(double x, double y) {
  struct {
    float x, y;
  } const rounded{static_cast<float>(x), static_cast<float>(y)};
  return {static_cast<double>(rounded.x), static_cast<double>(rounded.y)};
}

}  // namespace

TEST_CASE("a number that was rounded to float stays rounded", "[math]") {
  volatile double a = 0.1, b = 0.2;  // so that nothing is known of the numbers
  const Doubles rounded = through_float(a, b);
  CHECK(rounded.x == static_cast<double>(0.1F));
  CHECK(rounded.y == static_cast<double>(0.2F));
}
