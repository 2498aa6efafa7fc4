// Claims of a played lesson, held to its trace.

#include "lesson/check.h"
#include "lesson/facts.h"
#include "timeline/event_json.h"
#include "timeline/recorder.h"

#include <fmt/format.h>

#include <algorithm>

namespace raywalk::detail {

namespace {

class ClaimsChecker {
 public:
  explicit ClaimsChecker(const PlayedLesson& played) : played_(played) {}

  std::vector<Error> check() {
    for (index_ = 0; index_ < played_.steps.size(); ++index_) verify_all();
    if (!played_.errors.empty() || played_.steps.empty()) return errors_;
    index_ = played_.steps.size() - 1;
    for (const Saying& saying : played_.lesson->says)
      for (const Formula& claim : saying.claims) verify(claim);
    return errors_;
  }

 private:
  [[nodiscard]] const PlayedStep& here() const { return played_.steps[index_]; }
  [[nodiscard]] std::string file() const { return played_.lesson->folder + "/lesson.toml"; }
  void fail(int line, std::string message, std::string hint = "") {
    errors_.push_back({file(), line, 0, std::move(message), std::move(hint)});
  }

  /// Of the step at `index_`.
  void verify_all() {
    const LessonStep& step = *played_.steps[index_].step;
    for (const PictureRequest& request : step.pictures)
      if (const auto& rendering = here().pictures.find(request.name)->second->rendering(); !rendering) {
        Error error = rendering.error();
        if (error.line == 0) error = {file(), request.line, 0, error.message, error.hint};
        errors_.push_back(std::move(error));
        return;
      }
    for (const Formula& check : step.checks) verify(check);
    for (const Saying& saying : step.says)
      for (const Formula& claim : saying.claims) verify(claim);
    if (step.fault) verify_fault(step);
    if (step.question) verify_question(step);
  }

  void verify(const Formula& check) {
    const int position = here().shown;
    const Outcome value = value_at(played_, index_, position, check.expression);
    if (!value) return fail(check.line, check.text + ": " + value.error());
    if (holds(*value)) return;
    const std::string sides = check.expression.sides(Facts(played_, index_, position));
    fail(check.line,
         fmt::format("the trace does not bear out: {}{}", check.text, sides.empty() ? "" : "; it has " + sides),
         fmt::format("step \"{}\" stands at step {} of the walk", here().step->id, position));
  }

  /// The fault must change something in the current pixel, first at the line that it breaks.
  void verify_fault(const LessonStep& step) {
    const Timeline& timeline = here().walk->timeline;
    const int pixel = timeline.current_pixel(here().shown);
    if (pixel < 0) return fail(step.line, "fault: the walk stands in no pixel (expected pixel, or run)");
    const PixelRecord& at = timeline.pixels()[static_cast<std::size_t>(pixel)];
    Scene scene = here().walk->document.scene;
    scene.render.numerics = Numerics::naive;  // as with the fault
    const auto walked = [&](const Recording& how) {
      return here().walk->pixel ? record_pixel(scene, scene.image, at.column, at.row, how)
                                : record_cell(scene, at.column, how);
    };
    Recording broken;
    broken.fault = step.fault;
    const Timeline with = walked(broken), without = walked({});
    const std::optional<int> first = first_difference(scene, with, without);
    if (!first)
      return fail(step.line, fmt::format("fault: {} changes nothing in pixel {}", name_of(*step.fault), at.column),
                  "take another pixel, or another scene");
    const Line line = with.event(std::min(*first, with.steps() - 1)).line, expected = faulty_line(*step.fault);
    if (line != expected)
      fail(step.line, fmt::format("fault: the walk first changes at \"{}\" (expected \"{}\")", pseudocode_of(line).text,
                                  pseudocode_of(expected).text));
  }

  /// The predicted value must count as right.
  void verify_theory(const NumberQuestion& question, double measured) {
    const Outcome theory = value_at(played_, index_, here().shown, question.theory->expression);
    const double* number = theory ? std::get_if<double>(&*theory) : nullptr;
    if (number == nullptr)
      return fail(question.theory->line, "theory: " + question.theory->text + " is no number here");
    if (!question.accepts(*number, measured))
      fail(question.theory->line,
           fmt::format("theory: {} is {:.9g}, and the trace has {:.9g}: farther apart than the tolerance {:.9g}",
                       question.theory->text, *number, measured, question.tolerance));
  }

  void verify_question(const LessonStep& step) {
    const PlayedStep& played = here();
    if (std::holds_alternative<ArrowQuestion>(*step.question)) {
      const Outcome direction = value_at(played_, index_, played.shown, *Expression::parse("direction"));
      if (!direction || !std::holds_alternative<Vec3d>(*direction))
        fail(step.line, "predict: the line that is run to forms no ray, so there is no arrow to compare with");
    } else if (const auto* number = std::get_if<NumberQuestion>(&*step.question)) {
      const Outcome value = value_at(played_, index_, played.shown, number->answer.expression);
      if (!value)
        fail(number->answer.line, number->answer.text + ": " + value.error());
      else if (!std::holds_alternative<double>(*value))
        fail(number->answer.line, "predict: " + number->answer.text + " is no number here");
      else if (number->theory)
        verify_theory(*number, std::get<double>(*value));
    } else if (const auto* line = std::get_if<LineQuestion>(&*step.question)) {
      if (!step.fault)
        fail(step.line, "predict: a line is asked for, and no line is at fault (expected fault = \"...\")");
      else if (const auto right = pseudocode_of(faulty_line(*step.fault)).text; line->answer != right)
        fail(step.line, fmt::format("predict: \"{}\" is not the line that {} breaks (expected \"{}\")", line->answer,
                                    name_of(*step.fault), right));
    } else if (const auto* choice = std::get_if<ChoiceQuestion>(&*step.question)) {
      int right = 0;
      for (const Formula& each : choice->choices) {
        const Outcome value = value_at(played_, index_, played.shown, each.expression);
        if (!value) return fail(each.line, each.text + ": " + value.error());
        right += holds(*value) ? 1 : 0;
      }
      if (right != 1)
        fail(step.line, fmt::format("predict: {} of the {} choices hold in the trace (expected exactly one)", right,
                                    choice->choices.size()));
    }
  }

  const PlayedLesson& played_;
  std::size_t index_ = 0;  ///< of the step
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> check_claims(const PlayedLesson& played) { return ClaimsChecker(played).check(); }

}  // namespace raywalk::detail
