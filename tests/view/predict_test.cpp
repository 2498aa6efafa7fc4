// Predictions on any walk: when they are asked for, how they are judged, and what is kept of them.
#include "view/predict/predict.h"

#include "fixtures.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "timeline/message.h"
#include "view/document/question.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <cmath>
#include <numbers>

using namespace raywalk;
using namespace raywalk::test;

namespace {

State predicting() {
  State state = classic_state();
  update(state, action::SetPredictions{true});
  return state;
}

/// To the first position at which such a question is asked about such a ray.
void to_question(State& state, PredictionKind what, RayKind kind) {
  for (int position = state.walk.position + 1; position < state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    const auto asked = prediction_asked(state);
    if (asked && asked->what == what && state.walk.timeline->rays()[static_cast<std::size_t>(asked->ray)].kind == kind)
      return;
  }
  FAIL("nothing is asked");
}

const RayRecord& asked_ray(const State& state) {
  return state.walk.timeline->rays()[static_cast<std::size_t>(prediction_asked(state)->ray)];
}

Vec2d turned(const Vec2d& v, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

}  // namespace

TEST_CASE("nothing is asked before predictions are switched on, while AUTO plays, or outside Trace") {
  State state = classic_state();
  for (int position = 0; position <= state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    CHECK_FALSE(prediction_asked(state));
    CHECK_FALSE(aim_origin(state));
  }
  update(state, action::Clear{});
  update(state, action::SetPredictions{true});
  to_question(state, PredictionKind::way, RayKind::shadow);
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(prediction_asked(state));
  update(state, action::SetMode{Mode::trace});
  CHECK(prediction_asked(state));
  update(state, action::PlayPause{});
  CHECK_FALSE(prediction_asked(state));
}

TEST_CASE("an arrow is dragged from the ring, the step that forms the ray judges it, and it stays beside the ray") {
  const auto [degrees, right] = GENERATE(std::pair(0.0, true), std::pair(8.0, true), std::pair(-35.0, false));
  const RayKind kind = GENERATE(RayKind::shadow, RayKind::reflect, RayKind::refract);
  State state = predicting();
  to_question(state, PredictionKind::way, kind);
  const RayRecord ray = asked_ray(state);
  const Vec2d origin = plan(ray.origin);
  REQUIRE(aim_origin(state) == origin);
  const Vec2d tip = origin + 2.0 * turned(plan(ray.direction) / length(plan(ray.direction)), degrees);
  const std::size_t undone = state.document.undo.size();
  drag(state, to_pixels(state, origin + Vec2d(0, 1)), to_pixels(state, tip));
  REQUIRE(state.predictions.open);
  CHECK(state.document.undo.size() == undone);
  CHECK(state.predictions.judged.empty());
  const std::size_t drawn_open = plan_view(state, state.plan.viewport).size();
  update(state, action::Step{});
  CHECK_FALSE(state.predictions.open);
  REQUIRE(state.predictions.judged.size() == 1);
  CHECK(state.predictions.judged[0].degrees == Approx(std::abs(degrees)).margin(0.01));
  CHECK(state.predictions.judged[0].right == right);
  CHECK(state.predictions.right() == (right ? 1 : 0));
  CHECK(prediction_sentence(state).find(std::to_string(static_cast<int>(std::abs(degrees)))) != std::string::npos);
  // The ray, the guess and its angle stand there now.
  CHECK(plan_view(state, state.plan.viewport).size() > drawn_open);
  // Back before the answer the guess is not shown again, nor counted twice; nor is one by who has seen the answer.
  update(state, action::Step{false});
  update(state, action::Step{});
  CHECK(state.predictions.made.size() == 1);
  update(state, action::Step{false});
  update(state, action::GuessWay{origin + plan(ray.direction)});
  update(state, action::Step{});
  CHECK(state.predictions.made.size() == 1);
  REQUIRE(state.predictions.judged.size() == 1);
  CHECK(state.predictions.judged[0].right);
}

TEST_CASE("a click whose pointer has left before it ended counts where it began") {
  State state = predicting();
  to_question(state, PredictionKind::end, RayKind::primary);
  update(state, action::PointerPressed{Vec2d(3, 3)});
  update(state, action::PointerLeft{});
  update(state, action::Step{});  // which ends the click first
  CHECK(state.predictions.made.size() == 1);
}

TEST_CASE("what a ray meets is clicked: a body, a light, or the empty plan, whatever rays lie over it") {
  State state = predicting();
  int seen_object = 0, seen_light = 0, seen_nothing = 0;
  for (int position = 0; position < state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    const auto asked = prediction_asked(state);
    if (!asked || asked->what != PredictionKind::end) continue;
    const RayRecord& ray = asked_ray(state);
    const bool stopped = ray.ending == Ending::hit || ray.ending == Ending::blocked;
    const Target truth = stopped                               ? Target{TargetKind::object, ray.object}
                         : ray.ending == Ending::reached_light ? Target{TargetKind::light, ray.light}
                                                               : Target{};
    const std::size_t before = state.predictions.made.size();
    update(state, action::GuessEnd{truth});
    REQUIRE(state.predictions.open);
    update(state, action::Step{});
    REQUIRE(state.predictions.made.size() == before + 1);
    CHECK(state.predictions.made.back().right);
    (stopped ? seen_object : truth ? seen_light : seen_nothing) += 1;
  }
  CHECK(seen_object > 0);
  CHECK(seen_light > 0);
  CHECK(seen_nothing > 0);

  // By mouse, and wrong.
  update(state, action::Clear{});
  to_question(state, PredictionKind::end, RayKind::primary);
  const int glass = index_of_object(state.scene(), "Transparent Sphere");
  REQUIRE(asked_ray(state).object != glass);
  const Vec2d at = pixels_of(state, {TargetKind::object, glass});
  drag(state, at, at);
  REQUIRE(state.predictions.open);
  CHECK(state.predictions.open->met == Target{TargetKind::object, glass});
  CHECK(prediction_sentence(state).find("Transparent Sphere") != std::string::npos);
  update(state, action::Step{});
  CHECK_FALSE(state.predictions.judged.back().right);
  // What no ray can meet is no guess.
  to_question(state, PredictionKind::end, RayKind::primary);
  update(state, action::GuessEnd{{TargetKind::eye}});
  update(state, action::GuessEnd{{TargetKind::object, 99}});
  CHECK_FALSE(state.predictions.open);
}

TEST_CASE("of a path a shadow ray meets the object that it was aimed at, or the sky, where nothing is clicked") {
  const auto [name, message] = GENERATE(std::pair("radiosity", "walk.object_seen"), std::pair("gold", "walk.sky_seen"));
  State state = state_of([&, name = name] {
    Scene scene = read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml").scene;
    scene.render.integrator = Integrator::path;
    return scene;
  }());
  update(state, action::SetPredictions{true});
  int seen = 0;
  for (int position = 0; position < state.walk.timeline->steps() && seen < 3; ++position) {
    if (describe(state.scene(), *state.walk.timeline, position + 1).id != message) continue;
    update(state, action::Jump{position});
    const bool in_sky = std::string_view(message) == "walk.sky_seen";
    update(state,
           action::GuessEnd{in_sky ? Target{} : Target{TargetKind::object, index_of_object(state.scene(), "Lamp")}});
    REQUIRE(state.predictions.open);
    update(state, action::Step{});
    CHECK(state.predictions.made.back().right);
    ++seen;
  }
  CHECK(seen == 3);
}

TEST_CASE("AUTO, held steps, runs and large steps come to rest where a ray is to be predicted") {
  const auto is_rest = [](const State& state) {
    const auto asked = prediction_asked(state);
    return asked && asked->what == PredictionKind::way;
  };
  State state = predicting();
  update(state, action::RunOn{});
  CHECK(is_rest(state));
  const int first = state.walk.position;
  update(state, action::RunOn{});
  CHECK(is_rest(state));
  CHECK(state.walk.position > first);
  update(state, action::Clear{});
  update(state, action::Step{true, Grain::pixel});
  update(state, action::Step{true, Grain::pixel});
  CHECK(is_rest(state));
  update(state, action::Clear{});
  update(state, action::PlayPause{});
  for (int i = 0; i < 1000 && state.walk.playing; ++i) update(state, action::Tick{0.1});
  CHECK_FALSE(state.walk.playing);
  CHECK(state.walk.position == first);
  CHECK(is_rest(state));
  update(state, action::Clear{});
  update(state, action::Hold{true});
  for (int i = 0; i < 1000 && state.walk.hold; ++i) update(state, action::Tick{0.1});
  CHECK(state.walk.position == first);
  // Among lines in space no arrow can be drawn: nothing is asked, and nothing holds.
  update(state, action::Clear{});
  update(state, action::ShowLines{true});
  update(state, action::RunOn{});
  CHECK(state.walk.position == state.walk.timeline->steps());
  update(state, action::ShowLines{false});
  // Switched off, nothing holds.
  update(state, action::Clear{});
  update(state, action::SetPredictions{false});
  update(state, action::RunOn{});
  CHECK(state.walk.position == state.walk.timeline->steps());
}

TEST_CASE("a lesson's own questions and a hunt go before; a guess that was walked away from is forgotten") {
  State state = predicting();
  to_question(state, PredictionKind::way, RayKind::reflect);
  update(state, action::GuessWay{plan(asked_ray(state).origin) + Vec2d(1, 0)});
  REQUIRE(state.predictions.open);
  update(state, action::Step{false});
  CHECK_FALSE(state.predictions.open);
  CHECK(state.predictions.made.empty());
  // A new walk: what was judged of the old one is not drawn, but counted.
  to_question(state, PredictionKind::way, RayKind::reflect);
  update(state, action::GuessWay{plan(asked_ray(state).origin) + Vec2d(1, 0)});
  update(state, action::Step{});
  REQUIRE(state.predictions.judged.size() == 1);
  update(state, action::SetLimits{{2, 0}});
  CHECK(state.predictions.judged.empty());
  CHECK(state.predictions.made.size() == 1);
  state.lessons.folder = std::string(RAYWALK_SOURCE_DIR) + "/lessons";
  state.lessons.scenes_folder = std::string(RAYWALK_SOURCE_DIR) + "/scenes";
  update(state, action::HuntBug{1});
  REQUIRE(state.bugs.hunt);
  for (int position = 0; position < state.walk.timeline->steps(); ++position) {
    update(state, action::Jump{position});
    CHECK_FALSE(prediction_asked(state));
  }
}

TEST_CASE("a question whose answer was seen is counted once, on another walk of the scene too") {
  const PredictionKind what = GENERATE(PredictionKind::way, PredictionKind::end);
  State state = predicting();
  const RayKind kind = RayKind::reflect;
  const auto predict = [&] {
    update(state, action::Clear{});
    to_question(state, what, kind);
    if (what == PredictionKind::way)
      update(state, action::GuessAngle{30});
    else
      update(state, action::GuessEnd{});
    REQUIRE(state.predictions.open);
    update(state, action::Step{});
    REQUIRE(state.predictions.judged.size() == 1);
  };
  predict();
  CHECK(state.predictions.made.size() == 1);
  const auto walk = state.walk.timeline;
  update(state, action::SwitchEffect{Effect::refraction, false});
  REQUIRE(state.walk.timeline != walk);
  update(state, action::SwitchEffect{Effect::refraction, true});
  REQUIRE(state.predictions.judged.empty());
  predict();
  CHECK(state.predictions.made.size() == 1);
  // In a scene that is another one the ray goes from elsewhere.
  Camera camera = state.scene().camera;
  camera.eye.y += 0.1;
  update(state, action::SetCamera{camera});
  predict();
  CHECK(state.predictions.made.size() == 2);
  update(state, action::Undo{});
  predict();
  CHECK(state.predictions.made.size() == 2);
}

TEST_CASE("leaving asks once about predictions that are not saved, after it has asked about the scene") {
  const TemporaryFolder folder;
  State state = predicting();
  to_question(state, PredictionKind::way, RayKind::reflect);
  update(state, action::GuessAngle{30});
  update(state, action::Step{});
  REQUIRE(state.predictions.made.size() == 1);
  make_dirty(state);
  using action::Answer;
  const auto kind = [&] {
    REQUIRE(state.document.question);
    return state.document.question->kind;
  };
  // Called off at either.
  update(state, action::Quit{});
  CHECK(kind() == Question::Kind::unsaved);
  update(state, action::AnswerQuestion{Answer::cancel});
  CHECK_FALSE(state.document.question);
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::discard});
  CHECK(kind() == Question::Kind::predictions);
  CHECK(question_panel(state).text == text("question.predictions_quit", in_english));
  update(state, action::AnswerQuestion{Answer::cancel});
  CHECK_FALSE(state.document.quit);
  CHECK(state.document.dirty);
  // The dialog for the file may be called off, too; what is then saved ends nothing.
  update(state, action::Quit{});
  update(state, action::AnswerQuestion{Answer::discard});
  update(state, action::AnswerQuestion{Answer::save});
  CHECK(state.document.prompt == PathPrompt::save_predictions);
  update(state, action::CancelPrompt{});
  update(state, action::SaveAs{folder.file("scene.toml")});
  CHECK_FALSE(state.document.dirty);
  CHECK_FALSE(state.document.quit);
  State thrown_away = state, kept = state;
  update(thrown_away, action::Quit{});
  update(thrown_away, action::AnswerQuestion{Answer::discard});
  CHECK(thrown_away.document.quit);
  update(state, action::Quit{});
  CHECK(kind() == Question::Kind::predictions);
  update(state, action::AnswerQuestion{Answer::save});
  update(state, action::SavePredictions{folder.file("no/such/folder.csv")});
  CHECK_FALSE(state.document.quit);
  update(state, action::SavePredictions{folder.file("mine.csv")});
  CHECK(state.document.quit);
  CHECK(read_file(folder.file("mine.csv"), 1 << 16).has_value());
  // What is saved is not asked about.
  update(kept, action::SavePredictions{folder.file("kept.csv")});
  update(kept, action::Quit{});
  CHECK(kept.document.quit);
}

