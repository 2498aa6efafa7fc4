#include "view/lesson_panel.h"

#include "view/bug_text.h"
#include "view/plan_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raywalk {

std::string_view lesson_word(LessonWord word, std::string_view language) {
  const auto in = [&](std::string_view english, std::string_view portuguese) {
    return language == "pt" ? portuguese : english;
  };
  switch (word) {
    case LessonWord::lessons:
      return in("Lessons", "Lições");
    case LessonWord::next:
      return in("Next", "Próximo");
    case LessonWord::back:
      return in("Back", "Voltar");
    case LessonWord::reveal:
      return in("Reveal", "Revelar");
    case LessonWord::all_lessons:
      return in("All lessons", "Todas as lições");
    case LessonWord::finish:
      return in("Finish", "Concluir");
    case LessonWord::presenter:
      return in("Presenter", "Apresentador");
    case LessonWord::unlock:
      return in("Unlock all", "Liberar todas");
    case LessonWord::predict:
      return in("Predict", "Preveja");
    case LessonWord::drag_arrow:
      return in("Drag an arrow in the plan", "Arraste uma seta na planta");
    case LessonWord::type_number:
      return in("Type a number, then Enter", "Digite um número e Enter");
    case LessonWord::change:
      return in("Now change something", "Agora mude algo");
    case LessonWord::teacher:
      return in("Teacher's notes", "Notas do professor");
    case LessonWord::right:
      return in("Right", "Certo");
    case LessonWord::wrong:
      return in("Not quite", "Ainda não");
    case LessonWord::error:
      return in("off by", "erro de");
    case LessonWord::of:
      return in("of", "de");
    case LessonWord::locked:
      return in("finish the lesson before", "conclua a lição anterior");
    case LessonWord::done:
      return in("done", "concluída");
    case LessonWord::score:
      return in("predictions right", "previsões certas");
  }
  return "";
}

namespace {

/// A value of the step's answer.
Outcome answer_of(const LessonSitting& sitting, const Expression& expression) {
  return value_at(sitting.open->played, static_cast<std::size_t>(sitting.step), sitting.at()->shown, expression);
}

std::optional<double> number_of(const LessonSitting& sitting, const NumberQuestion& question) {
  const Outcome value = answer_of(sitting, question.answer.expression);
  const double* number = value ? std::get_if<double>(&*value) : nullptr;
  return number == nullptr ? std::nullopt : std::optional(*number);
}

/// The direction that an arrow has to have, as the plan shows it.
std::optional<Vec2d> direction_of(const LessonSitting& sitting) {
  const PlayedStep& step = *sitting.at();
  const EventDetail& detail = step.walk->timeline.event(step.shown - 1).detail;
  if (const auto* formed = std::get_if<RayFormed>(&detail)) return plan(formed->direction);
  if (const auto* stub = std::get_if<RayNotFormed>(&detail)) return plan(stub->direction);
  return std::nullopt;
}

std::optional<Vec2d> origin_of(const LessonSitting& sitting) {
  const PlayedStep& step = *sitting.at();
  const EventDetail& detail = step.walk->timeline.event(step.shown - 1).detail;
  if (const auto* formed = std::get_if<RayFormed>(&detail)) return plan(formed->origin);
  if (const auto* stub = std::get_if<RayNotFormed>(&detail)) return plan(stub->origin);
  return std::nullopt;
}

bool choice_holds(const LessonSitting& sitting, const Formula& choice) {
  const Outcome value = answer_of(sitting, choice.expression);
  return value && holds(*value);
}

}  // namespace

