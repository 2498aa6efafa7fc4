#pragma once
// Lessons: their list, and the open one.

#include "io/scene_file.h"
#include "lesson/play.h"
#include "view/document/room.h"
#include "view/fields.h"
#include "view/picture/room.h"
#include "view/room.h"
#include "view/walk/room.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raywalk {

/// A lesson of the list.
struct LessonEntry {
  std::string name;                                                 ///< of its folder
  std::map<std::string, std::string, std::less<>> titles;           ///< by the languages' codes
  [[nodiscard]] const std::string& title(Language language) const;  ///< in English if there is none in this language
  std::map<std::string, std::string, std::less<>> summaries{};      ///< likewise: what one learns, in a sentence
  [[nodiscard]] const std::string& summary(Language language) const;
  std::string scene{};  ///< the shipped one that it begins with; empty if it has its own
  int steps = 0;
};

/// An open lesson. Never copied: `played` points into `lesson`.
struct OpenedLesson {
  explicit OpenedLesson(Lesson of) : lesson(std::move(of)) {}
  OpenedLesson(const OpenedLesson&) = delete;
  OpenedLesson& operator=(const OpenedLesson&) = delete;
  Lesson lesson;
  PlayedLesson played;
};

/// The prediction at this step, by the kind of its question.
struct LessonGuess {
  std::optional<int> choice;  ///< from 0
  std::optional<double> number;
  std::optional<Vec2d> arrow;  ///< where it points, from the ray's origin; scene units, not of length 0
  std::optional<Line> line;    ///< suspected to be faulty
  [[nodiscard]] bool any() const { return choice || number || arrow || line; }
  friend bool operator==(const LessonGuess&, const LessonGuess&) = default;
};

/// The scene that was open before a lesson was.
struct OwnScene {
  SceneDocument document;
  std::string path;  ///< empty: never saved
  Mode mode{};
  int position = 0;  ///< of its walk
  ImageSettings settings;
  Tab tab;
};

}  // namespace raywalk

namespace raywalk::action {

struct ShowLessons {
  static constexpr std::string_view word = "lessons";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  [[nodiscard]] constexpr Traits traits() const { return {.of_own_scene = shown}; }
  void apply(State& state) const;
};
/// Reads what lessons there are, for the dialog that asks what to open.
struct ListLessons {
  static constexpr std::string_view word = "list-lessons";
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true, .answers_prompt = true};
  void apply(State& state) const;
};
/// At the first unfinished step, unless it is locked; asks first if there is unsaved work, of an open lesson too.
struct OpenLesson {
  static constexpr std::string_view word = "open-lesson";
  std::string name;
  static void fields(auto& f, auto& a) { f(a.name); }
  static constexpr Traits traits{.of_own_scene = true};
  void apply(State& state) const;
};
/// In the list by keys: the one so many below what is marked there.
struct ChooseLesson {
  static constexpr std::string_view word = "choose-lesson";
  int by;
  static void fields(auto& f, auto& a) { f(a.by); }
  void apply(State& state) const;
};
/// Back to the list, and to the previous scene; asks first if the lesson's was changed.
struct LeaveLesson {
  static constexpr std::string_view word = "leave-lesson";
  void apply(State& state) const;
};
/// Changes of the scene stay with their step: the other one is shown as it was written, and whoever comes back can redo
/// them.
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
/// Shows the answer to the guess, once there is one.
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

/// What stands in the tabs and the plan change places: of what a step shows large for this step and mode alone, for the
/// next one shows again what it speaks of; else for the open tab.
struct ExchangePanes {
  static constexpr std::string_view word = "exchange";
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};

/// The presenter's notes in a window of their own, which a class does not see.
struct ShowNotesWindow {
  static constexpr std::string_view word = "notes-window";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// By step, whether the first prediction was right; none if nothing was predicted.
struct FirstTries {
  std::map<int, std::optional<bool>> by_step;
  [[nodiscard]] int judged() const {
    return count([](const std::optional<bool>& right) { return right.has_value(); });
  }
  [[nodiscard]] int right() const {
    return count([](const std::optional<bool>& right) { return right.value_or(false); });
  }
  friend bool operator==(const FirstTries&, const FirstTries&) = default;

