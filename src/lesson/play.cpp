#include "lesson/play.h"

#include "inspect/search_walk.h"
#include "lesson/facts.h"
#include "lesson/staging.h"
#include "scene/effects.h"
#include "timeline/event_json.h"
#include "timeline/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

class Player {
 public:
  Player(PlayedLesson& to, const std::string& scenes_folder, Playing playing)
      : to_(to), lesson_(*to.lesson), scenes_folder_(scenes_folder), playing_(playing) {}
  /// Plays again what `first` played, with other random numbers.
  Player(PlayedLesson& to, const std::string& scenes_folder, const PlayedLesson& first, std::uint64_t seed)
      : to_(to), lesson_(*to.lesson), scenes_folder_(scenes_folder), first_(&first), seed_(seed) {}

  void play() {
    for (const LessonStep& step : lesson_.steps) {
      if (!stage(step)) return;
      to_.steps.push_back({&step, walk_, position_, position_, {}});
      to_.steps.back().random = draws_random(integrator_of(document_.scene));
      if (!take_pictures(step) || !move(step)) {
        to_.steps.pop_back();
        return;
      }
      if (verifies()) verify_all(step);
      position_ = to_.steps.back().shown;
    }
    if (verifies())
      for (const Saying& saying : lesson_.says)
        for (const Formula& claim : saying.claims) verify(claim);
  }

 private:
  [[nodiscard]] bool verifies() const { return first_ == nullptr && playing_ == Playing::to_check; }
  [[nodiscard]] std::string file() const { return lesson_.folder + "/lesson.toml"; }
  void fail(int line, std::string message, std::string hint = "") {
    to_.errors.push_back({file(), line, 0, std::move(message), std::move(hint)});
  }
  bool fail(Error error, int line) {
    if (error.line == 0) error = {file(), line, 0, error.message, error.hint};
    to_.errors.push_back(std::move(error));
    return false;
  }

  void verify_all(const LessonStep& step) {
    for (const Formula& check : step.checks) verify(check);
    for (const Saying& saying : step.says)
      for (const Formula& claim : saying.claims) verify(claim);
    if (step.fault) verify_fault(step);
    if (step.question) verify_question(step);
  }

  /// Records the step's walk.
  bool stage(const LessonStep& step) {
    if (step.scene) {
      auto document = stage_scene(*step.scene, lesson_.folder, scenes_folder_);
      if (!document) return fail(document.error(), step.line);
      document_ = std::move(*document);
    }
    if (!step.changes.empty() || !step.removed.empty()) {
      auto changed = changed_scene(document_, step.changes, step.removed, file());
      if (!changed) return fail(changed.error(), step.line);
      document_ = std::move(*changed);
    }
    const std::optional<LessonPixel> wanted = step.pixel && step.pixel->row >= 0 ? step.pixel : std::nullopt;
    const bool same_scene = !step.scene && step.changes.empty() && step.removed.empty() && walk_ != nullptr;
    if (!same_scene || (step.pixel && walk_->pixel != wanted) || walk_->fault != step.fault) {
      const Scene& scene = document_.scene;
      const ImageSize size = scene.image;
      if (wanted && (wanted->column >= size.width || wanted->row >= size.height)) {
        fail(step.line, fmt::format("pixel: there is none [{}, {}] in a picture of {} x {}", wanted->column,
                                    wanted->row, size.width, size.height));
        return false;
      }
      Recording how;
      how.fault = step.fault;
      how.sampling.seed = seed_;
      walk_ = std::make_shared<LessonWalk>(LessonWalk{
          document_, wanted, step.fault,
          wanted ? record_pixel(scene, size, wanted->column, wanted->row, how) : record_strip(scene, how), nullptr});
      position_ = 0;
    }
    if (step.pane == LessonBeside::structure && walk_->searches == nullptr) {
      // The walk owns both, so the timeline lives long enough.
      const std::shared_ptr<const Timeline> timeline(std::shared_ptr<const Timeline>(), &walk_->timeline);
      walk_->searches = std::make_shared<const SearchWalks>(document_.scene, timeline, Precision::double_);
    }
    if (!step.pixel || wanted) {
      if (wanted) position_ = 0;
      return true;
    }
    const auto& pixels = walk_->timeline.pixels();
    const auto pixel = std::find_if(pixels.begin(), pixels.end(),
                                    [&](const PixelRecord& record) { return record.column == step.pixel->column; });
    if (pixel == pixels.end()) {
      fail(step.line,
           fmt::format("pixel: SCREEN has no cell {} (expected 0 to {})", step.pixel->column, pixels.size() - 1));
      return false;
    }
    position_ = pixel->begun_at - 1;
    return true;
  }

  bool take_pictures(const LessonStep& step) {
    for (const PictureRequest& request : step.pictures) {
      Scene scene = document_.scene;
      if (!request.changes.empty()) {
        const auto changed = changed_scene(document_, request.changes, {}, file());
        if (!changed) return fail(changed.error(), request.line);
        scene = changed->scene;
      }
      if (first_ != nullptr) {
        const auto& before = first_->steps[to_.steps.size() - 1].pictures.find(request.name)->second;
        if (request.seed || before->rendering()->statistics.random_draws() == 0) {
          to_.steps.back().pictures.insert_or_assign(request.name, before);
          continue;
        }
      }
      RenderSettings settings;
      settings.size = request.size;
      settings.sampling.per_pixel = request.samples;
      settings.sampling.seed = request.seed.value_or(seed_);
      settings.accelerator = request.accelerator;
      const auto picture = std::make_shared<const StepPicture>(std::move(scene), settings);
      to_.steps.back().pictures.insert_or_assign(request.name, picture);
      if (playing_ == Playing::to_show) continue;
      const Result<Rendering>& rendering = picture->rendering();
      if (!rendering) return fail(rendering.error(), request.line);
      if (rendering->statistics.random_draws() > 0 && !request.seed) to_.steps.back().random = true;
    }
    return true;
  }

