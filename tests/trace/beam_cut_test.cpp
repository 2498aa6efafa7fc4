// Where beams are cut, against rationals and roots of 320 bits: random plans and plans on a lattice, where corners
// coincide, edges touch circles and mirrors stand on end.

#include "trace/unfolded_plan.h"

#include "math/random.h"
#include "support/catch.h"
#include "support/effort.h"

#ifdef RAYWALK_GMP
#include "trace/beam_truth.h"
#endif

#include <cmath>
#include <numeric>
#include <vector>

using namespace raywalk;

namespace {

constexpr Place pixel_begin{0, 0}, pixel_end{1, 0};

/// Widths as they are, without rounding: each of the two sums is exact.
void check_whole(const std::vector<BeamPart>& parts, const Place& begin = pixel_begin, const Place& end = pixel_end) {
  REQUIRE_FALSE(parts.empty());
  CHECK(parts.front().begin == begin);
  CHECK(parts.back().end == end);
  Place sum;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) CHECK(parts[i].begin == parts[i - 1].end);
    CHECK(parts[i].width() > 0);
    sum.high += parts[i].end.high - parts[i].begin.high;
    sum.low += parts[i].end.low - parts[i].begin.low;
  }
  CHECK(sum == Place{end.high - begin.high, end.low - begin.low});
}

double covered(const std::vector<BeamPart>& parts, int outline) {
  double sum = 0;
  for (const BeamPart& part : parts)
    if (part.outline == outline) sum += part.width();
  return sum;
}

Outline side(const Vec2d& from, const Vec2d& to, int object) { return {OutlineSide{from, to}, object}; }
Outline circle(const Vec2d& centre, double radius, int object) { return {OutlineCircle{centre, radius}, object}; }
Outline wall(const Vec2d& at, const Vec2d& normal, int object) { return {OutlineWall{at, normal}, object}; }

/// From the origin, ahead: from y = -1 to y = 1 at x = 1.
constexpr PixelFan fan_ahead{{1, -1}, {1, 1}};

}  // namespace

TEST_CASE("a side covers what lies between its ends") {
  // At x = 2 the fan is 4 wide: from -1 to 0.5 are three eighths of it.
  const std::vector<Outline> plan{side({2, -1}, {2, 0.5}, 0)};
  const auto parts = UnfoldedPlan(plan, Vec2d(0.0)).cut(fan_ahead);
  check_whole(parts);
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].outline == 0);
  CHECK(parts[1].begin.value() == 0.25);
  CHECK(parts[1].width() == 0.375);
  CHECK(covered(parts, -1) == 0.625);
}

TEST_CASE("a circle covers what lies between the rays that touch it") {
  // Touched by rays of the slope tan(asin(3/5)) = 3/4 about the axis.
  const std::vector<Outline> plan{circle({5, 0}, 3, 0)};
  const auto parts = UnfoldedPlan(plan, Vec2d(0.0)).cut(fan_ahead);
  check_whole(parts);
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].begin.value() == 0.125);
  CHECK(parts[1].width() == 0.75);
}

TEST_CASE("what is nearer hides what is farther, and crossing outlines hide each other in part") {
  // A slope from (2, -2) to (4, 4) crosses the side at x = 3 in (3, 1).
  const std::vector<Outline> plan{side({3, -3}, {3, 3}, 0), side({2, -2}, {4, 4}, 1)};
  const auto parts = UnfoldedPlan(plan, Vec2d(0.0)).cut(fan_ahead);
  check_whole(parts);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].outline == 1);
  CHECK(parts[0].end.value() == Approx(2.0 / 3).epsilon(1e-15));
  CHECK(parts[1].outline == 0);
}