 private:
  [[nodiscard]] int count(const auto& is) const {
    return static_cast<int>(
        std::count_if(by_step.begin(), by_step.end(), [&](const auto& each) { return is(each.second); }));
  }
};

/// The lessons: which is open, its current step, the guesses.
struct LessonRoom {
  using Actions =
      Types<action::ShowLessons, action::ListLessons, action::OpenLesson, action::ChooseLesson, action::LeaveLesson,
            action::GoToLessonStep, action::GuessChoice, action::GuessNumber, action::RevealLesson, action::ShowHands,
            action::SetLessonOptions, action::ExchangePanes, action::ShowNotesWindow>;
  static Commands commands();
  static void close(State& state);
  static void follow(State& state, const Before& before);

  std::string folder, scenes_folder;  ///< of the lessons, and of the shipped scenes; empty: none
  bool shown = false;
  std::vector<LessonEntry> list;  ///< read when lessons are first shown
  std::optional<int> chosen{};    ///< of `list`, by keys, until a lesson is opened or the list is hidden
  std::shared_ptr<const OpenedLesson> open;
  std::string last;                     ///< the name of the lesson that is or was open; empty: none yet
  std::shared_ptr<const OwnScene> own;  ///< restored when the lesson is left; null: none
  int step = 0;                         ///< of `open`
  int first_pixel = 0;                  ///< of the strip: rays of earlier pixels are hidden
  bool revealed = false;                ///< the answer of this step is shown
  LessonGuess guess;
  std::vector<int> hands;               ///< of a class, for each choice of this step
  std::map<int, LessonGuess> answered;  ///< the guesses of the steps of `open` that were revealed
  std::map<int, History> changes;       ///< what was changed in steps of `open`, to be redone there
  bool told_of_changes = false;         ///< that they are kept, while `open` is
  std::map<std::string, FirstTries, std::less<>> first_tries;  ///< of each lesson, since it was begun
  bool presenter = false;                                      ///< shows of hands, every lesson open, and the notes
  bool notes = false;               ///< the pane shows presenter's script and teacher's notes
  bool notes_window = false;        ///< the notes have a window of their own
  bool unlocked = false;            ///< any lesson may be opened, and questions may be skipped
  std::array<bool, 2> exchanged{};  ///< what this step enlarges and the plan, by hand; in Move and in Trace
  std::map<std::string, int, std::less<>> done;     ///< finished steps of each lesson
  std::map<std::string, int, std::less<>> left_at;  ///< the step at which each was left, if not at its end
  std::string unsaid;           ///< what went wrong with the file of all that, to be said after the action
  bool cannot_be_kept = false;  ///< it was not written the last time: said once

  /// The lesson of the list that has this name; null if there is none.
  [[nodiscard]] const LessonEntry* entry(std::string_view name) const {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const LessonEntry& each) { return each.name == name; });
    return found == list.end() ? nullptr : &*found;
  }

  /// First predictions of all lessons, and the right ones of them.
  [[nodiscard]] int judged() const { return sum(&FirstTries::judged); }
  [[nodiscard]] int right() const { return sum(&FirstTries::right); }
  [[nodiscard]] const PlayedStep* at() const {
    return open && step < static_cast<int>(open->played.steps.size())
               ? &open->played.steps[static_cast<std::size_t>(step)]
               : nullptr;
  }

 private:
  [[nodiscard]] int sum(int (FirstTries::*of)() const) const {
    int all = 0;
    for (const auto& [name, tries] : first_tries) all += (tries.*of)();
    return all;
  }
};

/// Opens a lesson, even a locked one, at `step`, from 0, or at the first unfinished; discards unsaved work. False, with
/// a notice, if it cannot be opened: nothing has changed then.
bool open_lesson(State& state, const std::string& name, std::optional<int> step);

}  // namespace raywalk
