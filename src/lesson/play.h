#pragma once
// A played lesson: its steps as places in recorded walks, where its claims are evaluated.

#include "io/scene_file.h"
#include "lesson/lesson.h"
#include "render/render.h"
#include "timeline/timeline.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
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

/// A picture of a step, rendered when its first value is asked for.
class StepPicture {
 public:
  StepPicture(Scene scene, const RenderSettings& settings) : scene_(std::move(scene)), settings_(settings) {}
  /// Renders it, if nobody has; also from several threads.
  [[nodiscard]] const Result<Rendering>& rendering() const;
  /// Whether another seed renders another picture.
  [[nodiscard]] bool is_random() const { return rendering() && rendering()->statistics.random_draws() > 0; }

 private:
  Scene scene_;
  RenderSettings settings_;
  mutable std::once_flag once_;
  mutable std::optional<Result<Rendering>> rendering_;
};

/// A step, and its place in its walk.
struct PlayedStep {
  const LessonStep* step = nullptr;
  std::shared_ptr<const LessonWalk> walk;
  int asked = 0;  ///< position at which the student reads and predicts
  int shown = 0;  ///< position of the answer; the same if nothing is asked
  std::map<std::string, std::shared_ptr<const StepPicture>, std::less<>> pictures;
};

/// The result of playing a lesson. `lesson` must outlive it.
struct PlayedLesson {
  const Lesson* lesson = nullptr;
  std::vector<PlayedStep> steps;  ///< up to the first that cannot be reached
  std::vector<Error> errors;      ///< why the next step is not reached
};

/// Plays all steps. What they claim is for check_lesson to hold to the trace. `scenes_folder`: of the shipped scenes.
[[nodiscard]] PlayedLesson play_lesson(const Lesson& lesson, const std::string& scenes_folder);

/// The same lesson with another seed. Steps without random numbers, and pictures with their own seed, keep their
/// pictures.
[[nodiscard]] PlayedLesson play_again(const PlayedLesson& first, const std::string& scenes_folder, std::uint64_t seed);

/// Whether another seed gives the step another walk or other pictures.
[[nodiscard]] bool depends_on_seed(const PlayedStep& step);

/// The value of a formula in step `index` at one of its positions.
[[nodiscard]] Outcome value_at(const PlayedLesson& played, std::size_t index, int position,
                               const Expression& expression);

/// A passage with its numbers filled in, or what is wrong with it. Numbers are written as `language` writes them.
[[nodiscard]] Result<std::string> filled(const PlayedLesson& played, std::size_t index, int position,
                                         const Passage& passage, Language language);

}  // namespace raywalk
