#include "math/double_double.h"

#include <cmath>
#include <cstdint>
#include <random>

#include "support/catch.h"

using namespace raywalk;

// The oracle: IEEE quadruple precision, 113 bits, which both compilers offer on x86-64.
__extension__ using Quad = __float128;
__extension__ using Wide = __int128;

namespace {

Quad quad(const DoubleDouble& x) { return static_cast<Quad>(x.hi) + static_cast<Quad>(x.lo); }

double relative_error(const DoubleDouble& got, Quad expected) {
  const Quad error = quad(got) - expected;
  const Quad ratio = expected == 0 ? error : error / expected;
  return std::abs(static_cast<double>(ratio));
}

// Doubles of all signs over many binades.
class Numbers {
 public:
  double operator()() {
    const double mantissa = std::uniform_real_distribution<>(-1, 1)(engine_);
    return std::ldexp(mantissa, std::uniform_int_distribution<>(-60, 60)(engine_));
  }

 private:
  std::mt19937_64 engine_{20240607};
};

constexpr double eps = 0x1p-104;

bool is_normal_form(const DoubleDouble& x) { return x.hi + x.lo == x.hi; }

}  // namespace

TEST_CASE("sums and products of two doubles are exact") {
  Numbers next;
  for (int i = 0; i < 100000; ++i) {
    const double a = next(), b = next();
    const DoubleDouble product = two_product(a, b), sum = two_sum(a, b);
    if (quad(product) != static_cast<Quad>(a) * static_cast<Quad>(b)) FAIL(a << " * " << b);
    if (sum.hi != a + b || !is_normal_form(sum)) FAIL(a << " + " << b);
    // Quad holds the sum exactly when the exponents are close enough.
    if (std::abs(std::ilogb(a) - std::ilogb(b)) < 50 && quad(sum) != static_cast<Quad>(a) + static_cast<Quad>(b))
      FAIL(a << " + " << b);
  }
}

TEST_CASE("two_sum keeps what a double would lose") {
  const DoubleDouble sum = two_sum(1e16, 1.0);
  CHECK(sum.hi == 1e16);
  CHECK(sum.lo == 1.0);
  const DoubleDouble cancelled = two_sum(0.1, -0.1);
  CHECK(cancelled.hi == 0);
  CHECK(cancelled.lo == 0);
}

TEST_CASE("arithmetic in double-double keeps about 104 bits") {
  Numbers next;
  double worst_sum = 0, worst_product = 0, worst_quotient = 0, worst_root = 0;
  for (int i = 0; i < 100000; ++i) {
    const DoubleDouble x = two_sum(next(), next() * 0x1p-60), y = two_sum(next(), next() * 0x1p-60);
    // The sum's error is measured against the larger part: what cancels is gone.
    const Quad sum = quad(x) + quad(y);
    const double size = std::fmax(std::abs(x.hi), std::abs(y.hi));
    worst_sum = std::fmax(worst_sum, std::abs(static_cast<double>(quad(x + y) - sum)) / size);
    worst_product = std::fmax(worst_product, relative_error(x * y, quad(x) * quad(y)));
    worst_quotient = std::fmax(worst_quotient, relative_error(x / y, quad(x) / quad(y)));
    const DoubleDouble square = x * x;
    worst_root = std::fmax(worst_root, relative_error(sqrt(square), x.hi < 0 ? -quad(x) : quad(x)));
    if (!is_normal_form(x + y) || !is_normal_form(x * y) || !is_normal_form(x / y) || !is_normal_form(sqrt(square)))
      FAIL("not in normal form at " << i);
  }
  CHECK(worst_sum <= eps);
  CHECK(worst_product <= 4 * eps);
  CHECK(worst_quotient <= 16 * eps);
  CHECK(worst_root <= 16 * eps);
}

TEST_CASE("integers up to 106 bits come out exactly") {
  std::mt19937_64 engine(5);
  std::uniform_int_distribution<std::int64_t> digits(-(std::int64_t{1} << 52), std::int64_t{1} << 52);
  for (int i = 0; i < 100000; ++i) {
    const std::int64_t a = digits(engine) >> 2, b = digits(engine) >> 2, c = digits(engine) >> 2,
                       d = digits(engine) >> 2;
    const DoubleDouble got = two_product(static_cast<double>(a), static_cast<double>(b)) -
                             two_product(static_cast<double>(c), static_cast<double>(d));
    const Wide expected = static_cast<Wide>(a) * b - static_cast<Wide>(c) * d;
    if (static_cast<Wide>(got.hi) + static_cast<Wide>(got.lo) != expected) FAIL("at " << i);
  }
}

TEST_CASE("roots of squares and of zero") {
  CHECK(static_cast<double>(sqrt(DoubleDouble(49.0))) == 7);
  CHECK(static_cast<double>(sqrt(DoubleDouble(0.0))) == 0);
  CHECK(static_cast<double>(DoubleDouble(1.0) / DoubleDouble(4.0)) == 0.25);
  CHECK(static_cast<double>(-two_sum(3, 0x1p-60)) == -3);
}
