// What is listed once is whole: every kind of light answers, and every integrator stands at its own place.
#include "scene/effects.h"
#include "scene/light.h"
#include "scene/render_choices.h"

#include <set>
#include <string_view>
#include <variant>

#include "support/catch.h"

using namespace raywalk;

namespace {

template <class Kinds>
struct Each;
template <class... Kinds>
struct Each<std::variant<Kinds...>> {
  static_assert((LightKind<Kinds> && ...));
  template <class Ask>
  static void ask(Ask ask) {
    (ask(Kinds{}), ...);
  }
};

}  // namespace

TEST_CASE("every kind of light has a name of its own, and moves as a whole") {
  std::set<std::string_view> names;
  Each<AnyLight>::ask([&]<class Kind>(Kind kind) {
    INFO(Kind::name);
    CHECK(names.insert(Kind::name).second);
    const auto before = kind.middle(), along = kind.axis();
    const auto corners = kind.outline();
    kind.move_by({1, 2, 3});
    CHECK(kind.middle().has_value() == before.has_value());
    if (before) CHECK(*kind.middle() == *before + Vec3d(1, 2, 3));
    CHECK(kind.axis() == along);
    const auto moved = kind.outline();
    REQUIRE(moved.size() == corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) CHECK(length(moved[i] - corners[i] - Vec3d(1, 2, 3)) < 1e-12);
  });
}

TEST_CASE("a light with an extent is sampled within its bounds, around its centre") {
  Each<AnyLight>::ask([]<class Kind>(const Kind& kind) {
    INFO(Kind::name);
    if (kind.is_delta()) {
      CHECK(kind.reach() == 0);
      return;
    }
    if constexpr (requires(typename Kind::template Prepared<double> light) { light.sample(Vec2d(0)); }) {
      const typename Kind::template Prepared<double> light(kind);
      const Vec3d middle = kind.middle().value();
      Vec3d sum{0.0};
      constexpr int edge = 32;
      for (int i = 0; i < edge * edge; ++i) {
        const Vec3d at = light.sample(Vec2d((i % edge + 0.5) / edge, (i / edge + 0.5) / edge));
        CHECK(length(at - middle) <= kind.reach() * (1 + 1e-12));
        sum += at;
      }
      CHECK(length(sum / static_cast<double>(edge * edge) - middle) < 0.02 * kind.reach());
      for (const Vec3d& corner : kind.outline()) CHECK(length(corner - middle) <= kind.reach() * (1 + 1e-12));
    } else {
      FAIL("it has an extent and no samples");
    }
  });
}

TEST_CASE("integrators stand in the order of their enumeration, each with a name of its own") {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < integrators.size(); ++i) {
    CHECK(integrators[i].integrator == static_cast<Integrator>(i));
    CHECK(names.insert(integrators[i].name).second);
  }
  CHECK(values_of<Integrator>.back() == Integrator::pencils);
  CHECK(draws_random(Integrator::path));
  CHECK_FALSE(draws_random(Integrator::whitted));
}