TEST_CASE("a flat mirror shows the plan reflected, and nothing that stands behind it") {
  // A mirror along y = x from (1, 1) to (3, 3), seen from (4, 0): rays towards -x come back towards -y.
  const std::vector<Outline> plan{side({1, 1}, {3, 3}, 0), side({2.25, -2}, {3, -2}, 1), side({1.5, 3}, {2, 3}, 2)};
  const Vec2d eye(4, 0);
  const PixelFan fan{{-1, 0.25}, {-1, 1.5}};
  const UnfoldedPlan seen(plan, eye);
  const auto parts = seen.cut(fan);
  check_whole(parts);
  REQUIRE(parts.size() == 2);
  REQUIRE(parts[1].outline == 0);
  const UnfoldedPlan through = seen.mirrored(0);
  CHECK(through.virtual_eye() == Vec2d(0, 4));
  const auto beyond = through.cut(fan, parts[1].begin, parts[1].end);
  check_whole(beyond, parts[1].begin, parts[1].end);
  REQUIRE(beyond.size() == 3);
  CHECK(beyond[1].outline == 1);
  // Seen from (0, 4) it is mirrored to (-2, 2.25) and (-2, 3): from (4, 0) the slopes 3/8 and 1/2, an eighth of 5/4.
  CHECK(beyond[1].width() == Approx(0.1));
  CHECK(covered(beyond, 2) == 0);
  for (const BeamPart& part : beyond) {
    if (part.outline < 0) continue;
    const Vec2d at = through.end(fan, part, part.middle());
    CHECK(at.y == Approx(-2));
    CHECK(cross(at - through.start(fan.at(part.middle())), through.leaving(fan.at(part.middle()))) ==
          Approx(0).epsilon(0).margin(1e-12));
  }
}

TEST_CASE("edges of shadows on a wall are where the rays of a light that touch something arrive") {
  // A wall along x = 4; in front of it a side from (2, 1) to (2, 2), and a circle of radius 1 about (1, 2).
  const Vec2d eye(0, -4);
  const PixelFan fan{{4, 0}, {4, 12}};  // the wall from y = -4 to y = 8
  const auto places = [&](const Outline& before, const PlanLight& light) {
    const std::vector<Outline> plan{wall({4, 0}, {1, 0}, 0), before};
    std::vector<double> heights;
    for (const Place& edge : UnfoldedPlan(plan, eye).shadow_edges(fan, {pixel_begin, pixel_end, 0}, light))
      heights.push_back(-4 + 12 * edge.value());
    return heights;
  };
  const auto check = [](const std::vector<double>& heights, double first, double second) {
    REQUIRE(heights.size() == 2);
    CHECK(heights[0] == Approx(first).epsilon(1e-15));
    CHECK(heights[1] == Approx(second).epsilon(1e-15));
  };
  // From (0, 0), twice as far and twice as high; from the left, level and rising by 1 in 2.
  check(places(side({2, 1}, {2, 2}, 1), {{0, 0}}), 2, 4);
  check(places(side({2, 1}, {2, 2}, 1), {{-1, 0}, true}), 1, 2);
  check(places(side({2, 1}, {2, 2}, 1), {{-2, -1}, true}), 2, 3);
  // From (-4, 2), 5 from the centre: sine 1/5. From the left, level; by 4 in 3: 5/3 beside the ray through the centre.
  check(places(circle({1, 2}, 1, 1), {{-4, 2}}), 2 - 8 / std::sqrt(24.0), 2 + 8 / std::sqrt(24.0));
  check(places(circle({1, 2}, 1, 1), {{-1, 0}, true}), 1, 3);
  check(places(circle({1, 2}, 1, 1), {{-3, -4}, true}), 6 - 5.0 / 3, 6 + 5.0 / 3);
  // Mirrored in a wall along y = 0, seen from (0, 4).
  const std::vector<Outline> plan{wall({4, 0}, {1, 0}, 0), side({2, 1}, {2, 2}, 1), wall({0, 0}, {0, 1}, 2)};
  const PixelFan down{{4, -4}, {4, -16}};  // mirrored: to y = 0 up to y = 12 at x = 4
  const auto edges = UnfoldedPlan(plan, {0, 4}).mirrored(2).shadow_edges(down, {pixel_begin, pixel_end, 0}, {{0, 0.5}});
  REQUIRE(edges.size() == 2);
  CHECK(12 * edges[0].value() == Approx(1.5).epsilon(1e-15));
  CHECK(12 * edges[1].value() == Approx(3.5).epsilon(1e-15));
}

