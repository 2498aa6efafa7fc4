// Exact arithmetic on doubles against GMP's.
#include "math/expansion.h"

#include "check/rational.h"
#include "shape/numbers.h"
#include "support/catch.h"
#include "support/effort.h"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <utility>

using namespace raywalk;
using raywalk::test::Numbers;

TEST_CASE("sums and products of many terms are those of rationals, in sign and value") {
  Numbers next(11);
  int wrong = 0, longest = 0;
  for (int round = 0; round < test::rounds(4000); ++round) {
    std::array<Expansion, 5> exact;
    std::array<mpq_class, 5> truth;
    for (std::size_t i = 0; i + 1 < exact.size(); ++i) {  // the last one stays 0
      const double value = std::ldexp(next.real(), next.integer(-40, 40));
      exact[i] = value;
      truth[i] = value;
    }
    const auto any = [&] { return static_cast<std::size_t>(next.integer(0, 4)); };
    for (int step = 0; step < 9; ++step) {
      const std::size_t a = any(), b = any(), to = any();
      const int operation = next.integer(0, 2);
      const Expansion value = operation == 0   ? exact[a] + exact[b]
                              : operation == 1 ? exact[a] - exact[b]
                                               : exact[a] * exact[b];
      const mpq_class rational = operation == 0   ? mpq_class(truth[a] + truth[b])
                                 : operation == 1 ? mpq_class(truth[a] - truth[b])
                                                  : mpq_class(truth[a] * truth[b]);
      exact[to] = value;
      truth[to] = rational;
      const DoubleDouble rounded = value.rounded();
      const mpq_class error = abs(mpq_class(rational - mpq_class(rounded.hi) - mpq_class(rounded.lo)));
      wrong += value.sign() != sgn(rational) || error > abs(rational) * mpq_class(0x1p-98);
      longest = std::max(longest, static_cast<int>(mpz_sizeinbase(rational.get_num_mpz_t(), 2)));
    }
  }
  CHECK(wrong == 0);
  CHECK(longest > 700);  // bits: a dozen terms and more
}

TEST_CASE("a product of more terms than need no heap is exact") {
  // (1 + 2^-33)(1 + 2^-66)(1 + 2^-132)(1 + 2^-264)(1 + 2^-528): a bit in every 33 of 1023.
  Expansion product = 1.0;
  mpq_class truth = 1;
  for (int exponent = 33; exponent <= 528; exponent *= 2) {
    const double factor = std::ldexp(1.0, -exponent);
    product = product * (Expansion(1.0) + Expansion(factor));
    truth *= 1 + mpq_class(factor);
  }
  Expansion copy = product, moved = std::move(copy);
  for (int bit = 0; bit <= 31; ++bit) {
    const double least = std::ldexp(1.0, -33 * bit);
    moved = moved - Expansion(least);
    truth -= mpq_class(least);
    CHECK(moved.sign() == sgn(truth));
  }
  CHECK(moved.sign() == 0);
  copy = product;
  CHECK((copy - product).sign() == 0);
}
