// Sine and cosine. From the nearest multiple of pi / 1024, whose sine S and cosine C stand in a table:
//     sin(a + r) = S + C r + S (cos r - 1) + C (sin r - r),  |r| <= pi / 2048 < 2^-9.3
// The first two terms are right up to 2^-78, the others, below 2^-19 S, are computed in one double: errors below 2^-69.
// For floats, from the nearest quarter turn by Taylor's series in one double: errors below 2^-45.
#include "math/elementary.h"

#include "math/elementary/steps.h"

#include <array>
#include <limits>

namespace raywalk::portable {
namespace {

constexpr int quarter = 512;  // steps of pi / 1024
constexpr double steps_per_radian = 0x1.45f306dc9c883p+8;
// pi / 1024 in parts of 29, 29, 53 and 53 bits: up to 2^24 times the first two are exact.
constexpr double step_1 = 0x1.921fb54p-9, step_2 = 0x1.10b4611p-39, step_3 = 0x1.4c4c6628b80dcp-68,
                 step_4 = 0x1.cd129024e088ap-124;
// pi / 2 in parts of 38 and 53 bits: up to 2^15 times the first is exact.
constexpr double quarters_per_radian = 0x1.45f306dc9c883p-1;
constexpr double quarter_1 = 0x1.921fb5444p+0, quarter_2 = 0x1.68c234c4c6629p-39;
constexpr double quick_limit = 0x1p15;

/// sin(i pi / 1024), by turning step after step.
constexpr auto sines = [] {
  constexpr DoubleDouble sin{0x1.921f8becca4bap-9, 0x1.2ba407bcab5b2p-63};
  constexpr DoubleDouble cos{0x1.ffff621621d02p-1, -0x1.6acfcebc82813p-56};
  std::array<Parts, quarter + 1> table{};
  DoubleDouble s(0), c(1);
  for (std::size_t i = 0; i <= quarter / 2; ++i) {
    table[i] = parts(s);
    table[quarter - i] = parts(c);
    const DoubleDouble next = s * cos + c * sin;
    c = c * cos - s * sin;
    s = next;
  }
  return table;
}();

/// The sine of an angle that is ahead by `quarters` quarter turns, 0 or 1.
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T slow_sine(T angle, int quarters) {
  if (!std::isfinite(angle)) return std::numeric_limits<T>::quiet_NaN();
  return correctly_rounded<T>([=](int words) {
    const BigFloat exact(angle, words);
    return quarters == 0 ? big::sin(exact) : big::cos(exact);
  });
}

/// The step of the table that is nearest to an angle, and by how much the angle is ahead of it, right up to `error`.
struct Reduced {
  double steps;
  Parts rest;
  double error;
};
/// So close to a step as only 90 degrees and their like are: there the sine or the cosine may be as small as the rest.
constexpr double at_a_step = 0x1p-40;
[[nodiscard]] inline Reduced reduce(double angle) {
  const double steps = nearest_whole(angle * steps_per_radian);
  const DoubleDouble rest = two_sum(angle - steps * step_1, -(steps * step_2));
  if (std::abs(rest.hi) < at_a_step) [[unlikely]]
    return {steps, parts(rest - two_product(steps, step_3) - steps * step_4), std::abs(steps) * 0x1p-165};
  return {steps, parts(rest.hi, rest.lo - steps * step_3), std::abs(steps) * 0x1p-114};
}

/// value cos r + slope sin r
[[nodiscard]] inline DoubleDouble turned(const Parts& value, const Parts& slope, const Parts& rest) {
  const double r = rest.value(), square = r * r;
  const double cos_less_1 = square * polynomial(square, {-1.0 / 2, 1.0 / 24, -1.0 / 720});
  const double sin_less_r = r * square * polynomial(square, {-1.0 / 6, 1.0 / 120, -1.0 / 5040});
  const DoubleDouble sum = ordered_sum(value.head, slope.head * rest.head);
  return {sum.hi, sum.lo + (value.tail + (slope.head * rest.tail + slope.tail * r) +
                            (value.value() * cos_less_1 + slope.value() * sin_less_r))};
}

[[nodiscard]] inline double sine(const Reduced& at, int quarters, double angle) {
  const std::int32_t step = static_cast<std::int32_t>(at.steps) + quarters * quarter;
  const auto entry = static_cast<std::size_t>(step & (quarter - 1));
  const Parts &sin = sines[entry], &cos = sines[quarter - entry];
  const DoubleDouble size = (step & quarter) != 0 ? turned(cos, -sin, at.rest) : turned(sin, cos, at.rest);
  const DoubleDouble sine = (step & 2 * quarter) != 0 ? -size : size;
  const double error = std::abs(sine.hi) * 0x1p-68 + at.error;
  return round_or(sine.hi, sine.lo, error, [=] { return slow_sine(angle, quarters); });
}

/// The same for floats: the nearest quarter turn, and the rest in one double.
struct ReducedFloat {
  double steps, rest;
};
[[nodiscard]] inline ReducedFloat reduce(float angle) {
  const double steps = nearest_whole(angle * quarters_per_radian);
  return {steps, angle - steps * quarter_1 - steps * quarter_2};
}

[[nodiscard]] inline float sine(const ReducedFloat& at, int quarters, float angle) {
  const std::int32_t step = static_cast<std::int32_t>(at.steps) + quarters;
  const double r = at.rest, s = r * r;
  double size;
  if ((step & 1) != 0) {
    size = 1 + s * polynomial(s, {-1.0 / 2, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600,
                                  -1.0 / 87178291200});
  } else {
    size =
        r + r * s * polynomial(s, {-1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800});
  }
  const double error = std::abs(size) * 0x1p-44 + std::abs(at.steps) * 0x1p-90;
  return round_or((step & 2) != 0 ? -size : size, error, [=] { return slow_sine(angle, quarters); });
}

template <class T>
[[nodiscard]] T sine(T angle, int quarters) {
  if (!(std::abs(angle) <= quick_limit)) return slow_sine(angle, quarters);
  return sine(reduce(angle), quarters, angle);
}

/// So close to 0 the sine is the angle, whose zero keeps its sign.
template <class T>
constexpr T tiny = static_cast<T>(std::numeric_limits<T>::digits == 24 ? 0x1p-12 : 0x1p-27);

template <class T>
[[nodiscard]] T any_sin(T angle) {
  return std::abs(angle) < tiny<T> ? angle : sine(angle, 0);
}

template <class T>
[[nodiscard]] SineCosine<T> any_sin_cos(T angle) {
  const T size = std::abs(angle);
  if (!(size >= tiny<T> && size <= quick_limit)) return {any_sin(angle), sine(angle, 1)};
  const auto reduced = reduce(angle);
  return {sine(reduced, 0, angle), sine(reduced, 1, angle)};
}

}  // namespace

float sin(float angle) { return any_sin(angle); }
double sin(double angle) { return any_sin(angle); }
float cos(float angle) { return sine(angle, 1); }
double cos(double angle) { return sine(angle, 1); }
SineCosine<float> sin_cos(float angle) { return any_sin_cos(angle); }
SineCosine<double> sin_cos(double angle) { return any_sin_cos(angle); }

}  // namespace raywalk::portable
