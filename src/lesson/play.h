#pragma once
// A lesson played: its steps as places in recorded walks. What it claims is looked up there.

#include "io/scene_file.h"
#include "lesson/lesson.h"
#include "render/render.h"
#include "timeline/timeline.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

class SearchWalks;  // timeline/search_walk.h

/// The walk that a step, and those after it, stand in.
struct LessonWalk {
  SceneDocument document;
  std::optional<LessonPixel> pixel;  ///< what was recorded: one pixel of the image; none: the whole strip
  std::optional<Fault> fault;        ///< that the tracer had
  Timeline timeline;
  std::shared_ptr<const SearchWalks> searches;  ///< where a step shows structures; else null
};

/// A step, and where in its walk it stands.
struct PlayedStep {
  const LessonStep* step = nullptr;
  std::shared_ptr<const LessonWalk> walk;
  int asked = 0;  ///< position at which the student reads and predicts
  int shown = 0;  ///< position of the answer; where nothing is asked, the same
  std::map<std::string, Rendering, std::less<>> pictures;
  bool random = false;  ///< other random numbers would make another walk, or other pictures
};

/// What a lesson comes to. `lesson` must outlive it.
struct PlayedLesson {
  const Lesson* lesson = nullptr;
  std::vector<PlayedStep> steps;  ///< up to the first that cannot be reached
  std::vector<Error> errors;      ///< steps that are not reached, and claims that the trace does not bear out
};

/// Whether to render the pictures that steps ask for: a class that looks on need not wait for those.
enum class Pictures { render, leave_out };

/// Plays all steps. `scenes_folder`: where the scenes are that come with Raywalk.
[[nodiscard]] PlayedLesson play_lesson(const Lesson& lesson, const std::string& scenes_folder,
                                       Pictures pictures = Pictures::render);

/// The same lesson with the random numbers of another seed. Steps that draw none keep their pictures, and pictures keep
/// theirs that have a seed of their own; nothing is verified.
[[nodiscard]] PlayedLesson play_again(const PlayedLesson& first, const std::string& scenes_folder, std::uint64_t seed);

/// The value of a formula in the step number `index` at one of its positions.
[[nodiscard]] Outcome value_at(const PlayedLesson& played, std::size_t index, int position,
                               const Expression& expression);

/// A passage with its numbers filled in, or what is wrong with it. Numbers are written as `language` writes them.
[[nodiscard]] Result<std::string> filled(const PlayedLesson& played, std::size_t index, int position,
                                         const Passage& passage, Language language);

}  // namespace raywalk
