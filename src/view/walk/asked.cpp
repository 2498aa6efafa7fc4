#include "view/walk/asked.h"

#include "view/document/document.h"
#include "view/text/text.h"
#include "view/walk/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <variant>

namespace raywalk {

namespace {

std::optional<Vec2d> origin_of(const LessonRoom& sitting) {
  const PlayedStep& step = *sitting.at();
  const EventDetail& detail = step.walk->timeline.event(step.shown - 1).detail;
  if (const auto* formed = std::get_if<RayFormed>(&detail)) return plan(formed->origin);
  if (const auto* stub = std::get_if<RayNotFormed>(&detail)) return plan(stub->origin);
  return std::nullopt;
}

/// The question that the step after `position` answers.
std::optional<PredictionAsked> answered_after(const Timeline& timeline, int position) {
  if (position >= timeline.steps()) return std::nullopt;
  const auto after = timeline.rays_at(position + 1);
  const int ray = timeline.current_ray(position);
  // A beam or a cone goes many ways, and meets many things.
  if (timeline.has_width() &&
      timeline.rays()[static_cast<std::size_t>(std::max(timeline.current_ray(position + 1), 0))].beam >= 0)
    return std::nullopt;
  if (after.size() > timeline.rays_at(position).size()) {
    // A primary ray goes through its pixel: nothing to predict.
    const RayRecord& formed = after.back();
    const bool can_be_seen = length(plan(formed.direction)) > 1e-9 * length(formed.direction);
    if (!formed.formed || formed.kind == RayKind::primary || !can_be_seen) return std::nullopt;
    return PredictionAsked{static_cast<int>(after.size()) - 1, PredictionKind::way};
  }
  if (ray < 0 || ray >= static_cast<int>(after.size())) return std::nullopt;
  const RayRecord& followed = after[static_cast<std::size_t>(ray)];
  if (!followed.formed || followed.found_at != position + 1) return std::nullopt;
  return PredictionAsked{ray, PredictionKind::end};
}

/// Predictions are on, an arrow can be drawn, and neither a lesson nor a hunt asks its own questions.
bool may_ask(const State& state) {
  return state.predictions.on && !shows_lines(state) && !state.bugs.hunt &&
         !(state.lessons.shown && state.lessons.at() != nullptr);
}

}  // namespace

bool is_open_question(const LessonRoom& sitting) {
  const PlayedStep* step = sitting.at();
  return step != nullptr && step->step->question && !sitting.revealed &&
         !std::holds_alternative<LineQuestion>(*step->step->question);
}

std::optional<PixelWalk> pixel_of(const LessonWalk& walk) {
  if (!walk.pixel) return std::nullopt;
  return PixelWalk{walk.document.scene.image, walk.pixel->column, walk.pixel->row, {}};
}

bool is_staged(const State& state) {
  const PlayedStep* step = state.lessons.at();
  if (step == nullptr) return false;
  const LessonWalk& walk = *step->walk;
  const ImageSettings& settings = state.picture.settings;
  return state.scene() == walk.document.scene && state.walk.pixel == pixel_of(walk) && !settings.single_precision &&
         !settings.integrator && settings.walk_samples == 1 && !state.effects.leaves_out() &&
         fault_at_work(state) == walk.fault;
}

double degrees_between(const Vec2d& a, const Vec2d& b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b))) * 180 / std::numbers::pi;
}

int decimals_of(const NumberQuestion& question, double number) {
  constexpr int some = 2, most = 6;
  constexpr double beyond_counting = 1e9;
  if (number >= beyond_counting) return -1;
  if (question.tolerance > 0)
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(question.tolerance))), 0, most);
  return number == std::floor(number) ? 0 : some;
}

std::optional<Vec2d> guess_origin(const State& state) {
  const PlayedStep* step = state.lessons.at();
  if (!state.lessons.shown || step == nullptr || state.walk.mode != Mode::trace || !step->step->question)
    return std::nullopt;
  if (!std::holds_alternative<ArrowQuestion>(*step->step->question)) return std::nullopt;
  if (state.scene() != step->walk->document.scene) return std::nullopt;
  return origin_of(state.lessons);
}

bool question_waits(const State& state) {
  if (!state.lessons.shown || !is_open_question(state.lessons) || state.walk.mode != Mode::trace) return false;
  const PlayedStep& step = *state.lessons.at();
  return state.walk.position == step.asked && is_staged(state);
}

void ask_to_predict(State& state) {
  inform(state, std::string(text("lesson.predict_first", state.appearance.language)));
}

