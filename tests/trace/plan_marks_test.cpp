// Where lines of checkers, rims of spot lights and shadows on circles divide outlines, against what they are by
// definition.

#include "trace/plan_marks.h"
#include "trace/flat_refraction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.h"

using namespace raywalk;

namespace {

Outline side(const Vec2d& from, const Vec2d& to) { return {OutlineSide{from, to}, 0}; }
Outline circle(const Vec2d& centre, double radius) { return {OutlineCircle{centre, radius}, 0}; }

bool has(const std::vector<Vec2d>& points, const Vec2d& point) {
  return std::any_of(points.begin(), points.end(), [&](const Vec2d& at) { return length(at - point) < 1e-12; });
}

/// The points that part `shade` of neighbours on a circle, by a search of it all.
template <class Shade>
std::vector<Vec2d> changes(const OutlineCircle& on, const Shade& shade) {
  constexpr int steps = 20000;
  const auto at = [&](double turn) {
    const double angle = 2 * std::numbers::pi * turn;
    return on.centre + on.radius * Vec2d(std::cos(angle), std::sin(angle));
  };
  std::vector<Vec2d> found;
  for (int i = 0; i < steps; ++i) {
    double low = (i + 0.5) / steps, high = (i + 1.5) / steps;
    const auto before = shade(at(low));
    if (before == shade(at(high))) continue;
    while (high - low > 1e-15) {
      const double middle = (low + high) / 2;
      if (middle == low || middle == high) break;
      (shade(at(middle)) == before ? low : high) = middle;
    }
    found.push_back(at(low));
  }
  return found;
}

}  // namespace

TEST_CASE("a checker's lines on a straight outline lie a square apart, counted from where u and v begin") {
  const Vec2d from{1, 2}, to{4, 6};
  const auto uv = [&](const Vec2d& at) { return Vec2d(length(at - from), 0.3); };
  const auto lines = checker_lines(side(from, to), {from, to}, 2, 64, uv);
  REQUIRE(lines);
  CHECK(has(*lines, from + 2.0 * Vec2d(0.6, 0.8)));
  CHECK(has(*lines, from + 4.0 * Vec2d(0.6, 0.8)));
  CHECK(lines->size() == 3);  // with that at u = 0
  CHECK_FALSE(checker_lines(side(from, to), {from, to}, 0.01, 64, uv));
  // Aslant to both axes.
  const auto aslant = checker_lines(side(from, to), {from, to}, 1, 64, [](const Vec2d& at) { return at; });
  REQUIRE(aslant);
  CHECK(has(*aslant, {2.5, 4}));
  CHECK(has(*aslant, {2, 2 + 4.0 / 3}));
  CHECK(aslant->size() == 9);
}

TEST_CASE("a checker's lines on a circle lie a square apart, and where its angles begin anew") {
  const OutlineCircle on{{0.4, -0.2}, 1.5};
  const double size = 0.7;
  const auto even = [&](const Vec2d& at) {
    const double along = on.radius * std::atan2(at.y - on.centre.y, at.x - on.centre.x);
    return static_cast<int>(std::floor(along / size));
  };
  OutlineStretch around;
  for (int i = 0; i <= 16; ++i) {
    const double angle = 2 + i * 0.35;  // over the seam
    around.push_back(on.centre + on.radius * Vec2d(std::cos(angle), std::sin(angle)));
  }
  const auto lines = checker_lines(circle(on.centre, on.radius), around, size, 64, {});
  REQUIRE(lines);
  int inside = 0;
  for (const Vec2d& change : changes(on, even)) {
    double angle = std::atan2(change.y - on.centre.y, change.x - on.centre.x);
    if (angle < 2) angle += 2 * std::numbers::pi;
    if (angle > 2 + 16 * 0.35) continue;
    CAPTURE(change.x, change.y);
    CHECK(has(*lines, change));
    ++inside;
  }
  CHECK(inside == static_cast<int>(lines->size()));
  CHECK(inside > 10);
  CHECK_FALSE(checker_lines(circle(on.centre, on.radius), around, 0.01, 64, {}));
}

TEST_CASE("a spot light's rims stand where its light begins to fall off and where it ends") {
  for (const double rise : {0.0, 1.0}) {
    const SpotLight light{{-1, 0.5, 0}, {3, -0.7, rise}, 70, 50, {}};
    const SpotLight::Prepared<double> spot(light);
    const auto shade = [&](const Vec2d& at) {
      const double falloff = spot.falloff(normalize(Vec3d(light.position.x - at.x, light.position.y - at.y, 0)));
      return falloff >= 1 ? 2 : falloff > 0 ? 1 : 0;
    };
    // Round about it, beside it, and beyond.
    for (const OutlineCircle& on :
         {OutlineCircle{{-1, 0.5}, 2}, OutlineCircle{{0, 0}, 4}, OutlineCircle{{3, 0}, 1.9}}) {
      const std::vector<Vec2d> rims = spot_rims(circle(on.centre, on.radius), plan(light.position), spot);
      const std::vector<Vec2d> expected = changes(on, shade);
      CHECK(expected.size() >= 4);
      for (const Vec2d& at : expected) {
        CAPTURE(rise, on.radius, at.x, at.y);
        CHECK(std::any_of(rims.begin(), rims.end(), [&](const Vec2d& rim) { return length(at - rim) < 1e-7; }));
      }
    }
    for (const Outline& wall : {side({5, -9}, {5.5, 9}), Outline{OutlineWall{{5, -9}, {18, -0.5}}, 0}}) {
      const std::vector<Vec2d> rims = spot_rims(wall, plan(light.position), spot);
      CHECK(rims.size() == 4);
      for (const Vec2d& at : rims) {
        CHECK(cross(at - Vec2d(5, -9), Vec2d(0.5, 18)) == Approx(0).margin(1e-12));
        const Vec3d to_light = normalize(Vec3d(light.position.x - at.x, light.position.y - at.y, 0));
        const double cosine = -dot(to_light, spot.axis);
        CHECK(std::min(std::abs(cosine - spot.cos_inner), std::abs(cosine - spot.cos_outer)) < 1e-14);
      }
    }
    CHECK(spot_rims(side({-5, -9}, {-5, 9}), plan(light.position), spot).empty());  // behind it
  }
}

