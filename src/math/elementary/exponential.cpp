// Exponential function, logarithm and powers.
//
// e^x = 2^k T (1 + (e^r - 1)), where T = 2^(i / 128), from a table, and |r| < 2^-8.5. Of e^r - 1, r and r^2 / 2 are
// right up to 2^-79 and what follows, below 2^-28, is computed in one double: errors below 2^-77.
//
// log(x) = e log 2 + log(256 / n) + log(1 + r), where x = 2^e m, n is the whole number nearest to 256 / m, its
// logarithm from a table, and |r| = |m n / 256 - 1| < 2^-8.5. Errors below 2^-77, and below 2^-69 of the result.
#include "math/elementary.h"

#include "math/elementary/steps.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace raywalk::portable {
namespace {

// ---------------------------------------------------------------------------------------------------------------------
// The exponential function

constexpr int roots = 128;
constexpr double roots_per_unit = 0x1.71547652b82fep+7;  // 128 / log 2
// log 2 / 128 in parts of 35 and 53 bits: up to 2^18 times the first is exact.
constexpr double root_1 = 0x1.62e42fef8p-8, root_2 = 0x1.1cf79abc9e3b4p-43;

/// 2^(i / 128)
constexpr auto powers = [] {
  constexpr DoubleDouble root{0x1.0163da9fb3335p+0, 0x1.b61299ab8cdb7p-54};
  std::array<Parts, roots> table{};
  DoubleDouble power(1);
  for (Parts& entry : table) {
    entry = parts(power);
    power = power * root;
  }
  return table;
}();

/// 2^twos power (1 + less_1)
struct Exponential {
  int twos;
  Parts power, less_1;

  /// The product without 2^twos: from 0.99 to 2, right up to 2^-76.
  [[nodiscard]] DoubleDouble scaled() const {
    const DoubleDouble sum = ordered_sum(power.head, power.head * less_1.head);
    return {sum.hi, sum.lo + (power.head * less_1.tail + (power.tail + power.tail * less_1.value()))};
  }
};

/// e^(x + x_low), |x| < 1100, |x_low| at most half of x's last bit.
[[nodiscard]] inline Exponential exp_of(double x, double x_low) {
  const double steps = nearest_whole(x * roots_per_unit);
  const auto step = static_cast<std::int32_t>(steps);
  const DoubleDouble rest = two_sum(x - steps * root_1, -(steps * root_2));
  const Parts split = parts(rest.hi, rest.lo + x_low);
  const double r = split.value();
  const double tail = r * r * r * polynomial(r, {1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040});
  const DoubleDouble sum = ordered_sum(split.head, split.head * split.head / 2);
  return {step >> 7, powers[static_cast<std::size_t>(step & (roots - 1))],
          parts(sum.hi, sum.lo + (split.tail + (split.tail * (r + split.head) / 2 + tail)))};
}

/// e^x in one double, right up to 2^-50 of it; |x| < 700.
[[nodiscard]] inline double quick_exp(double x) {
  const double steps = nearest_whole(x * roots_per_unit);
  const auto step = static_cast<std::int32_t>(steps);
  const double power = powers[static_cast<std::size_t>(step & (roots - 1))].value();
  const double r = x - steps * root_1 - steps * root_2;
  const double less_1 = r + r * r * polynomial(r, {1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120});
  return (power + power * less_1) * power_of_two(step >> 7);
}

// ---------------------------------------------------------------------------------------------------------------------
// The logarithm

constexpr int first_inverse = 181, last_inverse = 363;  // 256 / sqrt(2) and 256 sqrt(2)
// log 2 in parts of 42 and 53 bits: up to 2^11 times the first is exact.
constexpr double log_2_high = 0x1.62e42fefa38p-1, log_2_low = 0x1.ef35793c7673p-45;

/// log(256 / n): from n to n + 1 it falls by 2 artanh(1 / (2 n + 1)).
constexpr auto logarithms = [] {
  std::array<Parts, last_inverse - first_inverse + 1> table{};
  const auto step = [](int n) { return arc_series(DoubleDouble(1) / (2 * n + 1), 1) * 2; };
  DoubleDouble log(0);
  for (int n = 256; n >= first_inverse; --n) {
    table[static_cast<std::size_t>(n - first_inverse)] = parts(log);
    log = log + step(n - 1);
  }
  log = 0;
  for (int n = 256; n <= last_inverse; ++n) {
    table[static_cast<std::size_t>(n - first_inverse)] = parts(log);
    log = log - step(n);
  }
  return table;
}();

/// x = 2^twos m, and the place of m in the table.
struct Mantissa {
  int twos;
  double m, inverse;
  [[nodiscard]] const Parts& log() const { return logarithms[static_cast<std::size_t>(inverse) - first_inverse]; }
};
/// Of a normal x > 0: m from sqrt(1/2) to sqrt(2).
[[nodiscard]] inline Mantissa mantissa_of(double x) {
  constexpr auto root_half = std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp-1);
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto twos = static_cast<std::int64_t>(bits - root_half) >> 52;
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(twos) << 52));
  return {static_cast<int>(twos), m, nearest_whole(256 / m)};
}

