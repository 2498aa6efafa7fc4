#pragma once
// Traits of the curved shapes.

#include "check/stratum.h"

#include <algorithm>
#include <cmath>

namespace raywalk::check {

template <class T>
struct ShapeTraits<Sphere<T>> {
  using S = Sphere<T>;
  static constexpr bool placed = false;
  static S make(Random& random, double scale, const Vec3d& centre) {
    return {Vec3<T>(centre + scale * random.in_box()), static_cast<T>(scale * random.real(0.1, 2))};
  }
  static double size(const S& s) { return static_cast<double>(s.radius); }
  static Vec3d centre(const S& s) { return Vec3d(s.centre); }
  static Vec3d surface(const S& s, Random& random) { return centre(s) + size(s) * random.unit(); }
  static Vec3d interior(const S& s, Random& random) { return centre(s) + random.real(0, 1) * size(s) * random.unit(); }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& eye) {
    const Vec3d view = centre(s) - eye;
    const double distance = length(view), r = size(s);
    if (!(distance > r)) return surface(s, random);
    const double sine = r / distance;
    return centre(s) - r * sine / distance * view + r * std::sqrt(1 - sine * sine) * across(view, random);
  }
  static Vec3d special(const S& s, Random& random) {
    Vec3d pole = centre(s);
    pole[random.whole(0, 2)] += random.sign() * size(s);
    return pole;
  }
  static Vec3d parallel(const S& /*s*/, Random& random) {
    Vec3d axis(0.0);
    axis[random.whole(0, 2)] = random.sign();
    return axis;
  }
  static Case<S, T> exactly_tangent(Random& random) {
    const Triple p = pythagorean(random);
    const int turns = random.whole(0, 2), back = random.whole(-20, 20);
    const double m = random.whole(1, 60), u = random.whole(1, 9), v = random.whole(-99, 99);
    const double unit = std::ldexp(1.0, random.whole(-20, 20));
    const Vec3d c(random.whole(-999, 999), random.whole(-999, 999), random.whole(-999, 999));
    const Vec3d touch = turned(Vec3d(m * p.a, m * p.b, 0), turns), d = turned(Vec3d(-p.b * u, p.a * u, v), turns);
    return {{Vec3<T>(unit * c), static_cast<T>(unit * m * p.h)},
            {Vec3<T>(unit * (c + touch - static_cast<double>(back) * d)), Vec3<T>(d)}};
  }
};

template <class T>
struct ShapeTraits<Disk<T>> {
  using S = Disk<T>;
  static constexpr bool placed = false;
  static S make(Random& random, double scale, const Vec3d& centre) {
    const Vec3d normal = random.whole(0, 3) == 0 ? ShapeTraits<Sphere<T>>::parallel({}, random) : random.unit();
    return {Vec3<T>(centre + scale * random.in_box()), Vec3<T>(normal), static_cast<T>(scale * random.real(0.1, 2))};
  }
  static double size(const S& s) { return static_cast<double>(s.radius); }
  static Vec3d centre(const S& s) { return Vec3d(s.centre); }
  static Vec3d in_plane(const S& s, Random& random) { return across(Vec3d(s.normal), random); }
  static Vec3d surface(const S& s, Random& random) {
    return centre(s) + random.real(0, 1) * size(s) * in_plane(s, random);
  }
  static Vec3d interior(const S& s, Random& random) { return surface(s, random); }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& /*eye*/) { return special(s, random); }
  static Vec3d special(const S& s, Random& random) { return centre(s) + size(s) * in_plane(s, random); }
  static Vec3d parallel(const S& s, Random& random) { return in_plane(s, random); }
  /// Through the rim, which belongs to the disk; or along the plane.
  static Case<S, T> exactly_tangent(Random& random) {
    const Triple p = pythagorean(random);
    const int turns = random.whole(0, 2);
    const double m = random.whole(1, 60), unit = std::ldexp(1.0, random.whole(-20, 20));
    const Vec3d c(random.whole(-999, 999), random.whole(-999, 999), random.whole(-999, 999));
    const Vec3d rim = turned(Vec3d(m * p.a, m * p.b, 0), turns);
    const double slope = random.whole(0, 5) == 0 ? 0 : random.sign() * random.whole(1, 99);
    const Vec3d d = turned(Vec3d(random.whole(-99, 99), random.whole(1, 99), slope), turns);
    return {
        {Vec3<T>(unit * c), Vec3<T>(turned(Vec3d(0, 0, random.whole(1, 9)), turns)), static_cast<T>(unit * m * p.h)},
        {Vec3<T>(unit * (c + rim - static_cast<double>(random.whole(-20, 20)) * d)), Vec3<T>(d)}};
  }
};