TEST_CASE("predictions are saved as a table, and no file is written over unasked") {
  const TemporaryFolder folder;
  State state = predicting();
  update(state, action::AskSavePredictions{});
  CHECK(state.document.prompt == PathPrompt::none);  // there is none yet
  REQUIRE(state.document.notice);
  to_question(state, PredictionKind::way, RayKind::reflect);
  update(state, action::GuessWay{plan(asked_ray(state).origin) + plan(asked_ray(state).direction)});
  const int answered = state.walk.position + 1;
  update(state, action::Step{});
  update(state, action::AskSavePredictions{});
  CHECK(state.document.prompt == PathPrompt::save_predictions);
  const std::string path = folder.file("predictions.csv");
  update(state, action::SavePredictions{path});
  CHECK(state.document.prompt == PathPrompt::none);
  const auto table = read_file(path, 1 << 16);
  REQUIRE(table);
  CHECK(*table == "scene,step,ray,asked,degrees_off,right\n" + state.document.path + "," + std::to_string(answered) +
                      ",reflect,where it goes,0.0,1\n");
  // What stands there already is written over only when that is said.
  update(state, action::Step{});
  to_question(state, PredictionKind::way, RayKind::refract);
  update(state, action::GuessWay{plan(asked_ray(state).origin) + plan(asked_ray(state).direction)});
  update(state, action::Step{});
  update(state, action::AskSavePredictions{});
  update(state, action::SavePredictions{path});
  REQUIRE(state.document.question);
  CHECK(read_file(path, 1 << 16) == table);
  update(state, action::AnswerQuestion{action::Answer::cancel});
  CHECK(state.document.prompt == PathPrompt::save_predictions);
  update(state, action::SavePredictions{path});
  update(state, action::AnswerQuestion{action::Answer::save});
  CHECK(state.document.prompt == PathPrompt::none);
  CHECK(read_file(path, 1 << 16)->size() > table->size());
  update(state, action::SavePredictions{folder.file("no/such/folder.csv")});
  CHECK(state.document.notice->kind == Notice::Kind::error);
}
