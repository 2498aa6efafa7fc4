
#include "view/lesson/lesson_panel.h"
#include "lesson/script.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

/// A value of the step's answer.
Outcome answer_of(const LessonRoom& sitting, const Expression& expression) {
  return value_at(sitting.open->played, static_cast<std::size_t>(sitting.step), sitting.at()->shown, expression);
}

std::optional<double> number_of(const LessonRoom& sitting, const NumberQuestion& question) {
  const Outcome value = answer_of(sitting, question.answer.expression);
  const double* number = value ? std::get_if<double>(&*value) : nullptr;
  return number == nullptr ? std::nullopt : std::optional(*number);
}

/// The correct direction of an arrow, in the plan.
std::optional<Vec2d> direction_of(const LessonRoom& sitting) {
  const PlayedStep& step = *sitting.at();
  const EventDetail& detail = step.walk->timeline.event(step.shown - 1).detail;
  if (const auto* formed = std::get_if<RayFormed>(&detail)) return plan(formed->direction);
  if (const auto* stub = std::get_if<RayNotFormed>(&detail)) return plan(stub->direction);
  return std::nullopt;
}

bool choice_holds(const LessonRoom& sitting, const Formula& choice) {
  const Outcome value = answer_of(sitting, choice.expression);
  return value && holds(*value);
}

/// When a presenter finishes the step, and the total time.
std::string time_of(const LessonRoom& sitting, const LessonWords& words, Language language) {
  const Lesson& lesson = sitting.open->lesson;
  const auto step = static_cast<std::size_t>(sitting.step);
  if (lesson.steps[step].extra) return std::string(text("lesson.extra", language));
  return fill("lesson.time", language,
              {{"end", minutes_text(script_time(lesson, words, step).end)},
               {"all", minutes_text(script_time(lesson, words, lesson.steps.size() - 1).end)}});
}

}  // namespace

namespace {

const std::string& told(const std::map<std::string, std::string, std::less<>>& words, Language language) {
  const auto own = words.find(language.code());
  return own == words.end() ? words.find("en")->second : own->second;
}

}  // namespace

const std::string& LessonEntry::title(Language language) const { return told(titles, language); }

const std::string& LessonEntry::summary(Language language) const { return told(summaries, language); }

std::vector<LessonRow> lesson_rows(const LessonRoom& sitting, Language language) {
  std::vector<LessonRow> rows;
  bool before_done = true;
  for (const LessonEntry& entry : sitting.list) {
    const auto done = sitting.done.find(entry.name);
    LessonRow row{entry.name, entry.title(language),
                  done == sitting.done.end() ? 0 : std::min(done->second, entry.steps), entry.steps, false};
    row.locked = !before_done && !sitting.unlocked && !sitting.presenter && row.done == 0;
    before_done = row.done == row.steps;
    rows.push_back(std::move(row));
  }
  // The lesson that was open last, or the first one after it that is not finished.
  const auto open = [](const LessonRow& row) { return !row.locked && row.done < row.steps; };
  const auto last =
      std::find_if(rows.begin(), rows.end(), [&](const LessonRow& row) { return row.name == sitting.last; });
  auto next = std::find_if(last == rows.end() ? rows.begin() : last, rows.end(), open);
  if (next == rows.end()) next = std::find_if(rows.begin(), rows.end(), open);
  if (next != rows.end()) next->next = true;
  return rows;
}

