// Pencils: the system matrix equals the derivatives of rays (trace/ray_differential.h), finds the foci that optics has
// in closed form, and loses no light.

#include "trace/pencil.h"

#include "trace/optics.h"
#include "trace/ray_differential.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "support/catch.h"
#include "trace/pencil_derivatives.h"

using namespace raywalk;
using test::Derivatives;
using test::difference;

namespace {

/// Left of a direction in the plan.
Vec3d beside(const Vec3d& direction) { return {-direction.y, direction.x, 0}; }

/// An axis that goes through balls about given places, mirrored or refracted at each surface, followed twice: by its
/// matrix in both planes and by the derivatives of a ray. `offset`, `slope`: of the ray beside the axis at the start.
struct Both {
  Vec3d origin, direction;
  PencilMatrix plan{}, across{};
  RayDerivative<double> in_plan, upright;

  Both(const Vec3d& from, const Vec3d& along, double offset, double slope) : origin(from), direction(normalize(along)) {
    in_plan = {offset * beside(direction), slope * beside(direction)};
    upright = {Vec3d(0, 0, offset), Vec3d(0, 0, slope)};
  }
  void go(double distance) {
    plan = pencil_transfer(distance) * plan, across = pencil_transfer(distance) * across;
    // As to a plane across the axis.
    in_plan = transfer(in_plan, direction, distance, direction),
    upright = transfer(upright, direction, distance, direction);
    origin += distance * direction;
  }
  /// To the sphere, from outside or inside, and on.
  void meet(const Vec3d& centre, double radius, bool from_inside, double n1, double n2, bool refracts) {
    const Vec3d to = centre - origin;
    const double middle = dot(to, direction), off = radius * radius - (dot(to, to) - middle * middle);
    REQUIRE(off > 0);
    const double t = from_inside ? middle + std::sqrt(off) : middle - std::sqrt(off);
    plan = pencil_transfer(t) * plan, across = pencil_transfer(t) * across;
    origin += t * direction;
    const Vec3d outward = (origin - centre) / radius, normal = from_inside ? -outward : outward;
    in_plan = transfer(in_plan, direction, t, normal), upright = transfer(upright, direction, t, normal);
    const double side = from_inside ? -1 : 1, curvature = side / radius;
    const Vec3d turn = side / radius * in_plan.dP, turn_across = side / radius * upright.dP;
    const double cos_in = -dot(direction, normal);
    if (refracts) {
      const Refraction<double> at = refraction_at(direction, normal, n1, n2);
      REQUIRE_FALSE(at.total());
      in_plan = refract(in_plan, direction, normal, turn, at);
      upright = refract(upright, direction, normal, turn_across, at);
      direction = normalize(*refract(direction, normal, at));
      plan = pencil_refraction(ConePlane::of_incidence, curvature, n1, n2, cos_in, at.cos_out) * plan;
      across = pencil_refraction(ConePlane::across, curvature, n1, n2, cos_in, at.cos_out) * across;
    } else {
      in_plan = reflect(in_plan, direction, normal, turn);
      upright = reflect(upright, direction, normal, turn_across);
      direction = normalize(reflect(direction, normal));
      plan = pencil_mirror(ConePlane::of_incidence, curvature, cos_in) * plan;
      across = pencil_mirror(ConePlane::across, curvature, cos_in) * across;
    }
  }
  /// The same ray by both ways.
  void agree(double offset, double slope) const {
    const auto flat = transfer(in_plan, direction, 0.0, direction), up = transfer(upright, direction, 0.0, direction);
    const ParaxialRay own = plan({offset, slope}), own_up = across({offset, slope});
    CHECK(own.offset == Approx(dot(flat.dP, beside(direction))).epsilon(1e-10).margin(1e-10));
    CHECK(own.slope == Approx(dot(flat.dD, beside(direction))).epsilon(1e-10).margin(1e-10));
    CHECK(own_up.offset == Approx(up.dP.z).epsilon(1e-10).margin(1e-10));
    CHECK(own_up.slope == Approx(up.dD.z).epsilon(1e-10).margin(1e-10));
  }
};

}  // namespace

