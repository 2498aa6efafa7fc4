#include "gui/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "support/catch.h"

using raywalk::Layout;
using raywalk::Rect;

namespace {

bool overlap(const Rect& a, const Rect& b) {
  if (a.empty() || b.empty()) return false;
  constexpr float rounding = 0.01f;
  return std::min(a.right(), b.right()) - std::max(a.x, b.x) > rounding &&
         std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y) > rounding;
}

// What is wrong with a layout; empty when nothing is.
std::string faults(const Layout& layout, float width, float height) {
  const std::array panes{layout.bar,    layout.lesson, layout.plan,      layout.effects, layout.band,
                         layout.strip,  layout.corner, layout.transport, layout.side,    layout.tabs,
                         layout.fronts, layout.folded, layout.choice};
  const std::array names{"bar",       "lesson", "plan", "effects", "band",   "strip", "corner",
                         "transport", "side",   "tabs", "fronts",  "folded", "choice"};
  std::string text;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const Rect& pane = panes[i];
    if (pane.width < 0 || pane.height < 0) text += std::string(names[i]) + " has a negative size\n";
    if (pane.x < 0 || pane.y < 0 || pane.right() > width + 0.01f || pane.bottom() > height + 0.01f)
      text += std::string(names[i]) + " leaves the window\n";
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(pane, panes[j])) text += std::string(names[i]) + " overlaps " + names[j] + "\n";
    }
  }
  return text;
}

constexpr std::array sizes{0.0f, 1.0f, 7.0f, 40.0f, 100.0f, 333.0f, 640.0f, 1280.0f, 1920.0f, 7680.0f};

}  // namespace

TEST_CASE("no size of the window makes panes overlap or leave it") {
  for (const float width : sizes) {
    for (const float height : sizes) {
      for (const float unit : {1.0f, 1.25f, 2.0f, 3.75f, 7.5f}) {
        CAPTURE(width, height, unit);
        raywalk::LayoutWishes wishes{width, height, unit, 150 * unit, 420 * unit, 300 * unit};
        CHECK(faults(raywalk::lay_out(wishes), width, height) == "");
        wishes.lesson = 330 * unit;
        wishes.choice = 62 * unit;
        for (const auto front : {raywalk::Front::code, raywalk::Front::tabs, raywalk::Front::lesson}) {
          wishes.front = front;
          for (const bool focus : {false, true}) {
            wishes.focus = focus;
            wishes.band = 58 * unit;
            wishes.effects = wishes.effects_row = 34 * unit;
            CHECK(faults(raywalk::lay_out(wishes), width, height) == "");
          }
        }
        wishes.focus = false;
        wishes.bare = true;
        for (const auto front : {raywalk::Front::code, raywalk::Front::lesson}) {
          wishes.front = front;
          const Layout bare = raywalk::lay_out(wishes);
          CHECK(faults(bare, width, height) == "");
          CHECK((bare.bar.empty() && bare.strip.empty() && bare.tabs.empty()));
        }
      }
    }
  }
}

TEST_CASE("a lesson takes its room from the plan alone, which keeps the larger part of it") {
  raywalk::LayoutWishes wishes{1280, 720, 1, 134, 413, 300};
  const Layout without = raywalk::lay_out(wishes);
  wishes.lesson = 330;
  const Layout with = raywalk::lay_out(wishes);
  CHECK(without.lesson.empty());
  CHECK(with.lesson.width == 330);
  CHECK(with.plan.width == without.plan.width - 331);
  CHECK(with.plan.width > 450);
  CHECK(with.side == without.side);
  CHECK(with.tabs == without.tabs);
}