bool withholds_answer(const State& state) {
  if (question_waits(state)) return true;
  return state.walk.mode == Mode::move && state.lessons.shown && is_open_question(state.lessons);
}

bool withholds_end(const State& state) {
  if (withholds_answer(state)) return true;
  const auto asked = prediction_asked(state);
  return asked && asked->what == PredictionKind::end;
}

bool hides_rays_to_come(const State& state) { return withholds_answer(state) || state.predictions.on; }

std::optional<Vec2d> arrow_origin(const State& state) {
  const PlayedStep* step = state.lessons.at();
  if (state.lessons.revealed || step == nullptr || state.walk.position != step->asked) return std::nullopt;
  return guess_origin(state);
}

void guess_arrow(State& state, const Vec2d& towards) {
  const std::optional<Vec2d> origin = arrow_origin(state);
  if (!origin) return;
  const Vec2d arrow = towards - *origin;
  if (length(arrow) > 0) state.lessons.guess.arrow = arrow;
}

std::optional<PredictionAsked> prediction_asked(const State& state) {
  if (!may_ask(state) || state.walk.mode != Mode::trace || state.walk.playing) return std::nullopt;
  return answered_after(*state.walk.timeline, state.walk.position);
}

bool rests_for_prediction(const State& state, int position) {
  if (!may_ask(state)) return false;
  const auto asked = answered_after(*state.walk.timeline, position);
  return asked && asked->what == PredictionKind::way;
}

std::optional<Vec2d> aim_origin(const State& state) {
  if (const auto of_lesson = arrow_origin(state)) return of_lesson;
  const auto asked = prediction_asked(state);
  if (!asked || asked->what != PredictionKind::way) return std::nullopt;
  return plan(state.walk.timeline->rays()[static_cast<std::size_t>(asked->ray)].origin);
}

void forget_aim(State& state) {
  state.lessons.guess.arrow.reset();
  state.predictions.open.reset();
}

bool asks_for_line(const State& state) {
  if (state.bugs.hunt) return state.bugs.hunt->end == BugEnd::open;
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  return step != nullptr && step->step->question && std::holds_alternative<LineQuestion>(*step->step->question) &&
         !state.lessons.revealed;
}

std::optional<Line> marked_line(const State& state) {
  return state.bugs.hunt ? state.bugs.hunt->marked : state.lessons.shown ? state.lessons.guess.line : std::nullopt;
}

std::string question_with_answer(const PlayedLesson& played, std::size_t i, const StepWords& said, Language language) {
  const PlayedStep& step = played.steps[i];
  const auto filled_in = [&](const Passage& passage) {
    return filled(played, i, step.asked, passage, language).value_or(passage.text);
  };
  std::string question = filled_in(said.question);
  if (const auto* choices = std::get_if<ChoiceQuestion>(&*step.step->question)) {
    for (std::size_t c = 0; c < choices->choices.size() && c < said.choices.size(); ++c) {
      const Outcome value = value_at(played, i, step.shown, choices->choices[c].expression);
      question += fmt::format("\n{}. {}{}", c + 1, filled_in(said.choices[c]), value && holds(*value) ? " \u2713" : "");
    }
  } else if (const auto* number = std::get_if<NumberQuestion>(&*step.step->question)) {
    const Outcome value = value_at(played, i, step.shown, number->answer.expression);
    if (const double* truth = value ? std::get_if<double>(&*value) : nullptr)
      question +=
          "\n\n" + text_of(*truth, decimals_of(*number, *truth), language.decimal_mark()) + number->unit + " \u2713";
  } else if (std::holds_alternative<LineQuestion>(*step.step->question) && step.walk->fault) {
    question += "\n\n" + std::string(text(faulty_line(*step.walk->fault), language)) + " \u2713";
  }
  return question;
}

std::string line_told(const State& state, Line line) {
  const Language language = state.appearance.code_language();
  const std::string_view told = text(line, language);
  const auto& lines = pseudocode_with(line).lines;
  const auto its =
      std::find_if(lines.begin(), lines.end(), [&](const PseudocodeLine& one) { return one.line == line; });
  const bool is_alone = std::none_of(lines.begin(), lines.end(), [&](const PseudocodeLine& one) {
    return one.line != line && text(one.line, language) == told;
  });
  const auto governs = [&](const PseudocodeLine& one) {
    return one.procedure == its->procedure && one.indent < its->indent;
  };
  const auto head = std::find_if(std::make_reverse_iterator(its), lines.rend(), governs);
  if (is_alone || head == lines.rend()) return std::string(told);
  return fmt::format("{} ({})", told, text(head->line, language));
}

}  // namespace raywalk
