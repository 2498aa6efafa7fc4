#pragma once
// A played lesson: its steps as places in recorded walks, where its claims are evaluated.

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

class SearchWalks;  // inspect/search_walk.h

/// The walk of a step and those after it.
struct LessonWalk {
  SceneDocument document;
  std::optional<LessonPixel> pixel;  ///< what was recorded: one pixel of the image; none: the whole strip
  std::optional<Fault> fault;        ///< of the tracer
  Timeline timeline;
  std::shared_ptr<const SearchWalks> searches;  ///< if a step shows accelerators; else null
};

/// A step, and its place in its walk.
struct PlayedStep {
  const LessonStep* step = nullptr;
  std::shared_ptr<const LessonWalk> walk;
  int asked = 0;  ///< position at which the student reads and predicts
  int shown = 0;  ///< position of the answer; the same if nothing is asked
  std::map<std::string, Rendering, std::less<>> pictures;
  bool random = false;  ///< its walk or its pictures depend on random numbers
};

/// The result of playing a lesson. `lesson` must outlive it.
struct PlayedLesson {
  const Lesson* lesson = nullptr;
  std::vector<PlayedStep> steps;  ///< up to the first that cannot be reached
  std::vector<Error> errors;      ///< steps that are not reached, and claims that the trace contradicts
};

/// Whether to render the steps' pictures: not needed for showing the lesson.
enum class Pictures { render, leave_out };

/// Plays all steps. `scenes_folder`: of the shipped scenes.
[[nodiscard]] PlayedLesson play_lesson(const Lesson& lesson, const std::string& scenes_folder,
                                       Pictures pictures = Pictures::render);

/// The same lesson with another seed. Steps without random numbers, and pictures with their own seed, keep their
/// pictures; nothing is verified.
[[nodiscard]] PlayedLesson play_again(const PlayedLesson& first, const std::string& scenes_folder, std::uint64_t seed);

/// The value of a formula in step `index` at one of its positions.
[[nodiscard]] Outcome value_at(const PlayedLesson& played, std::size_t index, int position,
                               const Expression& expression);

/// A passage with its numbers filled in, or what is wrong with it. Numbers are written as `language` writes them.
[[nodiscard]] Result<std::string> filled(const PlayedLesson& played, std::size_t index, int position,
                                         const Passage& passage, Language language);

}  // namespace raywalk
