// The lessons by mouse and keys: on the bench, and in the real window.

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <variant>

#include "gui/bench.h"
#include "gui/classic_walk.h"
#include "gui/fonts.h"
#include "gui/layout.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/languages.h"
#include "text/file.h"
#include "view/lesson/lesson_panel.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"

using namespace raywalk;
using namespace raywalk::test;

using Json = nlohmann::json;

TEST_CASE("a lesson by keys: list, choice by digit, Enter reveals and goes on") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("F2");
  REQUIRE(bench.has("lesson/01-ray-casting"));
  bench.click("lesson/02-ray-meets-sphere");
  CHECK(bench.state.lessons.at() == nullptr);
  bench.click("lesson/01-ray-casting");
  REQUIRE(bench.state.lessons.at() != nullptr);
  bench.key("Enter");
  REQUIRE(bench.state.lessons.step == 1);
  // Nothing is revealed before something is predicted.
  bench.key("Enter");
  CHECK_FALSE(bench.state.lessons.revealed);
  const int position = bench.state.walk.position;
  const Grain grain = bench.state.walk.grain;
  bench.key("Down");
  CHECK(bench.state.lessons.guess.choice == 0);
  for (int press = 0; press < 5; ++press) bench.key("Down");
  CHECK(bench.state.lessons.guess.choice == 3);
  bench.key("Up");
  CHECK(bench.state.lessons.guess.choice == 2);
  CHECK(bench.state.walk.position == position);
  bench.key("2");
  CHECK(bench.state.lessons.guess.choice == 1);
  CHECK(bench.state.walk.grain == grain);
  bench.key("Enter");
  CHECK(bench.state.lessons.revealed);
  CHECK(bench.state.lessons.first_tries[bench.state.lessons.last].right() == 1);
  CHECK(bench.state.walk.position == position + 1);
  bench.key("Enter");
  CHECK(bench.state.lessons.step == 2);
  bench.click("guess/1");
  bench.click("lesson-reveal");
  CHECK(bench.state.lessons.first_tries[bench.state.lessons.last].judged() == 2);
  CHECK(bench.state.lessons.first_tries[bench.state.lessons.last].right() == 1);
  bench.click("lesson-next");
  CHECK(bench.state.lessons.step == 3);
  bench.click("lesson-back");
  CHECK(bench.state.lessons.step == 2);
  bench.click("lesson-list");
  CHECK(bench.state.lessons.at() == nullptr);
  bench.click("lesson-close");
  CHECK_FALSE(bench.state.lessons.shown);
}

TEST_CASE("a presenter counts hands by digits and by buttons") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("F2");
  bench.click("lesson/01-ray-casting");
  bench.click("lesson-presenter");
  bench.key("Enter");
  REQUIRE(bench.has("hand-more/1"));
  bench.key("2");
  bench.key("2");
  bench.key("1");
  bench.key("Shift+2");
  bench.click("hand-more/3");
  bench.click("hand-more/3");
  bench.click("hand-less/3");
  REQUIRE(bench.state.lessons.hands.size() >= 3);
  CHECK(bench.state.lessons.hands[0] == 1);
  CHECK(bench.state.lessons.hands[1] == 1);
  CHECK(bench.state.lessons.hands[2] == 1);
  CHECK_FALSE(bench.state.lessons.guess.choice);
  const Rect pane = bench.interface().layout().lesson;
  for (const char* item : {"hand-less/1", "hand-more/3"}) {
    CHECK(bench.rect(item).x >= pane.x);
    CHECK(bench.rect(item).right() <= pane.right());
  }
  bench.click("lesson-reveal");
  CHECK(bench.state.lessons.revealed);
  CHECK_FALSE(bench.has("hand-more/1"));
}

TEST_CASE("after the last step of a lesson the list shows the next one") {
  Bench bench(classic_with_lessons());
  bench.resize(1280, 720);
  update(bench.state, action::ShowLessons{true});
  update(bench.state, action::SetLessonOptions{false, true});
  bench.frames(3);
  const auto in_sight = [&](const std::string& item) {
    const Rect lines = bench.rect("lesson-lines"), where = bench.rect(item);
    return where.y >= lines.y && where.bottom() <= lines.bottom();
  };
  const std::string last = "lesson/" + bench.state.lessons.list.back().name;
  CHECK(in_sight("lesson/" + bench.state.lessons.list.front().name));
  CHECK_FALSE(in_sight(last));
  const LessonEntry& entry = bench.state.lessons.list[bench.state.lessons.list.size() - 2];
  const std::string name = entry.name;
  for (int step = 0; step <= entry.steps; ++step) {
    if (step == 0) update(bench.state, action::OpenLesson{name});
    update(bench.state, action::GoToLessonStep{step});
    bench.frames(1);
  }
  REQUIRE(bench.state.lessons.at() == nullptr);
  bench.frames(3);
  CHECK(in_sight(last));
}

