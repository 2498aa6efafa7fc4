#include "view/predict/predict.h"

#include "text/file.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raywalk {

namespace {

const RayRecord& ray_of(const State& state, const PredictionAsked& asked) {
  return state.walk.timeline->rays()[static_cast<std::size_t>(asked.ray)];
}

/// The position from which the answer is shown.
int answered_at(const State& state, const PredictionAsked& asked) {
  const RayRecord& ray = ray_of(state, asked);
  return asked.what == PredictionKind::way ? ray.formed_at : ray.found_at;
}

/// What a ray hit, as a click target.
Target met_by(const RayRecord& ray) {
  switch (ray.ending) {
    case Ending::hit:
    case Ending::scattered:
    case Ending::blocked:
      return {TargetKind::object, ray.object};
    case Ending::reached_light:  // a lamp, an object that gives off light, or the sky, where nothing can be clicked
      if (ray.light >= 0) return {TargetKind::light, ray.light};
      return ray.object >= 0 ? Target{TargetKind::object, ray.object} : Target{};
    case Ending::missed:
    case Ending::depth:
    case Ending::threshold:
    case Ending::total_internal_reflection:
    case Ending::path_length:
    case Ending::facing_away:
    case Ending::outside_cone:
    case Ending::wrong_side:
      return {};
  }
  return {};
}

/// Whether the question was the same, and has the same answer: about such a ray of the same scene, on whatever walk.
bool asks_the_same(const PredictionRecord& a, const PredictionRecord& b) {
  return a.scene == b.scene && a.kind == b.kind && a.what == b.what && a.origin == b.origin &&
         a.direction == b.direction && a.met == b.met;
}

std::string name_of(const State& state, const Target& target) {
  return target ? target_text(state, target) : std::string(text("predict.nothing", state.appearance.language));
}

std::string said(const State& state, std::string_view id, const TextArguments& arguments = {}) {
  return fill(id, state.appearance.language, arguments);
}

void write_predictions(State& state, const std::string& path) {
  if (const auto written = write_file_atomically(path, prediction_table(state.predictions)); !written)
    return complain(state, written.error().text());
  state.predictions.saved = state.predictions.made.size();
  const PathPrompt asked = std::exchange(state.document.prompt, PathPrompt::none);
  inform(state, fill("notice.saved_as", state.appearance.language, {{"file", path}}));
  if (asked != PathPrompt::save_predictions) return;
  if (const std::optional<Intent> intent = std::exchange(state.document.after_save, std::nullopt))
    intent->carry_out(state, state.document.after_save_path);
}

}  // namespace

int PredictRoom::right() const {
  return static_cast<int>(std::count_if(made.begin(), made.end(), [](const auto& one) { return one.right; }));
}

std::string prediction_sentence(const State& state) {
  const PredictRoom& predictions = state.predictions;
  std::string verdict;
  if (!predictions.judged.empty() && answered_at(state, predictions.judged.back().of) == state.walk.position) {
    const Prediction& last = predictions.judged.back();
    const std::string truth = name_of(state, met_by(ray_of(state, last.of)));
    if (last.of.what == PredictionKind::way)
      verdict = said(state, last.right ? "predict.off" : "predict.off_too_far",
                     {{"degrees", number_text(std::round(last.degrees), state.appearance.language)}});
    else if (last.right)
      verdict = said(state, "predict.met_right", {{"object", truth}});
    else
      verdict = said(state, "predict.met_wrong", {{"object", truth}, {"guess", name_of(state, last.met)}});
    verdict += " ";
  }
  if (const auto asked = prediction_asked(state)) {
    const std::string kind(text(ray_of(state, *asked).kind, state.appearance.language));
    const bool guessed = predictions.open && predictions.open->of == *asked;
    if (asked->what == PredictionKind::way)
      return verdict + said(state, guessed ? "predict.way_guessed" : "predict.ask_way", {{"ray", kind}});
    return verdict + (guessed ? said(state, "predict.end_guessed", {{"guess", name_of(state, predictions.open->met)}})
                              : said(state, "predict.ask_end", {{"ray", kind}}));
  }
  const bool at_end = state.walk.position == state.walk.timeline->steps();
  if (predictions.made.empty()) return said(state, at_end ? "predict.idle_at_end" : "predict.idle");
  return verdict + said(state, "predict.score", {{"right", predictions.right()}, {"all", predictions.made.size()}});
}

std::string prediction_table(const PredictRoom& predictions) {
  std::string table = "scene,step,ray,asked,degrees_off,right\n";
  for (const PredictionRecord& one : predictions.made) {
    std::string scene = one.scene;
    std::replace_if(scene.begin(), scene.end(), [](char c) { return c == ',' || c == '"' || c == '\n'; }, '_');
    const bool way = one.what == PredictionKind::way;
    table +=
        fmt::format("{},{},{},{},{},{}\n", scene, one.step, name_of(one.kind), way ? "where it goes" : "what it meets",
                    way ? fmt::format("{:.1f}", one.degrees) : "", one.right ? 1 : 0);
  }
  return table;
}

