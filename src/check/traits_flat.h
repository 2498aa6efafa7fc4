#pragma once
// Traits of the flat-faced shapes.

#include "check/traits_round.h"

#include <vector>

namespace raywalk::check {

template <class T>
struct ShapeTraits<Plane<T>> {
  using S = Plane<T>;
  static constexpr bool placed = false;
  static S make(Random& random, double scale, const Vec3d& centre) {
    const Vec3d normal = random.whole(0, 3) == 0 ? ShapeTraits<Sphere<T>>::parallel({}, random) : random.unit();
    return {Vec3<T>(centre + scale * random.in_box()),
            Vec3<T>(random.coin() ? normal : random.magnitude(-3, 3) * normal)};
  }
  static double size(const S& s) { return std::max(1e-9, length(Vec3d(s.point))); }
  static Vec3d centre(const S& s) { return Vec3d(s.point); }
  static Vec3d in_plane(const S& s, Random& random) { return across(Vec3d(s.normal), random); }
  static Vec3d surface(const S& s, Random& random) {
    return centre(s) + random.real(0, 2) * size(s) * in_plane(s, random);
  }
  static Vec3d interior(const S& s, Random& random) { return surface(s, random); }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& eye) { return eye + size(s) * in_plane(s, random); }
  static Vec3d special(const S& s, Random& random) { return surface(s, random); }
  static Vec3d parallel(const S& s, Random& random) { return in_plane(s, random); }
  /// In the plane or beside it, exactly parallel: no intersection.
  static Case<S, T> exactly_tangent(Random& random) {
    const auto whole = [&](int reach) { return static_cast<double>(random.whole(-reach, reach)); };
    const Vec3d normal(whole(30), whole(30), random.whole(1, 30)), v(whole(30), whole(30), random.whole(1, 30));
    Vec3d along = raywalk::cross(normal, v);
    if (along == Vec3d(0.0)) along = {-normal.z, 0, normal.x};
    const Vec3d point(whole(999), whole(999), whole(999)), beside = random.coin() ? Vec3d(0.0) : whole(9) * normal;
    return {{Vec3<T>(point), Vec3<T>(normal)}, {Vec3<T>(point + whole(9) * along + beside), Vec3<T>(along)}};
  }
};

template <class T>
struct ShapeTraits<Box<T>> {
  using S = Box<T>;
  static constexpr bool placed = false;
  static S make(Random& random, double scale, const Vec3d& centre) {
    const Vec3d low = centre + scale * random.in_box();
    S s{Vec3<T>(low), Vec3<T>(low)};
    const int flat = random.whole(0, 7);
    for (int axis = 0; axis < 3; ++axis)
      if (axis != flat) s.max[axis] = std::max(s.min[axis], static_cast<T>(low[axis] + scale * random.real(0.1, 2)));
    return s;
  }
  static double size(const S& s) { return length(Vec3d(s.max) - Vec3d(s.min)) / 2; }
  static Vec3d centre(const S& s) { return Vec3d(s.min) + 0.5 * (Vec3d(s.max) - Vec3d(s.min)); }
  static Vec3d interior(const S& s, Random& random) {
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = static_cast<double>(s.min[axis]) +
                random.real(0, 1) * (static_cast<double>(s.max[axis]) - static_cast<double>(s.min[axis]));
    return p;
  }
  static void clamp_some(const S& s, Random& random, Vec3d& p, int count) {
    const int first = random.whole(0, 2);
    for (int i = 0; i < count; ++i) {
      const int axis = (first + i) % 3;
      p[axis] = static_cast<double>(random.coin() ? s.min[axis] : s.max[axis]);
    }
  }
  static Vec3d surface(const S& s, Random& random) {
    Vec3d p = interior(s, random);
    clamp_some(s, random, p, 1);
    return p;
  }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& /*eye*/) {
    Vec3d p = interior(s, random);
    clamp_some(s, random, p, 2);
    return p;
  }
  static Vec3d special(const S& s, Random& random) {
    Vec3d p = interior(s, random);
    clamp_some(s, random, p, random.whole(2, 3));
    return p;
  }
  static Vec3d parallel(const S& /*s*/, Random& random) {
    Vec3d d = random.in_box();
    d[random.whole(0, 2)] = 0;
    if (random.coin()) d = ShapeTraits<Sphere<T>>::parallel({}, random);
    return d;
  }
  /// Exactly through an edge or a corner, or along a face.
  static Case<S, T> exactly_tangent(Random& random) {
    S s;
    for (int axis = 0; axis < 3; ++axis) {
      s.min[axis] = static_cast<T>(random.whole(-99, 99));
      s.max[axis] = s.min[axis] + static_cast<T>(random.whole(axis == 0 ? 0 : 1, 99));
    }
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = random.whole(static_cast<int>(s.min[axis]), static_cast<int>(s.max[axis]));
    clamp_some(s, random, p, random.whole(1, 3));
    Vec3d d(random.whole(-9, 9), random.whole(-9, 9), random.whole(-9, 9));
    if (d == Vec3d(0.0)) d.x = 1;
    return {s, {Vec3<T>(p - static_cast<double>(random.whole(-3, 9)) * d), Vec3<T>(d)}};
  }
};

