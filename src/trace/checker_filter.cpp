#include "trace/checker_filter.h"

#include "trace/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace raywalk {

namespace {

/// Two numbers at a time: of u and v, or of two sides that run the same way.
using Pair = double __attribute__((vector_size(16)));

Pair swapped(Pair x) { return Pair{x[1], x[0]}; }
Pair absolute(Pair x) {
  using Bits = std::int64_t __attribute__((vector_size(16)));
  constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
  return reinterpret_cast<Pair>(reinterpret_cast<Bits>(x) & Bits{all_but_sign, all_but_sign});
}
double sum_of(Pair x) { return x[0] + x[1]; }
double dot(Pair a, Pair b) { return sum_of(a * b); }
double cross(Pair a, Pair b) { return a[0] * b[1] - a[1] * b[0]; }

/// The whole numbers that are nearest to x, |x| < 2^51.
Pair nearest_whole(Pair x) {
  constexpr double has_no_fraction = 0x1.8p52;  // nor has a sum with it
  return (x + has_no_fraction) - has_no_fraction;
}
/// The whole numbers below x. |x| < 2^51.
Pair whole_below(Pair x) {
  const Pair nearest = nearest_whole(x);
  return nearest - (nearest > x ? Pair{1, 1} : Pair{0, 0});
}
/// x less the multiple of 2 that is nearest to it, in -1..1. |x| < 2^51.
Pair within_period(Pair x) { return x - 2.0 * nearest_whole(x * 0.5); }

/// The square wave of squares with the edge 1, in that which begins at a whole number: 1 in even ones, -1 in odd ones.
Pair square_wave(Pair whole) { return 1.0 - 2.0 * absolute(within_period(whole)); }
/// Its integral, whose mean is 0: a triangle wave from -1/2 to 1/2.
Pair integral_of_square_wave(Pair u) { return absolute(within_period(u)) - 0.5; }
/// The integral of that, 0 at each line between squares.
Pair second_integral_of_square_wave(Pair u) {
  const Pair within = within_period(u);
  return within * (absolute(within) - 1.0) * 0.5;
}

/// The mean of the square wave over an interval.
double mean_of_square_wave(double middle, double width) {
  if (!(width > 0)) return square_wave(whole_below(Pair{middle, middle}))[0];
  const Pair S = integral_of_square_wave(middle + Pair{-0.5, 0.5} * width);
  return std::clamp((S[1] - S[0]) / width, -1.0, 1.0);
}
/// The mean over the sum of two intervals about `middle`: their lengths may have any sign.
double mean_of_square_wave(double middle, double one, double other) {
  const double a = std::max(std::abs(one), std::abs(other)) / 2, b = std::min(std::abs(one), std::abs(other)) / 2;
  // So thin that it hardly matters, or that the differences below have lost their digits.
  constexpr double thin = 1e-5, least_product = 1e-10;
  if (b < thin * a || a * b < least_product) return mean_of_square_wave(middle, 2 * a);
  const Pair ends{a + b, a - b};
  const Pair R = second_integral_of_square_wave(middle + ends) + second_integral_of_square_wave(middle - ends);
  return std::clamp((R[0] - R[1]) / (4 * a * b), -1.0, 1.0);
}

/// The sum of s(v) times the change of F(u), over the rows that the ways from two points (u, v) to (u + du, v + dv)
/// lead through: s, the square wave, is constant in each.
template <Pair F(Pair)>
Pair sum_over_rows(Pair u, Pair v, double du, double dv) {
  const Pair row = whole_below(v), end = v + dv;
  const double slope = du / dv;
  const double step = dv > 0 ? 1 : -1;
  Pair line = row + (dv > 0 ? 1.0 : 0.0), wave = square_wave(row);
  Pair sum = -wave * F(u);
  for (;; line += step) {
    const auto crossed = (end - line) * step > 0.0;
    if (!(crossed[0] | crossed[1])) return sum + wave * F(u + du);
    sum += crossed ? 2.0 * wave * F(u + slope * (line - v)) : Pair{0, 0};
    wave = crossed ? -wave : wave;
  }
}

/// A part of a side that is so small that a division by it may not be finite counts as none.
constexpr double dust = 1e-200;

/// The integral of S(u) s(v) dv along the way from one corner, less that along the same way from another, where S is
/// the integral of s.
double difference_along(Pair one, Pair other, Pair way) {
  constexpr auto S = [](Pair u) { return integral_of_square_wave(u); };
  constexpr auto over_rows = sum_over_rows<second_integral_of_square_wave>;
  constexpr auto difference = [](Pair x) { return x[0] - x[1]; };
  const double du = way[0], dv = way[1];
  const Pair u{one[0], other[0]}, v{one[1], other[1]};
  if (std::abs(dv) < dust) return 0;
  if (std::abs(dv) <= std::abs(du))  // S(u) du is the change of S's own integral
    return dv / du * difference(over_rows(u, v, du, dv));
  // Steep, it leads through fewer columns. By parts it is the change of S(u) S(v), less the integral of S(v) s(u) du.
  const double change = difference(S(u + du) * S(v + dv) - S(u) * S(v));
  return std::abs(du) < dust ? change : change - du / dv * difference(over_rows(v, u, dv, du));
}

/// The mean of s(u) s(v) over the parallelogram about `centre` with the sides p and q, by its border (Green): its area
/// and the integral of S(u) s(v) dv are both negative where that runs clockwise.
double mean_over_parallelogram(Pair centre, Pair p, Pair q) {
  const Pair corner = centre - 0.5 * p - 0.5 * q;
  const double integral = difference_along(corner, corner + q, p) + difference_along(corner + p, corner, q);
  return std::clamp(integral / cross(p, q), -1.0, 1.0);
}

/// The mean of s(u) s(v) over the way about `centre`.
double mean_along(Pair centre, Pair way) {
  if (std::abs(way[0]) < std::abs(way[1])) return mean_along(swapped(centre), swapped(way));
  if (std::abs(way[1]) < dust) way[1] = 0;
  const Pair start = centre - 0.5 * way, u{start[0], start[0]}, v{start[1], start[1]};  // twice the same
  return sum_over_rows<integral_of_square_wave>(u, v, way[0], way[1])[0] / way[0];
}

/// The mean of s(u) s(v) over the parallelogram about `centre` whose sides are so nearly parallel that it is a line:
/// over ways like the longer side, about the places along the shorter one of Gauss's rule with eight.
double mean_over_line(Pair centre, Pair longer, Pair shorter) {
  constexpr double places[]{0.0917173212478249, 0.2627662049581645, 0.3983332387068134, 0.4801449282487681};
  constexpr double weights[]{0.1813418916891810, 0.1568533229389436, 0.1111905172266872, 0.0506142681451881};
  double mean = 0;
  for (int i = 0; i < 4; ++i)
    mean += weights[i] *
            (mean_along(centre + places[i] * shorter, longer) + mean_along(centre - places[i] * shorter, longer));
  return mean;
}

}  // namespace