TEST_CASE("shadows on a circle begin and end at its marks") {
  const OutlineCircle on{{2, 1}, 1.5};
  const std::vector<Outline> outlines{circle(on.centre, on.radius), circle({-0.6, 1.2}, 0.3),
                                      side({-1, 2.2}, {0.5, 1.8})};
  const auto hidden_by_circle = [](const Vec2d& at, const Vec2d& to, const OutlineCircle& by, double t_max) {
    // The nearest point to the centre on the way to the light.
    const double t = std::clamp(dot(by.centre - at, to) / dot(to, to), 1e-9, t_max);
    return length(at + t * to - by.centre) < by.radius - 1e-9;
  };
  for (const PlanLight& light : {PlanLight{{-5, 2}}, PlanLight{{-4, 1.5}, true}}) {
    const double t_max = light.is_distant ? 100 : 1;
    const auto lit = [&](const Vec2d& at) {
      const Vec2d to = light.is_distant ? light.place : light.place - at;
      if (!(dot(to, at - on.centre) > 0)) return false;
      if (hidden_by_circle(at, to, std::get<OutlineCircle>(outlines[1].shape), t_max)) return false;
      const auto& edge = std::get<OutlineSide>(outlines[2].shape);
      return (cross(to, edge.from - at) > 0) == (cross(to, edge.to - at) > 0);
    };
    const std::vector<Vec2d> marks = shadows_on_circle(on, outlines, light), expected = changes(on, lit);
    CHECK(expected.size() == 6);
    for (const Vec2d& at : expected) {
      CAPTURE(light.is_distant, at.x, at.y);
      CHECK(std::any_of(marks.begin(), marks.end(), [&](const Vec2d& mark) { return length(at - mark) < 1e-6; }));
    }
  }
}

TEST_CASE("the critical angle is where the sine to the normal is that of the indices") {
  const Vec2d from{1, -2};
  for (const Outline& face :
       {side({-3, 2}, {5, 4}), Outline{OutlineWall{{-3, 2}, {-2, 8}}, 0}, side({5, -4}, {-3, -6})}) {
    const Vec2d normal = Vec2d(-2, 8) / std::sqrt(68.0);
    const std::vector<Vec2d> points = seen_at_sine(face, from, 2.0 / 3);
    REQUIRE(points.size() == 2);
    CHECK(length(points[0] - points[1]) > 1);
    for (const Vec2d& at : points)
      CHECK(std::abs(dot(normal, at - from)) == Approx(std::sqrt(5.0) / 3 * length(at - from)).epsilon(1e-12));
  }
}

TEST_CASE(
    "beyond flat glass the middle ray is Snell's, the rays seem to come from one point, and equal indices bend none") {
  const Vec2d eye{0.3, 1.2}, normal{0.2, 2};  // of the face through the origin, towards the eye
  const Vec2d up = normal / length(normal), along{up.y, -up.x};
  for (const auto& [n1, n2] : {std::pair{1.0, 1.5}, {1.33, 1.5}, {1.5, 1.33}, {1.0, 1.0}, {1.4, 1.4}}) {
    for (const double tangent : {0.0, 0.4, -0.9}) {
      const double cos_in = 1 / std::sqrt(1 + tangent * tangent), sin_out = n1 / n2 * tangent * cos_in;
      const double cos_out = std::sqrt(1 - sin_out * sin_out);
      const FlatRefraction face(normal, n1, n2, cos_in, cos_out);
      const Vec2d middle = tangent * along - up, snell = sin_out * along - cos_out * up;
      CAPTURE(n1, n2, tangent);
      CHECK(cross(face.bent(middle), snell) == Approx(0).margin(1e-15));
      CHECK(dot(face.bent(middle), snell) > 0);
      CHECK(face.off(middle) < 1e-15);
      const Vec2d seems = -face.bent(-eye);
      for (const double beside : {-0.2, -0.01, 0.01, 0.2}) {
        const Vec2d direction = middle + beside * along;
        const Vec2d point = eye - dot(eye, up) / dot(direction, up) * direction;  // on the face
        CHECK(cross(point - seems, face.bent(direction)) == Approx(0).margin(1e-15));
        if (n1 == n2) CHECK((face.off(direction) == 0 && face.bent(direction) == direction && seems == eye));
        // By the angles themselves.
        const double in = std::atan(tangent + beside), out = std::asin(n1 / n2 * std::sin(in));
        const double taken = std::atan((tangent + beside) * cos_in / cos_out * n1 / n2);
        CHECK(face.off(direction) == Approx(std::abs(taken - out)).margin(1e-14));
        if (n1 != n2 && std::abs(beside) > 0.1) CHECK(face.off(direction) > 1e-4);
      }
    }
  }
}