template <class T>
struct ShapeTraits<Triangle<T>> {
  using S = Triangle<T>;
  static constexpr bool placed = false;
  static S make(Random& random, double scale, const Vec3d& centre) {
    const Vec3d a = centre + scale * random.in_box();
    const Vec3d b = a + scale * random.in_box();
    Vec3d c = a + scale * random.in_box();
    if (random.whole(0, 5) == 0) c = a + random.real(0, 1) * (b - a) + scale * random.magnitude(-8, -1) * random.unit();
    return {Vec3<T>(a), Vec3<T>(b), Vec3<T>(c)};
  }
  static double size(const S& s) { return std::max(length(Vec3d(s.b) - Vec3d(s.a)), length(Vec3d(s.c) - Vec3d(s.a))); }
  static Vec3d centre(const S& s) { return Vec3d(s.a); }
  static Vec3d at(const S& s, double u, double v) {
    return Vec3d(s.a) + u * (Vec3d(s.b) - Vec3d(s.a)) + v * (Vec3d(s.c) - Vec3d(s.a));
  }
  static Vec3d surface(const S& s, Random& random) {
    const double u = random.real(0, 1);
    return at(s, u, random.real(0, 1 - u));
  }
  static Vec3d interior(const S& s, Random& random) { return surface(s, random); }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& /*eye*/) {
    const double u = random.real(0, 1);
    const int edge = random.whole(0, 2);
    return edge == 0 ? at(s, u, 0) : edge == 1 ? at(s, 0, u) : at(s, u, 1 - u);
  }
  static Vec3d special(const S& s, Random& random) {
    const int corner = random.whole(0, 2);
    return Vec3d(corner == 0 ? s.a : corner == 1 ? s.b : s.c);
  }
  static Vec3d parallel(const S& s, Random& random) {
    const Vec3d d = at(s, random.real(), random.real()) - Vec3d(s.a);
    return random.coin() ? d : Vec3d(s.b) - Vec3d(s.a);
  }
  static Case<S, T> exactly_tangent(Random& random) {
    const auto corner = [&] { return Vec3d(random.whole(-50, 50), random.whole(-50, 50), random.whole(-50, 50)); };
    const Vec3d a = corner(), b = corner(), c = corner();
    const double k = random.whole(0, 8);
    Vec3d d = corner();
    if (d == Vec3d(0.0)) d.x = 1;
    return {{Vec3<T>(8.0 * a), Vec3<T>(8.0 * b), Vec3<T>(8.0 * c)},
            {Vec3<T>((8 - k) * a + k * b - static_cast<double>(random.whole(-3, 9)) * d), Vec3<T>(d)}};
  }
};

/// A star-shaped polygon of 3 to 9 corners about a point, in plan.
inline std::vector<Vec2d> star(Random& random, double size, const Vec2d& centre) {
  const int corners = random.whole(3, 9);
  std::vector<Vec2d> all;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * (i + random.real(0, 0.8)) / corners, r = size * random.real(0.3, 1.5);
    all.push_back(centre + r * Vec2d(std::cos(angle), std::sin(angle)));
  }
  return all;
}

template <class T>
struct ShapeTraits<Polygon<T>> {
  using S = Polygon<T>;
  static constexpr bool placed = false;
  static S make(Random& random, double scale, const Vec3d& centre) {
    const Vec3d normal = random.whole(0, 3) == 0 ? ShapeTraits<Sphere<T>>::parallel({}, random) : random.unit();
    const Vec3d u = across(normal, random), v = raywalk::cross(normal, u), origin = centre + scale * random.in_box();
    const auto lift = [&](const std::vector<Vec2d>& plan) {
      std::vector<Vec3<T>> loop;
      for (const Vec2d& p : plan) loop.emplace_back(origin + p.x * u + p.y * v);
      return loop;
    };
    S s{lift(star(random, scale, Vec2d(0.0))), {}};
    if (random.coin()) s.holes.push_back(lift(star(random, 0.15 * scale, Vec2d(0.0))));
    return s;
  }
  static double size(const S& s) { return length(Vec3d(s.outline[1]) - Vec3d(s.outline[0])); }
  static Vec3d centre(const S& s) {
    Vec3d sum(0.0);
    for (const auto& corner : s.outline) sum += Vec3d(corner) / static_cast<double>(s.outline.size());
    return sum;
  }
  static std::pair<Vec3d, Vec3d> edge(const S& s, Random& random) {
    const auto& loop = !s.holes.empty() && random.whole(0, 2) == 0 ? s.holes[0] : s.outline;
    const std::size_t i = static_cast<std::size_t>(random.whole(0, static_cast<int>(loop.size()) - 1));
    return {Vec3d(loop[i]), Vec3d(loop[i + 1 == loop.size() ? 0 : i + 1])};
  }
  static Vec3d surface(const S& s, Random& random) {
    const auto [p, q] = edge(s, random);
    const Vec3d on_edge = p + random.real(0, 1) * (q - p);
    return on_edge + random.real(0, 1) * (centre(s) - on_edge);
  }
  static Vec3d interior(const S& s, Random& random) { return surface(s, random); }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& /*eye*/) {
    const auto [p, q] = edge(s, random);
    return p + random.real(0, 1) * (q - p);
  }
  static Vec3d special(const S& s, Random& random) { return edge(s, random).first; }
  static Vec3d parallel(const S& s, Random& random) {
    const auto [p, q] = edge(s, random);
    return random.coin() ? q - p : surface(s, random) - p;
  }
  static Case<S, T> exactly_tangent(Random& random) {
    const int turns = random.whole(0, 2);
    std::vector<Vec3d> corners;
    for (const Vec2d& p : star(random, 40, Vec2d(0.0)))
      corners.push_back(turned(Vec3d(8 * std::round(p.x), 8 * std::round(p.y), 16), turns));
    S s;
    for (const Vec3d& p : corners) s.outline.emplace_back(p);
    const std::size_t i = static_cast<std::size_t>(random.whole(0, static_cast<int>(corners.size()) - 1));
    const double k = random.whole(0, 8);
    const Vec3d on_edge = ((8 - k) * corners[i] + k * corners[(i + 1) % corners.size()]) / 8.0;
    const Vec3d d =
        turned(Vec3d(random.whole(-50, 50), random.whole(-50, 50), random.sign() * random.whole(1, 50)), turns);
    return {s, {Vec3<T>(on_edge - static_cast<double>(random.whole(-3, 9)) * d), Vec3<T>(d)}};
  }
};

