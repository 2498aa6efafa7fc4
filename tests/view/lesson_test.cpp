// Lessons as a student goes through them, without a window.
#include "view/lesson/lesson_panel.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"
#include "view/walk/asked.h"
#include "view/walk/status.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "fixtures.h"
#include "lesson_state.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "view/action.h"
#include "view/plan/painter.h"
#include "view/plan/plan_view.h"

using namespace raywalk;
using raywalk::test::make_dirty;
using raywalk::test::with_lessons;

namespace {

const std::string root = RAYWALK_SOURCE_DIR;

/// Goes to the first step of the open lesson that asks so.
void go_to_question(State& state, Asks asks) {
  while (lesson_panel(state).asks != asks) {
    const int step = lesson_panel(state).step;
    REQUIRE(step < lesson_panel(state).steps);
    update(state, action::GoToLessonStep{step});
    REQUIRE(lesson_panel(state).step == step + 1);
  }
}

}  // namespace

TEST_CASE("the list holds all lessons, of which the first is open to a student") {
  const State state = with_lessons();
  const auto rows = lesson_panel(state).rows;
  const auto folders = std::filesystem::directory_iterator(RAYWALK_SOURCE_DIR "/lessons");
  REQUIRE(static_cast<std::ptrdiff_t>(rows.size()) ==
          std::count_if(begin(folders), end(folders),
                        [](const auto& entry) { return std::filesystem::exists(entry.path() / "lesson.toml"); }));
  CHECK(rows[0].title == "Ray casting");
  CHECK_FALSE(rows[0].locked);
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i].locked);
}

TEST_CASE("a locked lesson opens when the one before is done, or when a teacher unlocks all") {
  State state = with_lessons();
  const std::string first = state.lessons.list[0].name, second = state.lessons.list[1].name;
  update(state, action::OpenLesson{second});
  CHECK(state.lessons.at() == nullptr);
  state.lessons.done[first] = state.lessons.list[0].steps;
  update(state, action::OpenLesson{second});
  REQUIRE(state.lessons.at() != nullptr);
  update(state, action::LeaveLesson{});
  update(state, action::SetLessonOptions{false, true});
  update(state, action::SetLanguage{"pt"});
  CHECK(lesson_panel(state).rows[12].title == "De Whitted ao traçado de caminhos");
  CHECK_FALSE(lesson_panel(state).rows[12].locked);
}

TEST_CASE("a lesson of the list is found by its name, and no other is") {
  const State state = with_lessons();
  for (const LessonEntry& each : state.lessons.list) CHECK(state.lessons.entry(each.name) == &each);
  CHECK(state.lessons.entry("") == nullptr);
  CHECK(state.lessons.entry("no such lesson") == nullptr);
}

TEST_CASE("the list marks the lesson to go on with: the open one, or what comes after the one just finished") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  const auto marked = [&] {
    std::vector<std::string> names;
    for (const LessonRow& row : lesson_panel(state).rows)
      if (row.next) names.push_back(row.name);
    return names;
  };
  const std::vector<LessonEntry> list = state.lessons.list;
  using Names = std::vector<std::string>;
  CHECK(marked() == Names{list[0].name});
  // Left before its end.
  update(state, action::OpenLesson{list[2].name});
  update(state, action::GoToLessonStep{1});
  update(state, action::LeaveLesson{});
  CHECK(marked() == Names{list[2].name});
  // Finished, although the first ones are not.
  update(state, action::OpenLesson{list[2].name});
  for (int step = 1; step <= list[2].steps; ++step) update(state, action::GoToLessonStep{step});
  REQUIRE(state.lessons.at() == nullptr);
  CHECK(marked() == Names{list[3].name});
  // After the last one, the first that is left; once all are done, none.
  state.lessons.last = list.back().name;
  state.lessons.done[list.back().name] = list.back().steps;
  CHECK(marked() == Names{list[0].name});
  for (const LessonEntry& entry : list) state.lessons.done[entry.name] = entry.steps;
  CHECK(marked().empty());
}

