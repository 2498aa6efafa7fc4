// Claims under other seeds: what holds only for some is luck.

#include "lesson/check.h"

#include <fmt/format.h>

#include <algorithm>

namespace raywalk::detail {

namespace {

class SeedsChecker {
 public:
  SeedsChecker(const PlayedLesson& played, const LessonCheckSettings& settings)
      : played_(played), settings_(settings), file_(played.lesson->folder + "/lesson.toml") {}

  LessonCheck check() {
    if (std::none_of(played_.steps.begin(), played_.steps.end(), depends_on_seed)) return {};
    look_at(played_);
    for (int seed = 1; seed <= settings_.seeds; ++seed) {
      seed_ = seed;
      const PlayedLesson again = play_again(played_, settings_.scenes_folder, static_cast<std::uint64_t>(seed));
      for (const Error& error : again.errors) {
        found_.errors.push_back(error);
        found_.errors.back().message += with_seed();
      }
      if (!again.errors.empty()) break;
      look_at(again);
    }
    return finish();
  }

 private:
  /// A formula's values over all seeds so far.
  struct Tried {
    std::string step, text;
    int line = 0;
    double least = 0, most = 0;
    bool any = false;
    std::string broken{};  ///< what is wrong with it, for the first failing seed
    int breaks = 0;        ///< the number of failing seeds
    const NumberQuestion* question = nullptr;
    std::optional<double> theory{};
  };

  /// The left side of a comparison.
  [[nodiscard]] static std::string left_of(const std::string& claim) {
    int nested = 0;
    for (std::size_t i = 0; i < claim.size(); ++i) {
      nested += claim[i] == '(' ? 1 : claim[i] == ')' ? -1 : 0;
      if (nested > 0 || std::string_view("=!<>").find(claim[i]) == std::string_view::npos) continue;
      return claim.substr(0, claim.find_last_not_of(' ', i - 1) + 1);
    }
    return claim;
  }
  [[nodiscard]] std::string with_seed() const { return fmt::format(" (with seed {})", seed_); }

  void look_at(const PlayedLesson& played) {
    at_ = 0;
    for (std::size_t i = 0; i < played.steps.size(); ++i) {
      const LessonStep& step = *played.steps[i].step;
      for (const Formula& claim : step.checks) look_at(played, i, claim);
      for (const Saying& saying : step.says)
        for (const Formula& claim : saying.claims) look_at(played, i, claim);
      if (step.question) look_at(played, i, *step.question);
    }
    for (const Saying& saying : played.lesson->says)
      for (const Formula& claim : saying.claims) look_at(played, played.steps.size() - 1, claim);
  }

  /// The next entry: formulas come in the same order for each seed.
  Tried& next(const LessonStep& step, const std::string& text, int line) {
    if (at_ == tried_.size()) tried_.push_back({step.id, text, line});
    return tried_[at_++];
  }
  void take(Tried& tried, const Outcome& value) {
    const double* number = value ? std::get_if<double>(&*value) : nullptr;
    if (number == nullptr) return;
    tried.least = tried.any ? std::min(tried.least, *number) : *number;
    tried.most = tried.any ? std::max(tried.most, *number) : *number;
    tried.any = true;
  }
  void breaks(Tried& tried, const std::string& why) {
    if (++tried.breaks == 1) tried.broken = why + with_seed();
  }

  void look_at(const PlayedLesson& played, std::size_t index, const Formula& claim) {
    const PlayedStep& step = played.steps[index];
    const auto left = claim.expression.left_side();
    Tried& tried = next(*step.step, left ? left_of(claim.text) : claim.text, claim.line);
    if (left) take(tried, value_at(played, index, step.shown, *left));
    const Outcome value = value_at(played, index, step.shown, claim.expression);
    if (!value)
      breaks(tried, value.error());
    else if (!holds(*value))
      breaks(tried, "the trace does not bear out: " + claim.text);
  }

  void look_at(const PlayedLesson& played, std::size_t index, const LessonQuestion& question) {
    const PlayedStep& step = played.steps[index];
    if (const auto* number = std::get_if<NumberQuestion>(&question)) {
      Tried& tried = next(*step.step, number->answer.text, number->answer.line);
      tried.question = number;
      take(tried, value_at(played, index, step.shown, number->answer.expression));
      if (!number->theory) return;
      const Outcome theory = value_at(played, index, step.shown, number->theory->expression);
      if (const double* right = theory ? std::get_if<double>(&*theory) : nullptr) tried.theory = *right;
    } else if (const auto* choice = std::get_if<ChoiceQuestion>(&question)) {
      for (const Formula& each : choice->choices) {
        const auto truth = [&](const PlayedLesson& of) {
          const Outcome value = value_at(of, index, of.steps[index].shown, each.expression);
          return value && holds(*value);
        };
        Tried& tried = next(*step.step, each.text, each.line);
        if (truth(played) != truth(played_)) breaks(tried, "predict: another choice is right: " + each.text);
      }
    }
  }

  LessonCheck finish() {
    for (const Tried& tried : tried_) {
      const std::string range = tried.any ? fmt::format("; it is {:.4g} to {:.4g}", tried.least, tried.most) : "";
      if (tried.breaks > 0)
        fail(tried, fmt::format("{}: {} of {} seeds break it{}", tried.broken, tried.breaks, settings_.seeds, range));
      if (tried.question != nullptr) check_number(tried, range);
      if (tried.any && tried.least < tried.most)
        found_.spreads.push_back({tried.step, tried.text, tried.least, tried.most, tried.theory});
    }
    return std::move(found_);
  }

  /// An answer that depends on random numbers needs a predictable one that is right for all seeds.
  void check_number(const Tried& tried, const std::string& range) {
    if (tried.least == tried.most) return;
    if (!tried.theory)
      return fail(tried,
                  fmt::format("predict: the answer hangs on random numbers{} (expected theory = 'FORMULA')", range));
    const NumberQuestion& question = *tried.question;
    if (!question.accepts(*tried.theory, tried.least) || !question.accepts(*tried.theory, tried.most))
      fail(tried, fmt::format("theory: {:.4g} is not within {:.4g} of the answer with every seed{}", *tried.theory,
                              question.tolerance, range));
  }

  void fail(const Tried& tried, std::string message) {
    found_.errors.push_back({file_, tried.line, 0, std::move(message),
                             "choose samplers, samples and sizes with which the claim holds whatever is drawn"});
  }

  const PlayedLesson& played_;
  const LessonCheckSettings& settings_;
  std::string file_;
  int seed_ = 0;
  std::size_t at_ = 0;
  std::vector<Tried> tried_;
  LessonCheck found_;
};

}  // namespace

LessonCheck check_seeds(const PlayedLesson& played, const LessonCheckSettings& settings) {
  return SeedsChecker(played, settings).check();
}

}  // namespace raywalk::detail