std::optional<LessonVerdict> judge(const LessonRoom& sitting) {
  const PlayedStep* step = sitting.at();
  if (step == nullptr || !step->step->question) return std::nullopt;
  const LessonQuestion& question = *step->step->question;
  if (const auto* choices = std::get_if<ChoiceQuestion>(&question)) {
    if (!sitting.guess.choice) return std::nullopt;
    const bool right = choice_holds(sitting, choices->choices[static_cast<std::size_t>(*sitting.guess.choice)]);
    return LessonVerdict{right, right ? 0.0 : 1.0};
  }
  if (const auto* number = std::get_if<NumberQuestion>(&question)) {
    if (!sitting.guess.number) return std::nullopt;
    const std::optional<double> truth = number_of(sitting, *number);
    if (!truth) return std::nullopt;
    return LessonVerdict{number->accepts(*sitting.guess.number, *truth), std::abs(*sitting.guess.number - *truth)};
  }
  if (std::holds_alternative<LineQuestion>(question)) {
    if (!sitting.guess.line || !step->walk->fault) return std::nullopt;
    const bool right = *sitting.guess.line == faulty_line(*step->walk->fault);
    return LessonVerdict{right, right ? 0.0 : 1.0};
  }
  const std::optional<Vec2d> truth = direction_of(sitting);
  if (!truth || !sitting.guess.arrow) return std::nullopt;
  const double degrees = degrees_between(*truth, *sitting.guess.arrow);
  return LessonVerdict{degrees <= std::get<ArrowQuestion>(question).tolerance, degrees};
}

LessonBeside left_before(const LessonRoom& sitting) {
  LessonBeside left = LessonBeside::unchanged;
  for (int i = sitting.step - 1; i >= 0 && left == LessonBeside::unchanged; --i)
    left = left_by(*sitting.open->played.steps[static_cast<std::size_t>(i)].step);
  return left;
}

bool lesson_enlarges(const State& state) {
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  if (step == nullptr || !step->step->large) return false;
  const LessonBeside last = left_by(*step->step);
  const Tab& tab = state.appearance.tab;
  return last == LessonBeside::picture ? tab == PictureRoom::tab : tab.word == name_of(last);
}

bool image_tells_answer(const State& state) {
  return mark_tells_answer(state) && !state.lessons.at()->step->pictures.empty();
}

bool mark_tells_answer(const State& state) {
  if (!withholds_answer(state)) return false;
  // What this step shows, or the last one before it that shows something: a picture is then what is asked about.
  const LessonBeside own = state.lessons.at()->step->pane;
  return (own == LessonBeside::unchanged ? left_before(state.lessons) : own) != LessonBeside::picture;
}

bool has_plans_place(const State& state) {
  const Tab& tab = state.appearance.tab;
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  if (step != nullptr && step->step->pane == LessonBeside::microscope && tab == MicroscopeRoom::tab)
    return !question_waits(state);
  return tab.large || (lesson_enlarges(state) && state.walk.mode != Mode::move);  // in Move the plan is worked on
}

bool exchanged_by_hand(const State& state) {
  return lesson_enlarges(state) ? state.lessons.exchanged[state.walk.mode == Mode::move ? 0 : 1]
                                : state.appearance.exchanges();
}

namespace {

/// How many first predictions were right, of the lesson that is or was open.
std::string score_of(const LessonRoom& sitting, Language language) {
  const auto tries = sitting.first_tries.find(sitting.last);
  if (tries == sitting.first_tries.end() || sitting.presenter) return {};  // a class counts its hands
  const int judged = tries->second.judged(), right = tries->second.right();
  if (judged == 0) return {};
  const std::string score =
      fmt::format("{} {} {} {}", right, text("lesson.of", language), judged, text("lesson.score", language));
  const LessonEntry* entry = sitting.entry(sitting.last);
  return sitting.at() != nullptr || entry == nullptr ? score : entry->title(language) + ": " + score;
}

}  // namespace

