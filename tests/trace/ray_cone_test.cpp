// The closed areas by which cones are covered, and what mirrors and glass make of their width.

#include "trace/ray_cone.h"

#include "math/random.h"
#include "trace/microfacets.h"
#include "trace/optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

namespace {

/// The area that two discs share, by slices: Gauss' rule in an angle that takes the ends' square roots away.
long double lens_by_slices(long double distance, long double radius) {
  const long double low = std::max(-1.0L, distance - radius), high = std::min(1.0L, distance + radius);
  constexpr int slices = 20000;
  const long double half_turn = std::numbers::pi_v<long double>;
  long double sum = 0;
  for (int i = 0; i < slices; ++i) {
    const long double angle = half_turn * (i + 0.5L) / slices;
    const long double x = low + (high - low) * (1 - std::cos(angle)) / 2;
    const long double off = x - distance;
    const long double half =
        std::min(std::sqrt(std::max(1 - x * x, 0.0L)), std::sqrt(std::max(radius * radius - off * off, 0.0L)));
    sum += 2 * half * (high - low) / 2 * std::sin(angle) * half_turn / slices;
  }
  return sum;
}

/// What facets send on of a ray from above: how far along `across` and in the plane of incidence, over the axis. Half
/// of it is nearer than what is returned.
struct Halves {
  double in_plane, across, away;  ///< and whatever the direction
};
double middle_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
template <class Send>
Halves halves_of(double slope, const Vec3d& axis, Send&& send) {
  const Ggx<double> facets(slope);
  const Vec3d across(0, 1, 0), in_plane = cross(across, axis);
  std::vector<double> along, aside, away;
  for (std::uint32_t i = 0; i < 40000; ++i) {
    RandomKey key{};
    key.sample = i;
    Vec2d u;
    for (int k = 0; k < 2; ++k) {
      key.dimension = static_cast<std::uint32_t>(k);
      u[k] = random_unit<double>(key);
    }
    // By their projected area, whoever looks: as from straight above.
    const std::optional<Vec3d> direction = send(facets.sample_half({0, 0, 1}, u));
    if (!direction) continue;
    const double ahead = dot(*direction, axis), x = dot(*direction, in_plane) / ahead,
                 y = dot(*direction, across) / ahead;
    along.push_back(std::abs(x)), aside.push_back(std::abs(y)), away.push_back(std::sqrt(x * x + y * y));
  }
  return {middle_of(along), middle_of(aside), middle_of(away)};
}

}  // namespace

TEST_CASE("the share of a cone that a disc covers is the closed area of two segments") {
  for (const double radius : {0.01, 0.3, 1.0, 1.7, 20.0})
    for (const double place : {0.001, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99}) {
      // From where one is in the other to where they touch from outside.
      const double inner = std::abs(radius - 1), outer = radius + 1, distance = inner + place * (outer - inner);
      CAPTURE(radius, distance);
      const double expected = static_cast<double>(lens_by_slices(distance, radius) / std::numbers::pi_v<long double>);
      CHECK(share_of_disc(distance, radius) == Approx(expected).epsilon(1e-6));
    }
  CHECK(share_of_disc(0, 0.5) == 0.25);
  CHECK(share_of_disc(0, 3) == 1);
  CHECK(share_of_disc(3, 1) == 0);
  // Little of it: 2/3 of chord times height, to first order.
  const double off = 1e-8, chord = 2 * std::sqrt(off);
  CHECK(share_of_disc(2 - off, 1) == Approx(2 * (2.0 / 3) * chord * (off / 2) / std::numbers::pi).epsilon(1e-6));
}

TEST_CASE("beyond a line through the middle is one half") {
  CHECK(share_beyond(0) == Approx(0.5).epsilon(1e-15));
  CHECK(share_beyond(0.5) + share_beyond(-0.5) == Approx(1).epsilon(1e-15));
  CHECK(share_beyond(1) == 0);
  CHECK(share_beyond(-1) == 1);
}