TEST_CASE("an answer shown without a prediction says that it does not count, but not to a presenter") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  CHECK(lesson_panel(state).unanswered.empty());
  State guessed = state, presented = state;
  update(state, action::RevealLesson{});
  CHECK_THAT(lesson_panel(state).unanswered, test::contains("not counted"));
  CHECK(lesson_panel(state).score.empty());
  update(guessed, action::GuessChoice{0});
  update(guessed, action::RevealLesson{});
  CHECK(lesson_panel(guessed).unanswered.empty());
  update(presented, action::SetLessonOptions{true, true});
  update(presented, action::RevealLesson{});
  CHECK(lesson_panel(presented).unanswered.empty());
}

TEST_CASE("a question holds a student until it is answered, and shows then where its line leads") {
  State state = with_lessons();
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  const PlayedStep& step = *state.lessons.at();
  CHECK(state.walk.mode == Mode::trace);
  CHECK(state.walk.position == step.asked);
  CHECK_FALSE(lesson_panel(state).can_go_on);
  CHECK_FALSE(lesson_panel(state).can_reveal);
  CHECK(lesson_panel(state).reveal.empty());
  const int number = state.lessons.step;
  update(state, action::GoToLessonStep{number + 1});
  CHECK(state.lessons.step == number);
  update(state, action::GuessChoice{7});
  CHECK_FALSE(state.lessons.guess.choice);
  update(state, action::GuessChoice{2});
  CHECK(lesson_panel(state).can_reveal);
  update(state, action::RevealLesson{});
  CHECK(state.walk.position == step.shown);
  CHECK_FALSE(lesson_panel(state).is_right);
  CHECK_FALSE(lesson_panel(state).reveal.empty());
  CHECK_THAT(lesson_panel(state).score, test::contains("0 of 1"));
  int right = 0;
  for (const LessonChoice& choice : lesson_panel(state).choices) right += choice.right ? 1 : 0;
  CHECK(right == 1);
  CHECK(lesson_panel(state).can_go_on);
}

TEST_CASE("STEP asks for the prediction first, and then shows the answer") {
  State state = with_lessons();
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  const PlayedStep& step = *state.lessons.at();
  REQUIRE(question_waits(state));
  for (const Action& forward : {Action(action::Step{}), Action(action::Step{true, Grain::pixel}),
                                Action(action::Hold{}), Action(action::PlayPause{})}) {
    update(state, forward);
    CHECK_FALSE(state.walk.playing);
    CHECK(state.walk.position == step.asked);
    CHECK_FALSE(state.walk.hold);
    CHECK_FALSE(state.lessons.revealed);
  }
  REQUIRE(state.document.notice);
  CHECK(state.document.notice->text == text("lesson.predict_first", test::in_english));
  update(state, action::GuessChoice{0});
  update(state, action::Step{});
  CHECK(state.lessons.revealed);
  CHECK(state.walk.position == step.shown);
  CHECK_FALSE(question_waits(state));
  update(state, action::Step{});
  CHECK(state.walk.position == step.shown + 1);
}

TEST_CASE("AUTO comes to rest at a question that is still open") {
  State state = with_lessons();
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  const int asked = state.walk.position;
  update(state, action::Jump{asked - 3});
  update(state, action::PlayPause{});
  REQUIRE(state.walk.playing);
  for (int tick = 0; tick < 20; ++tick) update(state, action::Tick{1.0});
  CHECK(state.walk.position == asked);
  CHECK_FALSE(state.walk.playing);
}

TEST_CASE("the tree does not show rays that are still to be predicted") {
  State state = with_lessons();
  const auto future = [&] {
    const std::vector<TreeNode> nodes = tree_panel(state).nodes;
    return std::count_if(nodes.begin(), nodes.end(), [](const TreeNode& node) { return node.future; });
  };
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  CHECK(future() == 0);
  CHECK(tree_panel(state).nodes.size() == 1);
  update(state, action::GuessChoice{1});
  update(state, action::RevealLesson{});
  CHECK(future() > 0);
  update(state, action::SetPredictions{true});
  CHECK(future() == 0);
}

