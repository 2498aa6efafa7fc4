// Ray differentials against dual numbers: derivatives that are carried along by automatic differentiation, through
// transfer, reflection and refraction at surfaces that are flat, curved, mapped or shaded smoothly.

#include "trace/ray_differential.h"
#include "accel/primitives.h"
#include "accel/query.h"
#include "support/catch.h"

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

using namespace raywalk;

namespace {

/// v + d epsilon, with epsilon^2 = 0.
struct Dual {
  double v = 0, d = 0;
};
Dual operator+(Dual a, Dual b) { return {a.v + b.v, a.d + b.d}; }
Dual operator-(Dual a, Dual b) { return {a.v - b.v, a.d - b.d}; }
Dual operator*(Dual a, Dual b) { return {a.v * b.v, a.d * b.v + a.v * b.d}; }
Dual operator/(Dual a, Dual b) { return {a.v / b.v, (a.d * b.v - a.v * b.d) / (b.v * b.v)}; }
Dual root(Dual a) { return {std::sqrt(a.v), a.d / (2 * std::sqrt(a.v))}; }

struct Dual3 {
  Dual x, y, z;
  [[nodiscard]] Vec3d value() const { return {x.v, y.v, z.v}; }
  [[nodiscard]] Vec3d derivative() const { return {x.d, y.d, z.d}; }
};
Dual3 dual(const Vec3d& v, const Vec3d& d = Vec3d(0.0)) { return {{v.x, d.x}, {v.y, d.y}, {v.z, d.z}}; }
Dual3 operator+(Dual3 a, Dual3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Dual3 operator-(Dual3 a, Dual3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Dual3 operator*(Dual a, Dual3 b) { return {a * b.x, a * b.y, a * b.z}; }
Dual dot(Dual3 a, Dual3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Dual3 unit(Dual3 a) { return (Dual{1} / root(dot(a, a))) * a; }
Dual3 mapped(const Affine<double>& m, Dual3 v) { return v.x * dual(m.x) + v.y * dual(m.y) + v.z * dual(m.z); }
Dual3 operator*(Dual3, Dual) = delete;

/// A surface as an equation F = 0 in its own space, with its gradient, and the normal that rays are bent by.
struct Truth {
  std::function<Dual(Dual3)> value;
  std::function<Dual3(Dual3)> gradient;
  Affine<double> to_world{}, to_object{};
  std::function<Dual3(Dual3)> normal{};  ///< of a place in the world, if it is not the gradient's; of any length
  double ior = 0;                        ///< 0: a mirror

  [[nodiscard]] Dual3 own(Dual3 place) const { return mapped(to_object, place) + dual(to_object.move); }
  [[nodiscard]] Dual3 normal_at(Dual3 place) const {
    if (normal) return unit(normal(place));
    const Dual3 g = gradient(own(place));  // by the transpose of the map to object space
    return unit({dot(dual(to_object.x), g), dot(dual(to_object.y), g), dot(dual(to_object.z), g)});
  }
};

Truth quadric(double xx, double yy, double zz, double linear, double constant) {
  const auto k = [](double c) { return Dual{c}; };
  return {
      [=](Dual3 p) { return k(xx) * p.x * p.x + k(yy) * p.y * p.y + (k(zz) * p.z + k(linear)) * p.z + k(constant); },
      [=](Dual3 p) { return Dual3{k(2 * xx) * p.x, k(2 * yy) * p.y, k(2 * zz) * p.z + k(linear)}; }};
}
Truth plane(const Vec3d& normal, const Vec3d& point) {
  return {[=](Dual3 p) { return dot(p - dual(point), dual(normal)); }, [=](Dual3) { return dual(normal); }};
}

/// Things inside of a room whose walls are mirrors.
struct Room {
  Primitives<double> primitives;
  std::vector<Truth> truths;

  void add(const Shape<double>& shape, Truth truth, double ior, const Affine<double>& map = {}) {
    truth.ior = ior;
    if (map == Affine<double>{}) {
      primitives.add(shape);
    } else {
      const auto both = *object_transform<double>(map);
      primitives.add(shape, both);
      truth.to_world = both.to_world, truth.to_object = both.to_object;
    }
    truths.push_back(truth);
  }
};

Room room() {
  constexpr double inf = infinity<double>;
  Room all;
  const auto turned = [](double degrees, const Vec3d& scale, const Vec3d& move) {
    return translation(move) * rotation(Vec3d(1, 2, 3), degrees) * scaling(scale);
  };
  Truth ball = quadric(1, 1, 1, 0, -0.64);
  ball.to_object.move = {1.5, 0.2, -0.3};
  all.primitives.add(Sphere<double>{{-1.5, -0.2, 0.3}, 0.8});
  all.truths.push_back(ball);
  all.add(Sphere<double>{{0, 0, 0}, 1}, quadric(1, 1, 1, 0, -1), 1.5, turned(40, {0.9, 0.5, 0.7}, {0.8, 1.4, 0.2}));
  all.add(Ellipsoid<double>{{0.9, 0.6, 0.8}, -inf, inf, false}, quadric(1 / 0.81, 1 / 0.36, 1 / 0.64, 0, -1), 1.33,
          turned(100, {1, 1, 1}, {1.2, -1.3, -0.4}));
  all.add(EllipticParaboloid<double>{{0.7, 0.9, 1}, -inf, 1.5, false}, quadric(1 / 0.49, 1 / 0.81, 0, -1, 0), 0,
          turned(200, {0.8, 0.7, 0.6}, {-1.2, 1.7, -1}));
  all.add(Cone<double>{{0.7, 0.5, 1}, -2, 2, false}, quadric(1 / 0.49, 1 / 0.25, -1, 0, 0), 0,
          turned(290, {0.4, 0.4, 0.4}, {-0.4, -2, 1}));
  all.add(Cylinder<double>{{0.5, 0.7, 1}, -1, 1, false}, quadric(1 / 0.25, 1 / 0.49, 0, 0, -1), 0,
          turned(20, {0.6, 0.6, 0.9}, {2.2, 0.1, 1.4}));
  all.add(HyperboloidOneSheet<double>{{0.4, 0.5, 0.6}, -1, 1, false}, quadric(1 / 0.16, 1 / 0.25, -1 / 0.36, 0, -1), 0,
          turned(70, {0.6, 0.6, 0.6}, {0, 0, -1.8}));
  all.add(HyperboloidTwoSheets<double>{{0.4, 0.5, 0.3}, -1, 1, false}, quadric(1 / 0.16, 1 / 0.25, -1 / 0.09, 0, 1), 0,
          turned(150, {0.7, 0.7, 0.7}, {0.3, 0.2, 2}));
  for (const double side : {-3.0, 3.0})
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d place(0.0), normal(0.1, -0.05, 0.02);
      place[axis] = side, normal[axis] = -side;
      all.add(Plane<double>{place, normal}, plane(normal, place), 0);
    }
  // A mesh of two triangles with bent normals, of which one is seen at a time.
  Mesh mesh;
  mesh.positions = {{-2.2, -2, -1.2}, {-0.6, -2.3, -1.4}, {-0.9, -1, -2}, {-2.4, -0.8, -1.9}};
  mesh.normals = {{-0.4, -0.3, 1}, {0.4, -0.2, 1}, {0.3, 0.5, 1}, {-0.3, 0.4, 2}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  all.primitives.add(mesh, Affine<double>{}, true);
  for (const auto& corners : mesh.triangles) {
    const auto at = [&](int i) {
      return mesh.positions[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
    };
    const auto bent = [&](int i) {
      return dual(normalize(mesh.normals[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])]));
    };
    const Vec3d a = at(0), b = at(1), c = at(2), n = cross(b - a, c - a);
    Truth flat = plane(n, a);
    const Dual3 na = bent(0), nb = bent(1), nc = bent(2);
    // Barycentric weights by areas.
    flat.normal = [=](Dual3 p) {
      const Dual3 area = dual(n), ap = p - dual(a);
      const auto times = [](Dual3 u, Dual3 w) {
        return Dual3{u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x};
      };
      const Dual v = dot(times(ap, dual(c - a)), area) / dot(area, area);
      const Dual w = dot(times(dual(b - a), ap), area) / dot(area, area);
      return (Dual{1} - v - w) * na + v * nb + w * nc;
    };
    all.truths.push_back(flat);
  }
  return all;
}

double error(const Vec3d& found, const Vec3d& right) { return length(found - right) / length(right); }

}  // namespace

TEST_CASE("differentials equal dual numbers, whatever bends the ray") {
  const Room all = room();
  // Of the eye: where it is, and the picture at distance 1.
  const Vec3d eye(-0.2, 0.4, 0.1), forward = normalize(Vec3d(1.2, -0.1, 0.1));
  const Vec3d right = normalize(cross(forward, Vec3d(0.1, 0, 1))), up = cross(right, forward);
  constexpr int width = 160, height = 100;
  constexpr double half = 3.7, step = 2 * half / width;
  double worst = 0;
  int bent[3] = {0, 0, 0};  // mirrored, refracted, totally reflected
  std::vector<int> met(all.truths.size(), 0);
  for (const bool by_x : {true, false})
    for (int pixel = 0; pixel < width * height; pixel += 7) {
      const double u = (2.0 * (pixel % width) + 1 - width) / width * half;
      const double v = (height - 1 - 2.0 * (pixel / width)) / width * half;
      // Of the truth only the derivatives are carried on: its values are those of the ray that is followed.
      Dual3 D = unit(dual(forward) + Dual{u, by_x ? step : 0} * dual(right) + Dual{v, by_x ? 0 : step} * dual(up));
      Ray<double> ray{eye, D.value()};
      RayDerivative<double> found = from_eye(ray.direction, dot(ray.direction, forward), step * (by_x ? right : up));
      Dual3 P = dual(eye);
      worst = std::max(worst, error(found.dD, D.derivative()));
      for (int bounce = 0; bounce < 7; ++bounce) {
        std::optional<Hit<double>> nearest;
        for (int id = 0; id < all.primitives.size(); ++id)
          if (const auto hit = all.primitives.intersect(id, ray, nearest ? nearest->t : infinity<double>))
            nearest = Hit<double>{hit->t, id, hit->part};
        if (!nearest) break;
        const Truth& truth = all.truths[static_cast<std::size_t>(nearest->primitive)];
        const SurfacePoint<double> point =
            all.primitives.surface_at(nearest->primitive, ray, Intersection<double>{nearest->t, nearest->part});
        const Vec3d outward = all.primitives.smooth_normal(nearest->primitive, point).value_or(point.normal);
        // Where a ray grazes, derivatives are large and both of their ways to them lose digits.
        if (std::abs(dot(ray.direction, point.normal)) < 0.15 || std::abs(dot(ray.direction, outward)) < 0.15) break;
        ++met[static_cast<std::size_t>(nearest->primitive)];
        // Transfer: t moves so that F stays 0.
        const Dual3 straight = P + Dual{nearest->t} * D;
        const Dual3 gradient = truth.gradient(truth.own(straight));
        const Dual slope = dot(gradient, mapped(truth.to_object, D));
        P = straight + Dual{0, -truth.value(truth.own(straight)).d / slope.v} * D;
        P = dual(point.position, P.derivative());
        found = transfer(found, ray.direction, nearest->t, point.normal);
        worst = std::max(worst, error(found.dP, P.derivative()));
        // The normal, on the side of the ray.
        const double facing = dot(outward, ray.direction) < 0 ? 1 : -1;
        const Vec3d N = facing * outward;
        Dual3 normal = truth.normal_at(P);
        if (dot(normal.value(), N) < 0) normal = Dual{-1} * normal;
        const HitDifferential<double> same{found.dP, found.dP};
        const Vec3d dN = normal_differential(same, all.primitives, nearest->primitive, point, nearest->part, 0.0, N).x;
        if (length(normal.derivative()) > 1e-12 * length(found.dP))
          worst = std::max(worst, error(dN, normal.derivative()));
        CHECK(length(N - normal.value()) < 1e-13);
        normal = dual(N, normal.derivative());
        // Mirrored or refracted.
        const bool enters = dot(point.normal, ray.direction) < 0;
        const double n1 = enters ? 1 : truth.ior, n2 = enters ? truth.ior : 1;
        const bool glass = truth.ior > 0;
        const Refraction<double> at = glass ? refraction_at(ray.direction, N, n1, n2) : Refraction<double>{};
        Vec3d direction;
        if (glass && !at.total()) {
          if (at.cos_out < 0.15) break;
          const Dual eta{n1 / n2}, cosine = Dual{-1} * dot(D, normal);
          const Dual beyond = root(Dual{1} - eta * eta * (Dual{1} - cosine * cosine));
          D = eta * D + (eta * cosine - beyond) * normal;
          found = refract(found, ray.direction, N, dN, at);
          direction = *refract(ray.direction, N, at);
          ++bent[1];
        } else {
          D = D - (Dual{2} * dot(D, normal)) * normal;
          found = reflect(found, ray.direction, N, dN);
          direction = reflect(ray.direction, N);
          ++bent[glass ? 2 : 0];
          // An interpolated normal may send the ray through the surface.
          if (dot(direction, point.normal) * dot(ray.direction, point.normal) > 0) break;
        }
        worst = std::max(worst, error(found.dD, D.derivative()));
        CHECK(length(direction - D.value()) < 1e-12);
        direction = normalize(direction);
        D = dual(direction, D.derivative());
        ray = {point.position, direction, {nearest->primitive, nearest->part}, 0};
      }
    }
  CAPTURE(worst);
  CHECK(worst < 1e-10);
  for (const int count : bent) CHECK(count > 100);
  for (std::size_t i = 0; i < met.size(); ++i) {
    CAPTURE(i);
    CHECK(met[i] > 20);
  }
}

TEST_CASE("a flat mirror changes nothing but the place") {
  std::mt19937 bits(7);
  const auto number = [&] { return static_cast<double>(bits()) / 0x1p31 - 1; };
  const auto vector = [&] { return Vec3d(number(), number(), number()); };
  for (int i = 0; i < 1000; ++i) {
    const RayDerivative<double> start{vector(), vector()};
    const Vec3d D = normalize(vector()), mirror = normalize(vector()), wall = normalize(vector());
    if (std::abs(dot(D, mirror)) < 0.1 || std::abs(dot(reflect(D, mirror), wall)) < 0.1) continue;
    const double first = 1 + number() / 2, second = 1 + number() / 2;
    // Straight on through the mirror to the mirrored wall, and by the mirror.
    const RayDerivative<double> straight = transfer(start, D, first + second, reflect(wall, mirror));
    const auto at_mirror = transfer(start, D, first, mirror);
    const RayDerivative<double> there =
        transfer(reflect(at_mirror, D, mirror, Vec3d(0.0)), reflect(D, mirror), second, wall);
    CHECK(length(there.dP - reflect(straight.dP, mirror)) < 1e-12 * (1 + length(straight.dP)));
    CHECK(length(there.dD - reflect(straight.dD, mirror)) < 1e-12 * (1 + length(straight.dD)));
  }
}

TEST_CASE("a sampled direction is as wide as its sample's share of all directions") {
  const RayDifferential<double> came{{{1, 0, 0}, {0.001, 0, 0}}, {{0, 1, 0}, {0, 0.001, 0}}};
  const Vec3d direction = normalize(Vec3d(1, 2, 3));
  const auto wide = scattered(came, direction, 4.0, 0.5);
  CHECK(length(wide.x.dD) == Approx(0.25));
  CHECK(length(wide.y.dD) == Approx(0.25));
  CHECK(std::abs(dot(wide.x.dD, wide.y.dD)) < 1e-15);
  CHECK(std::abs(dot(wide.x.dD, direction)) < 1e-15);
  CHECK(wide.x.dP == came.x.dP);
  CHECK(length(scattered(came, direction, 1e12, 0.5).x.dD) == Approx(0.001));
}