TEST_CASE("on a telephone on its side the lesson, the code and the tabs share a column") {
  raywalk::LayoutWishes wishes{640, 360, 1, 110, 413, 250};
  wishes.lesson = 330;
  for (const auto front : {raywalk::Front::code, raywalk::Front::tabs, raywalk::Front::lesson}) {
    wishes.front = front;
    const Layout layout = raywalk::lay_out(wishes);
    CHECK(layout.fronts.height >= 36);
    CHECK((layout.side.empty() ? 0 : 1) + (layout.tabs.empty() ? 0 : 1) + (layout.lesson.empty() ? 0 : 1) == 1);
    CHECK((front == raywalk::Front::lesson) == !layout.lesson.empty());
    CHECK(layout.plan.width > 300);
  }
}

TEST_CASE("on a telephone on its side code and tabs have the whole height of their column, one at a time") {
  for (const auto& [width, height] : {std::pair{640.0f, 360.0f}, {844.0f, 390.0f}, {896.0f, 414.0f}}) {
    CAPTURE(width, height);
    raywalk::LayoutWishes wishes{width, height, 1, 110, 413, 250};
    wishes.choice = 62;
    const Layout code = raywalk::lay_out(wishes);
    CHECK(faults(code, width, height).empty());
    CHECK(code.tabs.empty());
    CHECK(code.side.height > 270);
    wishes.front = raywalk::Front::tabs;
    const Layout tabs = raywalk::lay_out(wishes);
    CHECK(faults(tabs, width, height).empty());
    CHECK(tabs.side.empty());
    CHECK(tabs.tabs.height > 210);
    CHECK(tabs.plan == code.plan);
    CHECK(tabs.fronts == code.fronts);
    wishes.focus = true;
    CHECK(raywalk::lay_out(wishes).fronts.empty());
  }
  CHECK(raywalk::lay_out({900, 390, 1, 110, 413, 250}).fronts.empty());
  CHECK(raywalk::lay_out({844, 480, 1, 110, 413, 250}).fronts.empty());
}

TEST_CASE("at 1280 x 720 every pane has room for what it shows") {
  const Layout layout = raywalk::lay_out({1280, 720, 1, 134, 413, 300});
  CHECK(layout.plan.width > 800);
  CHECK(layout.plan.height > 450);
  CHECK(layout.transport.height == 134);
  CHECK(layout.side.height == 413);
  CHECK(layout.tabs.height > 240);
  CHECK(layout.tabs.width > 400);
}

TEST_CASE("the room of code and tabs is divided as it was chosen, and gripped between them") {
  raywalk::LayoutWishes wishes{1280, 720, 1, 134, 413, 300};
  for (const float part : {0.15f, 0.4f, 0.85f}) {
    wishes.code_part = part;
    const Layout layout = raywalk::lay_out(wishes);
    CHECK(faults(layout, 1280, 720).empty());
    const float below = 720 - layout.side.y;
    CHECK(layout.side.height == Approx(std::min(part * below, below - 130)).margin(1));
    CHECK(layout.tabs.height >= 128);
    CHECK(layout.divider.y < layout.side.bottom());
    CHECK(layout.divider.bottom() > layout.tabs.y);
    CHECK(layout.divider.height >= 8);
  }
  // Where they are beside each other, or one at a time, there is nothing to divide.
  wishes.width = 700, wishes.height = 1200;
  CHECK(raywalk::lay_out(wishes).divider.empty());
  wishes = {1280, 720, 1, 134, 413, 300};
  wishes.focus = true;
  CHECK(raywalk::lay_out(wishes).divider.empty());
}

TEST_CASE("effects and the band leave the plan what can be seen, in low windows too") {
  for (const auto& [width, height] : {std::pair{1280.0f, 720.0f}, {960.0f, 540.0f}, {853.0f, 480.0f}}) {
    raywalk::LayoutWishes wishes{width, height, 1, 150, 413, 300};
    wishes.band = 70, wishes.effects = 130;
    const Layout layout = raywalk::lay_out(wishes);
    CAPTURE(width, height);
    CHECK(faults(layout, width, height).empty());
    CHECK(layout.plan.height > 0.35f * (height - layout.bar.height - layout.transport.height));
    CHECK(layout.band.height > 0);
  }
}