TEST_CASE("everything of a lesson fits into its pane, in both languages") {
  for (const float scale : {1.0f, 1.5f}) {
    Bench bench(classic_with_lessons());
    bench.dpi = bench.unit = scale;
    bench.resize(1280 * scale, 720 * scale);
    update(bench.state, action::ShowLessons{true});
    for (const Language language : all_languages()) {
      update(bench.state, action::SetLanguage{std::string(language.code())});
      update(bench.state, action::SetLessonOptions{true, true});
      update(bench.state, action::OpenLesson{"05-refraction"});
      bench.frames(3);
      const Rect& pane = bench.interface().layout().lesson;
      for (const std::string item : {"lesson-list", "lesson-back", "lesson-reveal", "lesson-close", "lesson-presenter",
                                     "lesson-notes", "lesson-script"}) {
        CAPTURE(item, language.code(), scale);
        const Rect where = bench.rect(item);
        CHECK(where.x >= pane.x);
        CHECK(where.right() <= pane.right());
        CHECK(where.bottom() <= pane.bottom());
      }
    }
  }
}

TEST_CASE("on a telephone the answer is seen with its reason, and a notice covers neither EYE nor a light") {
  const FontFiles files = find_fonts(font_folders(""));
  Bench bench(classic_with_lessons(), 360, 640, files);
  bench.unit = bench.dpi = shrink_to_fit(360, 640, 1, true);
  update(bench.state, action::ShowFront{Front::lesson});
  update(bench.state, action::ShowLessons{true});
  for (const Language language : all_languages()) {
    update(bench.state, action::SetLanguage{std::string(language.code())});
    update(bench.state, action::OpenLesson{"01-ray-casting"});
    update(bench.state, action::SetLessonOptions{false, true});
    update(bench.state, action::GoToLessonStep{2});
    update(bench.state, action::SetLessonOptions{false, false});
    update(bench.state, action::Step{});  // asks for the prediction first
    bench.frames(3);
    CAPTURE(language.code());
    REQUIRE(bench.has("notice"));
    const Rect notice = bench.rect("notice"), plan = bench.rect("plan");
    const PlanRoom& room = bench.state.plan;
    for (const Target& target : {Target{TargetKind::eye}, Target{TargetKind::light, 0}}) {
      const Vec2d at = to_pixels(room.camera, room.viewport, place_of(bench.state, target, room.viewport));
      CHECK_FALSE(notice.contains(plan.x + static_cast<float>(at.x) * bench.dpi,
                                  plan.y + static_cast<float>(at.y) * bench.dpi));
    }
    update(bench.state, action::GuessChoice{0});
    update(bench.state, action::RevealLesson{});
    bench.frames(4);
    const Rect verdict = bench.rect("lesson-verdict"), seen = bench.rect("lesson-lines");
    CHECK(verdict.y >= seen.y);
    CHECK(seen.bottom() - verdict.bottom() > 2 * verdict.height);
    update(bench.state, action::LeaveLesson{});
  }
}

TEST_CASE("a guess stays in sight beside the verdict on it, where both fit") {
  const FontFiles files = find_fonts(font_folders(""));
  for (const auto& [width, height] : {std::pair{390.0f, 844.0f}, {844.0f, 390.0f}, {1280.0f, 720.0f}}) {
    Bench bench(classic_with_lessons(), width, height, files);
    bench.unit = bench.dpi = shrink_to_fit(width, height, 1, true);
    update(bench.state, action::ShowFront{Front::lesson});
    update(bench.state, action::ShowLessons{true});
    update(bench.state, action::OpenLesson{"01-ray-casting"});
    for (const int step : {1, 2}) {
      CAPTURE(width, step);
      update(bench.state, action::GoToLessonStep{step});
      bench.frames(4);
      const int choice = static_cast<int>(lesson_panel(bench.state).choices.size()) - 1;
      update(bench.state, action::GuessChoice{choice});
      update(bench.state, action::RevealLesson{});
      bench.frames(4);
      const Rect seen = bench.rect("lesson-lines"), verdict = bench.rect("lesson-verdict"),
                 guess = bench.rect("guess/" + std::to_string(choice + 1));
      CHECK(guess.y >= seen.y);
      CHECK(verdict.bottom() < seen.bottom());
    }
  }
}

