#pragma once
// Actions of the lessons.

#include "view/fields.h"

#include <string>

namespace raywalk::action {

struct ShowLessons {
  static constexpr std::string_view word = "lessons";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  [[nodiscard]] constexpr Traits traits() const { return {.of_own_scene = shown}; }
  void apply(State& state) const;
};
/// At the first unfinished step; asks first if there is unsaved work.
struct OpenLesson {
  static constexpr std::string_view word = "open-lesson";
  std::string name;
  static void fields(auto& f, auto& a) { f(a.name); }
  static constexpr Traits traits{.of_own_scene = true};
  void apply(State& state) const;
};
/// Back to the list, and to the previous scene.
struct LeaveLesson {
  static constexpr std::string_view word = "leave-lesson";
  void apply(State& state) const;
};
struct GoToLessonStep {
  static constexpr std::string_view word = "lesson-step";
  int step;  ///< from 0; past the last: finished, back to the list. Not past an unanswered question
  static void fields(auto& f, auto& a) { f(a.step); }
  void apply(State& state) const;
};
struct GuessChoice {
  static constexpr std::string_view word = "guess-choice";
  int choice;  ///< from 0
  static void fields(auto& f, auto& a) { f(a.choice); }
  void apply(State& state) const;
};
/// Arrows are dragged, and a line is guessed by MarkLine.
struct GuessNumber {
  static constexpr std::string_view word = "guess-number";
  double number;  ///< not finite: withdrawn
  static void fields(auto& f, auto& a) { f(a.number, Number::any); }
  void apply(State& state) const;
};
/// Shows the answer to the guess.
struct RevealLesson {
  static constexpr std::string_view word = "reveal";
  void apply(State& state) const;
};
/// A change of the number of hands for a lesson's choice.
struct ShowHands {
  static constexpr std::string_view word = "hands";
  int choice, hands;
  static void fields(auto& f, auto& a) { f(a.choice), f(a.hands); }
  void apply(State& state) const;
};
struct SetLessonOptions {
  static constexpr std::string_view word = "lesson-options";
  bool presenter = false, unlocked = false, without_notes = false;
  static void fields(auto& f, auto& a) {
    f(a.presenter, Flag{"presenter"}), f(a.unlocked, Flag{"unlocked"}), f(a.without_notes, Flag{"without-notes"});
  }
  void apply(State& state) const;
};

using OfLesson = Types<ShowLessons, OpenLesson, LeaveLesson, GoToLessonStep, GuessChoice, GuessNumber, RevealLesson,
                       ShowHands, SetLessonOptions>;

}  // namespace raywalk::action