TEST_CASE("no row of effects is cut, and one is always seen, in low windows too") {
  for (const bool touch : {false, true}) {
    for (const auto& [width, height] : {std::pair{640.0f, 360.0f}, {740.0f, 360.0f}, {960.0f, 540.0f}}) {
      raywalk::LayoutWishes wishes{width, height, 1, 131, 413, 300};
      wishes.touch = touch;
      wishes.band = 58, wishes.effects_row = 40, wishes.effects = 160;
      const Layout layout = raywalk::lay_out(wishes);
      CAPTURE(width, height, touch);
      CHECK(faults(layout, width, height).empty());
      CHECK(layout.effects.height >= 40);
      CHECK(std::fmod(layout.effects.height, 40.0f) == 0);
      CHECK(layout.band.height > 40);
      CHECK(layout.plan.height > 0.25f * (height - layout.bar.height - layout.transport.height));
    }
  }
}

TEST_CASE("in focus, in an upright window, a question stands below the walk") {
  raywalk::LayoutWishes wishes{768, 1024, 1, 134, 413, 300};
  wishes.focus = true;
  wishes.lesson = 330;
  const Layout layout = raywalk::lay_out(wishes);
  CHECK(faults(layout, 768, 1024).empty());
  CHECK(layout.plan.width == 768);
  CHECK(layout.lesson.width == 768);
  CHECK(layout.lesson.y > layout.transport.bottom());
  CHECK(layout.plan.height > 300);
  CHECK(layout.lesson.height > 300);
}

TEST_CASE("what chooses the tabs stays where it is when plan and tabs change places") {
  for (const auto& [width, height] : {std::pair{1280.0f, 720.0f}, {1920.0f, 1080.0f}, {768.0f, 1024.0f}}) {
    CAPTURE(width, height);
    raywalk::LayoutWishes wishes{width, height, 1, 134, 413, 300};
    wishes.choice = 62;
    wishes.front = raywalk::Front::tabs;
    const Layout before = raywalk::lay_out(wishes);
    CHECK(before.choice.bottom() == before.tabs.y);
    wishes.exchanged = true;
    const Layout after = raywalk::lay_out(wishes);
    CHECK(faults(after, width, height).empty());
    CHECK(after.choice == before.choice);
    CHECK(after.tabs == before.plan);
    CHECK(after.plan == before.tabs);
  }
}

TEST_CASE("what has the plan's place keeps it in focus") {
  raywalk::LayoutWishes wishes{1280, 720, 1, 134, 413, 300};
  wishes.focus = true;
  const Layout plan = raywalk::lay_out(wishes);
  CHECK(plan.tabs.empty());
  wishes.exchanged = true;
  const Layout picture = raywalk::lay_out(wishes);
  CHECK(picture.tabs == plan.plan);
  CHECK(picture.plan.empty());
}

TEST_CASE("in a small window everything is drawn smaller, never below what can be read") {
  using raywalk::shrink_to_fit;
  CHECK(shrink_to_fit(1280, 720, 1) == 1);
  CHECK(shrink_to_fit(1280, 720, 2) == 1);
  CHECK(shrink_to_fit(1280, 720, 2.5f) < 1);
  CHECK(shrink_to_fit(1280, 900, 2, true) < 0.75f);
  CHECK(shrink_to_fit(1280, 720, 2, true) == 1);  // low: the lesson is not beside the code
  CHECK(shrink_to_fit(1280, 720, 1, true) == 1);
  CHECK(shrink_to_fit(400, 300, 1) <= 400 / 640.0f);
  CHECK(shrink_to_fit(400, 300, 1) > 0.9f * 400 / 640);
  CHECK(shrink_to_fit(10, 10, 1) > 0.2f);
  // Upright, a lesson is not beside the code, and a telephone's letters stay legible.
  CHECK(shrink_to_fit(768, 1024, 1, true) == 1);
  CHECK(shrink_to_fit(360, 640, 1, true) > 0.85f);
}