TEST_CASE("through many mirrors the same is seen, however long they are, and on any scale") {
  // Two that face each other, six apart, and a ball between them; in them the eye stands every twelve.
  const auto facing = [](double reach, double scale) {
    return std::vector<Outline>{side(scale * Vec2d(-reach, 3), scale * Vec2d(reach, 3), 0),
                                side(scale * Vec2d(reach, -3), scale * Vec2d(-reach, -3), 1),
                                circle(scale * Vec2d(24, 0), scale * 2, 2)};
  };
  const auto endless = [](double size) {
    return std::vector<Outline>{wall({0, 3}, {0, -size}, 0), wall({0, -3}, {0, size}, 1), circle({24, 0}, 2, 2)};
  };
  const auto check_all = [](const std::vector<Outline>& plan, double scale) {
    const PixelFan fan{scale * Vec2d(1, 9), scale * Vec2d(1, 11)};
    std::vector<std::vector<BeamPart>> all;
    UnfoldedPlan seen(plan, Vec2d(0.0));
    for (int mirrors = 0; mirrors <= 41; ++mirrors) {
      CAPTURE(mirrors);
      all.push_back(seen.cut(fan));
      check_whole(all.back());
      // The fan begins where it touches the ball about (24, 6 mirrors), which is seen by that many mirrors.
      CHECK((covered(all.back(), 2) > 0) == (mirrors >= 33));
      CHECK(seen.virtual_eye() == scale * Vec2d(0, mirrors % 2 == 0 ? -6 * mirrors : 6 * mirrors));
      for (const BeamPart& part : all.back()) {
        const Vec2d at = seen.end(fan, part, part.middle()) / scale;
        if (part.outline < 2) CHECK(at.y == Approx(part.outline == 0 ? 3 : -3));
        if (part.outline == 2) CHECK(length(at - Vec2d(24, 0)) == Approx(2));
      }
      const std::vector<Place> edges =
          seen.shadow_edges(fan, {pixel_begin, pixel_end, mirrors % 2}, {scale * Vec2d(28, 1)});
      all.back().push_back({edges.empty() ? Place{} : edges.front(), {}, static_cast<int>(edges.size())});
      seen = seen.mirrored(mirrors % 2);
    }
    return all;
  };
  const auto expected = check_all(facing(128, 1), 1);
  const auto check_same = [&](const std::vector<std::vector<BeamPart>>& all) {
    REQUIRE(all.size() == expected.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      REQUIRE(all[i].size() == expected[i].size());
      for (std::size_t k = 0; k < all[i].size(); ++k) {
        CHECK(all[i][k].outline == expected[i][k].outline);
        CHECK(all[i][k].begin == expected[i][k].begin);
      }
    }
  };
  check_same(check_all(facing(0x1p14, 1), 1));
  check_same(check_all(facing(0x1p40, 1), 1));
  for (const double scale : {0x1p-60, 0x1p-30, 0x1p30, 0x1p60}) check_same(check_all(facing(128, scale), scale));
  check_same(check_all(endless(1), 1));
  check_same(check_all(endless(0x1p-300), 1));
  check_same(check_all(endless(0x1p300), 1));
}

TEST_CASE("a cut ends when it is asked to") {
  Stopper stopper;
  stopper.raised = true;
  const std::vector<Outline> plan{side({2, -1}, {2, 0.5}, 0), wall({4, 0}, {1, 0}, 1)};
  const UnfoldedPlan seen(plan, Vec2d(0.0));
  CHECK_THROWS_AS(seen.cut(fan_ahead, pixel_begin, pixel_end, Stop(stopper)), Stopped);
  CHECK_THROWS_AS(seen.shadow_edges(fan_ahead, {pixel_begin, pixel_end, 1}, {{0, 0}}, Stop(stopper)), Stopped);
}

