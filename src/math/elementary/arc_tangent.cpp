// The angle of the point (x, y) in the first octant is that of the nearest slope c = i /
// 256, from a table, and that from there to the point:
//     atan(y / x) = atan(c) + atan(t),  t = (y - c x) / (x + c y),  |t| < 2^-9
// t is right up to 2^-79 and its series beyond t, below 2^-19 t, is computed in one double: errors below 2^-70.
#include "math/elementary.h"

#include "math/elementary/steps.h"

#include <array>
#include <limits>
#include <numbers>

namespace raywalk::portable {
namespace {

constexpr int slopes = 256;
constexpr DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble right_angle{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// atan(i / 256): from one slope c to the next, d, the tangent is (d - c) / (1 + c d).
constexpr auto angles = [] {
  std::array<DoubleDouble, slopes + 1> table{};
  for (int i = 0; i < slopes; ++i) {
    const auto at = static_cast<std::size_t>(i);
    table[at + 1] = table[at] + arc_series(DoubleDouble(slopes) / (slopes * slopes + i * (i + 1)), -1);
  }
  return table;
}();

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T slow_atan2(T y, T x) {
  return correctly_rounded<T>([=](int words) { return big::atan2(BigFloat(y, words), BigFloat(x, words)); });
}

/// Where the angle of a point lies: at `from`, ahead or back by the angle of the slope small / large.
struct Octant {
  DoubleDouble from;
  double sense;
};
[[nodiscard]] inline Octant octant_of(double y, double x) {
  const bool steep = std::abs(y) > std::abs(x), left = std::signbit(x);
  if (steep) return {right_angle, left ? 1.0 : -1.0};
  return {left ? pi : DoubleDouble(0), left ? -1.0 : 1.0};
}

/// Whether angle_of can take a coordinate. Doubles must leave room for the parts of their quotient.
template <class T>
[[nodiscard]] bool is_ample(T size) {
  constexpr bool single = std::numeric_limits<T>::digits == 24;
  return size >= (single ? std::numeric_limits<T>::denorm_min() : static_cast<T>(0x1p-300)) &&
         size <= (single ? std::numeric_limits<T>::max() : static_cast<T>(0x1p300));
}

/// The angle of a point with y > 0, both ample, or x = 0.
[[nodiscard]] inline double angle_of(double y, double x) {
  const auto [from, sense] = octant_of(y, x);
  const double wide = std::abs(x), small = std::min(y, wide), large = std::max(y, wide);
  const double steps = nearest_whole(small / large * slopes);
  const double c = steps * (1.0 / slopes);  // 9 bits: products with a head, or with what follows it, are exact
  const double small_head = head_of(small), large_head = head_of(large);
  const DoubleDouble over = two_sum(small - c * large_head, -(c * (large - large_head)));
  const DoubleDouble sum = ordered_sum(large, c * small_head);
  const Parts across = parts(over.hi, over.lo), along = parts(sum.hi, sum.lo + c * (small - small_head));
  // The quotient: what one division leaves over is divided once more.
  const double divisor = along.value(), t = across.value() / divisor;
  const double t_head = head_of(t), t_tail = t - t_head;
  const double left_over =
      ((across.head - t_head * along.head) + across.tail) - (t_head * along.tail + t_tail * divisor);
  const double square = t * t;
  const double beyond_t = t * square * polynomial(square, {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9}) + left_over / divisor;
  const DoubleDouble& base = angles[static_cast<std::size_t>(steps)];
  const DoubleDouble octant = ordered_sum(base.hi, t);
  const DoubleDouble angle = ordered_sum(from.hi, sense * octant.hi);
  const double rest = angle.lo + (from.lo + sense * (octant.lo + (base.lo + beyond_t)));
  return round_or(angle.hi, rest, angle.hi * 0x1p-68, [=] { return slow_atan2(y, x); });
}

/// The same for floats, in one double.
[[nodiscard]] inline float angle_of(float y, float x) {
  const auto [from, sense] = octant_of(y, x);
  const double wide = std::abs(x), small = std::min<double>(y, wide), large = std::max<double>(y, wide);
  const double steps = nearest_whole(small / large * slopes), c = steps * (1.0 / slopes);
  const double t = (small - c * large) / (large + c * small), square = t * t;
  const double octant =
      angles[static_cast<std::size_t>(steps)].hi + (t + t * square * polynomial(square, {-1.0 / 3, 1.0 / 5, -1.0 / 7}));
  const double angle = from.hi + sense * octant;
  return round_or(angle, angle * 0x1p-49, [=] { return slow_atan2(y, x); });
}

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] T special_atan2(T y, T x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<T>::quiet_NaN();
  if (y == 0) return std::signbit(x) ? std::copysign(std::numbers::pi_v<T>, y) : y;
  if (std::isfinite(x) && std::isfinite(y)) return slow_atan2(y, x);
  const auto far = [](T v) { return std::copysign(std::isinf(v) ? T(1) : T(0), v); };
  return portable::atan2(far(y), far(x));
}

template <class T>
[[nodiscard]] T any_atan2(T y, T x) {
  const T high = std::abs(y), wide = std::abs(x);
  if (!is_ample(high) || !(is_ample(wide) || wide == 0)) return special_atan2(y, x);
  return std::copysign(angle_of(high, x), y);
}

}  // namespace

float atan2(float y, float x) { return any_atan2(y, x); }
double atan2(double y, double x) { return any_atan2(y, x); }

}  // namespace raywalk::portable
