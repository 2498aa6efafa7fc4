// The elementary functions: correctly rounded by MPFR's judgement, the special values of IEEE 754, and the same bits
// from every compiler on every processor.
#include "math/elementary.h"

#include "math/elementary/big_float.h"
#include "math/elementary_oracle.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "support/catch.h"

using namespace raywalk;
using oracle::Arguments;
using oracle::Function;

namespace {

template <class T>
void check_rounding(const Function& function, std::uint64_t first, std::uint64_t count, bool by_mpfr_alone) {
  int wrong = 0;
  for (std::uint64_t i = first; i < first + count && wrong < 5; ++i) {
    const auto at = oracle::arguments<T>(function, i);
    const T got = oracle::value(function, at);
    if (by_mpfr_alone ? oracle::same(got, oracle::exact(function, at)) : oracle::is_right(function, at, got)) continue;
    ++wrong;
    UNSCOPED_INFO(std::hexfloat << function.name << "(" << at.x << ", " << at.y << ") = " << got << ", not "
                                << oracle::exact(function, at));
  }
  CHECK(wrong == 0);
}

// Those of the arguments that a full count tries first, as a number that any other result would change.
template <class T>
std::uint64_t hash(const Function& function) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::uint64_t i = 1; i < 20'000; ++i) {
    const T value = oracle::value(function, oracle::arguments<T>(function, i));
    if (std::isnan(value)) continue;
    hash =
        (hash ^ std::bit_cast<std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>(value)) * 0x100000001b3;
  }
  return hash;
}

template <class T>
bool is_negative_zero(T x) {
  return x == 0 && std::signbit(x);
}
template <class T>
bool is_positive_zero(T x) {
  return x == 0 && !std::signbit(x);
}

}  // namespace