TEST_CASE("a long title is shortened in a narrow window, and is told in full where it stands") {
  const FontFiles files = find_fonts(font_folders(""));
  for (const auto& [width, height] : {std::pair{390.0f, 844.0f}, {360.0f, 640.0f}}) {
    Bench bench(classic_with_lessons(), width, height, files);
    bench.unit = bench.dpi = shrink_to_fit(width, height, 1, true);
    update(bench.state, action::SetLanguage{"pt"});
    update(bench.state, action::ShowFront{Front::lesson});
    update(bench.state, action::ShowLessons{true});
    update(bench.state, action::SetLessonOptions{false, true});
    update(bench.state, action::OpenLesson{"13-whitted-to-path-tracing"});
    bench.frames(3);
    CAPTURE(width);
    REQUIRE(bench.has("document-title"));
    const Rect title = bench.rect("document-title");
    CHECK(title.width > 50);
    CHECK(title.right() <= width);
    CHECK_FALSE(bench.has("tooltip"));
    bench.point_at("document-title");
    bench.frames(60);
    REQUIRE(bench.has("tooltip"));
    CHECK(bench.rect("tooltip").width > title.width);
  }
}

TEST_CASE("a class's hands are counted beside each choice, and what is out of sight is marked") {
  for (const float unit : {1.0f, 1.25f}) {
    Bench bench(classic_with_lessons());
    bench.unit = unit;
    bench.resize(1280, 720);
    update(bench.state, action::SetLessonOptions{true, true});
    for (const std::string lesson : {"01-ray-casting", "03-shadows", "05-refraction", "07-shading"}) {
      update(bench.state, action::OpenLesson{lesson});
      REQUIRE(bench.state.lessons.open);
      const int steps = static_cast<int>(bench.state.lessons.open->played.steps.size());
      for (int step = 0; step < steps; ++step) {
        update(bench.state, action::GoToLessonStep{step});
        bench.frames(3);
        const LessonPanel panel = lesson_panel(bench.state);
        const Rect& pane = bench.interface().layout().lesson;
        float bottom = 0;
        for (std::size_t i = 0; i < panel.choices.size(); ++i) {
          const std::string key = std::to_string(i + 1);
          CAPTURE(unit, lesson, step, key);
          const Rect choice = bench.rect("guess/" + key), less = bench.rect("hand-less/" + key),
                     more = bench.rect("hand-more/" + key);
          CHECK(choice.y >= bottom);
          CHECK(choice.right() <= less.x);
          CHECK(less.right() <= more.x);
          CHECK(more.right() <= pane.right());
          CHECK(std::abs(less.y + less.height / 2 - choice.y - choice.height / 2) <= 1);
          bottom = choice.bottom();
        }
      }
    }
  }
}