TEST_CASE("the bar has two lines in an upright window too narrow for one, and the strip is as high as it must be") {
  raywalk::LayoutWishes wishes{768, 1024, 1, 134, 413, 310};
  wishes.bar_width = 768;
  const Layout one = raywalk::lay_out(wishes);
  wishes.bar_width = 769;
  wishes.strip = 54;
  const Layout two = raywalk::lay_out(wishes);
  CHECK(one.bar.height == 44);
  CHECK(two.bar.height == 76);
  CHECK(one.strip.height == 42);
  CHECK(two.strip.height == 54);
  CHECK(two.corner.width == one.corner.width);
}

TEST_CASE("in an upright window the columns are below each other") {
  raywalk::LayoutWishes wishes{768, 1024, 1, 134, 413, 310};
  const Layout layout = raywalk::lay_out(wishes);
  CHECK(layout.plan.width == 768);
  CHECK(layout.plan.height > 300);
  CHECK(layout.side.y > layout.transport.bottom());
  CHECK(layout.side.width >= 310);
  CHECK(layout.side.height >= 0.85f * 413);  // its lines stand closer before any is out of sight
  CHECK(layout.tabs.y == layout.side.y);
  CHECK(layout.tabs.width > 400);
  CHECK(layout.fronts.empty());
  wishes.lesson = 330;
  const Layout with = raywalk::lay_out(wishes);
  CHECK(with.lesson.width == 330);
  CHECK(with.plan.width > 400);
  CHECK(with.tabs == layout.tabs);
}

TEST_CASE("in an upright window effects and the band leave the plan its height, also in the projector's letters") {
  for (const float unit : {1.0f, 1.25f}) {
    raywalk::LayoutWishes wishes{768, 1024, unit, 134 * unit, 413 * unit, 310 * unit};
    wishes.strip = 54 * unit;
    wishes.bar_width = 769;
    for (const float lesson : {0.0f, 330 * unit}) {
      wishes.lesson = lesson;
      wishes.effects_row = 34 * unit;
      wishes.effects = (lesson > 0 ? 3 : 2) * wishes.effects_row;
      wishes.band = 0;
      const Layout layout = raywalk::lay_out(wishes);
      CAPTURE(unit, lesson, layout.plan.height);
      CHECK(layout.plan.height > 200 * unit);
      CHECK(layout.effects.height == std::round(wishes.effects));
      CHECK(layout.side.height > 0.27f * 1024);
      wishes.band = 58 * unit;
      CHECK(raywalk::lay_out(wishes).plan.height > 145 * unit);
    }
  }
}

TEST_CASE("on a telephone held upright lesson, code and panels stand below the walk one at a time") {
  raywalk::LayoutWishes wishes{360, 640, 0.875f, 140, 360, 270};
  wishes.lesson = 290;
  for (const auto front : {raywalk::Front::code, raywalk::Front::tabs, raywalk::Front::lesson}) {
    wishes.front = front;
    const Layout layout = raywalk::lay_out(wishes);
    CHECK(layout.plan.width == 360);
    CHECK(layout.plan.height > 80);
    CHECK_FALSE(layout.fronts.empty());
    CHECK(layout.side.empty() == (front != raywalk::Front::code));
    CHECK(layout.tabs.empty() == (front != raywalk::Front::tabs));
    CHECK(layout.lesson.empty() == (front != raywalk::Front::lesson));
  }
}

TEST_CASE("the side is never narrower than the longest line of code where the window has room for both") {
  const Layout layout = raywalk::lay_out({960, 540, 1, 134, 413, 310});
  CHECK(layout.side.width >= 310);
  CHECK(layout.plan.width > 600);
}
