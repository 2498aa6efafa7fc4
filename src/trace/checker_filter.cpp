#include "trace/checker_filter.h"

#include "trace/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raywalk {

namespace {

/// The whole number below x; quicker than std::floor, which is a call on old processors. |x| < 2^62.
std::int64_t whole_below(double x) {
  const auto cut = static_cast<std::int64_t>(x);
  return cut - static_cast<std::int64_t>(x < static_cast<double>(cut));
}
/// x less the multiple of 2 that is nearest to it, in -1..1. |x| < 2^51.
double within_period(double x) {
  constexpr double has_no_fraction = 0x1.8p52;  // nor has a sum with it
  return x - 2 * ((x / 2 + has_no_fraction) - has_no_fraction);
}

/// The square wave of one row of squares, of edge 1: 1 in even ones, -1 in odd ones.
double square_wave(std::int64_t square) { return static_cast<double>(1 - 2 * (square & 1)); }
/// Its integral, whose mean is 0: a triangle wave from -1/2 to 1/2.
double integral_of_square_wave(double u) { return std::abs(within_period(u)) - 0.5; }
/// The integral of that, 0 at each line between squares.
double second_integral_of_square_wave(double u) {
  const double within = within_period(u);
  return within * (std::abs(within) - 1) / 2;
}

/// The mean of the square wave over an interval.
double mean_of_square_wave(double middle, double width) {
  if (!(width > 0)) return square_wave(whole_below(middle));
  return std::clamp((integral_of_square_wave(middle + width / 2) - integral_of_square_wave(middle - width / 2)) / width,
                    -1.0, 1.0);
}
/// The mean over the sum of two intervals about `middle`: their lengths may have any sign.
double mean_of_square_wave(double middle, double one, double other) {
  const double a = std::max(std::abs(one), std::abs(other)) / 2, b = std::min(std::abs(one), std::abs(other)) / 2;
  // So thin that it hardly matters, or that the differences below have lost their digits.
  constexpr double thin = 1e-5, least_product = 1e-10;
  if (b < thin * a || a * b < least_product) return mean_of_square_wave(middle, 2 * a);
  const auto R = [&](double at) { return second_integral_of_square_wave(middle + at); };
  return std::clamp((R(a + b) - R(a - b) - R(b - a) + R(-a - b)) / (4 * a * b), -1.0, 1.0);
}

/// The sum of s(v) times the change of F(u), over the rows that the way from `start` leads through: s, the square wave,
/// is constant in each. `slope`: way.x / way.y; anything where way.y is 0.
template <double F(double)>
double sum_over_rows(const Vec2d& start, const Vec2d& way, double slope) {
  const Vec2d end = start + way;
  const std::int64_t row = whole_below(start.y);
  const double step = way.y > 0 ? 1 : -1;
  double line = static_cast<double>(row + (way.y > 0)), wave = square_wave(row);
  double sum = -wave * F(start.x);
  for (; (end.y - line) * step > 0; line += step) {
    sum += 2 * wave * F(start.x + slope * (line - start.y));
    wave = -wave;
  }
  return sum + wave * F(end.x);
}

Vec2d exchanged(const Vec2d& uv) { return {uv.y, uv.x}; }

/// The integral of S(u) s(v) dv along the way from a, less that along the same way from b, where S is the integral of
/// s.
double difference_along(const Vec2d& a, const Vec2d& b, const Vec2d& way) {
  constexpr auto S = integral_of_square_wave;
  constexpr auto SS = second_integral_of_square_wave;
  const double du_dv = way.x / way.y, dv_du = way.y / way.x;
  if (way.y == 0) return 0;
  if (std::abs(way.y) <= std::abs(way.x))  // S(u) du is the change of S's own integral
    return dv_du * (sum_over_rows<SS>(a, way, du_dv) - sum_over_rows<SS>(b, way, du_dv));
  // Steep, it leads through fewer columns. By parts it is the change of S(u) S(v), less the integral of S(v) s(u) du.
  const auto S_S = [](const Vec2d& at) { return S(at.x) * S(at.y); };
  const auto over_columns = [&](const Vec2d& start) {
    return sum_over_rows<SS>(exchanged(start), exchanged(way), dv_du);
  };
  return (S_S(a + way) - S_S(a)) - (S_S(b + way) - S_S(b)) - du_dv * (over_columns(a) - over_columns(b));
}

/// The mean of s(u) s(v) over the parallelogram about `centre` with the sides p and q, by its border (Green): its area
/// and the integral of S(u) s(v) dv are both negative where that runs clockwise.
double mean_over_parallelogram(const Vec2d& centre, const Vec2d& p, const Vec2d& q) {
  const Vec2d corner = centre - 0.5 * p - 0.5 * q;
  const double integral = difference_along(corner, corner + q, p) + difference_along(corner + p, corner, q);
  return std::clamp(integral / cross(p, q), -1.0, 1.0);
}

/// The mean of s(u) s(v) over the way about `centre`.
double mean_along(const Vec2d& centre, const Vec2d& way) {
  if (std::abs(way.x) < std::abs(way.y)) return mean_along(exchanged(centre), exchanged(way));
  return sum_over_rows<integral_of_square_wave>(centre - 0.5 * way, way, way.x / way.y) / way.x;
}

}  // namespace