TEST_CASE("elementary functions are correctly rounded") {
  if (!oracle::has_mpfr()) RAYWALK_SKIP("the elementary functions were not judged: no MPFR (apt install libmpfr-dev)");
  for (const Function& function : oracle::functions()) {
    DYNAMIC_SECTION(function.name) {
      check_rounding<float>(function, 1, 10'000, true);
      check_rounding<double>(function, 1, 10'000, true);
      check_rounding<float>(function, 10'001, 200'000, false);
      check_rounding<double>(function, 10'001, 200'000, false);
    }
  }
}

// RAYWALK_ELEMENTARY="FIRST COUNT" chooses another share; `-c NAME` a function, as `sin double`.
TEST_CASE("elementary functions are correctly rounded, full count", "[.][full]") {
  REQUIRE(oracle::has_mpfr());
  std::uint64_t first = 1, count = 100'000'000;
  if (const char* share = std::getenv("RAYWALK_ELEMENTARY")) std::istringstream(share) >> first >> count;
  for (const Function& function : oracle::functions()) {
    DYNAMIC_SECTION(function.name << " float") { check_rounding<float>(function, first, count, false); }
    DYNAMIC_SECTION(function.name << " double") { check_rounding<double>(function, first, count, false); }
  }
}

// On 128 bits and on 960: what the first does not settle, the second does. No quick evaluation stands in between.
TEST_CASE("the last resort of the elementary functions has the precision that it claims") {
  const auto check = [](const auto& evaluate) {
    const BigFloat few = evaluate(6), many = evaluate(32).in_words(12);
    const BigFloat error = few.in_words(12) - many;
    const BigFloat bound = many.times_power_of_two(-32 * (6 - 2));
    INFO(many.nearest<double>() << " " << error.nearest<double>() << " " << bound.nearest<double>());
    CHECK(std::abs(error.nearest<double>()) <= std::abs(bound.nearest<double>()));
  };
  for (std::uint64_t i = 1; i <= 300; ++i) {
    const auto function = [](int kind) -> const Function& {
      return oracle::functions()[static_cast<std::size_t>(kind)];
    };
    const auto one = [&](int kind, auto big) {
      const auto at = oracle::arguments<double>(function(kind), i);
      const double result = oracle::value(function(kind), at);
      if (!std::isfinite(result) || std::abs(result) < 1e-300 || result == at.x) return;
      INFO(function(kind).name << " " << at.x << " " << at.y);
      check([&](int words) { return big(BigFloat(at.x, words), BigFloat(at.y, words)); });
    };
    one(0, [](const BigFloat& x, const BigFloat&) { return big::sin(x); });
    one(1, [](const BigFloat& x, const BigFloat&) { return big::cos(x); });
    one(2, [](const BigFloat& y, const BigFloat& x) { return big::atan2(y, x); });
    one(3, [](const BigFloat& x, const BigFloat&) { return big::exp(x); });
    one(4, [](const BigFloat& x, const BigFloat&) { return big::expm1(x); });
    one(5, [](const BigFloat& x, const BigFloat&) { return big::log1p(x); });
    one(6, [](const BigFloat& x, const BigFloat& y) { return big::exp(y * big::log(x)); });
  }
}

TEMPLATE_TEST_CASE("elementary functions have the special values of IEEE 754", "", float, double) {
  using T = TestType;
  constexpr T nan = std::numeric_limits<T>::quiet_NaN(), inf = std::numeric_limits<T>::infinity(), zero = 0, one = 1;
  constexpr T pi = std::numbers::pi_v<T>;

  CHECK(is_negative_zero(portable::sin(-zero)));
  CHECK(is_positive_zero(portable::sin(zero)));
  CHECK(portable::cos(-zero) == 1);
  for (const T x : {nan, inf, -inf}) {
    CHECK(std::isnan(portable::sin(x)));
    CHECK(std::isnan(portable::cos(x)));
    CHECK(std::isnan(portable::sin_cos(x).sin));
    CHECK(std::isnan(portable::sin_cos(x).cos));
  }

  CHECK(is_positive_zero(portable::atan2(zero, one)));
  CHECK(is_negative_zero(portable::atan2(-zero, one)));
  CHECK(is_positive_zero(portable::atan2(zero, zero)));
  CHECK(is_negative_zero(portable::atan2(-zero, zero)));
  CHECK(portable::atan2(zero, -zero) == pi);
  CHECK(portable::atan2(-zero, -zero) == -pi);
  CHECK(portable::atan2(-zero, -one) == -pi);
  CHECK(portable::atan2(one, zero) == pi / 2);
  CHECK(portable::atan2(-one, -zero) == -pi / 2);
  CHECK(portable::atan2(inf, inf) == pi / 4);
  CHECK(portable::atan2(-inf, -inf) == -static_cast<T>(3 * std::numbers::pi_v<long double> / 4));
  CHECK(is_negative_zero(portable::atan2(-one, inf)));
  CHECK(portable::atan2(one, -inf) == pi);
  CHECK(portable::atan2(-inf, one) == -pi / 2);
  CHECK(std::isnan(portable::atan2(nan, one)));
  CHECK(std::isnan(portable::atan2(one, nan)));

  CHECK(portable::exp(-zero) == 1);
  CHECK(portable::exp(inf) == inf);
  CHECK(is_positive_zero(portable::exp(-inf)));
  CHECK(portable::exp(T(1000)) == inf);
  CHECK(is_positive_zero(portable::exp(T(-1000))));
  CHECK(std::isnan(portable::exp(nan)));
  CHECK(is_negative_zero(portable::expm1(-zero)));
  CHECK(portable::expm1(inf) == inf);
  CHECK(portable::expm1(-inf) == -1);
  CHECK(std::isnan(portable::expm1(nan)));

  CHECK(is_negative_zero(portable::log1p(-zero)));
  CHECK(portable::log1p(-one) == -inf);
  CHECK(portable::log1p(inf) == inf);
  CHECK(std::isnan(portable::log1p(T(-2))));
  CHECK(std::isnan(portable::log1p(nan)));

  for (const T x : {zero, -zero, one, inf, -inf, nan}) {
    CHECK(portable::pow(x, zero) == 1);
    CHECK(portable::pow(one, x) == 1);
  }
  CHECK(portable::pow(-one, inf) == 1);
  CHECK(is_negative_zero(portable::pow(-zero, T(3))));
  CHECK(is_positive_zero(portable::pow(-zero, T(2))));
  CHECK(portable::pow(-zero, T(-3)) == -inf);
  CHECK(portable::pow(-zero, T(-2.5)) == inf);
  CHECK(portable::pow(-inf, T(3)) == -inf);
  CHECK(is_negative_zero(portable::pow(-inf, T(-3))));
  CHECK(portable::pow(T(0.5), -inf) == inf);
  CHECK(is_positive_zero(portable::pow(T(0.5), inf)));
  CHECK(portable::pow(T(-2), T(3)) == -8);
  CHECK(portable::pow(T(-2), T(4)) == 16);
  CHECK(std::isnan(portable::pow(T(-2), T(0.5))));
  CHECK(std::isnan(portable::pow(nan, one)));
  CHECK(std::isnan(portable::pow(T(2), nan)));
  CHECK(portable::pow(T(2), T(-1)) == T(0.5));
  // Half of the least subnormal lies in the middle: to even.
  const int least = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
  CHECK(portable::pow(T(2), static_cast<T>(least)) == std::numeric_limits<T>::denorm_min());
  CHECK(portable::pow(T(2), static_cast<T>(least - 1)) == 0);
  CHECK(portable::pow(T(4), static_cast<T>(least + 1) / 2) == 2 * std::numeric_limits<T>::denorm_min());
}

TEMPLATE_TEST_CASE("elementary functions keep their symmetries", "", float, double) {
  using T = TestType;
  const Function& function = oracle::functions()[2];
  for (std::uint64_t i = 1; i < 20'000; ++i) {
    const auto [y, x] = oracle::arguments<T>(function, i);
    INFO(x << " " << y);
    REQUIRE(portable::sin(-y) == -portable::sin(y));
    REQUIRE(portable::cos(-y) == portable::cos(y));
    REQUIRE(portable::sin_cos(y).sin == portable::sin(y));
    REQUIRE(portable::sin_cos(y).cos == portable::cos(y));
    REQUIRE(portable::atan2(-y, x) == -portable::atan2(y, x));
  }
}

TEST_CASE("elementary functions give the same bits everywhere") {
  struct Expected {
    std::string name;
    std::uint64_t in_float, in_double;
  };
  for (const Expected& expected : std::vector<Expected>{{"sin", 0x8c387bc0d772ce54, 0xff44b17f1f7fdd9d},
                                                        {"cos", 0x4e28a0b32eb60dfe, 0x4a25b1c851d85638},
                                                        {"atan2", 0xf190cb3b820ac79d, 0x93987d4314b3dff4},
                                                        {"exp", 0x05250cf8e31e4e4f, 0xfff78c3048bc9c53},
                                                        {"expm1", 0xef3be1eec926b9da, 0xd82cbfdeb97f655a},
                                                        {"log1p", 0xfd214658d8c5393e, 0xe108c7001012e3cc},
                                                        {"pow", 0xebc3f8c568057aee, 0xcd3240c88bba7203}}) {
    for (const Function& function : oracle::functions()) {
      if (function.name != expected.name) continue;
      INFO(function.name);
      CHECK(hash<float>(function) == expected.in_float);
      CHECK(hash<double>(function) == expected.in_double);
    }
  }
}
