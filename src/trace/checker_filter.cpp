#include "trace/checker_filter.h"

#include "trace/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raywalk {

namespace {

/// The whole number below x; quicker than std::floor, which is a call on old processors. |x| < 2^62.
double whole_below(double x) {
  const auto cut = static_cast<double>(static_cast<std::int64_t>(x));
  return cut - static_cast<double>(x < cut);
}
/// The square wave of one row of squares, of edge 1: 1 in even ones, -1 in odd ones.
double square_wave(double u) { return u - 2 * whole_below(u / 2) < 1 ? 1 : -1; }
/// Its integral, whose mean is 0: a triangle wave from -1/2 to 1/2.
double integral_of_square_wave(double u) { return 0.5 - std::abs(u - 2 * whole_below(u / 2) - 1); }

/// The integral of that, from 0 at each line between squares.
double second_integral_of_square_wave(double u) {
  const double within = u - 2 * whole_below(u / 2), beyond = within - 1;
  return within < 1 ? within * (within - 1) / 2 : beyond * (1 - beyond) / 2;
}

/// The mean of the square wave over an interval.
double mean_of_square_wave(double middle, double width) {
  if (!(width > 0)) return square_wave(middle);
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

/// Calls `piece(from, to)` for each part of the way from a to b, both in squares, that lies in one square.
template <class Piece>
void walk_squares(const Vec2d& a, const Vec2d& b, Piece piece) {
  const Vec2d way = b - a;
  // Of each coordinate: the next line between squares, and where along the way, in 0..1, that is; 2: there is none.
  struct Lines {
    Lines(double start, double way_along)
        : from(start),
          step(way_along > 0 ? 1 : -1),
          next(way_along > 0 ? whole_below(start) + 1 : -whole_below(-start) - 1),
          inverse(1 / way_along),
          at(way_along == 0 ? 2 : (next - from) * inverse) {}
    void go_on() {
      next += step;
      at = (next - from) * inverse;
    }
    double from, step, next, inverse, at;
  };
  Lines u(a.x, way.x), v(a.y, way.y);
  Vec2d from = a;
  for (;;) {
    const double at_u = u.at, at_v = v.at, along = std::min(at_u, at_v);
    if (!(along < 1)) return piece(from, b);
    Vec2d to = a + along * way;
    if (at_u <= at_v) to.x = u.next, u.go_on();
    if (at_v <= at_u) to.y = v.next, v.go_on();
    piece(from, to);
    from = to;
  }
}

/// The integral of S(u) s(v) dv along the way from a to b, where s is the square wave and S its integral. Between two
/// lines of v it is s times the change of S's own integral, over du / dv.
double integral_along(const Vec2d& a, const Vec2d& b) {
  const Vec2d way = b - a;
  if (way.y == 0) return 0;
  const double slope = way.x / way.y;
  constexpr double steep = 1e-5;  // along a line of u such a change would have lost its digits
  double sum = 0;
  if (std::abs(slope) < steep) {
    // In each square S is linear and s constant, so a trapezium is exact.
    walk_squares(a, b, [&](const Vec2d& from, const Vec2d& to) {
      const double u = integral_of_square_wave(from.x) + integral_of_square_wave(to.x);
      sum += u * (integral_of_square_wave(to.y) - integral_of_square_wave(from.y)) / 2;
    });
    return sum;
  }
  const double step = way.y > 0 ? 1 : -1;
  double line = way.y > 0 ? whole_below(a.y) + 1 : -whole_below(-a.y) - 1;
  double wave = square_wave(line - 0.5 * step);
  sum = -wave * second_integral_of_square_wave(a.x);
  for (; (b.y - line) * step > 0; line += step) {
    sum += 2 * wave * second_integral_of_square_wave(a.x + slope * (line - a.y));
    wave = -wave;
  }
  return (sum + wave * second_integral_of_square_wave(b.x)) / slope;
}

/// The integral of s(u) s(v) du dv over the parallelogram about `centre` with the sides p and q, by its border (Green):
/// that of S(u) s(v) dv, counter-clockwise.
double integral_over_parallelogram(const Vec2d& centre, const Vec2d& p, const Vec2d& q) {
  const Vec2d corner = centre - 0.5 * p - 0.5 * q;
  const double sum = integral_along(corner, corner + p) + integral_along(corner + p, corner + p + q) +
                     integral_along(corner + p + q, corner + q) + integral_along(corner + q, corner);
  return cross(p, q) < 0 ? -sum : sum;
}

Vec2d exchanged(const Vec2d& uv) { return {uv.y, uv.x}; }

/// The mean of s(u) s(v) over the way about `centre`.
double mean_along(const Vec2d& centre, const Vec2d& way) {
  double sum = 0;
  walk_squares(centre - 0.5 * way, centre + 0.5 * way, [&](const Vec2d& a, const Vec2d& b) {
    const Vec2d middle = 0.5 * (a + b);
    const double share = std::abs(way.x) > std::abs(way.y) ? (b.x - a.x) / way.x : (b.y - a.y) / way.y;
    sum += share * square_wave(middle.x) * square_wave(middle.y);
  });
  return sum;
}

}  // namespace

template <class T>
T even_share(const Vec2<T>& uv, T size, const Footprint<T>& footprint) {
  const double scale = 1 / static_cast<double>(size);
  const Vec2d p = scale * Vec2d(footprint.x), q = scale * Vec2d(footprint.y);
  const Vec2d reach(std::abs(p.x) + std::abs(q.x), std::abs(p.y) + std::abs(q.y));
  Vec2d place(static_cast<double>(uv.x / size), static_cast<double>(uv.y / size));
  constexpr double countless = 1e6, most = 48, least = 32;  // squares
  if (!(reach.x + reach.y < countless)) return T(0.5);      // NaN: at the horizon
  constexpr double far = 0x1p50;                            // where doubles have no digits left within a square
  if (!(std::abs(place.x) < far && std::abs(place.y) < far)) return even_square(uv, size) ? T(1) : T(0);
  // In two rows each way, which repeat.
  const Vec2d low = place - 0.5 * reach, high = place + 0.5 * reach;
  const bool one_column = whole_below(low.x) == whole_below(high.x);
  const bool one_row = whole_below(low.y) == whole_below(high.y);
  if (one_column && one_row) return even_square(uv, size) ? T(1) : T(0);
  place -= Vec2d(2 * whole_below(place.x / 2), 2 * whole_below(place.y / 2));
  if (one_row) return static_cast<T>(0.5 + 0.5 * square_wave(place.y) * mean_of_square_wave(place.x, p.x, q.x));
  if (one_column) return static_cast<T>(0.5 + 0.5 * square_wave(place.x) * mean_of_square_wave(place.y, p.y, q.y));
  double exact = 0, rectangle = 0;
  const double crossed = reach.x + reach.y, blend = std::clamp((crossed - least) / (most - least), 0.0, 1.0);
  if (blend < 1) {
    const Vec2d& longer = dot(p, p) > dot(q, q) ? p : q;
    const double area = std::abs(cross(p, q));
    constexpr double thin = 1e-7;  // so thin that it is a line, or its integral has lost its digits
    exact = area > thin * std::max(dot(longer, longer), 1e-3)
                // The pattern is the same if u and v are exchanged: with fewer lines of v there is less to add up.
                ? std::clamp(
                      (reach.y <= reach.x ? integral_over_parallelogram(place, p, q)
                                          : integral_over_parallelogram(exchanged(place), exchanged(p), exchanged(q))) /
                          area,
                      -1.0, 1.0)
                : mean_along(place, longer);
  }
  if (blend > 0) rectangle = mean_of_square_wave(place.x, reach.x) * mean_of_square_wave(place.y, reach.y);
  return static_cast<T>(0.5 + 0.5 * ((1 - blend) * exact + blend * rectangle));
}

template float even_share(const Vec2<float>&, float, const Footprint<float>&);
template double even_share(const Vec2<double>&, double, const Footprint<double>&);

}  // namespace raywalk