TEST_CASE("what is typed and is no number takes the guess before it back") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"01-ray-casting"});
  go_to_question(state, Asks::number);
  update(state, action::GuessNumber{12});
  CHECK(state.lessons.guess.number == 12);
  update(state, action::GuessNumber{std::nan("")});
  CHECK_FALSE(state.lessons.guess.number);
}

TEST_CASE("a student who leaves a question is shown the way back") {
  State state = with_lessons();
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  CHECK_FALSE(lesson_panel(state).astray);
  const int asked = state.walk.position, step = state.lessons.step;
  update(state, action::Step{false});
  CHECK(lesson_panel(state).astray);
  update(state, action::Step{});  // back to it, by foot
  CHECK_FALSE(lesson_panel(state).astray);
  update(state, action::Select{{TargetKind::object, 0}});
  update(state, action::Nudge{{1, 0}});
  CHECK(lesson_panel(state).astray);
  update(state, action::GoToLessonStep{step});
  CHECK(state.walk.position == asked);
  CHECK(question_waits(state));
  CHECK_FALSE(lesson_panel(state).astray);
}

TEST_CASE("the script gives no answer away before it stands there, nor do the notes") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{true, false});
  for (const LessonEntry& entry : std::vector(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    REQUIRE(state.lessons.at() != nullptr);
    for (bool more = true; more;) {
      const LessonPanel asked = lesson_panel(state);
      CAPTURE(entry.name, asked.heading);
      CHECK_FALSE(asked.presenter.empty());
      if (asked.asks != Asks::nothing) {
        CHECK(asked.teacher.empty());
        update(state, action::RevealLesson{});
      }
      const LessonPanel shown = lesson_panel(state);
      CHECK(shown.presenter.starts_with(asked.presenter));
      CHECK(shown.notes.empty() == !shown.is_last);
      more = !shown.is_last;
      update(state, action::GoToLessonStep{shown.step});
    }
  }
  update(state, action::OpenLesson{"05-refraction"});
  update(state, action::GoToLessonStep{0});
  CHECK(lesson_panel(state).time.starts_with("until 1:"));
  update(state, action::SetLessonOptions{true, false, true});
  CHECK(lesson_panel(state).presenter.empty());
  update(state, action::SetLessonOptions{true, false, false});
  CHECK(lesson_panel(state).presenter.find("Reveal") != std::string::npos);
  update(state, action::RevealLesson{});
  update(state, action::GoToLessonStep{1});
  CHECK(lesson_panel(state).presenter.ends_with("Reveal."));
  CHECK(lesson_panel(state).choices.size() == 3);
}

TEST_CASE("a class shows hands for the choices, and the answer says how many were right") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{true, false});
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  for (const auto& [choice, hands] :
       {std::pair(0, 3), std::pair(1, 5), std::pair(0, -1), std::pair(2, -4), std::pair(9, 1)})
    update(state, action::ShowHands{choice, hands});
  std::vector<int> counted;
  for (const LessonChoice& choice : lesson_panel(state).choices) counted.push_back(choice.hands);
  REQUIRE(counted.size() >= 3);
  CHECK(counted[0] == 2);
  CHECK(counted[1] == 5);
  CHECK(counted[2] == 0);
  CHECK(lesson_panel(state).hands.empty());  // what is right is not told yet
  update(state, action::RevealLesson{});
  const LessonPanel panel = lesson_panel(state);
  int right = 0;
  for (const LessonChoice& choice : panel.choices) right += choice.right ? choice.hands : 0;
  CHECK(panel.hands == "Right: " + std::to_string(right) + " of 7 hands");
  update(state, action::ShowHands{0, 1});
  CHECK(lesson_panel(state).choices[0].hands == 2);
  update(state, action::GoToLessonStep{state.lessons.step + 1});
  CHECK(state.lessons.hands.empty());
}

