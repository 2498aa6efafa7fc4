// Spot the bug by mouse and keys, on the bench.

#include "gui/bench.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "view/action_text.h"
#include "view/bugs/bug_panel.h"
#include "view/walk/asked.h"
#include "view/walk/fault.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::string row_of(Line line) { return "line-" + std::to_string(static_cast<int>(line)); }

bool inside(const Rect& part, const Rect& whole) {
  return part.x >= whole.x && part.right() <= whole.right() + 0.5f && part.y >= whole.y &&
         part.bottom() <= whole.bottom() + 0.5f;
}

}  // namespace

TEST_CASE("a bug by mouse: list, click on the line, is it this one, the cure, mend, back") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  const Scene mine = bench.state.scene();
  bench.key("Shift+F2");
  REQUIRE(bench.has("bug/1"));
  REQUIRE(bench.has("bug/8"));
  CHECK_FALSE(bench.has("banner"));
  bench.click("bug/2");
  REQUIRE(bench.state.bugs.hunt);
  REQUIRE(bench.has("banner"));
  // The strip stands over the plan and takes nothing away from it.
  CHECK(bench.rect("banner").bottom() <= bench.interface().layout().plan.y);
  const int position = bench.state.walk.position;
  bench.click(row_of(Line::form_shadow_ray));
  CHECK(bench.state.walk.position == position);  // a click marks, and does not run
  CHECK(marked_line(bench.state) == Line::form_shadow_ray);
  bench.click("bug-mark");
  CHECK(bench.state.bugs.hunt->end == BugEnd::open);
  CHECK(bug_panel(bench.state).verdict.find("Not this line") == 0);
  bench.click(row_of(Line::form_reflect_ray));
  bench.click("bug-mark");
  CHECK(bench.state.bugs.hunt->end == BugEnd::found);
  bench.click("bug-mend");
  CHECK(bench.state.walk.bug->mended);
  bench.click("bug-mend");
  CHECK_FALSE(bench.state.walk.bug->mended);
  bench.click(row_of(Line::form_reflect_ray));
  CHECK(bench.state.walk.position != position);  // nothing is asked any more: a click runs on
  bench.click("bugs-list");
  CHECK_FALSE(bench.state.bugs.hunt);
  CHECK(bench.state.scene() == mine);
  CHECK_FALSE(bench.has("banner"));
  CHECK(bench.has("bug/2"));
  bench.click("bugs-close");
  CHECK_FALSE(bench.state.bugs.shown);
}

TEST_CASE("a bug by keys: a surprise, Enter marks and asks, Y gives up, Q mends, Esc leads back") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("Ctrl+F2");
  REQUIRE(bench.state.bugs.hunt);
  CHECK(bench.state.bugs.hunt->surprise);
  bench.key("Alt+Enter");
  CHECK_FALSE(bench.state.walk.bug->mended);
  update(bench.state, action::HuntBug{1});
  while (bench.state.walk.timeline->just_run(bench.state.walk.position)->line != Line::form_shadow_ray)
    bench.key("Space");
  bench.key("Enter");
  CHECK(marked_line(bench.state) == Line::form_shadow_ray);
  CHECK(bench.state.bugs.hunt->end == BugEnd::open);
  bench.key("Enter");
  CHECK(bench.state.bugs.hunt->end == BugEnd::found);
  bench.key("Alt+Enter");
  CHECK(bench.state.walk.bug->mended);
  update(bench.state, action::HuntBug{7});
  bench.key("Shift+Enter");
  CHECK(bench.state.bugs.hunt->end == BugEnd::given_up);
  bench.key("Escape");
  CHECK_FALSE(bench.state.bugs.hunt);
  CHECK(bench.state.bugs.shown);
  bench.key("Escape");
  CHECK_FALSE(bench.state.bugs.shown);
  // Shift+F2 in the midst of a hunt leads back as well, and so does the undo of someone who has changed nothing.
  update(bench.state, action::HuntBug{3});
  bench.key("Shift+F2");
  CHECK_FALSE(bench.state.bugs.hunt);
  update(bench.state, action::HuntBug{3});
  bench.key("Ctrl+Z");
  CHECK_FALSE(bench.state.bugs.hunt);
  // What was found out is not thrown away.
  update(bench.state, action::HuntBug{3});
  bench.key("Shift+Enter");
  bench.key("Ctrl+Z");
  CHECK(bench.state.bugs.hunt);
}