/// base + log(1 + r), |r| < 2^-8.5 and, unless it is 0, |base| > |r|.
[[nodiscard]] inline DoubleDouble log_from(double base, double base_low, const DoubleDouble& rest) {
  const Parts split = parts(rest.hi, rest.lo);
  const double r = split.value();
  const double tail = r * r * r * polynomial(r, {1.0 / 3, -1.0 / 4, 1.0 / 5, -1.0 / 6, 1.0 / 7, -1.0 / 8});
  const DoubleDouble sum = ordered_sum(base, split.head);
  const DoubleDouble log = ordered_sum(sum.hi, -(split.head * split.head / 2));
  return ordered_sum(log.hi, log.lo + (sum.lo + (split.tail - split.tail * (r + split.head) / 2 + base_low + tail)));
}
/// log(x + x_low), x > 0 and normal, |x_low| at most half of x's last bit.
[[nodiscard]] inline DoubleDouble log_of(double x, double x_low) {
  const Mantissa at = mantissa_of(x);
  const double head = head_of(at.m);
  const DoubleDouble rest = two_sum(head * at.inverse - 256, (at.m - head) * at.inverse);
  const double low = x_low == 0 ? 0 : x_low * power_of_two(-at.twos) * at.inverse;
  const Parts& log = at.log();
  return log_from(at.twos * log_2_high + log.head, at.twos * log_2_low + log.tail,
                  {rest.hi / 256, (rest.lo + low) / 256});
}
/// A bound on the error of both.
[[nodiscard]] inline double log_error(double log) { return std::min(std::abs(log), 0x1p-8) * 0x1p-67; }

/// base + log(1 + r) in one double, up to 2^-50 of it.
[[nodiscard]] inline double quick_log_from(double base, double base_low, double r) {
  return base + (r + r * r * polynomial(r, {-1.0 / 2, 1.0 / 3, -1.0 / 4, 1.0 / 5, -1.0 / 6}) + base_low);
}
[[nodiscard]] inline double quick_log(double x) {
  const Mantissa at = mantissa_of(x);
  const Parts& log = at.log();
  return quick_log_from(at.twos * log_2_high + log.head, at.twos * log_2_low + log.tail, at.m * at.inverse / 256 - 1);
}

// ---------------------------------------------------------------------------------------------------------------------
// The last resort

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T slow_exp(T x) {
  return correctly_rounded<T>([=](int words) { return big::exp(BigFloat(x, words)); });
}
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T slow_expm1(T x) {
  return correctly_rounded<T>([=](int words) { return big::expm1(BigFloat(x, words)); });
}
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T slow_log1p(T x) {
  return correctly_rounded<T>([=](int words) { return big::log1p(BigFloat(x, words)); });
}

