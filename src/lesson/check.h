#pragma once
// What is wrong with a lesson: claims that the trace does not bear out, and words that nothing bears out.

#include "lesson/claim_words.h"
#include "lesson/play.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

struct LessonCheckSettings {
  std::string scenes_folder;  ///< where the scenes are that come with Raywalk
  std::string words_folder;   ///< where the lists of words are that state something: see claim_words.h
  int seeds = 20;             ///< with how many other random numbers all claims have to hold too
};

/// A number that hangs on random numbers: between what it was with all seeds.
struct Spread {
  std::string step, formula;
  double least = 0, most = 0;
  std::optional<double> theory;  ///< of a question's number: what thinking finds
};

struct LessonCheck {
  std::vector<Error> errors;  ///< empty for a good lesson
  std::vector<Spread> spreads;
};

/// Plays the lesson, with several seeds where it draws random numbers, and reads its words in each language: steps that
/// are not reached, claims that the trace does not bear out, words that are missing or too many, numbers that nothing
/// checks, and words that state what no claim says.
[[nodiscard]] LessonCheck check_lesson(const Lesson& lesson, const LessonCheckSettings& settings);

namespace detail {
/// Claims and answers that other random numbers would break, and how far their numbers spread.
[[nodiscard]] LessonCheck check_seeds(const PlayedLesson& played, const LessonCheckSettings& settings);
/// The words in every language.
[[nodiscard]] std::vector<Error> check_words(const PlayedLesson& played, const LessonCheckSettings& settings);
}  // namespace detail

}  // namespace raywalk
