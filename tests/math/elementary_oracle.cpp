#include "math/elementary_oracle.h"

#include "math/elementary.h"

#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#ifdef RAYWALK_MPFR
#include <mpfr.h>
#endif

namespace raywalk::oracle {
namespace {

enum Kind { of_sin, of_cos, of_atan2, of_exp, of_expm1, of_log1p, of_pow };

#define RAYWALK_ORACLE(function, extended, ...)                                                                 \
  Function {                                                                                                    \
    #function, [](float x, [[maybe_unused]] float y) { return portable::function(__VA_ARGS__); },               \
        [](double x, [[maybe_unused]] double y) { return portable::function(__VA_ARGS__); },                    \
        [](long double x, [[maybe_unused]] long double y) { return std::extended(__VA_ARGS__); }, of_##function \
  }

// A stream of random numbers for each argument, so that a count can be cut into chunks anywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x632be59bd9b4e019u) {}
  std::uint64_t bits() {  // S. Vigna's splitmix64
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  int below(int n) { return static_cast<int>((bits() >> 32) * static_cast<std::uint64_t>(n) >> 32); }
  double real(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  // Of either sign, in binades from 2^low up to 2^high.
  double binade(int low, int high) {
    const double mantissa = 1 + static_cast<double>(bits() >> 12) * 0x1p-52;
    const double size = std::ldexp(mantissa, low + below(high - low));
    return (bits() & 1) != 0 ? size : -size;
  }

 private:
  std::uint64_t state_;
};

// Up to three floats beside `v`.
template <class T>
T near(Random& random, double v) {
  T value = static_cast<T>(v);
  for (int i = random.below(4); i > 0; --i)
    value = std::nextafter(
        value, (random.bits() & 1) != 0 ? std::numeric_limits<T>::infinity() : -std::numeric_limits<T>::infinity());
  return value;
}

// Near the powers that are exact or lie in the middle between two floats.
template <class T>
Arguments<T> near_short_power(Random& random) {
  const int root = random.below(4), power = 1 + random.below(6);
  double x = 1 + random.below(1 << 12);
  for (int i = 0; i < root; ++i) x *= x;
  const double y = std::ldexp(power, -root);
  return random.below(4) == 0 ? Arguments<T>{near<T>(random, x), static_cast<T>(y)}
                              : Arguments<T>{static_cast<T>(std::ldexp(x, random.below(64) - 32)), static_cast<T>(y)};
}

}  // namespace

const std::vector<Function>& functions() {
  static const std::vector<Function> all{RAYWALK_ORACLE(sin, sin, x),        RAYWALK_ORACLE(cos, cos, x),
                                         RAYWALK_ORACLE(atan2, atan2, x, y), RAYWALK_ORACLE(exp, exp, x),
                                         RAYWALK_ORACLE(expm1, expm1, x),    RAYWALK_ORACLE(log1p, log1p, x),
                                         RAYWALK_ORACLE(pow, pow, x, y)};
  return all;
}

template <class T>
bool same(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}
template bool same(float, float);
template bool same(double, double);

template <class T>
Arguments<T> arguments(const Function& function, std::uint64_t i) {
  using Limits = std::numeric_limits<T>;
  constexpr double pi = std::numbers::pi;
  constexpr int lowest = Limits::min_exponent - Limits::digits, highest = Limits::max_exponent;
  Random random(i);
  const auto one = [](double x) { return Arguments<T>{static_cast<T>(x), 0}; };
  const auto two = [](double x, double y) { return Arguments<T>{static_cast<T>(x), static_cast<T>(y)}; };
  const auto binades = [&](int low, int high) {
    const double x = random.binade(low, high), y = random.binade(low, high);
    return two(x, y);
  };
  // Anything at all, seldom: much of it is decided before any arithmetic, and huge angles are slow.
  if (i % 4096 == 0) return binades(lowest, highest);
  const int stratum = random.below(4);
  switch (static_cast<Kind>(function.mpfr)) {
    case of_sin:
    case of_cos:
      if (stratum == 0) return one(random.binade(-30, 15));
      if (stratum == 1 && random.below(8) == 0)
        return {near<T>(random, random.below(1 << random.below(14)) * (pi / 2)), 0};
      if (stratum == 2) return {near<T>(random, random.below(4096) * (pi / 2048)), 0};
      return one(random.real(-4, 4));
    case of_atan2: {
      const double x = random.real(-1, 1);
      if (stratum == 0) return binades(-60, 60);
      if (stratum == 1) return {near<T>(random, x * random.below(513) / 256), static_cast<T>(x)};
      if (stratum == 2) return two(random.binade(-10, 0), x);
      return two(random.real(-1, 1), x);
    }
    case of_exp:
    case of_expm1:
      if (stratum == 0) return one(random.binade(-62, 7));
      if (stratum == 1) return {near<T>(random, (random.below(4096) - 2048) * (std::numbers::ln2 / 256)), 0};
      if (stratum == 2) return one(random.real(Limits::digits == 24 ? -110 : -750, Limits::digits == 24 ? 90 : 711));
      return one(random.real(-10, 10));
    case of_log1p:
      if (stratum == 0) return one(random.binade(-62, 0));
      if (stratum == 1) return one(std::abs(random.binade(-62, 120)));
      if (stratum == 2) return one(std::abs(random.binade(-Limits::digits, 0)) - 1);
      return one(-random.real(0, 1));
    case of_pow: {
      const double x = stratum == 0 ? std::abs(random.binade(-126, 127)) : random.real(0, 1);
      if (stratum <= 1)
        return two(x, random.real(Limits::min_exponent - 60, highest + 2) * std::numbers::ln2 / portable::log1p(x - 1));
      if (stratum == 3) return two(x, random.real(0, 100));
      if (random.below(4) == 0) return near_short_power<T>(random);
      if (random.below(2) == 0) {
        const double near_1 = 1 + random.binade(-Limits::digits, -5);
        return two(near_1, random.binade(0, Limits::digits));
      }
      constexpr double usual[] = {2.4, 1 / 2.4, 1.0 / 3, 2.2, 0.5, 1.5, 0.1};
      return two(2 * x, usual[random.below(7)]);
    }
  }
  return {};
}
template Arguments<float> arguments(const Function&, std::uint64_t);
template Arguments<double> arguments(const Function&, std::uint64_t);

#ifdef RAYWALK_MPFR

bool has_mpfr() { return true; }

template <class T>
T exact(const Function& function, const Arguments<T>& at) {
  struct Number {
    mpfr_t v;
    Number() { mpfr_init2(v, std::numeric_limits<T>::digits); }
    ~Number() { mpfr_clear(v); }
    Number(const Number&) = delete;
    Number& operator=(const Number&) = delete;
  };
  thread_local Number x, y, result;
  // MPFR's mantissas are in 1/2..1, and its exponents need to be bounded for subnormal results.
  mpfr_set_emin(std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits + 1);
  mpfr_set_emax(std::numeric_limits<T>::max_exponent);
  mpfr_set_d(x.v, at.x, MPFR_RNDN);
  mpfr_set_d(y.v, at.y, MPFR_RNDN);
  const auto evaluate = [&] {
    switch (static_cast<Kind>(function.mpfr)) {
      case of_sin:
        return mpfr_sin(result.v, x.v, MPFR_RNDN);
      case of_cos:
        return mpfr_cos(result.v, x.v, MPFR_RNDN);
      case of_atan2:
        return mpfr_atan2(result.v, x.v, y.v, MPFR_RNDN);
      case of_exp:
        return mpfr_exp(result.v, x.v, MPFR_RNDN);
      case of_expm1:
        return mpfr_expm1(result.v, x.v, MPFR_RNDN);
      case of_log1p:
        return mpfr_log1p(result.v, x.v, MPFR_RNDN);
      case of_pow:
        return mpfr_pow(result.v, x.v, y.v, MPFR_RNDN);
    }
    return 0;
  };
  const int above = evaluate();
  mpfr_subnormalize(result.v, above, MPFR_RNDN);
  return static_cast<T>(mpfr_get_d(result.v, MPFR_RNDN));
}

template <class T>
bool is_right(const Function& function, const Arguments<T>& at, T value) {
  if constexpr (LDBL_MANT_DIG >= 64) {
    const long double close = function.extended(at.x, at.y);
    const long double error = std::isinf(close) ? 0 : std::abs(close) * 0x1p-61L;
    const T low = static_cast<T>(close - error), high = static_cast<T>(close + error);
    if (low == high && same(low, value)) return true;
  }
  return same(value, exact(function, at));
}

#else

bool has_mpfr() { return false; }
template <class T>
T exact(const Function&, const Arguments<T>&) {
  return std::numeric_limits<T>::quiet_NaN();
}
template <class T>
bool is_right(const Function&, const Arguments<T>&, T) {
  return false;
}

#endif

template float exact(const Function&, const Arguments<float>&);
template double exact(const Function&, const Arguments<double>&);
template bool is_right(const Function&, const Arguments<float>&, float);
template bool is_right(const Function&, const Arguments<double>&, double);

}  // namespace raywalk::oracle