template <class T>
struct ShapeTraits<Prism<T>> {
  using S = Prism<T>;
  static constexpr bool placed = true;
  static S make(Random& random, double scale, const Vec3d& /*centre*/) {
    S s;
    for (const Vec2d& p : star(random, scale, scale * plan(random.in_box()))) s.corners.emplace_back(p);
    if (random.coin()) std::reverse(s.corners.begin(), s.corners.end());
    s.height = static_cast<T>(scale * random.real(0.1, 3));
    return s;
  }
  static double half(const S& s) { return static_cast<double>(s.height) / 2; }
  static double size(const S& s) { return length(Vec2d(s.corners[1]) - Vec2d(s.corners[0])) + half(s); }
  static Vec3d centre(const S& s) {
    Vec2d sum(0.0);
    for (const auto& corner : s.corners) sum += Vec2d(corner) / static_cast<double>(s.corners.size());
    return {sum.x, sum.y, 0};
  }
  static std::pair<Vec2d, Vec2d> edge(const S& s, Random& random) {
    const int i = random.whole(0, s.sides() - 1);
    return {Vec2d(s.corner(i)), Vec2d(s.corner_after(i))};
  }
  static Vec3d at(const Vec2d& p, double z) { return {p.x, p.y, z}; }
  static Vec3d interior(const S& s, Random& random) {
    const auto [p, q] = edge(s, random);
    const Vec2d side = p + random.real(0, 1) * (q - p);
    return at(side + random.real(0, 1) * (plan(centre(s)) - side), random.real(-half(s), half(s)));
  }
  static Vec3d surface(const S& s, Random& random) {
    if (random.coin()) return at(plan(interior(s, random)), random.sign() * half(s));
    const auto [p, q] = edge(s, random);
    return at(p + random.real(0, 1) * (q - p), random.real(-half(s), half(s)));
  }
  static Vec3d silhouette(const S& s, Random& random, const Vec3d& /*eye*/) {
    const auto [p, q] = edge(s, random);
    if (random.coin()) return at(p, random.real(-half(s), half(s)));
    return at(p + random.real(0, 1) * (q - p), random.sign() * half(s));
  }
  static Vec3d special(const S& s, Random& random) { return at(edge(s, random).first, random.sign() * half(s)); }
  static Vec3d parallel(const S& s, Random& random) {
    const auto [p, q] = edge(s, random);
    const int which = random.whole(0, 2);
    if (which == 0) return {0, 0, random.sign()};
    return at(q - p, which == 1 ? 0 : random.real() * half(s));
  }
  static Case<S, T> exactly_tangent(Random& random) {
    S s;
    for (const Vec2d& p : star(random, 40, Vec2d(0.0)))
      s.corners.emplace_back(Vec2d(8 * std::round(p.x), 8 * std::round(p.y)));
    s.height = static_cast<T>(16 * random.whole(1, 9));
    const auto [p, q] = edge(s, random);
    const double k = random.whole(0, 8);
    Vec3d on_edge = at(((8 - k) * p + k * q) / 8.0, random.whole(-9, 9));
    if (random.coin()) on_edge.z = random.sign() * half(s);
    Vec3d d(random.whole(-9, 9), random.whole(-9, 9), random.whole(-9, 9));
    if (d == Vec3d(0.0)) d.x = 1;
    return {s, {Vec3<T>(on_edge - static_cast<double>(random.whole(-3, 9)) * d), Vec3<T>(d)}};
  }
};

}  // namespace raywalk::check