TEST_CASE("a part of a cone is as wide as its rays are apart") {
  const double size = 1e-4;
  for (const bool flat : {false, true})
    for (const double spread : {0.5, 2.0, -0.25}) {
      const RayCone cone = cone_about({0, 0, 0}, {1, 0, 0}, 0.7, spread, flat);
      const Vec2d u(0.8, 0);
      const RayCone part = part_of_cone(cone, u, size);
      for (const double depth : {0.0, 1.0, 7.0}) {
        // Where a ray that is `size` away, radially or beside it, goes through the plane across the middle one.
        const auto off = [&](const Vec2d& step) {
          const Vec3d from = cone.start(u + size * step) - part.origin, way = cone.direction(u + size * step);
          return length(from + (depth - dot(from, part.axis)) / dot(way, part.axis) * way - depth * part.axis);
        };
        CAPTURE(flat, spread, depth);
        // In space it stays round: of the area of the ellipse.
        const double expected = flat ? off({1, 0}) : std::sqrt(off({1, 0}) * off({0, 1}));
        CHECK(std::abs(part.radius_at(depth)) == Approx(expected).epsilon(1e-3));
      }
    }
}

TEST_CASE("a flat mirror leaves a cone's width as it is, and so does glass without another index") {
  const ConeWidth width{0.3, 0.07};
  for (const double cosine : {1.0, 0.6, 0.1}) {
    for (const bool flat : {false, true}) {
      const ConeWidth out = mirrored_cone(width, 0, cosine, flat);
      CHECK(out.radius == width.radius);
      CHECK(out.spread == width.spread);
      const ConeWidth through = refracted_cone(width, 0.4, 1.3, 1.3, cosine, cosine, flat);
      CHECK(through.radius == Approx(width.radius).epsilon(1e-14));
      CHECK(through.spread == Approx(width.spread).epsilon(1e-14));
    }
  }
}

namespace {

/// A ray at `offset` from the middle of a cone that comes along -y, at angle `angle` to the normal of a ball about the
/// origin, and where it goes: how far from the middle one, and by how much it turns, both across it.
struct Neighbour {
  Vec3d origin, direction;
};
Neighbour after(const Neighbour& ray, double radius, bool from_inside, double n1, double n2, bool refracts) {
  const double b = dot(ray.origin, ray.direction), c = dot(ray.origin, ray.origin) - radius * radius;
  const double root = std::sqrt(b * b - c), t = from_inside ? -b + root : -b - root;
  const Vec3d point = ray.origin + t * ray.direction, outward = normalize(point);
  const Vec3d normal = from_inside ? -outward : outward;
  if (!refracts) return {point, reflect(ray.direction, normal)};
  return {point, normalize(*refract(ray.direction, normal, refraction_at(ray.direction, normal, n1, n2)))};
}

}  // namespace

TEST_CASE("what balls make of a cone's spread is the difference of neighbouring rays") {
  const double radius = 0.8, near = 2.0;  // of the ball; from where the cone comes
  for (const bool inside : {false, true})
    for (const bool refracts : {false, true})
      for (const double degrees : {5.0, 25.0, 40.0})
        for (const bool across : {false, true}) {
          const double angle = degrees * std::numbers::pi / 180;
          // The middle ray meets the ball in (radius, 0, 0); it comes at this angle to the normal there.
          const double side = inside ? -1 : 1;
          const Vec3d direction{-side * std::cos(angle), std::sin(angle), 0};
          const Vec3d hit{radius, 0, 0};
          const double length_in = inside ? 0.4 : near;
          const double n1 = inside ? 1.5 : 1, n2 = inside ? 1 : 1.5;
          const Vec3d apex = hit - length_in * direction;
          const Vec3d sideways = across ? Vec3d(0, 0, 1) : Vec3d(-direction.y, direction.x, 0);
          const double step = 1e-5;
          const Neighbour middle = after({apex, direction}, radius, inside, n1, n2, refracts);
          const Neighbour up = after({apex, normalize(direction + step * sideways)}, radius, inside, n1, n2, refracts);
          const Neighbour down =
              after({apex, normalize(direction - step * sideways)}, radius, inside, n1, n2, refracts);
          const Vec3d out = middle.direction, beside = across ? Vec3d(0, 0, 1) : Vec3d(-out.y, out.x, 0);
          // The plane across the middle ray through its hit: rays are carried there.
          const auto offset = [&](const Neighbour& ray) {
            const double t = dot(hit - ray.origin, out) / dot(ray.direction, out);
            return dot(ray.origin + t * ray.direction - hit, beside);
          };
          const auto slope = [&](const Neighbour& ray) { return dot(ray.direction, beside) / dot(ray.direction, out); };
          const double w = (offset(up) - offset(down)) / (2 * step), s = (slope(up) - slope(down)) / (2 * step);
          const ConeWidth in{length_in, 1};
          const double curvature = (inside ? -1 : 1) / radius, cos_in = std::cos(angle);
          const ConePlane plane = across ? ConePlane::across : ConePlane::of_incidence;
          const double sine = n1 / n2 * std::sin(angle);
          const ConeWidth made = refracts ? refracted(in, plane, curvature, n1, n2, cos_in, std::sqrt(1 - sine * sine))
                                          : mirrored(in, plane, curvature, cos_in);
          CAPTURE(inside, refracts, degrees, across, w, s, made.radius, made.spread);
          // Seen from either side: a mirror turns the plane of incidence over.
          const double turned = w < 0 ? -1 : 1;
          CHECK(made.radius == Approx(turned * w).epsilon(1e-7));
          CHECK(made.spread == Approx(turned * s).epsilon(1e-7).margin(1e-7));
        }
}

