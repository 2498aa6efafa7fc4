#include "math/expansion.h"

#include "shape/numbers.h"
#include "support/catch.h"

using namespace raywalk;
using raywalk::test::Numbers;

TEST_CASE("expansions keep every bit of sums and products") {
  // (1 + 2^-300) (1 - 2^-300) - 1 = -2^-600, and the same with larger terms about it.
  const Expansion one = 1.0, least = 0x1p-300, most = 0x1p300;
  CHECK(((one + least) * (one - least) - one + least * least).sign() == 0);
  CHECK(((one + least) * (one - least) - one).sign() == -1);
  CHECK((most + least - most).sign() == 1);
  CHECK((most + least - most - least).sign() == 0);
  CHECK(static_cast<double>((most + least - most).rounded()) == 0x1p-300);
  CHECK(Expansion(0.0).sign() == 0);
  CHECK(Expansion(-0.0).sign() == 0);
}

TEST_CASE("expansions obey the laws of arithmetic exactly, whatever cancels") {
  Numbers next(5);
  int not_small = 0;
  for (int i = 0; i < 500; ++i) {
    const auto number = [&] { return Expansion(std::ldexp(next.real(), next.integer(-60, 60))); };
    const Expansion a = number(), b = number(), c = number(), d = number();
    CHECK((a * (b + c) - a * b - a * c).sign() == 0);
    CHECK(((a + b) * (c + d) - a * c - a * d - b * c - b * d).sign() == 0);
    CHECK(((a - b) * (a + b) - a * a + b * b).sign() == 0);
    // The Lagrange identity, of degree four: (a c + b d)^2 + (a d - b c)^2 = (a^2 + b^2)(c^2 + d^2).
    const Expansion left = (a * c + b * d) * (a * c + b * d) + (a * d - b * c) * (a * d - b * c);
    CHECK((left - (a * a + b * b) * (c * c + d * d)).sign() == 0);
    const Expansion off = left - (a * a + b * b) * (c * c + d * d) + Expansion(0x1p-500);
    CHECK(off.sign() == 1);
    not_small += static_cast<double>(off.rounded()) != 0x1p-500;
  }
  CHECK(not_small == 0);
}
