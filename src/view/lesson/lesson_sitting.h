#pragma once
// The lessons in progress: which is open, its current step, the guesses. Part of the state.

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
  [[nodiscard]] const std::string& title(Language language) const;  ///< in English if there is none in this language
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
  friend bool operator==(const LessonGuess&, const LessonGuess&) = default;
};

/// The scene that was open before a lesson was.
struct OwnScene {
  SceneDocument document;
  std::string path;  ///< empty: never saved
  Mode mode{};
};

struct LessonSitting {
  std::string folder, scenes_folder;  ///< of the lessons, and of the shipped scenes; empty: none
  bool shown = false;
  std::vector<LessonEntry> list;  ///< read when lessons are first shown
  std::shared_ptr<const OpenedLesson> open;
  std::shared_ptr<const OwnScene> own;  ///< restored when the lesson is left; null: none
  int step = 0;                         ///< of `open`
  int first_pixel = 0;                  ///< of the strip: rays of earlier pixels are hidden
  bool revealed = false;                ///< the answer of this step is shown
  LessonGuess guess;
  std::vector<int> hands;                         ///< of a class, for each choice of this step
  int right = 0, judged = 0;                      ///< first predictions of this session
  std::set<std::pair<std::string, int>> counted;  ///< lessons and steps of these questions
  bool presenter = false;                         ///< shows of hands, every lesson open, and the notes
  bool notes = false;                             ///< the pane shows presenter's script and teacher's notes
  bool unlocked = false;                          ///< any lesson may be opened, and questions may be skipped
  std::map<std::string, int, std::less<>> done;   ///< finished steps of each lesson

  [[nodiscard]] const PlayedStep* at() const {
    return open && step < static_cast<int>(open->played.steps.size())
               ? &open->played.steps[static_cast<std::size_t>(step)]
               : nullptr;
  }
};

}  // namespace raywalk