TEST_CASE("gloss widens a cone, and nothing narrower than sharp is left as it is") {
  const ConeWidth sharp{0.1, 0.02};
  CHECK(widened(sharp, 0).spread == sharp.spread);
  const double angle = 0.1;
  CHECK(widened(sharp, 1 - std::cos(angle)).spread == Approx(sharp.spread + std::tan(angle)).epsilon(1e-9));
  CHECK(widened(sharp, 1).spread == largest_spread);
}

TEST_CASE("small facets widen a cone by what half of them turn a direction") {
  const double slope = 0.01;
  const ConeWidth sharp{0.1, 0};
  CHECK(widened_by_mirrors(sharp, 0, 0.5, false).spread == sharp.spread);
  CHECK(widened_by_facets(sharp, 0, 1, 1.5, 0.5, 0.8, true).spread == sharp.spread);
  for (const double cos_in : {1.0, 0.8, 0.5}) {
    const Vec3d incident(std::sqrt(1 - cos_in * cos_in), 0, -cos_in), up(0, 0, 1);
    CAPTURE(cos_in);
    const auto check = [&](const Halves& halves, double round, double flat) {
      // A disc has half of its area within 1 / sqrt(2) of its radius, a line half of its length within 1 / 2.
      CHECK(round == Approx(std::sqrt(2) * halves.away).epsilon(cos_in == 1 ? 0.02 : 0.1));
      CHECK(flat == Approx(2 * halves.in_plane).epsilon(0.03));
    };
    check(halves_of(slope, reflect(incident, up),
                    [&](const Vec3d& half) { return std::optional(reflect(incident, half)); }),
          widened_by_mirrors(sharp, slope, cos_in, false).spread,
          widened_by_mirrors(sharp, slope, cos_in, true).spread);
    for (const auto& [n1, n2] : {std::pair(1.0, 1.5), std::pair(1.33, 1.0)}) {
      CAPTURE(n1, n2);
      const Refraction<double> own = refraction_at(incident, up, n1, n2);
      if (own.total()) continue;
      check(
          halves_of(slope, *refract(incident, up, own),
                    [&](const Vec3d& half) { return refract(incident, half, refraction_at(incident, half, n1, n2)); }),
          widened_by_facets(sharp, slope, n1, n2, cos_in, own.cos_out, false).spread,
          widened_by_facets(sharp, slope, n1, n2, cos_in, own.cos_out, true).spread);
    }
  }
  CHECK(widened_by_mirrors(sharp, 1, 0.5, false).spread == Approx(std::sqrt(2) * 1.5));
  // Squares add up; a cone that narrows widens by all of it.
  CHECK(widened_by_mirrors({0.1, 1}, std::numbers::sqrt3 / 4, 1, true).spread == Approx(std::sqrt(2)));
  CHECK(widened_by_mirrors({0.1, -0.5}, std::numbers::sqrt3 / 4, 1, true).spread == Approx(0.5));
  CHECK(widened_by_facets(sharp, 1, 1.5, 1, 0.75, 0, false).spread == largest_spread);  // along the surface
}