  /// The first position from `from` on after a line for which the condition holds.
  std::optional<int> find(const Formula& condition, int from) {
    const Timeline& timeline = walk_->timeline;
    for (int position = from + 1; position <= timeline.steps(); ++position) {
      const Outcome here = value_at(to_, to_.steps.size() - 1, position, condition.expression);
      if (!here) {
        fail(condition.line, condition.text + ": " + here.error());
        return std::nullopt;
      }
      if (holds(*here)) return position;
    }
    fail(condition.line, fmt::format("no line of the walk from step {} on fulfils: {}", from, condition.text),
         "raywalk step SCENE --format json shows what there is");
    return std::nullopt;
  }

  bool move(const LessonStep& step) {
    PlayedStep& played = to_.steps.back();
    int asked = position_, shown = position_;
    if (step.run) {
      const auto found = find(*step.run, position_);
      if (!found) return false;
      shown = *found;
      const bool for_line = step.question && std::holds_alternative<LineQuestion>(*step.question);
      asked = step.question && !for_line ? shown - 1 : shown;
    }
    if (step.reveal) {
      const auto found = find(*step.reveal, asked);
      if (!found) return false;
      shown = *found;
    }
    played.asked = asked;
    played.shown = shown;
    return true;
  }

  void verify(const Formula& check) {
    const std::size_t index = to_.steps.size() - 1;
    const int position = to_.steps.back().shown;
    const Outcome value = value_at(to_, index, position, check.expression);
    if (!value) return fail(check.line, check.text + ": " + value.error());
    if (holds(*value)) return;
    const std::string sides = check.expression.sides(Facts(to_, index, position));
    fail(check.line,
         fmt::format("the trace does not bear out: {}{}", check.text, sides.empty() ? "" : "; it has " + sides),
         fmt::format("step \"{}\" stands at step {} of the walk", to_.steps.back().step->id, position));
  }

  /// The fault must change something in the current pixel, first at the line that it breaks.
  void verify_fault(const LessonStep& step) {
    const Timeline& timeline = walk_->timeline;
    const int pixel = timeline.current_pixel(to_.steps.back().shown);
    if (pixel < 0) return fail(step.line, "fault: the walk stands in no pixel (expected pixel, or run)");
    const PixelRecord& at = timeline.pixels()[static_cast<std::size_t>(pixel)];
    Scene scene = document_.scene;
    scene.render.numerics = Numerics::naive;  // as with the fault
    const auto walked = [&](const Recording& how) {
      return walk_->pixel ? record_pixel(scene, scene.image, at.column, at.row, how)
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
    const Outcome theory = value_at(to_, to_.steps.size() - 1, to_.steps.back().shown, question.theory->expression);
    const double* number = theory ? std::get_if<double>(&*theory) : nullptr;
    if (number == nullptr)
      return fail(question.theory->line, "theory: " + question.theory->text + " is no number here");
    if (!question.accepts(*number, measured))
      fail(question.theory->line,
           fmt::format("theory: {} is {:.9g}, and the trace has {:.9g}: farther apart than the tolerance {:.9g}",
                       question.theory->text, *number, measured, question.tolerance));
  }

  void verify_question(const LessonStep& step) {
    const PlayedStep& played = to_.steps.back();
    const std::size_t index = to_.steps.size() - 1;
    if (std::holds_alternative<ArrowQuestion>(*step.question)) {
      const Outcome direction = value_at(to_, index, played.shown, *Expression::parse("direction"));
      if (!direction || !std::holds_alternative<Vec3d>(*direction))
        fail(step.line, "predict: the line that is run to forms no ray, so there is no arrow to compare with");
    } else if (const auto* number = std::get_if<NumberQuestion>(&*step.question)) {
      const Outcome value = value_at(to_, index, played.shown, number->answer.expression);
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
        const Outcome value = value_at(to_, index, played.shown, each.expression);
        if (!value) return fail(each.line, each.text + ": " + value.error());
        right += holds(*value) ? 1 : 0;
      }
      if (right != 1)
        fail(step.line, fmt::format("predict: {} of the {} choices hold in the trace (expected exactly one)", right,
                                    choice->choices.size()));
    }
  }

  PlayedLesson& to_;
  const Lesson& lesson_;
  const std::string& scenes_folder_;
  Playing playing_ = Playing::to_check;
  SceneDocument document_;
  std::shared_ptr<LessonWalk> walk_;
  int position_ = 0;
  const PlayedLesson* first_ = nullptr;
  std::uint64_t seed_ = 0;
};

}  // namespace

const Result<Rendering>& StepPicture::rendering() const {
  std::call_once(once_, [this] { rendering_ = render(scene_, settings_); });
  return *rendering_;
}

PlayedLesson play_lesson(const Lesson& lesson, const std::string& scenes_folder, Playing playing) {
  PlayedLesson played;
  played.lesson = &lesson;
  Player(played, scenes_folder, playing).play();
  return played;
}

PlayedLesson play_again(const PlayedLesson& first, const std::string& scenes_folder, std::uint64_t seed) {
  PlayedLesson played;
  played.lesson = first.lesson;
  Player(played, scenes_folder, first, seed).play();
  return played;
}

Outcome value_at(const PlayedLesson& played, std::size_t index, int position, const Expression& expression) {
  return expression.evaluate(Facts(played, index, position));
}

}  // namespace raywalk