template <class T, QuadricKind Kind>
struct ShapeTraits<Quadric<T, Kind>> {
  using S = Quadric<T, Kind>;
  static constexpr bool placed = true;
  static S make(Random& random, double scale, const Vec3d& /*centre*/) {
    // The paraboloid and the cone have no intrinsic length but their cuts.
    constexpr bool slopes = Kind == QuadricKind::cone;
    const double width = slopes ? 1 : Kind == QuadricKind::elliptic_paraboloid ? std::sqrt(scale) : scale;
    S s;
    s.radii = Vec3<T>(Vec3d(width * random.real(0.2, 2), width * random.real(0.2, 2), scale * random.real(0.2, 2)));
    if (random.whole(0, 3) == 0) s.radii.y = s.radii.x;
    if (random.whole(0, 3) == 0) s.radii = Vec3<T>(static_cast<T>(width));
    const bool cut = random.whole(0, 3) != 0;
    if (cut)
      s.z_min = static_cast<T>(scale * random.real(-3, 0.5)),
      s.z_max = s.z_min + static_cast<T>(scale * random.real(0.5, 4));
    if (cut && random.whole(0, 5) == 0) s.z_min = 0, s.z_max = static_cast<T>(scale);
    s.capped = cut && random.coin();
    return s;
  }
  static double low(const S& s) { return std::isfinite(s.z_min) ? static_cast<double>(s.z_min) : -3 * size(s); }
  static double high(const S& s) { return std::isfinite(s.z_max) ? static_cast<double>(s.z_max) : 3 * size(s); }
  static double size(const S& s) {
    if (std::isfinite(s.z_max))
      return std::max(std::abs(static_cast<double>(s.z_max)), std::abs(static_cast<double>(s.z_min)));
    return static_cast<double>(Kind == QuadricKind::cone || Kind == QuadricKind::elliptic_paraboloid ? s.radii.x
                                                                                                     : s.radii.z);
  }
  static Vec3d centre(const S& s) { return {0, 0, (low(s) + high(s)) / 2}; }
  static Vec3d ring(const S& s, Random& random, double z, double share) {
    const double angle = random.real(-3.2, 3.2), reach = share * std::sqrt(std::max(0.0, squared_section(s, z)));
    return {static_cast<double>(s.radii.x) * reach * std::cos(angle),
            static_cast<double>(s.radii.y) * reach * std::sin(angle), z};
  }
  static Vec3d surface(const S& s, Random& random) { return ring(s, random, random.real(low(s), high(s)), 1); }
  static Vec3d interior(const S& s, Random& random) {
    return ring(s, random, random.real(low(s), high(s)), random.real(0, 1));
  }
  /// A point of exact tangency is as hard to find as to hit; a point whose normal is nearly perpendicular to the view
  /// is close enough: the best of 32.
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& eye) {
    Vec3d best(0.0);
    double least = infinity<double>;
    for (int i = 0; i < 8; ++i) {
      const double angle = random.real(-3.2, 3.2);
      double z = random.real(low(s), high(s));
      // A few regula falsi steps over the height bring g.view to 0 along this meridian.
      for (int step = 0; step < 3; ++step) {
        const auto slope_at = [&](double at) {
          const double reach = std::sqrt(std::max(0.0, squared_section(s, at)));
          const Vec3d p(static_cast<double>(s.radii.x) * reach * std::cos(angle),
                        static_cast<double>(s.radii.y) * reach * std::sin(angle), at);
          return std::pair(p, raywalk::dot(gradient(s, p), p - eye));
        };
        const double h = 1e-4 * (high(s) - low(s));
        const auto [p, f] = slope_at(z);
        const double rate = (slope_at(z + h).second - f) / h;
        if (std::abs(f) < least) least = std::abs(f), best = p;
        if (rate != 0 && std::isfinite(f / rate)) z = std::clamp(z - f / rate, low(s), high(s));
      }
    }
    return best;
  }
  static Vec3d gradient(const S& s, const Vec3d& p) {
    const Vec3d r(s.radii);
    const double z = p.z / (r.z * r.z);
    const double along = Kind == QuadricKind::ellipsoid             ? z
                         : Kind == QuadricKind::elliptic_paraboloid ? -0.5
                         : Kind == QuadricKind::cone                ? -p.z
                         : Kind == QuadricKind::cylinder            ? 0
                                                                    : -z;
    return {p.x / (r.x * r.x), p.y / (r.y * r.y), along};
  }
  static Vec3d special(const S& s, Random& random) {
    if (random.coin() && std::isfinite(s.z_min)) return ring(s, random, random.coin() ? low(s) : high(s), 1);
    const double rz = static_cast<double>(s.radii.z);
    if (Kind == QuadricKind::cone || Kind == QuadricKind::elliptic_paraboloid) return Vec3d(0.0);
    if (Kind == QuadricKind::ellipsoid || Kind == QuadricKind::hyperboloid_two_sheets)
      return {0, 0, random.coin() ? rz : -rz};
    return ring(s, random, 0, 1);
  }
  /// Along a generator, an asymptote or the axis.
  static Vec3d parallel(const S& s, Random& random) {
    const double angle = random.real(-3.2, 3.2);
    const double x = static_cast<double>(s.radii.x), y = static_cast<double>(s.radii.y);
    const double z = Kind == QuadricKind::cone ? 1 : static_cast<double>(s.radii.z);
    const bool slanted = Kind != QuadricKind::cylinder && Kind != QuadricKind::elliptic_paraboloid;
    if (!slanted || random.whole(0, 3) == 0) return {0, 0, random.sign()};
    const Triple p = pythagorean(random);
    if (random.coin()) return Vec3d(x * p.a, y * p.b, z * p.h);  // exact for integers
    return {x * std::cos(angle), y * std::sin(angle), z};
  }
  static Case<S, T> exactly_tangent(Random& random) {
    const Triple p = pythagorean(random);
    const auto power = [&] { return std::ldexp(1.0, random.whole(-8, 8)); };
    const auto small = [&](int low = -9) { return static_cast<double>(random.whole(low, 9)); };
    S s;
    Vec3d touch, u, v;
    switch (Kind) {
      case QuadricKind::ellipsoid:
      case QuadricKind::cylinder:
      case QuadricKind::hyperboloid_one_sheet: {
        const double x = power(), y = power(), z = power();
        s.radii = Vec3<T>(Vec3d(p.h * x, p.h * y, p.h * z));
        touch = {p.a * x, p.b * y, Kind == QuadricKind::cylinder ? small() : 0};
        u = {-p.b * x, p.a * y, 0}, v = {0, 0, z};
        break;
      }
      case QuadricKind::elliptic_paraboloid: {
        const double x = small(1), y = small(1), m = small(), n = small();
        s.radii = Vec3<T>(Vec3d(x, y, 1));
        touch = {x * m, y * n, m * m + n * n}, u = {x, 0, 2 * m}, v = {0, y, 2 * n};
        break;
      }
      case QuadricKind::cone: {
        const double x = small(1), y = small(1);
        s.radii = Vec3<T>(Vec3d(x, y, 1));
        touch = {x * p.a, y * p.b, static_cast<double>(p.h)}, u = {-x * p.b, y * p.a, 0}, v = touch;
        break;
      }
      case QuadricKind::hyperboloid_two_sheets: {
        const double x = power(), z = power(), b = std::max(1, std::abs(p.b));
        const double a = p.b == 0 ? 0 : p.a, h = p.b == 0 ? 1 : p.h;
        s.radii = Vec3<T>(Vec3d(b * x, power(), b * z));
        touch = {a * x, 0, h * z}, u = {h * x, 0, a * z}, v = {0, 1, 0};
        break;
      }
    }
    double k = small(), l = small();
    if (k == 0 && l == 0) k = 1;
    const Vec3d d = k * u + l * v;
    return {s, {Vec3<T>(touch - static_cast<double>(random.whole(-20, 20)) * d), Vec3<T>(d)}};
  }
};

}  // namespace raywalk::check