TEST_CASE("an arrow is dragged in the plan, and judged by its angle") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"04-reflection"});
  REQUIRE(lesson_panel(state).asks == Asks::arrow);
  const auto origin = arrow_origin(state);
  REQUIRE(origin);
  const auto& formed =
      std::get<RayFormed>(state.lessons.at()->walk->timeline.event(state.lessons.at()->shown - 1).detail);
  const Vec2d truth(formed.direction.x, formed.direction.y);
  const double tilt = 0.1;  // radians
  const Vec2d guess(truth.x * std::cos(tilt) - truth.y * std::sin(tilt),
                    truth.x * std::sin(tilt) + truth.y * std::cos(tilt));
  const auto pixels = [&](const Vec2d& at) { return to_pixels(state.plan.camera, state.plan.viewport, at); };
  const PlanCamera camera = state.plan.camera;
  update(state, action::PointerPressed{pixels(*origin + Vec2d(1, 0))});
  update(state, action::PointerMoved{pixels(*origin + 2.0 * guess)});
  update(state, action::PointerReleased{pixels(*origin + 2.0 * guess)});
  CHECK(state.plan.camera == camera);
  CHECK_FALSE(state.plan.drag);
  const auto verdict = judge(state.lessons);
  REQUIRE(verdict);
  CHECK(std::abs(verdict->error - tilt * 180 / 3.14159265358979) < 1e-6);
  CHECK(verdict->right);
  update(state, action::RevealLesson{});
  CHECK(lesson_panel(state).is_right);
  CHECK(state.lessons.first_tries[state.lessons.last].right() == 1);
  CHECK_FALSE(arrow_origin(state));
  CHECK(guess_origin(state));
  CHECK(is_finite(plan_view(state, state.plan.viewport)));
}

TEST_CASE("both borders of a tolerance count as right, however the truth was rounded") {
  NumberQuestion question{{"t", *Expression::parse("t")}, 0, "", std::nullopt};
  for (const auto& [truth, tolerance] :
       {std::pair(0.5, 0.05), std::pair(9.000000000000002, 1.0), std::pair(4.0, 0.0)}) {
    question.tolerance = tolerance;
    const double at = std::round(100 * truth) / 100;
    for (const double side : {-1.0, 1.0}) {
      CHECK(question.accepts(std::round(100 * (at + side * tolerance)) / 100, truth));
      CHECK_FALSE(question.accepts(at + side * (tolerance + 0.001), truth));
    }
  }
}

TEST_CASE("a number counts as right within its tolerance") {
  for (const bool near : {true, false}) {
    State state = with_lessons();
    update(state, action::SetLessonOptions{false, true});
    update(state, action::OpenLesson{"02-ray-meets-sphere"});
    go_to_question(state, Asks::number);
    const auto& question = std::get<NumberQuestion>(*state.lessons.at()->step->question);
    const double t = std::get<Found>(state.lessons.at()->walk->timeline.event(state.lessons.at()->shown - 1).detail).t;
    update(state, action::GuessNumber{t - question.tolerance * (near ? 0.99 : 1.01)});
    update(state, action::RevealLesson{});
    CHECK(lesson_panel(state).is_right == near);
    CHECK(state.lessons.first_tries[state.lessons.last].right() == (near ? 1 : 0));
  }
}

