#pragma once
// A lesson as it stands in its folder: lesson.toml (the steps: where to go, what to ask, what to check) and one file of
// words a language (en.md, pt.md). lessons/README.md explains both to those who write them.

#include "accel/accelerator.h"
#include "io/error.h"
#include "lesson/expression.h"
#include "lesson/words.h"
#include "scene/scene.h"
#include "text/language.h"
#include "trace/fault.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// A formula, and where it stands.
struct Formula {
  std::string text;
  Expression expression;
  int line = 0;
};

/// The student drags an arrow where the ray will go that the next line forms.
struct ArrowQuestion {
  double tolerance = 10;  ///< degrees between the guess and the ray, as the plan shows them
};
struct NumberQuestion {
  Formula answer;
  double tolerance = 0;
  std::string unit;               ///< shown behind the number; may be empty
  std::optional<Formula> theory;  ///< what thinking finds where `answer` is measured
};
/// Exactly one of the choices holds in the trace; the words of each stand in the files of words, in the same order.
struct ChoiceQuestion {
  std::vector<Formula> choices;
};
/// The student clicks the line of code that is at fault; the step has put a fault into the tracer.
struct LineQuestion {
  std::string answer;  ///< its text
};
using LessonQuestion = std::variant<ArrowQuestion, NumberQuestion, ChoiceQuestion, LineQuestion>;

/// What words of a lesson state that are on the list of claim_words.h: "half", "root". Either claims, each of which has
/// to hold where the answer stands, or what else the word stands for here.
struct Saying {
  std::string word;  ///< the list's name for it, the same in every language
  std::vector<Formula> claims;
  std::string means;
  int line = 0;
};

/// A 3-D picture that is rendered for what a step claims about it.
struct PictureRequest {
  std::string name;  ///< under which formulas know it
  std::optional<ImageSize> size;
  int samples = 1;
  AcceleratorKind accelerator = AcceleratorKind::automatic;
  std::optional<std::uint64_t> seed;  ///< keeps its random numbers while a check tries others: a reference
  std::string changes;                ///< to the step's scene, as TOML
  int line = 0;
};

/// What lies beside the plan at a step.
enum class LessonBeside { unchanged, picture, tree, stack, equation, structure };

/// A pixel of the scene's image, or with row -1 a cell of the strip; both from 0.
struct LessonPixel {
  int column = 0, row = -1;
  friend bool operator==(const LessonPixel&, const LessonPixel&) = default;
};

struct LessonStep {
  std::string id;                    ///< of the words that belong to it
  std::optional<std::string> scene;  ///< a file of the lesson's folder, or a scene that comes with Raywalk
  std::string changes;               ///< to values of the scene, as TOML; they hold until the next `scene`
  std::vector<std::string> removed;  ///< names of objects and lights that are taken out
  std::optional<LessonPixel> pixel;  ///< where the walk begins anew; without it, it goes on
  std::optional<Fault> fault;        ///< breaks the tracer on purpose, in this step alone
  std::optional<Formula> run;        ///< the line to run to; with a question, unless it is for a line, to stop before
  std::optional<Formula> reveal;     ///< the line that answers the question, when it is not the next one
  std::optional<LessonQuestion> question;
  std::vector<Formula> checks;  ///< claims about the trace, each of which must hold
  std::vector<Saying> says;     ///< what the words of this step state
  std::vector<PictureRequest> pictures;
  LessonBeside pane = LessonBeside::unchanged;
  bool breakpoints = true;  ///< of the student: whether they stop the walk here
  bool extra = false;       ///< not one of a presenter's five minutes: for whoever has more
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

/// The names of the lessons in a folder, sorted: each is a folder that holds a lesson.toml.
[[nodiscard]] std::vector<std::string> lesson_names(const std::string& folder);

/// Reads lesson.toml alone, without the words.
[[nodiscard]] Result<Lesson> parse_lesson(std::string_view text, const std::string& file_name);

/// Reads a lesson and its words in every language. Fails at the first thing that cannot be understood.
[[nodiscard]] Result<Lesson> read_lesson(const std::string& folder);

}  // namespace raywalk
