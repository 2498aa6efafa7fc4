#include "view/walk/asked.h"

#include <cmath>
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

}  // namespace

bool is_open_question(const LessonRoom& sitting) {
  const PlayedStep* step = sitting.at();
  return step != nullptr && step->step->question && !sitting.revealed &&
         !std::holds_alternative<LineQuestion>(*step->step->question);
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
  return state.walk.position == step.asked && state.scene() == step.walk->document.scene;
}

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

}  // namespace raywalk