TEST_CASE("every step of every lesson stands on the screen where the lesson was checked") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{true, true});
  for (const LessonEntry& entry : state.lessons.list) {
    update(state, action::OpenLesson{entry.name});
    INFO(entry.name);
    REQUIRE(state.lessons.at() != nullptr);
    for (int step = 0; step < entry.steps; ++step) {
      INFO(step);
      const PlayedStep& played = *state.lessons.at();
      CHECK(state.walk.timeline->steps() == played.walk->timeline.steps());
      CHECK(state.walk.position == played.asked);
      CHECK_FALSE(lesson_panel(state).text.empty());
      CHECK_FALSE(lesson_panel(state).presenter.empty());
      update(state, action::RevealLesson{});
      CHECK(state.walk.position == played.shown);
      update(state, action::GoToLessonStep{step + 1});
    }
    CHECK(state.lessons.at() == nullptr);
    CHECK(state.lessons.done[entry.name] == entry.steps);
  }
}

TEST_CASE("a step hides the rays of pixels before its own, unless its answer takes them all") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"01-ray-casting"});
  go_to_question(state, Asks::number);
  CHECK(state.lessons.first_pixel == 9);
  // Also when the scene was changed before, or the lesson taken up again here.
  const int step = state.lessons.step;
  update(state, action::GoToLessonStep{step - 1});
  make_dirty(state);
  update(state, action::GoToLessonStep{step});
  CHECK(state.lessons.first_pixel == 9);
  update(state, action::GuessNumber{21});
  update(state, action::RevealLesson{});
  CHECK(lesson_panel(state).is_right);
  CHECK(state.lessons.first_pixel == 0);
}

TEST_CASE("a step with a bug asks for the line at fault, and mends the tracer when it is over") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"04-reflection"});
  go_to_question(state, Asks::line);
  REQUIRE(state.walk.bug);
  CHECK(fault_at_work(state) == Fault::reflection_flipped);
  CHECK(asks_for_line(state));
  CHECK(state.walk.timeline->steps() == state.lessons.at()->walk->timeline.steps());
  update(state, action::MendBug{true});
  CHECK(fault_at_work(state));  // not before it is known
  update(state, action::MarkLine{Line::form_shadow_ray});
  CHECK_THAT(lesson_panel(state).marked, test::contains("Form shadow ray"));
  update(state, action::MarkLine{Line::form_reflect_ray});
  update(state, action::RevealLesson{});
  CHECK(lesson_panel(state).is_right);
  CHECK(state.lessons.first_tries[state.lessons.last].right() == 1);
  CHECK_FALSE(asks_for_line(state));
  update(state, action::MendBug{true});
  CHECK_FALSE(fault_at_work(state));
  update(state, action::MendBug{false});

  // Nobody is left with a broken tracer: neither beside closed lessons, nor in another step, nor after the lesson.
  const int step = state.lessons.step;
  update(state, action::ShowLessons{false});
  CHECK_FALSE(state.walk.bug);
  update(state, action::ShowLessons{true});
  CHECK(fault_at_work(state) == Fault::reflection_flipped);
  update(state, action::GoToLessonStep{step - 1});
  CHECK_FALSE(state.walk.bug);
  CHECK(state.walk.timeline->steps() == state.lessons.at()->walk->timeline.steps());
  update(state, action::GoToLessonStep{step});
  CHECK(state.walk.bug);
  CHECK(lesson_panel(state).is_right);  // as it was left
  update(state, action::SetLessonOptions{true});
  update(state, action::GoToLessonStep{step});
  CHECK_FALSE(state.lessons.revealed);  // for another class
  update(state, action::GuessChoice{0});
  update(state, action::MarkLine{Line::form_shadow_ray});
  update(state, action::RevealLesson{});
  CHECK_FALSE(lesson_panel(state).is_right);
  update(state, action::LeaveLesson{});
  CHECK_FALSE(state.walk.bug);
}

TEST_CASE("a changed scene of a bug is restored with the answer") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"04-reflection"});
  go_to_question(state, Asks::line);
  const Scene asked = state.scene();
  make_dirty(state);
  update(state, action::MarkLine{Line::form_reflect_ray});
  update(state, action::RevealLesson{});
  CHECK(state.scene() == asked);
  CHECK(fault_at_work(state) == Fault::reflection_flipped);
  CHECK(state.walk.bug->known);
  CHECK(lesson_panel(state).is_right);
}