TEST_CASE("lesson 1 in the real window: choice, arrow, number, language, and progress at the next start", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  const auto lesson = [](const char* member, const Json& value) {
    return
        [member, value](const Json& report) { return report.contains("lesson") && report["lesson"][member] == value; };
  };
  {
    Visualiser raywalk(desktop, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"});
    INFO(raywalk.said());
    REQUIRE(raywalk.until([](const Json& report) { return report["window"]["frames"].get<int>() >= 3; }, 60));
    raywalk.key("F2");
    raywalk.click("lesson/01-ray-casting");
    REQUIRE(raywalk.until(lesson("open", "01-ray-casting")));
    raywalk.click("lesson-next");
    REQUIRE(raywalk.until(lesson("step", 2)));
    raywalk.click("guess/2");
    raywalk.click("lesson-reveal");
    REQUIRE(raywalk.until(lesson("revealed", true)));
    CHECK(raywalk.report()["lesson"]["right"] == 1);
    raywalk.click("lesson-next");
    REQUIRE(raywalk.until(lesson("step", 3)));
    raywalk.key("3");
    raywalk.key("Return");
    REQUIRE(raywalk.until(lesson("revealed", true)));
    raywalk.key("Return");
    REQUIRE(raywalk.until(lesson("step", 4)));

    // The arrow: from the polygon towards the light.
    const auto place = [&](const char* kind, const char* name) {
      const Json& at = raywalk.report()[kind][name]["window"];
      return std::pair{at[0].get<double>(), at[1].get<double>()};
    };
    const auto [from_x, from_y] = place("objects", "Polygon");
    const auto [to_x, to_y] = place("lights", "Light Source");
    raywalk.drag(from_x, from_y, to_x, to_y);
    REQUIRE(raywalk.until(lesson("aimed", true)));
    CHECK(raywalk.report()["undo"] == 0);
    raywalk.click("lesson-reveal");
    REQUIRE(raywalk.until(lesson("right", 3)));
    const auto pictures = std::filesystem::path(std::getenv("RAYWALK_BIN")).parent_path() / "window-test";
    desktop.picture(pictures / "e-lesson.png");
    raywalk.click("lesson-next");
    REQUIRE(raywalk.until(lesson("step", 5)));
    raywalk.type("21");
    raywalk.key("Return");
    REQUIRE(raywalk.until(lesson("right", 4)));
    raywalk.key("ctrl+l");
    REQUIRE(raywalk.until([](const Json& report) { return report["language"] == "es"; }));
    desktop.picture(pictures / "e-lesson-es.png");
    raywalk.click("lesson-next");
    REQUIRE(raywalk.until(lesson("open", "")));
    // What a lesson does to its scene is no work of one's own: nothing is asked.
    raywalk.key("ctrl+q");
    CHECK(raywalk.wait() == 0);
    CHECK(raywalk.said() == "");
  }
  Visualiser raywalk(desktop, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"});
  REQUIRE(raywalk.until([](const Json& report) { return report["window"]["frames"].get<int>() >= 3; }, 60));
  raywalk.key("F2");
  raywalk.click("lesson/02-ray-meets-sphere");
  REQUIRE(raywalk.until(lesson("open", "02-ray-meets-sphere")));
  CHECK(raywalk.report()["language"] == "es");
}

TEST_CASE("lesson 5 in the window, as a teacher presents it: hands, notes, script, language, projector", "[window]") {
  NEEDS_A_DESKTOP
  ClassicWalk walk;
  Visualiser& raywalk = walk.raywalk;
  INFO(raywalk.said());
  REQUIRE(walk.started);
  raywalk.key("F2");
  REQUIRE(walk.until("lesson", "open", ""));
  raywalk.click("lesson-presenter");
  REQUIRE(walk.until("lesson", "presenter", true));
  raywalk.click("lesson/05-refraction");
  REQUIRE(walk.until("lesson", "open", "05-refraction"));
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "revealed", true));
  raywalk.key("Return");
  REQUIRE(walk.until("lesson", "step", 2));
  for (const char* hand : {"3", "3", "1", "3", "shift+3"}) raywalk.key(hand);
  REQUIRE(walk.until("lesson", "hands", Json::array({1, 0, 2})));
  raywalk.click("hand-more/2");
  REQUIRE(walk.until("lesson", "hands", Json::array({1, 1, 2})));
  raywalk.click("lesson-reveal");
  REQUIRE(walk.until("lesson", "revealed", true));
  walk.keep_picture("l5-presenter");
  raywalk.click("lesson-notes");
  REQUIRE(walk.until("lesson", "notes", true));
  raywalk.click("lesson-script");
  REQUIRE(raywalk.until("prompt", "export"));
  walk.keep_picture("l6-script");
  const std::string path = (walk.folder() / "five.script.html").string();
  raywalk.retype(path);
  raywalk.key("Return");
  REQUIRE(raywalk.until("prompt", ""));
  const auto script = read_file(path, 1 << 20);
  REQUIRE(script);
  CHECK(script->find("Into the glass") != std::string::npos);
  raywalk.key("ctrl+l");
  REQUIRE(raywalk.until("language", "es"));
  raywalk.key("p");
  REQUIRE(raywalk.until("theme", "projector"));
  raywalk.key("ctrl+equal");
  REQUIRE(raywalk.until([](const Json& report) { return report["ui_scale"].get<double>() > 1; }));
  walk.keep_picture("l7-projector");
  // Closed, one's own scene stands there again.
  raywalk.click("lesson-close");
  REQUIRE(raywalk.until([](const Json& report) { return !report.contains("lesson"); }));
  CHECK(raywalk.report()["path"].get<std::string>().ends_with("classic.toml"));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait() == 0);
}