template <class T>
T even_share(const Vec2<T>& uv, T size, const Footprint<T>& footprint) {
  const double scale = 1 / static_cast<double>(size);
  const auto in_squares = [&](const Vec2<T>& at) -> Pair {
    return scale * Pair{static_cast<double>(at.x), static_cast<double>(at.y)};
  };
  const Pair p = in_squares(footprint.x), q = in_squares(footprint.y), reach = absolute(p) + absolute(q);
  Pair place = in_squares(uv);
  const double crossed = sum_of(reach);
  constexpr double countless = 1e6, most = 48, least = 32;  // squares
  if (!(crossed < countless)) return T(0.5);                // NaN: at the horizon
  constexpr double far = 0x1p50;                            // where doubles have no digits left within a square
  const auto near = absolute(place) < far;
  if (!(near[0] & near[1])) return even_square(uv, size) ? T(1) : T(0);
  const Pair square = whole_below(place - 0.5 * reach);
  const auto in_one = place + 0.5 * reach < square + 1.0;
  place = within_period(place);
  double mean = 0;
  if (in_one[0] & in_one[1])
    mean = square_wave(square)[0] * square_wave(square)[1];
  else if (in_one[1])
    mean = square_wave(square)[1] * mean_of_square_wave(place[0], p[0], q[0]);
  else if (in_one[0])
    mean = square_wave(square)[0] * mean_of_square_wave(place[1], p[1], q[1]);
  else {
    const double blend = std::clamp((crossed - least) / (most - least), 0.0, 1.0);
    if (blend < 1) {
      const bool p_is_longer = dot(p, p) > dot(q, q);
      const Pair longer = p_is_longer ? p : q, shorter = p_is_longer ? q : p;
      constexpr double thin = 1e-7;  // so thin that it is a line, or its integral has lost its digits
      mean = std::abs(cross(p, q)) > thin * std::max(dot(longer, longer), 1e-3)
                 ? mean_over_parallelogram(place, p, q)
                 : mean_over_line(place, longer, shorter);
    }
    if (blend > 0)
      mean += blend * (mean_of_square_wave(place[0], reach[0]) * mean_of_square_wave(place[1], reach[1]) - mean);
  }
  return static_cast<T>(0.5 + 0.5 * mean);
}

template float even_share(const Vec2<float>&, float, const Footprint<float>&);
template double even_share(const Vec2<double>&, double, const Footprint<double>&);

}  // namespace raywalk