/// x^y, if it has at most 64 bits; x > 0. Only such powers can lie in the middle between two doubles: every other is
/// irrational, or its last bit is too far from its first.
[[nodiscard]] std::optional<BigFloat> short_power(double x, double y) {
  // odd mantissa * 2^exponent
  const auto parts_of = [](double v) {
    int exponent = 0;
    auto mantissa = static_cast<std::uint64_t>(std::frexp(v, &exponent) * 0x1p53);
    const int zeros = std::countr_zero(mantissa);
    return std::pair(mantissa >> zeros, exponent - 53 + zeros);
  };
  auto [mantissa, exponent] = parts_of(x);
  auto [times, twos] = parts_of(std::abs(y));
  // y = times * 2^twos: as many square roots as it has binary places.
  for (; twos < 0; ++twos) {
    const auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(mantissa)));
    if (root * root != mantissa || exponent % 2 != 0) return std::nullopt;
    mantissa = root;
    exponent /= 2;
  }
  const double whole = std::ldexp(static_cast<double>(times), twos);
  if (mantissa != 1 && (y < 0 || whole > 64)) return std::nullopt;
  const auto twos_of_power = static_cast<std::int64_t>(exponent * (y < 0 ? -whole : whole));
  std::uint64_t product = 1;
  for (double i = 0; i < whole && mantissa != 1; ++i) {
    if (product > std::numeric_limits<std::uint64_t>::max() / mantissa) return std::nullopt;
    product *= mantissa;
  }
  return BigFloat(product, twos_of_power, 8);
}

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T slow_pow(T x, T y) {
  if (const auto exact = short_power(x, y)) return exact->template nearest<T>();
  return correctly_rounded<T>([=](int words) { return big::exp(BigFloat(y, words) * big::log(BigFloat(x, words))); });
}

// ---------------------------------------------------------------------------------------------------------------------
// Powers, and where functions end

/// Whether e^exponent is far enough beyond the largest T, or below the least, to be infinite, or 0.
template <class T>
[[nodiscard]] constexpr bool overflows(double exponent) {
  return exponent > (std::numeric_limits<T>::digits == 24 ? 89 : 710);
}
template <class T>
[[nodiscard]] constexpr bool underflows(double exponent) {
  return exponent < (std::numeric_limits<T>::digits == 24 ? -104 : -746);
}
/// Whether e^exponent, and the tail of its parts, are normal doubles: elsewhere it is evaluated slowly.
[[nodiscard]] constexpr bool is_ample(double exponent) { return exponent > -630 && exponent < 709; }
/// So close to 0, e^x - 1 and log(1 + x) are x.
constexpr double tiny = 0x1p-60;
/// Up to here both need no table.
constexpr double small = 0x1p-9;

/// x > 0, both finite.
[[nodiscard]] inline float positive_pow(float x, float y) {
  const double exponent = y * quick_log(x);
  if (overflows<float>(exponent)) return std::numeric_limits<float>::infinity();
  if (underflows<float>(exponent)) return 0;
  const double value = quick_exp(exponent);
  return round_or(value, value * (1 + std::abs(exponent)) * 0x1p-49, [=] { return slow_pow(x, y); });
}
[[nodiscard]] inline double positive_pow(double x, double y) {
  constexpr double least_normal = std::numeric_limits<double>::min();
  const DoubleDouble log = x < least_normal ? DoubleDouble(quick_log(x * 0x1p54) - 54 * log_2_high) : log_of(x, 0);
  const Parts y_parts = parts(y), log_parts = parts(log);
  const DoubleDouble exponent =
      ordered_sum(y_parts.head * log_parts.head, y_parts.tail * log_parts.head + y * log_parts.tail);
  if (overflows<double>(exponent.hi)) return std::numeric_limits<double>::infinity();
  if (underflows<double>(exponent.hi)) return 0;
  if (!is_ample(exponent.hi) || x < least_normal) return slow_pow(x, y);
  const Exponential power = exp_of(exponent.hi, exponent.lo);
  const DoubleDouble scaled = power.scaled();
  const double scale = power_of_two(power.twos);
  const double error = 0x1p-75 + 3 * (std::abs(y) * log_error(log.hi) + std::abs(exponent.hi) * 0x1p-77);
  return round_or(scaled.hi * scale, scaled.lo * scale, error * scale, [=] { return slow_pow(x, y); });
}

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T special_pow(T x, T y) {
  using Limits = std::numeric_limits<T>;
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return Limits::quiet_NaN();
  const T size = std::abs(x);
  if (std::isinf(y)) return size == 1 ? T(1) : (size > 1) == (y > 0) ? Limits::infinity() : T(0);
  const bool whole = std::trunc(y) == y, odd = whole && std::fmod(y, T(2)) != 0;
  T power;
  if (size == 0 || std::isinf(size)) {
    power = (size == 0) == (y > 0) ? T(0) : Limits::infinity();
  } else {
    if (x < 0 && !whole) return Limits::quiet_NaN();
    power = size == 1 ? T(1) : positive_pow(size, y);
  }
  return odd ? std::copysign(power, x) : power;
}