TEST_CASE("hard plans leave no gap and no overlap") {
  const Vec2d eye(0.0);
  const auto parts_of = [&](const std::vector<Outline>& plan, const PixelFan& fan = fan_ahead) {
    const auto parts = UnfoldedPlan(plan, eye).cut(fan);
    check_whole(parts);
    return parts;
  };
  SECTION("an edge that touches a circle where both are seen") {
    const auto parts = parts_of({circle({3, 0}, 1, 0), side({2, -1}, {2, 1}, 1)});
    // Upon each other in (2, 0) alone: the side is nearer everywhere else.
    CHECK(covered(parts, 1) == 0.5);
    CHECK(covered(parts, 0) == 0);
  }
  SECTION("circles that touch each other, one behind the other") {
    const auto parts = parts_of({circle({3, 0}, 1, 0), circle({5, 0}, 1, 1)});
    CHECK(parts.size() == 3);
    CHECK(covered(parts, 1) == 0);
  }
  SECTION("corners that coincide") {
    const auto parts = parts_of({side({2, -1}, {2, 0}, 0), side({2, 0}, {2, 1}, 1), side({2, 0}, {3, 0}, 2)});
    CHECK(parts.size() == 4);
    CHECK(covered(parts, 0) == covered(parts, 1));
    CHECK(covered(parts, 2) == 0);
  }
  SECTION("outlines that lie upon each other: the first object") {
    const auto parts = parts_of({side({2, -1}, {2, 1}, 0), side({2, 1}, {2, -1}, 1), side({2, -2}, {2, 2}, 2)});
    CHECK(covered(parts, 0) == 0.5);
    CHECK(covered(parts, 1) == 0);
    CHECK(covered(parts, 2) == 0.5);
  }
  SECTION("a side seen end on") {
    const auto parts = parts_of({side({1, 0}, {3, 0}, 0)});
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].outline == -1);
  }
  SECTION("the eye on an edge, on a corner, on a circle, in a circle") {
    CHECK(parts_of({side({0, -1}, {0, 1}, 0)}).size() == 1);
    CHECK(parts_of({side({0, 0}, {0, 1}, 0), side({0, 0}, {2, -1}, 0), side({2, -1}, {0, 1}, 0)}).size() == 2);
    const auto on = parts_of({circle({2, 0}, 2, 0)});
    REQUIRE(on.size() == 1);
    CHECK(on[0].outline == 0);
    const auto in = parts_of({circle({0.5, 0}, 2, 0)});
    REQUIRE(in.size() == 1);
    CHECK(in[0].outline == 0);
  }
  SECTION("a wall that the fan is parallel to in the middle") {
    const auto parts = parts_of({wall({0, -1}, {0, 1}, 0)});
    REQUIRE(parts.size() == 2);
    CHECK(covered(parts, 0) == 0.5);
  }
  SECTION("a sliver of a millionth of a millionth of a millionth") {
    const double gap = 0x1p-60;
    const auto parts = parts_of({side({2, -1}, {2, 0}, 0), side({2, gap}, {2, 1}, 1)});
    REQUIRE(parts.size() == 5);
    CHECK(parts[2].outline == -1);
    CHECK(parts[2].width() == gap / 4);
  }
}

#ifdef RAYWALK_GMP

namespace {

class Draw {
 public:
  explicit Draw(int number) { key_.seed = 18, key_.sample = static_cast<std::uint32_t>(number); }
  double unit() { return ++key_.dimension, random_unit<double>(key_); }
  int below(int n) { return static_cast<int>(unit() * n); }