std::vector<LessonRow> lesson_rows(const LessonSitting& sitting) {
  std::vector<LessonRow> rows;
  bool before_done = true;
  for (const LessonEntry& entry : sitting.list) {
    const auto done = sitting.done.find(entry.name);
    const auto title = entry.titles.find(sitting.language);
    LessonRow row{entry.name, title == entry.titles.end() ? entry.name : title->second,
                  done == sitting.done.end() ? 0 : std::min(done->second, entry.steps), entry.steps, false};
    row.locked = !before_done && !sitting.unlocked && row.done == 0;
    before_done = row.done == row.steps;
    rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<LessonVerdict> judge(const LessonSitting& sitting) {
  const PlayedStep* step = sitting.at();
  if (step == nullptr || !step->step->question) return std::nullopt;
  const LessonQuestion& question = *step->step->question;
  if (const auto* choices = std::get_if<ChoiceQuestion>(&question)) {
    if (!sitting.guess.choice) return std::nullopt;
    const bool right = choice_holds(sitting, choices->choices[static_cast<std::size_t>(*sitting.guess.choice)]);
    return LessonVerdict{right, right ? 0.0 : 1.0};
  }
  if (const auto* number = std::get_if<NumberQuestion>(&question)) {
    const std::optional<double> truth = number_of(sitting, *number);
    if (!truth || !sitting.guess.number) return std::nullopt;
    const double error = std::abs(*sitting.guess.number - *truth);
    return LessonVerdict{error <= number->tolerance, error};
  }
  if (std::holds_alternative<LineQuestion>(question)) {
    if (!sitting.guess.line || !step->walk->fault) return std::nullopt;
    const bool right = *sitting.guess.line == faulty_line(*step->walk->fault);
    return LessonVerdict{right, right ? 0.0 : 1.0};
  }
  const std::optional<Vec2d> truth = direction_of(sitting);
  if (!truth || !sitting.guess.arrow) return std::nullopt;
  const Vec2d& guess = *sitting.guess.arrow;
  const double degrees = std::abs(std::atan2(cross(*truth, guess), dot(*truth, guess))) * 180 / std::numbers::pi;
  return LessonVerdict{degrees <= std::get<ArrowQuestion>(question).tolerance, degrees};
}

std::optional<Vec2d> guess_origin(const State& state) {
  const PlayedStep* step = state.lessons.at();
  if (!state.lessons.shown || step == nullptr || state.mode != Mode::trace || !step->step->question)
    return std::nullopt;
  if (!std::holds_alternative<ArrowQuestion>(*step->step->question)) return std::nullopt;
  if (state.scene() != step->walk->document.scene) return std::nullopt;
  return origin_of(state.lessons);
}

std::optional<Vec2d> arrow_origin(const State& state) {
  const PlayedStep* step = state.lessons.at();
  if (state.lessons.revealed || step == nullptr || state.position != step->asked) return std::nullopt;
  return guess_origin(state);
}

LessonPanel lesson_panel(const State& state) {
  const LessonSitting& sitting = state.lessons;
  LessonPanel panel;
  const auto word = [&](LessonWord w) { return std::string(lesson_word(w, sitting.language)); };
  if (sitting.judged > 0)
    panel.score =
        fmt::format("{} {} {} {}", sitting.right, word(LessonWord::of), sitting.judged, word(LessonWord::score));
  const PlayedStep* step = sitting.at();
  if (step == nullptr) {
    panel.rows = lesson_rows(sitting);
    return panel;
  }
  const LessonWords& words = sitting.open->lesson.words.find(sitting.language)->second;
  panel.lesson = words.title;
  panel.step = sitting.step + 1;
  panel.steps = static_cast<int>(sitting.open->played.steps.size());
  const StepWords* said = words.find(step->step->id);
  if (said == nullptr) return panel;
  const auto fill = [&](const Passage& passage, int position) {
    return filled(sitting.open->played, static_cast<std::size_t>(sitting.step), position, passage, sitting.language)
        .value_or(passage.text);
  };
  panel.heading = said->heading;
  panel.text = fill(said->text, step->asked);
  panel.is_last = panel.step == panel.steps;
  panel.can_go_back = sitting.step > 0;
  const bool answered = !step->step->question || sitting.revealed;
  panel.can_go_on = answered || sitting.unlocked;
  if (step->step->question) {
    const LessonQuestion& question = *step->step->question;
    panel.question = fill(said->question, step->asked);
    const auto* choices = std::get_if<ChoiceQuestion>(&question);
    const auto* number = std::get_if<NumberQuestion>(&question);
    panel.asks = choices != nullptr                               ? Asks::choice
                 : number != nullptr                              ? Asks::number
                 : std::holds_alternative<LineQuestion>(question) ? Asks::line
                                                                  : Asks::arrow;
    if (panel.asks == Asks::line)
      panel.marked = sitting.guess.line ? bug_text(BugText::line_marked, sitting.language,
                                                   {std::string(pseudocode_of(*sitting.guess.line).text)})
                                        : std::string(bug_text(BugText::task_of_lesson, sitting.language));
    for (std::size_t i = 0; choices != nullptr && i < choices->choices.size() && i < said->choices.size(); ++i)
      panel.choices.push_back({fill(said->choices[i], step->asked), sitting.guess.choice == static_cast<int>(i),
                               answered && choice_holds(sitting, choices->choices[i])});
    if (number != nullptr) panel.unit = number->unit;
    const std::optional<LessonVerdict> verdict = judge(sitting);
    panel.can_reveal = !sitting.revealed && (verdict || sitting.unlocked || sitting.presenter);
    if (sitting.revealed && verdict) {
      panel.is_right = verdict->right;
      panel.verdict = word(verdict->right ? LessonWord::right : LessonWord::wrong);
      const char mark = sitting.language == "pt" ? ',' : '.';
      if (panel.asks == Asks::arrow)
        panel.verdict += ": " + word(LessonWord::error) + " " + text_of(verdict->error, 1, mark) + "°";
      if (panel.asks == Asks::number && verdict->error > 0)
        panel.verdict += ": " + word(LessonWord::error) + " " + text_of(verdict->error, -1, mark) + panel.unit;
    }
  }
  if (answered) {
    panel.reveal = fill(said->reveal, step->shown);
    panel.change = fill(said->change, step->shown);
  }
  if (sitting.presenter) {
    panel.presenter = fill(said->presenter, step->shown);
    panel.teacher = fill(said->teacher, step->shown);
  }
  return panel;
}

}  // namespace raywalk
