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
  Player(PlayedLesson& to, const std::string& scenes_folder)
      : to_(to), lesson_(*to.lesson), scenes_folder_(scenes_folder) {}
  /// Plays again what `first` played, with other random numbers.
  Player(PlayedLesson& to, const std::string& scenes_folder, const PlayedLesson& first, std::uint64_t seed)
      : to_(to), lesson_(*to.lesson), scenes_folder_(scenes_folder), first_(&first), seed_(seed) {}

  void play() {
    for (const LessonStep& step : lesson_.steps) {
      if (!stage(step)) return;
      to_.steps.push_back({&step, walk_, position_, position_, {}});
      if (!take_pictures(step) || !move(step)) {
        to_.steps.pop_back();
        return;
      }
      position_ = to_.steps.back().shown;
    }
  }

 private:
  [[nodiscard]] std::string file() const { return lesson_.folder + "/lesson.toml"; }
  void fail(int line, std::string message, std::string hint = "") {
    to_.errors.push_back({file(), line, 0, std::move(message), std::move(hint)});
  }
  bool fail(Error error, int line) {
    if (error.line == 0) error = {file(), line, 0, error.message, error.hint};
    to_.errors.push_back(std::move(error));
    return false;
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
        if (request.seed || !before->is_random()) {
          to_.steps.back().pictures.insert_or_assign(request.name, before);
          continue;
        }
      }
      RenderSettings settings;
      settings.size = request.size;
      settings.sampling.per_pixel = request.samples;
      settings.sampling.seed = request.seed.value_or(seed_);
      settings.accelerator = request.accelerator;
      to_.steps.back().pictures.insert_or_assign(request.name,
                                                 std::make_shared<const StepPicture>(std::move(scene), settings));
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

  PlayedLesson& to_;
  const Lesson& lesson_;
  const std::string& scenes_folder_;
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

PlayedLesson play_lesson(const Lesson& lesson, const std::string& scenes_folder) {
  PlayedLesson played;
  played.lesson = &lesson;
  Player(played, scenes_folder).play();
  return played;
}

PlayedLesson play_again(const PlayedLesson& first, const std::string& scenes_folder, std::uint64_t seed) {
  PlayedLesson played;
  played.lesson = first.lesson;
  Player(played, scenes_folder, first, seed).play();
  return played;
}

bool depends_on_seed(const PlayedStep& step) {
  const auto is_drawn = [&](const PictureRequest& request) {
    return !request.seed && step.pictures.find(request.name)->second->is_random();
  };
  return draws_random(integrator_of(step.walk->document.scene)) ||
         std::any_of(step.step->pictures.begin(), step.step->pictures.end(), is_drawn);
}

Outcome value_at(const PlayedLesson& played, std::size_t index, int position, const Expression& expression) {
  return expression.evaluate(Facts(played, index, position));
}

}  // namespace raywalk