TEST_CASE("everything of a hunt fits into its pane, in both languages, at every size") {
  for (const float scale : {1.0f, 1.5f}) {
    for (const float factor : {1.0f, 1.25f}) {
      Bench bench(classic_with_lessons());
      bench.dpi = scale;
      bench.unit = scale * factor;
      bench.resize(1280 * scale, 720 * scale);
      for (const Language language : all_languages()) {
        update(bench.state, action::SetLanguage{std::string(language.code())});
        update(bench.state, action::SetLessonOptions{false, true});
        for (int number = 1; number <= static_cast<int>(values_of<Fault>.size()); ++number) {
          update(bench.state, action::HuntBug{number});
          bench.frames(3);
          const Rect& pane = bench.interface().layout().lesson;
          for (const char* item : {"bug-mark", "bug-cure", "bugs-list", "bugs-leave", "bugs-close"}) {
            CAPTURE(language.code(), number, scale, factor, item);
            CHECK(inside(bench.rect(item), pane));
          }
          update(bench.state, action::ShowCure{});
          bench.frames(3);
          for (const char* item : {"bug-mend", "bug-surprise", "bugs-list", "bugs-leave"}) {
            CAPTURE(language.code(), number, scale, factor, item);
            CHECK(inside(bench.rect(item), pane));
          }
        }
      }
    }
  }
}

TEST_CASE("a lesson's line at fault is clicked in the code") {
  Bench bench(classic_with_lessons());
  update(bench.state, action::SetLessonOptions{false, true});
  update(bench.state, action::SetLanguage{"pt"});
  update(bench.state, action::OpenLesson{"05-refraction"});
  while (!asks_for_line(bench.state)) {
    REQUIRE(bench.state.lessons.at() != nullptr);
    update(bench.state, action::GoToLessonStep{bench.state.lessons.step + 1});
  }
  bench.frames(3);
  REQUIRE(bench.has("banner"));
  const int position = bench.state.walk.position;
  bench.click(row_of(Line::form_refract_ray));
  CHECK(bench.state.walk.position == position);
  bench.click("lesson-reveal");
  CHECK(bench.state.lessons.first_tries[bench.state.lessons.last].right() == 1);
  bench.key("Alt+Enter");
  CHECK(bench.state.walk.bug->mended);
  bench.frames(2);
  bench.click("bug-mend");  // breaks it again
  CHECK_FALSE(bench.state.walk.bug->mended);
}

TEST_CASE("the demo of spot the bug finds it and shows the cure") {
  const std::string file = RAYWALK_SOURCE_DIR "/tests/gui/demos/spot_the_bug.demo";
  const auto actions = parse_demo(read_file(file, 1 << 16).value(), file);
  REQUIRE(actions);
  Bench bench(classic_with_lessons());
  bool was_mended = false;
  for (const Action& each : *actions) {
    update(bench.state, each);
    bench.frames(1);
    was_mended = was_mended || (bench.state.walk.bug && bench.state.walk.bug->mended);
  }
  REQUIRE(bench.state.bugs.hunt);
  CHECK(bench.state.bugs.hunt->end == BugEnd::found);
  CHECK(was_mended);
  CHECK(fault_at_work(bench.state) == Fault::reflection_flipped);
}

TEST_CASE("a bug of the list is chosen by arrows and opened by Enter") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("Shift+F2");
  bench.key("Enter");
  CHECK_FALSE(bench.state.bugs.hunt);  // none is chosen yet
  for (const char* key : {"Up", "Down"}) bench.key(key);
  CHECK(bench.state.bugs.chosen == static_cast<int>(values_of<Fault>.size()));
  // It was scrolled into view.
  bench.frames(2);
  CHECK(inside(bench.rect("bug/16"), bench.interface().layout().lesson));
  for (int i = 0; i < 30; ++i) bench.key("Up");
  CHECK(bench.state.bugs.chosen == 1);
  for (const char* key : {"Down", "Enter"}) bench.key(key);
  REQUIRE(bench.state.bugs.hunt);
  CHECK(bench.state.bugs.hunt->number == 2);
  bench.key("Down");
  bench.key("Escape");
  CHECK_FALSE(bench.state.bugs.hunt);
  CHECK(bench.state.bugs.shown);
  bench.key("Escape");
  CHECK_FALSE(bench.state.bugs.shown);
}

TEST_CASE("in a hunt the switches for effects say no number of rays that they would bring") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("Shift+E");
  bench.frames(2);
  const float counted = bench.rect("effect/shadows").width;
  update(bench.state, action::HuntBug{2});
  bench.key("Shift+E");
  bench.frames(2);
  if (!bench.state.effects.shown) bench.key("Shift+E");
  bench.frames(2);
  REQUIRE(bench.state.effects.rays);
  CHECK(bench.state.effects.rays->can.none());
  CHECK(bench.rect("effect/shadows").width < 0.8f * counted);
}