template <class T>
[[nodiscard]] T any_pow(T x, T y) {
  using Limits = std::numeric_limits<T>;
  if (x >= Limits::min() && x <= Limits::max() && std::abs(y) <= Limits::max()) return positive_pow(x, y);
  return special_pow(x, y);
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------------------
// The functions

float exp(float x) {
  if (std::isnan(x)) return x;
  if (overflows<float>(x)) return std::numeric_limits<float>::infinity();
  if (underflows<float>(x)) return 0;
  const double value = quick_exp(static_cast<double>(x));
  return round_or(value, value * 0x1p-49, [=] { return slow_exp(x); });
}

double exp(double x) {
  if (!is_ample(x)) {
    if (std::isnan(x)) return x;
    if (overflows<double>(x)) return std::numeric_limits<double>::infinity();
    return underflows<double>(x) ? 0 : slow_exp(x);
  }
  const Exponential power = exp_of(x, 0);
  const DoubleDouble scaled = power.scaled();
  const double scale = power_of_two(power.twos);
  return round_or(scaled.hi * scale, scaled.lo * scale, scale * 0x1p-75, [=] { return slow_exp(x); });
}

float expm1(float x) {
  if (std::isnan(x) || std::abs(x) < tiny) return x;
  if (overflows<float>(x)) return std::numeric_limits<float>::infinity();
  if (x < -40) return -1;
  const double r = x;
  if (std::abs(x) < small) {
    const double value = r + r * r * polynomial(r, {1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120});
    return round_or(value, std::abs(value) * 0x1p-49, [=] { return slow_expm1(x); });
  }
  const double power = quick_exp(r);
  return round_or(power - 1, power * 0x1p-49, [=] { return slow_expm1(x); });
}

double expm1(double x) {
  if (std::isnan(x) || std::abs(x) < tiny) return x;
  if (x < -40) return -1;
  if (x >= 709) return overflows<double>(x) ? std::numeric_limits<double>::infinity() : slow_expm1(x);
  const Exponential power = exp_of(x, 0);
  const auto slow = [=] { return slow_expm1(x); };
  if (std::abs(x) < small)
    return round_or(power.less_1.head, power.less_1.tail, std::abs(power.less_1.head) * 0x1p-69, slow);
  const DoubleDouble scaled = power.scaled();
  const double scale = power_of_two(power.twos);
  const DoubleDouble less_1 = two_sum(scaled.hi * scale, -1);
  return round_or(less_1.hi, less_1.lo + scaled.lo * scale, scale * 0x1p-75 + 0x1p-106, slow);
}

float log1p(float x) {
  if (!(x > -1)) return x == -1 ? -std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
  if (std::abs(x) < tiny || std::isinf(x)) return x;
  const double value = std::abs(x) < small ? quick_log_from(0, 0, x) : quick_log(1.0 + x);
  return round_or(value, std::abs(value) * 0x1p-49, [=] { return slow_log1p(x); });
}

double log1p(double x) {
  if (!(x > -1)) return x == -1 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  if (std::abs(x) < tiny || std::isinf(x)) return x;
  if (x > 0x1p200) return slow_log1p(x);
  const DoubleDouble sum = two_sum(1, x);
  const DoubleDouble log = std::abs(x) < small ? log_from(0, 0, x) : log_of(sum.hi, sum.lo);
  return round_or(log.hi, log.lo, log_error(log.hi), [=] { return slow_log1p(x); });
}

float pow(float x, float y) { return any_pow(x, y); }
double pow(double x, double y) { return any_pow(x, y); }

}  // namespace raywalk::portable