LessonPanel lesson_panel(const State& state) {
  const LessonRoom& sitting = state.lessons;
  const Language language = state.appearance.language;
  LessonPanel panel;
  const auto word = [&](std::string_view w) { return std::string(text(w, language)); };
  panel.score = score_of(sitting, language);
  const PlayedStep* step = sitting.at();
  if (step == nullptr) {
    panel.rows = lesson_rows(sitting, language);
    if (const std::optional<int>& chosen = sitting.chosen)
      for (std::size_t i = 0; i < panel.rows.size(); ++i) panel.rows[i].next = static_cast<int>(i) == *chosen;
    return panel;
  }
  const Lesson& lesson = sitting.open->lesson;
  const LessonWords& words = lesson.told(language);
  const Language told_in = lesson.told_in(language);
  if (told_in != language) panel.told_in = fill("lesson.in_english", language, {{"language", language.name()}});
  panel.lesson = words.title;
  panel.step = sitting.step + 1;
  panel.steps = static_cast<int>(sitting.open->played.steps.size());
  const StepWords* said = words.find(step->step->id);
  if (said == nullptr) return panel;
  const auto said_at = [&](const Passage& passage, int position) {
    return filled(sitting.open->played, static_cast<std::size_t>(sitting.step), position, passage, told_in)
        .value_or(passage.text);
  };
  panel.heading = with_quotes(said->heading, told_in);
  if (sitting.step == 0) panel.summary = with_quotes(words.summary.text, told_in);
  panel.text = said_at(said->text, step->asked);
  panel.is_last = panel.step == panel.steps;
  panel.can_go_back = sitting.step > 0;
  const bool answered = !step->step->question || sitting.revealed;
  panel.can_go_on = answered || sitting.unlocked || sitting.presenter;
  if (step->step->question) {
    const LessonQuestion& question = *step->step->question;
    panel.question = said_at(said->question, step->asked);
    const auto* choices = std::get_if<ChoiceQuestion>(&question);
    const auto* number = std::get_if<NumberQuestion>(&question);
    panel.asks = choices != nullptr                               ? Asks::choice
                 : number != nullptr                              ? Asks::number
                 : std::holds_alternative<LineQuestion>(question) ? Asks::line
                                                                  : Asks::arrow;
    if (panel.asks == Asks::line)
      panel.marked = sitting.guess.line
                         ? fill("bug.line_marked", language, {{"line", line_told(state, *sitting.guess.line)}})
                         : std::string(text("bug.task_of_lesson", language));
    int hands = 0, hands_right = 0;
    for (std::size_t i = 0; choices != nullptr && i < choices->choices.size() && i < said->choices.size(); ++i) {
      std::string text = said_at(said->choices[i], step->asked);
      std::erase(text, '`');
      LessonChoice choice{std::move(text), sitting.guess.choice == static_cast<int>(i),
                          answered && choice_holds(sitting, choices->choices[i])};
      if (i < sitting.hands.size()) choice.hands = sitting.hands[i];
      hands += choice.hands;
      hands_right += choice.right ? choice.hands : 0;
      panel.choices.push_back(std::move(choice));
    }
    if (answered && hands > 0) panel.hands = fill("lesson.hands", language, {{"right", hands_right}, {"all", hands}});
    if (number != nullptr) panel.unit = number->unit;
    const std::optional<LessonVerdict> verdict = sitting.revealed ? judge(sitting) : std::nullopt;
    if (sitting.revealed && !verdict && !sitting.presenter) panel.unanswered = word("lesson.unanswered");
    panel.can_reveal = !sitting.revealed && (sitting.guess.any() || sitting.unlocked || sitting.presenter);
    if (verdict) {
      panel.is_right = verdict->right;
      panel.verdict = word(verdict->right ? "lesson.right" : "lesson.wrong");
      const char mark = language.decimal_mark();
      if (panel.asks == Asks::arrow)
        panel.verdict += ": " + word("lesson.error") + " " + text_of(verdict->error, 1, mark) + "°";
      if (panel.asks == Asks::number && verdict->error > 0)
        panel.verdict += ": " + word("lesson.error") + " " +
                         text_of(verdict->error, decimals_of(*number, verdict->error), mark) + panel.unit;
    }
  }
  panel.astray = is_open_question(sitting) && !question_waits(state);
  if (answered) {
    panel.reveal = said_at(said->reveal, step->shown);
    panel.change = said_at(said->change, step->shown);
  }
  if (sitting.presenter) {
    panel.time = time_of(sitting, words, language);
  }
  if (sitting.presenter && sitting.notes) {
    const std::string script = said_at(said->presenter, step->shown);
    panel.presenter = answered ? script : parts_of_script(script).before;
    if (answered) panel.teacher = said_at(said->teacher, step->shown);
    if (answered && panel.is_last) {
      panel.notes = with_quotes(words.teacher.text, told_in);
      panel.sources = with_quotes(words.sources.text, told_in);
    }
  }
  return panel;
}

}  // namespace raywalk
