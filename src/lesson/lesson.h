#pragma once
// A lesson: lesson.toml (the steps: where to go, what to ask, what to check) and one file of words per language (en.md,
// pt.md). lessons/README.md explains both to authors.

#include "accel/accelerator.h"
#include "lesson/expression.h"
#include "lesson/words.h"
#include "math/words.h"
#include "scene/scene.h"
#include "text/error.h"
#include "text/language.h"
#include "trace/fault.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// A formula, and its place in the file.
struct Formula {
  std::string text;
  Expression expression;
  int line = 0;
};

/// The student drags an arrow in the direction of the ray that the next line forms.
struct ArrowQuestion {
  double tolerance = 10;  ///< degrees between the guess and the ray, as the plan shows them
};
struct NumberQuestion {
  Formula answer;
  double tolerance = 0;
  std::string unit;               ///< shown behind the number; may be empty
  std::optional<Formula> theory;  ///< the predicted value, if `answer` is measured

  /// At the border of the tolerance both sides count: neither it nor the truth need be numbers of a computer.
  [[nodiscard]] bool accepts(double guess, double truth) const {
    constexpr double rounding = 1e-9;
    return std::abs(guess - truth) <= tolerance + rounding * std::max(1.0, std::abs(truth));
  }
};
/// Exactly one of the choices holds in the trace; their texts are in the files of words, in the same order.
struct ChoiceQuestion {
  std::vector<Formula> choices;
};
/// The student clicks the faulty line of code; the step injects a fault into the tracer.
struct LineQuestion {
  std::string answer;  ///< its text
};
using LessonQuestion = std::variant<ArrowQuestion, NumberQuestion, ChoiceQuestion, LineQuestion>;

/// What a word of the list of claim_words.h states in a lesson: "half", "root". Either claims, all of which must hold
/// at the answer, or what else the word means here.
struct Saying {
  std::string word;  ///< its name on the list, the same in every language
  std::vector<Formula> claims;
  std::string means;
  int line = 0;
};

/// A 3-D picture rendered for the claims of a step.
struct PictureRequest {
  std::string name;  ///< in formulas
  std::optional<ImageSize> size;
  int samples = 1;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  std::optional<std::uint64_t> seed;  ///< fixes its random numbers while a check varies the seed: a reference
  std::string changes;                ///< to the step's scene, as TOML
  int line = 0;
};

/// The tab shown beside the plan at a step.
enum class LessonBeside { unchanged, picture, tree, stack, equation, microscope, structure };
template <>
inline constexpr Word<LessonBeside> words_of<LessonBeside>[] = {
    {LessonBeside::picture, "picture"},       {LessonBeside::tree, "tree"},
    {LessonBeside::stack, "stack"},           {LessonBeside::equation, "equation"},
    {LessonBeside::microscope, "microscope"}, {LessonBeside::structure, "structure"}};

/// A pixel of the scene's image, or, with row -1, a cell of the strip; both from 0.
struct LessonPixel {
  int column = 0, row = -1;
  friend bool operator==(const LessonPixel&, const LessonPixel&) = default;
};

struct LessonStep {
  std::string id;                    ///< of its words
  std::optional<std::string> scene;  ///< a file of the lesson's folder, or a shipped scene
  std::string changes;               ///< to values of the scene, as TOML; in effect until the next `scene`
  std::vector<std::string> removed;  ///< names of objects and lights to remove
  std::optional<LessonPixel> pixel;  ///< where a new walk begins; absent: it continues
  std::optional<Fault> fault;        ///< injected into the tracer, in this step alone
  std::optional<Formula> run;        ///< the line to run to; with a question (unless for a line), to stop before
  std::optional<Formula> reveal;     ///< the line that answers the question, when it is not the next one
  std::optional<LessonQuestion> question;
  std::vector<Formula> checks;  ///< claims about the trace, each of which must hold
  std::vector<Saying> says;     ///< what the words of this step state
  std::vector<PictureRequest> pictures;
  LessonBeside pane = LessonBeside::unchanged;
  LessonBeside then = LessonBeside::unchanged;  ///< once the answer stands there
  bool large = false;                           ///< `then`, or `pane` without it, has the plan's place
  bool breakpoints = true;                      ///< whether the student's breakpoints stop the walk here
  bool extra = false;                           ///< not part of a presenter's five minutes
  bool zoom = false;                            ///< while the plan is in focus, it shows the ray in question large
  bool pencils = false;                         ///< those of the pixel's rays are drawn where the answer stands
  int line = 0;
};

struct Lesson {
  std::string name;    ///< of its folder: "01-ray-casting"
  std::string folder;  ///< its path
  std::vector<LessonStep> steps;
  std::vector<Saying> says;  ///< what the words about the whole lesson state
  /// By the codes of the languages that it is told in ("en"): English and whatever else its folder holds.
  std::map<std::string, LessonWords, std::less<>> words;

  /// The language in which it is told to who speaks this one: English where it has no words in that.
  [[nodiscard]] Language told_in(Language language) const;
  [[nodiscard]] const LessonWords& told(Language language) const {
    return words.find(told_in(language).code())->second;
  }
};

/// The names of the lessons in a folder, sorted: each is a folder with a lesson.toml.
[[nodiscard]] std::vector<std::string> lesson_names(const std::string& folder);

/// Reads lesson.toml alone, without the words.
[[nodiscard]] Result<Lesson> parse_lesson(std::string_view text, const std::string& file_name);

/// Reads a lesson and its words in every language. Fails at the first error.
[[nodiscard]] Result<Lesson> read_lesson(const std::string& folder);

}  // namespace raywalk