void action::SetPredictions::apply(State& state) const {
  state.predictions.on = on;
  state.predictions.open.reset();
  if (on) state.walk.mode = Mode::trace;
}

void action::GuessWay::apply(State& state) const {
  if (arrow_origin(state)) return guess_arrow(state, towards);
  const auto origin = aim_origin(state);
  if (!origin || !(length(towards - *origin) > 0)) return;
  state.predictions.open = Prediction{*prediction_asked(state), towards - *origin};
}

void action::GuessAngle::apply(State& state) const {
  const double angle = degrees * std::numbers::pi / 180;
  if (const auto origin = aim_origin(state)) GuessWay{*origin + Vec2d(std::cos(angle), std::sin(angle))}.apply(state);
}

void action::GuessEnd::apply(State& state) const {
  const auto asked = prediction_asked(state);
  const bool can_be_met = !met || met.kind == TargetKind::object || met.kind == TargetKind::light;
  if (!asked || asked->what != PredictionKind::end || !can_be_met || !exists(state, met)) return;
  state.predictions.open = Prediction{*asked, Vec2d(0.0), {met.kind, met.index}};
}

void action::TurnGuess::apply(State& state) const {
  const auto origin = aim_origin(state);
  if (!origin) return;
  std::optional<Vec2d> arrow;
  if (arrow_origin(state))
    arrow = state.lessons.guess.arrow;
  else if (const auto& open = state.predictions.open; open && open->of == prediction_asked(state))
    arrow = open->arrow;
  if (!arrow) return GuessAngle{90}.apply(state);
  GuessAngle{std::atan2(arrow->y, arrow->x) * 180 / std::numbers::pi + degrees}.apply(state);
}

void action::NextGuess::apply(State& state) const {
  const auto asked = prediction_asked(state);
  if (!asked || asked->what != PredictionKind::end) return;
  const int objects = static_cast<int>(state.scene().objects.size());
  const int all = objects + static_cast<int>(state.scene().lights.size()) + 1;
  int at = by > 0 ? -1 : 0;
  if (const auto& open = state.predictions.open; open && open->of == *asked) {
    const Target& met = open->met;
    at = met.kind == TargetKind::object ? met.index : met.kind == TargetKind::light ? objects + met.index : all - 1;
  }
  at = ((at + by) % all + all) % all;
  GuessEnd{at < objects   ? Target{TargetKind::object, at}
           : at < all - 1 ? Target{TargetKind::light, at - objects}
                          : Target{}}
      .apply(state);
}

void action::AskSavePredictions::apply(State& state) const {
  if (state.predictions.made.empty())
    return inform(state, std::string(text("predict.nothing_to_save", state.appearance.language)));
  ask_path(state, PathPrompt::save_predictions);
}

void action::SavePredictions::apply(State& state) const {
  if (path.empty()) return;
  if (state.document.prompt == PathPrompt::save_predictions) state.document.notice.reset();
  if (!asks_to_overwrite(state, path, write_predictions)) write_predictions(state, path);
}

void PredictRoom::follow(State& state, const Before&) {
  PredictRoom& predictions = state.predictions;
  if (predictions.of_walk != state.walk.timeline) {
    predictions.open.reset();
    predictions.judged.clear();
    predictions.of_walk = state.walk.timeline;
  }
  if (!predictions.open) return;
  const PredictionAsked asked = predictions.open->of;
  if (state.walk.position < answered_at(state, asked)) {
    if (prediction_asked(state) != asked) predictions.open.reset();
    return;
  }
  Prediction judged = *std::exchange(predictions.open, std::nullopt);
  const RayRecord& ray = ray_of(state, asked);
  if (asked.what == PredictionKind::way) {
    judged.degrees = degrees_between(plan(ray.direction), judged.arrow);
    judged.right = judged.degrees <= PredictRoom::right_within;
  } else {
    judged.right = judged.met == met_by(ray);
  }
  std::erase_if(predictions.judged, [&](const Prediction& one) { return one.of == asked; });
  predictions.judged.push_back(judged);
  const PredictionRecord record{state.document.path,
                                answered_at(state, asked),
                                ray.kind,
                                asked.what,
                                judged.degrees,
                                judged.right,
                                ray.origin,
                                ray.direction,
                                asked.what == PredictionKind::end ? met_by(ray) : Target{}};
  // Whoever guesses again has seen the answer.
  const bool seen = std::any_of(predictions.made.begin(), predictions.made.end(),
                                [&](const PredictionRecord& one) { return asks_the_same(one, record); });
  if (!seen) predictions.made.push_back(record);
}

}  // namespace raywalk