template <class T>
T even_share(const Vec2<T>& uv, T size, const Footprint<T>& footprint) {
  const double scale = 1 / static_cast<double>(size);
  const Vec2d p = scale * Vec2d(footprint.x), q = scale * Vec2d(footprint.y);
  const Vec2d reach(std::abs(p.x) + std::abs(q.x), std::abs(p.y) + std::abs(q.y));
  Vec2d place = scale * Vec2d(uv);
  constexpr double countless = 1e6, most = 48, least = 32;  // squares
  if (!(reach.x + reach.y < countless)) return T(0.5);      // NaN: at the horizon
  constexpr double far = 0x1p50;                            // where doubles have no digits left within a square
  if (!(std::abs(place.x) < far && std::abs(place.y) < far)) return even_square(uv, size) ? T(1) : T(0);
  const Vec2d low = place - 0.5 * reach, high = place + 0.5 * reach;
  const std::int64_t column = whole_below(low.x), row = whole_below(low.y);
  const bool one_column = high.x < static_cast<double>(column + 1), one_row = high.y < static_cast<double>(row + 1);
  if (one_column && one_row) return static_cast<T>(((column ^ row) & 1) == 0);
  place = {within_period(place.x), within_period(place.y)};
  if (one_row) return static_cast<T>(0.5 + 0.5 * square_wave(row) * mean_of_square_wave(place.x, p.x, q.x));
  if (one_column) return static_cast<T>(0.5 + 0.5 * square_wave(column) * mean_of_square_wave(place.y, p.y, q.y));
  double exact = 0, rectangle = 0;
  const double crossed = reach.x + reach.y, blend = std::clamp((crossed - least) / (most - least), 0.0, 1.0);
  if (blend < 1) {
    const Vec2d& longer = dot(p, p) > dot(q, q) ? p : q;
    constexpr double thin = 1e-7;  // so thin that it is a line, or its integral has lost its digits
    exact = std::abs(cross(p, q)) > thin * std::max(dot(longer, longer), 1e-3) ? mean_over_parallelogram(place, p, q)
                                                                               : mean_along(place, longer);
  }
  if (blend > 0) rectangle = mean_of_square_wave(place.x, reach.x) * mean_of_square_wave(place.y, reach.y);
  return static_cast<T>(0.5 + 0.5 * ((1 - blend) * exact + blend * rectangle));
}

template float even_share(const Vec2<float>&, float, const Footprint<float>&);
template double even_share(const Vec2<double>&, double, const Footprint<double>&);

}  // namespace raywalk