 private:
  RandomKey key_;
};

struct Case {
  std::vector<Outline> plan;
  Vec2d eye;
  PixelFan fan;
};

/// Every second one on a lattice, where much coincides; every third one very narrow.
Case random_case(int number) {
  Draw draw(number);
  const bool on_lattice = number % 2 == 0;
  const auto coordinate = [&](double from, double to) {
    const double at = from + draw.unit() * (to - from);
    return on_lattice ? std::round(at) : at;
  };
  Case random;
  random.eye = {coordinate(-2, 0), coordinate(-1, 1)};
  const double narrow = number % 3 == 0 ? 0x1p-12 : 1;
  const double slope = coordinate(-2, 1);
  random.fan = {{1, slope}, {1, slope + narrow * (on_lattice ? 1 + draw.below(2) : 0.1 + draw.unit())}};
  const int count = 2 + draw.below(3);
  for (int object = 0; object < count; ++object) {
    const Vec2d at(coordinate(1, 7), coordinate(-5, 5));
    switch (draw.below(5)) {
      case 0:
      case 1:
        random.plan.push_back(circle(at, on_lattice ? 1 + draw.below(3) : 0.1 + 3 * draw.unit(), object));
        break;
      case 2:
        random.plan.push_back(wall(at, {coordinate(-2, 2) + 0.5, coordinate(-2, 2)}, object));
        break;
      default: {
        const Vec2d b(coordinate(1, 7), coordinate(-5, 5)), c(coordinate(1, 7), coordinate(-5, 5));
        if (at == b || b == c || c == at) break;
        random.plan.push_back(side(at, b, object));
        random.plan.push_back(side(b, c, object));
        random.plan.push_back(side(c, at, object));
      }
    }
  }
  return random;
}

struct CutTally {
  int cells = 0, parts = 0, mirrored = 0;
  double worst_ulp = 0;
};

double ulp_of(double x) { return std::nextafter(x, INFINITY) - x; }

/// Compares one beam with the truth, and those that its mirrors make of it.
void compare(const Case& of, const UnfoldedPlan& plan, const std::vector<int>& mirrors, const Place& begin,
             const Place& end, CutTally& tally) {
  using test::BeamTruth;
  const auto real = [](const Place& at) { return BeamTruth::Real(BeamTruth::Real(at.high, 320) + at.low); };
  const auto parts = plan.cut(of.fan, begin, end);
  const auto truth = BeamTruth(of.plan, of.eye, mirrors).cut(of.fan, real(begin), real(end));
  check_whole(parts, begin, end);
  REQUIRE(parts.size() == truth.size());
  ++tally.cells;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ++tally.parts;
    REQUIRE(parts[i].outline == truth[i].outline);
    const BeamTruth::Real width = truth[i].end - truth[i].begin, error = abs(parts[i].width() - width);
    if (width.get_d() > 0x1p-48) tally.worst_ulp = std::max(tally.worst_ulp, error.get_d() / ulp_of(width.get_d()));
    REQUIRE(error.get_d() <= std::max(ulp_of(width.get_d()), 0x1p-100));
    const int seen = parts[i].outline;
    if (seen < 0 || !of.plan[static_cast<std::size_t>(seen)].is_straight() || mirrors.size() >= 2) continue;
    if (width.get_d() < 0x1p-40) continue;
    ++tally.mirrored;
    std::vector<int> further = mirrors;
    further.push_back(seen);
    compare(of, plan.mirrored(seen), further, parts[i].begin, parts[i].end, tally);
  }
}

CutTally compare_cases(int count) {
  CutTally tally;
  for (int number = 0; number < count; ++number) {
    CAPTURE(number);
    const Case random = random_case(number);
    compare(random, UnfoldedPlan(random.plan, random.eye), {}, pixel_begin, pixel_end, tally);
  }
  return tally;
}

}  // namespace

TEST_CASE("coverage is that of rationals and roots of 320 bits, to an ulp, by mirrors too") {
  const int count = test::rounds(2000);
  const CutTally tally = compare_cases(count);
  CHECK(tally.worst_ulp <= 1);
  CHECK(tally.parts > count);
  CHECK(tally.mirrored > count / 2);
}

TEST_CASE("coverage is that of rationals and roots of 320 bits, full count", "[.][full]") {
  const CutTally tally = compare_cases(1000000);
  WARN("cells " << tally.cells << ", parts " << tally.parts << ", mirrored " << tally.mirrored << ", worst "
                << tally.worst_ulp << " ulp");
}

#endif
