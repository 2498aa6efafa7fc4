#include "view/drawing/theme.h"

#include "contrast.h"

#include <cmath>
#include <limits>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr std::array kinds{RayKind::primary, RayKind::shadow, RayKind::reflect, RayKind::refract};
constexpr std::array themes{Theme::dark, Theme::projector};

}  // namespace

TEST_CASE("linear light is shown in sRGB, clamped, and what is not a number in magenta") {
  CHECK(display_colour(Rgbd(0.0)) == Colour{0, 0, 0});
  CHECK(display_colour(Rgbd(1.0)) == Colour{255, 255, 255});
  CHECK(display_colour(Rgbd(7, 0.2140, -1)) == Colour{255, 127, 0});
  CHECK(display_colour(Rgbd(0, std::numeric_limits<double>::quiet_NaN(), 0)) == Colour{255, 0, 255});
}

TEST_CASE("mixing") {
  CHECK(mix({0, 0, 0}, {200, 100, 50}, 0.5) == Colour{100, 50, 25});
  CHECK(mix({1, 2, 3}, {9, 9, 9}, 0) == Colour{1, 2, 3});
}

TEST_CASE("texts, rays and signs stand out from their ground") {
  for (const Theme theme : themes) {
    const Palette& p = palette(theme);
    for (const Colour ground : {p.window, p.plan, p.panel}) {
      CHECK(contrast(p.text, ground) >= 7);
      CHECK(contrast(p.dim_text, ground) >= 4.5);
    }
    CHECK(contrast(p.text, p.just_run) >= 4.5);
    CHECK(contrast(p.error, p.panel) >= 4.5);
    CHECK(contrast(p.next, p.panel) >= 3);
    for (const Colour sign : {p.ink, p.light, p.normal, p.handle, p.selected, p.hovered})
      CHECK(contrast(sign, p.plan) >= 3);
    for (const RayKind kind : kinds) CHECK(contrast(ray_style(theme, kind).colour, p.plan) >= 3);
  }
}

TEST_CASE("no two kinds of ray share a dash pattern or a colour") {
  for (const Theme theme : themes) {
    for (const RayKind a : kinds)
      for (const RayKind b : kinds) {
        if (a == b) continue;
        CHECK_FALSE(ray_style(theme, a).dash == ray_style(theme, b).dash);
        CHECK_FALSE(ray_style(theme, a).colour == ray_style(theme, b).colour);
      }
    CHECK(ray_style(theme, RayKind::primary).dash.count == 0);
  }
}

TEST_CASE("the projector's theme is larger and light") {
  CHECK(theme_scale(Theme::projector) > theme_scale(Theme::dark));
  CHECK(palette(Theme::projector).plan == Colour{255, 255, 255});
}