TEST_CASE("pencils equal the derivatives of rays through transfer, refraction, mirrors and curved surfaces") {
  for (const double offset : {0.0, 1.0})
    for (const double slope : {1.0, -0.4}) {
      Both both({-4, 0.2, 0}, {1, 0.03, 0}, offset, slope);
      both.go(0.7);
      both.agree(offset, slope);
      // Through a ball of glass, off a ball of chrome, and inside of a large mirror.
      both.meet({0, 0, 0}, 1, false, 1, 1.5, true);
      both.agree(offset, slope);
      both.meet({0, 0, 0}, 1, true, 1.5, 1, true);
      both.agree(offset, slope);
      both.meet({4, 0.5, 0}, 1.2, false, 1, 1, false);
      both.agree(offset, slope);
      both.meet({0, 1, 0}, 9, true, 1, 1, false);
      both.agree(offset, slope);
      both.go(2);
      both.agree(offset, slope);
    }
}

TEST_CASE("a ball lens focuses at f = n D / (4 (n - 1)) from its centre") {
  for (const double n : {1.3, 1.5, 1.8}) {
    const double diameter = 1.4, radius = diameter / 2;
    for (const ConePlane plane : {ConePlane::of_incidence, ConePlane::across}) {
      const PencilMatrix lens = pencil_refraction(plane, -1 / radius, n, 1, 1, 1) * pencil_transfer(diameter) *
                                pencil_refraction(plane, 1 / radius, 1, n, 1, 1);
      // From its back, where the light leaves it.
      CHECK(*focus_of_parallel(lens) + radius == Approx(n * diameter / (4 * (n - 1))).epsilon(1e-12));
    }
  }
}

TEST_CASE("a hollow mirror's two foci are Coddington's: 1/s + 1/s' is 2 / (R cos) in the plan, 2 cos / R across it") {
  const double radius = 2;
  for (const double degrees : {0.0, 20.0, 55.0})
    for (const double source : {1.7, 5.0}) {
      const double cosine = std::cos(degrees * std::numbers::pi / 180);
      const auto focus = [&](ConePlane plane) {
        return *focus_of_point(pencil_mirror(plane, -1 / radius, cosine) * pencil_transfer(source));
      };
      CHECK(1 / source + 1 / focus(ConePlane::of_incidence) == Approx(2 / (radius * cosine)).epsilon(1e-12));
      CHECK(1 / source + 1 / focus(ConePlane::across) == Approx(2 * cosine / radius).epsilon(1e-12));
    }
}

TEST_CASE("no light is lost between rays: the determinant is n1 / n2") {
  for (const double cos_in : {1.0, 0.7, 0.2})
    for (const double curvature : {-1.5, 0.0, 0.8}) {
      const double n1 = 1.1, n2 = 1.6, sine = n1 / n2 * std::sqrt(1 - cos_in * cos_in);
      const double cos_out = std::sqrt(1 - sine * sine);
      for (const ConePlane plane : {ConePlane::of_incidence, ConePlane::across}) {
        CHECK(pencil_refraction(plane, curvature, n1, n2, cos_in, cos_out).determinant() ==
              Approx(n1 / n2).epsilon(1e-13));
        CHECK(pencil_mirror(plane, curvature, cos_in).determinant() == Approx(1).epsilon(1e-13));
      }
    }
  CHECK(pencil_transfer(3).determinant() == 1);
  const PencilMatrix whole = pencil_transfer(2) * pencil_mirror(ConePlane::of_incidence, 0.4, 0.5) * pencil_transfer(3);
  CHECK(whole.determinant() == Approx(1).epsilon(1e-13));
}

