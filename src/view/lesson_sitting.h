#pragma once
// The lessons as a person goes through them: which is open, where in it they are, what they guessed. Part of the state.

#include "io/scene_file.h"
#include "lesson/play.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

enum class Mode;  // view/state.h

/// A lesson of the list.
struct LessonEntry {
  std::string name;                                                 ///< of its folder
  std::map<std::string, std::string, std::less<>> titles;           ///< by the languages' codes
  [[nodiscard]] const std::string& title(Language language) const;  ///< in English where there is none in this
  int steps = 0;
};

/// A lesson that is gone through. Never copied: `played` points into `lesson`.
struct OpenedLesson {
  explicit OpenedLesson(Lesson of) : lesson(std::move(of)) {}
  OpenedLesson(const OpenedLesson&) = delete;
  OpenedLesson& operator=(const OpenedLesson&) = delete;
  Lesson lesson;
  PlayedLesson played;
};

/// What was predicted at this step, by the kind of its question.
struct LessonGuess {
  std::optional<int> choice;  ///< from 0
  std::optional<double> number;
  std::optional<Vec2d> arrow;  ///< where it points, from the ray's origin; scene units, not of length 0
  std::optional<Line> line;    ///< that is thought to be at fault
  friend bool operator==(const LessonGuess&, const LessonGuess&) = default;
};

/// The scene that was open before a lesson was.
struct OwnScene {
  SceneDocument document;
  std::string path;  ///< empty: never saved
  Mode mode{};
};

struct LessonSitting {
  std::string folder, scenes_folder;  ///< where the lessons are, and the scenes that ship; empty: there are none
  bool shown = false;
  std::vector<LessonEntry> list;  ///< read when the lessons are first shown
  std::shared_ptr<const OpenedLesson> open;
  std::shared_ptr<const OwnScene> own;  ///< comes back when the lesson is left; null: none is waiting
  int step = 0;                         ///< of `open`
  int first_pixel = 0;                  ///< of the strip: rays of those before would only stand in the way
  bool revealed = false;                ///< the answer of this step stands there
  LessonGuess guess;
  std::vector<int> hands;                         ///< of a class, for each choice of this step
  int right = 0, judged = 0;                      ///< predictions of this sitting, of each question the first
  std::set<std::pair<std::string, int>> counted;  ///< lessons and steps whose questions these are
  bool presenter = false;                         ///< shows of hands, every lesson open, and the notes
  bool notes = false;                             ///< a presenter's script and the teacher's notes are in the pane
  bool unlocked = false;                          ///< any lesson may be opened, and no question stands in the way
  std::map<std::string, int, std::less<>> done;   ///< how many steps of each lesson have been finished

  [[nodiscard]] const PlayedStep* at() const {
    return open && step < static_cast<int>(open->played.steps.size())
               ? &open->played.steps[static_cast<std::size_t>(step)]
               : nullptr;
  }
};

}  // namespace raywalk