TEST_CASE("in Focus question, choices and Reveal are whole, and the plan is large, in every lesson and language") {
  // What the projector's theme leaves of 1280 x 720: everything is a quarter larger.
  const FontFiles files = find_fonts(font_folders(""));
  Bench bench(classic_with_lessons(), 1024, 576, files);
  bench.settle = 1;
  bench.state.lessons.unlocked = true;
  update(bench.state, action::ShowLessons{true});
  update(bench.state, action::SetFocus{true});
  unsigned turn = 0;
  int questions = 0;
  for (const LessonEntry& entry : std::vector<LessonEntry>(bench.state.lessons.list)) {
    update(bench.state, action::OpenLesson{entry.name});
    REQUIRE(bench.state.lessons.at() != nullptr);
    for (int step = 0; step < entry.steps; ++step) {
      update(bench.state, action::GoToLessonStep{step});
      if (bench.state.lessons.at() == nullptr || !bench.state.lessons.at()->step->question) continue;
      for (const Language language : all_languages()) {
        if (const unsigned now = turn++; left_to_all(now + now / 3, 3)) continue;  // each question in one, in turn
        bench.state.appearance.language = language;
        bench.frames(2);
        INFO(entry.name << ", step " << step + 1 << ", " << language.code());
        const Layout& layout = bench.interface().layout();
        // The line that is asked for is clicked in the code, which stays.
        const bool asks_line = std::holds_alternative<LineQuestion>(*bench.state.lessons.at()->step->question);
        CHECK(bench.has("code") == asks_line);
        // A picture that the step shows large keeps the plan's place.
        Rect large = layout.plan.empty() ? layout.tabs : layout.plan;
        if (layout.plan.empty()) large.height += layout.choice.height;  // above it, in its place
        CHECK(large.width > (asks_line ? 0.3f : 0.6f) * 1024);
        CHECK(large.height > (asks_line ? 0.4f : 0.5f) * 576);
        REQUIRE(bench.has("lesson-reveal"));
        const Rect reveal = bench.rect("lesson-reveal");
        CHECK(reveal.bottom() <= layout.lesson.bottom());
        for (int choice = 1; bench.has("guess/" + std::to_string(choice)); ++choice)
          CHECK(bench.rect("guess/" + std::to_string(choice)).bottom() <= reveal.y);
        if (bench.has("lesson-number")) CHECK(bench.rect("lesson-number").bottom() <= reveal.y);
        ++questions;
      }
    }
  }
  CHECK(questions > (!sanitized && thorough() ? 100 : 30));
}

TEST_CASE("Focus folds what stands around the plan, and the same key or either edge brings it back") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("F2");
  const Layout before = bench.interface().layout();
  for (const std::string way : {"key", "focus", "folded", "folded-lesson"}) {
    CAPTURE(way);
    bench.key("Shift+F");
    bench.frames(2);
    CHECK(bench.state.focus.on);
    CHECK(bench.interface().layout().plan.width > 1.8f * before.plan.width);
    CHECK_FALSE(bench.has("code"));
    CHECK_FALSE(bench.has("tabs"));
    REQUIRE(bench.has("transport"));
    if (way == "key")
      bench.key("Shift+F");
    else
      bench.click(way);
    bench.frames(2);
    CHECK_FALSE(bench.state.focus.on);
    CHECK(bench.interface().layout().plan == before.plan);
  }
}

TEST_CASE("the presenter's notes have a window of their own, which closes again", "[window]") {
  NEEDS_A_DESKTOP
  const Desktop desktop(1280, 800);
  Visualiser raywalk(desktop, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"});
  INFO(raywalk.said());
  const auto notes = [](bool shown) {
    return
        [shown](const Json& report) { return report.contains("lesson") && report["lesson"]["notes_window"] == shown; };
  };
  REQUIRE(raywalk.until([](const Json& report) { return report["window"]["frames"].get<int>() >= 3; }, 60));
  raywalk.key("F2");
  raywalk.click("lesson/01-ray-casting");
  raywalk.key("alt+n");
  REQUIRE(raywalk.until(notes(true)));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  desktop.picture(std::filesystem::path(std::getenv("RAYWALK_BIN")).parent_path() / "window-test" / "l9-notes.png");
  // The walk goes on, and its window is drawn as before.
  raywalk.key("space");
  REQUIRE(raywalk.until([](const Json& report) { return report["position"].get<int>() > 0; }));
  raywalk.key("alt+n");
  REQUIRE(raywalk.until(notes(false)));
  raywalk.key("ctrl+q");
  CHECK(raywalk.wait(10) == 0);
}