TEST_CASE("a flat mirror changes nothing but left and right") {
  const PencilMatrix flat = pencil_mirror(ConePlane::of_incidence, 0, 0.6);
  CHECK(flat.a == -1);
  CHECK(flat.b == 0);
  CHECK(flat.c == 0);
  CHECK(flat.d == -1);
  // Seen in it, a point is as far behind it as it is before it.
  CHECK(*focus_of_point(flat * pencil_transfer(3)) == -3);
  CHECK_FALSE(focus_of_parallel(flat).has_value());
}

namespace {

struct Point {
  Vec3d normal;
};
/// A surface about a point of it, whose normal turns by this much on the way along it: as two curvatures do at right
/// angles to each other, the first of them this way.
struct Bent {
  Vec3d way, other;
  double curvature, upright;

  [[nodiscard]] Vec3d normal_derivative(int /*primitive*/, const Point& /*at*/, int /*part*/, double /*time*/,
                                        const Vec3d& along) const {
    return curvature * dot(along, way) * way + upright * dot(along, other) * other;
  }
};

/// Directions, and numbers of -1 to 1, of no pattern.
class Unpatterned {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11U) * 0x1p-52 - 1;
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d d(next(), next(), next());
      if (const double size = length(d); size > 0.1 && size < 1) return d / size;
    }
  }

 private:
  std::uint64_t state_ = 1987;
};

}  // namespace

TEST_CASE("a surface has its curvatures towards the ray, in the plan and across it") {
  const Point point{{0.6, 0.8, 0}};
  const Bent bent{{-0.8, 0.6, 0}, {0, 0, 1}, 0.5, 2};
  const Vec3d along = normalize(Vec3d(-1, -0.2, 0));
  const double cosine = -dot(along, point.normal);
  for (const bool from_outside : {true, false}) {
    const double side = from_outside ? 1 : -1;
    const PencilSurface met = pencil_surface(bent, 0, 0, point, 0.0, side * along);
    CHECK(met.normal == side * point.normal);
    CHECK(met.cos_in == Approx(cosine).epsilon(1e-15));
    CHECK(met.curvature == Approx(side * 0.5).epsilon(1e-15));
    CHECK(met.upright == Approx(side * 2).epsilon(1e-15));
    CHECK(met.twist == 0);
    const PencilSystem mirror = mirrored_by(met), glass = refracted_by(met, 1, 1.5, 0.9);
    CHECK((mirror.is_unmixed() && glass.is_unmixed()));
    CHECK(mirror.plan.c == Approx(pencil_mirror(ConePlane::of_incidence, side * 0.5, met.cos_in).c));
    CHECK(mirror.across.c == Approx(pencil_mirror(ConePlane::across, side * 2, met.cos_in).c));
    CHECK(glass.plan.c == Approx(pencil_refraction(ConePlane::of_incidence, side * 0.5, 1, 1.5, met.cos_in, 0.9).c));
    CHECK(glass.across.c == Approx(pencil_refraction(ConePlane::across, side * 2, 1, 1.5, met.cos_in, 0.9).c));
    // What comes first acts first.
    const PencilSystem later = transferred(3) * mirror;
    CHECK(later.plan({1, 0}).offset == Approx(mirror.plan.a + 3 * mirror.plan.c).epsilon(1e-15));
    CHECK(later.across({1, 0}).offset == Approx(mirror.across.a + 3 * mirror.across.c).epsilon(1e-15));
  }
}

