// What scrolls shows whole lines, and a finger moves it.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "gui/bench.h"
#include "gui/fonts.h"
#include "gui/scroll.h"
#include "gui/ui.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Bench with_lesson(const std::string& name, int step, const FontFiles& files) {
  State state = classic_with_lessons();
  state.lessons.unlocked = true;
  update(state, action::ShowLessons{true});
  update(state, action::OpenLesson{name});
  update(state, action::GoToLessonStep{step});
  update(state, action::RevealLesson{});
  REQUIRE(state.lessons.at() != nullptr);
  return Bench(std::move(state), 1280, 500, files);
}

// The triangles in the window whose name ends so, in the last frame.
struct Drawn {
  float left, top, bottom;
};
std::vector<Drawn> drawn_in(const std::string& window) {
  std::vector<Drawn> all;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    if (list._OwnerName == nullptr || std::strstr(list._OwnerName, window.c_str()) == nullptr) continue;
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (unsigned at = 0; at + 2 < command.ElemCount; at += 3) {
        const auto corner_of = [&](unsigned n) {
          return list
              .VtxBuffer[static_cast<int>(command.VtxOffset) +
                         list.IdxBuffer[static_cast<int>(command.IdxOffset + at + n)]]
              .pos;
        };
        const ImVec2 a = corner_of(0), b = corner_of(1), c = corner_of(2);
        all.push_back({std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y})});
      }
    }
  }
  return all;
}

}  // namespace

TEST_CASE("an edge moves to where it cuts nothing, or says that this is too far") {
  const Bench bench;
  ImDrawList list(ImGui::GetDrawListSharedData());
  list._ResetForNewFrame();
  list.PushClipRectFullScreen();
  const auto box = [&](float x, float top, float bottom) {
    list.PrimReserve(6, 4);
    list.PrimRect({x, top}, {x + 10, bottom}, 0xffffffff);
  };
  const Rect window{0, 0, 100, 200};
  box(0, -10, 210);   // the ground
  box(110, 0, 150);   // a scroll bar, beside it
  box(10, 100, 116);  // a line: a letter with a tail,
  box(20, 96, 112);   // one that is tall,
  box(30, 102, 110);  // and a small one
  box(10, 120, 132);  // the next line
  CHECK(uncut_edge(list, window, 125, -1, 40) == Approx(120));
  CHECK(uncut_edge(list, window, 125, 1, 40) == Approx(132));
  // Only the tail is cut at first, and with it goes the whole line.
  CHECK(uncut_edge(list, window, 114, -1, 40) == Approx(96));
  CHECK(uncut_edge(list, window, 99, 1, 40) == Approx(116));
  CHECK(uncut_edge(list, window, 118, -1, 40) == Approx(118));
  CHECK_FALSE(uncut_edge(list, window, 114, -1, 10).has_value());
  // A box with round corners is cut as a whole: no sliver of it is left.
  list.AddRectFilled({10, 140}, {90, 170}, 0xffffffff, 8);
  CHECK(std::abs(uncut_edge(list, window, 160, -1, 40).value() - 140) <= 1);
  CHECK(std::abs(uncut_edge(list, window, 142, 1, 40).value() - 170) <= 1);
}

TEST_CASE("a lesson's text is cut through no line, wherever it is scrolled to") {
  const FontFiles files = find_fonts(font_folders(""));
  Bench bench = with_lesson("05-refraction", 3, files);
  bench.frames(3);
  const Rect pane = bench.rect("lesson");
  bench.move_to(pane.x + pane.width / 2, pane.y + pane.height / 2);
  bench.wheel(100);
  std::vector<float> tops;
  for (int turn = 0; turn < (sanitized ? 6 : 30); ++turn) {
    const Rect seen = bench.rect("lesson-lines");
    INFO("turn " << turn << ", from " << seen.y << " to " << seen.bottom());
    CHECK(seen.height > 60);
    int lines = 0;
    for (const Drawn& each : drawn_in("lesson-words")) {
      if (each.left >= seen.right()) continue;  // the scroll bar
      ++lines;
      // The letters of a line reach a pixel beyond it.
      const auto cut_at = [&](float edge) { return each.top < edge - 1.5f && each.bottom > edge + 1.5f; };
      CHECK_FALSE(cut_at(seen.y));
      CHECK_FALSE(cut_at(seen.bottom()));
    }
    CHECK(lines > 100);
    tops.push_back(seen.y);
    bench.move_to(pane.x + pane.width / 2, pane.y + pane.height / 2);
    bench.wheel(-0.25f);
  }
  // From its beginning to its end.
  CHECK(*std::max_element(tops.begin(), tops.end()) > *std::min_element(tops.begin(), tops.end()));
}

TEST_CASE("a finger moves the text of a lesson as paper, and stops at its ends") {
  Bench bench = with_lesson("05-refraction", 3, {});
  bench.frames(3);
  const Rect pane = bench.rect("lesson");
  const ImVec2 inside{pane.x + pane.width / 2, pane.y + pane.height / 2};
  const auto place = [&] { return bench.rect("guess/1").y; };
  const auto drag = [&](float by) {
    const bool scrolls = scroll_at(inside, by);
    bench.frames(2);
    return scrolls;
  };
  CHECK(drag(10000));  // to the top
  const float top = place();
  CHECK(drag(-30));
  CHECK(place() == Approx(top - 30));
  CHECK(drag(10));
  CHECK(place() == Approx(top - 20));
  CHECK(drag(50));
  CHECK(place() == Approx(top));
  CHECK(drag(-10000));
  const float end = place();
  CHECK(end < top - 30);
  CHECK(drag(-5));
  CHECK(place() == Approx(end));
}

TEST_CASE("what does not scroll is left to other uses of a finger") {
  Bench bench;
  bench.frames(3);
  const Rect plan = bench.rect("plan");
  CHECK_FALSE(scroll_at({plan.x + plan.width / 2, plan.y + plan.height / 2}, 20));
  CHECK_FALSE(scroll_at({-50, -50}, 20));
}

TEST_CASE("the letters of a line of code stand in its middle, from capitals to the feet of p and y") {
  State state = classic();
  update(state, action::SetMode{Mode::trace});
  Bench bench(std::move(state), 1280, 720, find_fonts(font_folders("")));
  for (const float unit : {1.0f, 1.25f, 2.0f}) {
    bench.unit = unit;
    bench.resize(1280 * unit, 720 * unit);
    bench.frames(2);
    const Rect line = bench.rect("line-" + std::to_string(static_cast<int>(Line::form_reflect_ray)));
    float top = line.bottom(), bottom = line.y;
    for (const Drawn& drawn : drawn_in("code")) {
      const float middle = (drawn.top + drawn.bottom) / 2;
      if (middle < line.y || middle > line.bottom() || drawn.bottom - drawn.top > line.height || drawn.left < line.x)
        continue;
      top = std::min(top, drawn.top), bottom = std::max(bottom, drawn.bottom);
    }
    CAPTURE(unit, line.y, top, bottom, line.bottom());
    REQUIRE(bottom - top > 8 * unit);
    CHECK(top - line.y > unit);
    CHECK(line.bottom() - bottom > unit);
    CHECK(std::abs((top - line.y) - (line.bottom() - bottom)) <= 1.5f * unit);
  }
}