TEST_CASE("an answer is shown in the walk that was asked about, wherever a student has walked meanwhile") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{true, false});
  update(state, action::OpenLesson{state.lessons.list[0].name});
  go_to_question(state, Asks::choice);
  update(state, action::ShowHands{1, 3});
  update(state, action::GuessChoice{0});
  const Timeline& asked = state.lessons.at()->walk->timeline;
  SECTION("a pixel of the picture") { update(state, action::WalkPixel{0, 0, {4, 3}}); }
  SECTION("single precision") {
    ImageSettings settings = state.picture.settings;
    settings.single_precision = true;
    update(state, action::SetImageSettings{settings});
  }
  SECTION("several samples") {
    ImageSettings settings = state.picture.settings;
    settings.walk_samples = 2;
    update(state, action::SetImageSettings{settings});
  }
  SECTION("a changed scene") { make_dirty(state); }
  CHECK_FALSE(question_waits(state));
  update(state, action::RevealLesson{});
  CHECK(state.lessons.revealed);
  CHECK(is_staged(state));
  CHECK(state.walk.timeline->steps() == asked.steps());
  CHECK(state.walk.position == state.lessons.at()->shown);
  CHECK(state.lessons.guess.choice == 0);
  REQUIRE(lesson_panel(state).choices.size() > 1);
  CHECK(lesson_panel(state).choices[1].hands == 3);
}

TEST_CASE("a change of a lesson's scene that was walked on from is not offered for recovery") {
  const test::TemporaryFolder folder;
  State state = with_lessons(folder.path());
  update(state, action::OpenLesson{state.lessons.list[0].name});
  make_dirty(state);
  update(state, action::Tick{1});
  REQUIRE(std::filesystem::exists(folder.file("autosave.toml")));
  update(state, action::GoToLessonStep{1});
  CHECK_FALSE(state.document.dirty);
  CHECK_FALSE(std::filesystem::exists(folder.file("autosave.toml")));
}

TEST_CASE("no step beyond a question is reached at once") {
  State state = with_lessons();
  update(state, action::OpenLesson{state.lessons.list[0].name});
  REQUIRE(lesson_panel(state).can_go_on);
  update(state, action::GoToLessonStep{99});
  CHECK(state.lessons.at() != nullptr);
  CHECK(state.lessons.step == 1);
  CHECK(lesson_rows(state.lessons, test::in_english)[0].done == 1);
  // A teacher may.
  update(state, action::SetLessonOptions{false, true});
  update(state, action::GoToLessonStep{3});
  CHECK(state.lessons.step == 3);
}

TEST_CASE("beside closed lessons the rays of all pixels are shown again") {
  State state = with_lessons();
  update(state, action::SetLessonOptions{false, true});
  update(state, action::OpenLesson{"01-ray-casting"});
  go_to_question(state, Asks::number);
  REQUIRE(rays_shown(state).first_pixel > 0);
  update(state, action::ShowLessons{false});
  CHECK(rays_shown(state).first_pixel == 0);
}

TEST_CASE("a lesson whose folder's name is no UTF-8 is walked like any other") {
  const test::TemporaryFolder folder;
  const std::string name = "1-caf\xe9";
  std::filesystem::create_directories(folder.file("lessons"));
  std::error_code refused;  // as some file systems do
  std::filesystem::copy(root + "/lessons/01-ray-casting", folder.file("lessons/" + name), refused);
  if (refused) return;
  State state = with_lessons(folder.file("state"));
  state.lessons.list.clear();
  state.lessons.folder = folder.file("lessons");
  update(state, action::OpenLesson{name});
  REQUIRE(state.lessons.open);
  update(state, action::GoToLessonStep{1});
  CHECK(state.lessons.step == 1);
  CHECK(std::filesystem::exists(folder.file("state/lessons.json")));
}