TEST_CASE("in space the 4 x 4 matrix is the derivative of rays, however surfaces lie and are curved") {
  Unpatterned numbers;
  double worst = 0;
  int mirrored = 0, refracted = 0, folded = 0;
  for (int round = 0; round < 300; ++round) {
    Vec3d axis = numbers.direction();
    if (round == 0) axis = {0, 0, 1};  // straight up, where no side is level of itself
    Derivatives beside(axis);
    PencilSystem system;
    double n = 1;
    for (int surface = 0; surface < 4; ++surface) {
      const double distance = 1 + 0.5 * numbers.next();
      // As to a plane across the axis.
      beside.each([&](const auto& one) { return transfer(one, axis, distance, axis); });
      system = transferred(distance) * system;
      Vec3d outward = numbers.direction();
      if (round == 1)
        outward = surface % 2 == 0 ? axis : -axis;  // along the normal, where no plane is that of incidence
      if (std::abs(dot(outward, axis)) < 0.1) continue;
      const Point point{outward};
      const Vec3d way = normalize(cross(outward, numbers.direction()));
      const Bent bent{way, cross(outward, way), numbers.next(), numbers.next()};
      const PencilSurface met = pencil_surface(bent, 0, 0, point, 0.0, axis);
      CHECK(dot(met.normal, axis) < 0);
      beside.each([&](const auto& one) { return transfer(one, axis, 0.0, met.normal); });
      const auto turn = [&](const RayDerivative<double>& one) {
        return (dot(outward, axis) < 0 ? 1.0 : -1.0) * bent.normal_derivative(0, point, 0, 0, one.dP);
      };
      const double other = n == 1 ? 1.5 : 1;
      const auto at = refraction_at(axis, met.normal, n, other);
      const auto bent_axis = surface % 2 == 0 ? refract(axis, met.normal, at) : std::nullopt;
      if (bent_axis) {
        beside.each([&](const auto& one) { return refract(one, axis, met.normal, turn(one), at); });
        system = refracted_by(met, n, other, at.cos_out) * system;
        axis = normalize(*bent_axis), n = other;
        ++refracted;
      } else {
        beside.each([&](const auto& one) { return reflect(one, axis, met.normal, turn(one)); });
        system = mirrored_by(met) * system;
        axis = normalize(reflect(axis, met.normal));
        ++mirrored;
      }
      worst = std::max(worst, difference(system, beside.system(axis)));
    }
    // Where the determinant of the offsets is 0, rays of two slopes meet the axis.
    for (const std::optional<double>& focus : foci_of_point(system)) {
      REQUIRE(focus);
      const PencilSystem there = transferred(*focus) * system;
      const Vec2d axes = ellipse_from_point(there);
      CHECK(axes.y <= 1e-9 * (axes.x + std::abs(*focus)));
      ++folded;
    }
    // All round the axis.
    const Vec2d axes = ellipse_from_point(system);
    double longest = 0, shortest = 1e300;
    for (int i = 0; i < 3600; ++i) {
      const double angle = i * std::numbers::pi / 1800, left = std::cos(angle), up = std::sin(angle);
      const double away = std::hypot(system.plan.b * left + system.left_from_up.b * up,
                                     system.up_from_left.b * left + system.across.b * up);
      longest = std::max(longest, away), shortest = std::min(shortest, away);
    }
    CHECK(axes.x == Approx(longest).epsilon(1e-5));
    CHECK(axes.y == Approx(shortest).margin(2e-3 * axes.x));
  }
  CHECK(worst < 1e-10);
  CHECK(mirrored > 300);
  CHECK(refracted > 300);
  CHECK(folded == 600);
}

TEST_CASE("rays that were parallel, or start together, have their foci in space too") {
  PencilSystem system;  // at EYE itself
  CHECK(*foci_of_point(system)[0] == 0);
  CHECK(*foci_of_point(system)[1] == 0);
  // A hollow mirror of radius 2, from its focus: parallel both ways.
  const PencilSurface hollow{{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, 1, -0.5, -0.5, 0};
  system = mirrored_by(hollow) * transferred(1);
  CHECK_FALSE(foci_of_point(system)[0]);
  CHECK_FALSE(foci_of_point(system)[1]);
  // A gutter in its place: parallel one way, and the other way as from a flat mirror.
  const PencilSurface gutter{{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, 1, -0.5, 0, 0};
  system = mirrored_by(gutter) * transferred(1);
  CHECK_FALSE(foci_of_point(system)[0]);
  CHECK(*foci_of_point(system)[1] == -1);
}
