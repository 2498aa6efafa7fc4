#pragma once
// Checks lessons: claims that the trace contradicts, and words without a claim.

#include "lesson/claim_words.h"
#include "lesson/play.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

struct LessonCheckSettings {
  std::string scenes_folder;  ///< of the shipped scenes
  std::string words_folder;   ///< of the lists of claim words: see claim_words.h
  int seeds = 20;             ///< how many other seeds all claims must hold for
};

/// A number that depends on random numbers: its range over all seeds.
struct SeedRange {
  std::string step, formula;
  double least = 0, most = 0;
  std::optional<double> theory;  ///< of a question's number: the predicted value
};

struct LessonCheck {
  std::vector<Error> errors;  ///< empty for a good lesson
  std::vector<SeedRange> spreads;
};

/// Plays the lesson, with several seeds if it draws random numbers, and checks its words in each language: steps that
/// are not reached, claims that the trace contradicts, missing or extra words, unchecked numbers, and words that state
/// what no claim says.
[[nodiscard]] LessonCheck check_lesson(const Lesson& lesson, const LessonCheckSettings& settings);

namespace detail {
/// Pictures that cannot be rendered, and claims, faults and answers that the trace contradicts, of all steps reached.
[[nodiscard]] std::vector<Error> check_claims(const PlayedLesson& played);
/// Claims and answers that fail for other seeds, and how far their numbers spread.
[[nodiscard]] LessonCheck check_seeds(const PlayedLesson& played, const LessonCheckSettings& settings);
/// The words in every language.
[[nodiscard]] std::vector<Error> check_words(const PlayedLesson& played, const LessonCheckSettings& settings);
}  // namespace detail

}  // namespace raywalk
