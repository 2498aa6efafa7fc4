// The words of a lesson: filled in, and checked for what is missing.

#include "lesson/check.h"
#include "lesson/script.h"
#include "scene/names.h"

#include <fmt/format.h>
#include "text/spelling.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

namespace raywalk {

namespace {

bool is_decimal_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A formula in braces, "t:2", and its number of decimals, or -1.
struct Slot {
  std::string formula;
  int decimals = -1;
};

Slot slot_of(std::string_view inner) {
  const std::size_t colon = inner.rfind(':');
  const std::string_view after = colon == std::string_view::npos ? "" : inner.substr(colon + 1);
  int decimals = 0;
  const auto [end, error] = std::from_chars(after.data(), after.data() + after.size(), decimals);
  constexpr int most = 12;
  if (after.empty() || error != std::errc() || end != after.data() + after.size() || decimals < 0 || decimals > most)
    return {std::string(inner), -1};
  return {std::string(inner.substr(0, colon)), decimals};
}

/// A decimal number in the words outside braces and code; empty if none.
std::string unchecked_number(const std::string& text) {
  int depth = 0;
  bool code = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}') --depth;
    if (text[i] == '`') code = !code;
    if (depth > 0 || code || i == 0 || i + 1 >= text.size()) continue;
    if ((text[i] == '.' || text[i] == ',') && is_decimal_digit(text[i - 1]) && is_decimal_digit(text[i + 1]))
      return text.substr(i - 1, 4);
  }
  return "";
}

/// The formulas of a text, with their braces.
std::vector<std::string> slots_in(const std::string& text) {
  std::vector<std::string> slots;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    slots.push_back(text.substr(at, end - at + 1));
  }
  return slots;
}

class WordsChecker {
 public:
  WordsChecker(const PlayedLesson& played, const ClaimWordsByLanguage& lists)
      : played_(played), lesson_(*played.lesson), lists_(lists) {}

  std::vector<Error> check() {
    for (const auto& [code, words] : lesson_.words) {
      words_ = &words;
      const auto list = lists_.find(code);
      list_ = list == lists_.end() ? nullptr : &list->second;
      require(words_->summary, 1, "the lesson has no summary below its title");
      require(words_->teacher, 1, "the section \"## teacher\" is missing");
      require(words_->sources, 1, "the section \"## sources\" is missing");
      for (std::size_t i = 0; i < lesson_.steps.size(); ++i) check_step(i);
      for (const StepWords& step : words_->steps)
        if (std::none_of(lesson_.steps.begin(), lesson_.steps.end(),
                         [&](const LessonStep& each) { return each.id == step.id; }))
          fail(step.line, fmt::format("lesson.toml has no step \"{}\"", step.id), "the id stands before the colon");
      if (played_.steps.empty()) continue;
      const std::size_t last = played_.steps.size() - 1;
      for (const Passage* whole : {&words_->summary, &words_->teacher}) fill(last, played_.steps[last].shown, *whole);
      for (const Passage* whole : {&words_->summary, &words_->teacher})
        check_stated(*whole, lesson_.says, "the lesson", whole == &words_->summary);
      check_length();
    }
    check_sayings();
    return errors_;
  }

 private:
  void fail(int line, std::string message, std::string hint = "") {
    errors_.push_back({words_->file, line, 0, std::move(message), std::move(hint)});
  }
  void require(const Passage& passage, int line, const std::string& message) {
    if (passage.empty()) fail(line, message, "lessons/README.md says what a lesson has");
  }

  void check_step(std::size_t index) {
    const LessonStep& step = lesson_.steps[index];
    const StepWords* words = words_->find(step.id);
    if (words == nullptr) return fail(1, fmt::format("the step \"{}\" has no words", step.id), "");
    require(words->text, words->line, fmt::format("the step \"{}\" has no text", step.id));
    require(words->presenter, words->line, fmt::format("the step \"{}\" has no \"### presenter\"", step.id));
    if (step.question) {
      require(words->question, words->line, fmt::format("the step \"{}\" asks nothing: \"### predict\"", step.id));
      require(words->reveal, words->line, fmt::format("the step \"{}\" has no \"### reveal\"", step.id));
      require(words->teacher, words->line, fmt::format("the step \"{}\" has no \"### teacher\"", step.id));
    } else if (!words->question.empty()) {
      fail(words->question.line, fmt::format("the step \"{}\" asks for no prediction in lesson.toml", step.id));
    }
    const auto* choice = step.question ? std::get_if<ChoiceQuestion>(&*step.question) : nullptr;
    const std::size_t expected = choice != nullptr ? choice->choices.size() : 0;
    if (words->choices.size() != expected)
      fail(words->line, fmt::format("the step \"{}\" has {} choices (expected {}, as in lesson.toml)", step.id,
                                    words->choices.size(), expected));
    const LessonWords& english = lesson_.words.at("en");
    if (const StepWords* other = english.find(step.id); other != nullptr) {
      if (other->change.empty() != words->change.empty())
        fail(words->line, fmt::format("\"### change\" of the step \"{}\" stands in one language only", step.id));
      if (other->teacher.empty() != words->teacher.empty())
        fail(words->line, fmt::format("\"### teacher\" of the step \"{}\" stands in one language only", step.id));
    }
    check_stated(step, *words);
    if (index >= played_.steps.size()) return;
    const PlayedStep& played = played_.steps[index];
    for (const Passage* before : {&words->text, &words->question}) fill(index, played.asked, *before);
    for (const Passage& each : words->choices) fill(index, played.asked, each);
    for (const Passage* after : {&words->reveal, &words->change, &words->presenter, &words->teacher})
      fill(index, played.shown, *after);
    // A number read before the answer and again with it must be the same: another line may have another current ray.
    for (const std::string& slot : slots_in(words->text.text + words->question.text)) {
      if (words->reveal.text.find(slot) == std::string::npos) continue;
      const Passage alone{slot, words->text.line};
      const auto before = filled(played_, index, played.asked, alone, {});
      const auto after = filled(played_, index, played.shown, alone, {});
      if (before && after && *before != *after)
        fail(
            words->text.line,
            fmt::format("{} is {} before the answer of the step \"{}\" and {} with it", slot, *before, step.id, *after),
            fmt::format("{{at(\"{}\", ...)}} has the value of the answer in both places", step.id));
    }
  }

  /// Each word of the passage that states something needs a claim.
  void check_stated(const Passage& passage, const std::vector<Saying>& says, const std::string& of,
                    bool quotes_state = true) {
    if (list_ == nullptr) return;
    for (const StatedWord& word : stated_words(passage.text, *list_, quotes_state)) {
      const auto saying =
          std::find_if(says.begin(), says.end(), [&](const Saying& each) { return each.word == word.name; });
      if (saying != says.end())
        used_.insert(&*saying);
      else
        fail(passage.line, fmt::format("\"{}\" states something that no claim of {} bears out", word.form, of),
             fmt::format("says.{} = 'CLAIM' in lesson.toml; lessons/README.md, \"Words that state something\"",
                         word.name));
    }
  }
  void check_stated(const LessonStep& step, const StepWords& words) {
    const std::string of = "the step \"" + step.id + "\"";
    for (const Passage& each :
         {Passage{words.heading, words.line}, words.text, words.question, words.reveal, words.change, words.presenter})
      check_stated(each, step.says, of);
    check_stated(words.teacher, step.says, of, false);
    if (list_ == nullptr) return;
    if (const std::string number = typed_number(words.reveal.text, *list_); !number.empty())
      fail(words.reveal.line, fmt::format("the number {} is typed into the answer of the step \"{}\"", number, step.id),
           "write it as a formula in braces, {count(formed)}, or as code between `");
  }

  /// What `says` names must be on the lists, and in the words of some language.
  void check_sayings() {
    const auto check = [&](const Saying& saying) {
      const ClaimWords& list = lists_.at("en");
      std::vector<std::string_view> names;
      for (const auto& [name, forms] : list.forms) names.push_back(name);
      std::string message;
      if (!list.forms.contains(saying.word))
        message = fmt::format("says.{}: not on the list (expected {})", saying.word, one_of(names));
      else if (!used_.contains(&saying))
        message = fmt::format("says.{}: no word of these stands in the words, in any language", saying.word);
      if (!message.empty()) errors_.push_back({lesson_.folder + "/lesson.toml", saying.line, 0, message, ""});
    };
    for (const Saying& saying : lesson_.says) check(saying);
    for (const LessonStep& step : lesson_.steps)
      for (const Saying& saying : step.says) check(saying);
  }

  void fill(std::size_t index, int position, const Passage& passage) {
    const auto text = filled(played_, index, position, passage, {});
    if (!text) fail(text.error().line, text.error().message, text.error().hint);
    if (const std::string number = unchecked_number(passage.text); !number.empty())
      fail(passage.line, fmt::format("the number \"{}...\" stands in the words and is checked by nothing", number),
           "write it as a formula in braces, {t:2}, or as code between `");
  }

  void check_length() {
    const double minutes = script_time(lesson_, *words_, lesson_.steps.size() - 1).end;
    if (minutes < fewest_minutes || minutes > max_minutes)
      fail(1,
           fmt::format("the presenter needs {:.1f} minutes (expected {} to {})", minutes, fewest_minutes, max_minutes),
           "counted: what is said and revealed, and the questions; a step with extra = true is left out");
  }

  const PlayedLesson& played_;
  const Lesson& lesson_;
  const LessonWords* words_ = nullptr;
  const ClaimWordsByLanguage& lists_;
  const ClaimWords* list_ = nullptr;  ///< null where the language has none
  std::set<const Saying*> used_;
  std::vector<Error> errors_;
};

/// A name in the language, a number as print has it.
std::string in_words(const Value& value, int decimals, const Scene& scene, Language language) {
  if (const auto* const name = std::get_if<std::string>(&value)) return shown_name(scene, *name, language);
  if (std::holds_alternative<double>(value)) return typeset_power(text_of(value, decimals), language);
  return text_of(value, decimals, language.decimal_mark());
}

}  // namespace

Result<std::string> filled(const PlayedLesson& played, std::size_t index, int position, const Passage& passage,
                           Language language) {
  const std::string& file = played.lesson->told(language).file;
  const auto wrong = [&](const std::string& message) {
    return tl::unexpected(Error{file, passage.line, 0, message, "a formula in braces takes its number from the trace"});
  };
  std::string text;
  for (std::size_t at = 0; at < passage.text.size();) {
    const std::size_t open = passage.text.find('{', at);
    text += passage.text.substr(at, open - at);
    if (open == std::string::npos) break;
    const std::size_t close = passage.text.find('}', open);
    if (close == std::string::npos) return wrong("a brace is opened and not closed");
    const Slot slot = slot_of(std::string_view(passage.text).substr(open + 1, close - open - 1));
    const auto expression = Expression::parse(slot.formula);
    if (!expression) return wrong(expression.error());
    const Outcome value = value_at(played, index, position, *expression);
    if (!value) return wrong(slot.formula + ": " + value.error());
    if (std::holds_alternative<Nothing>(*value))
      return wrong(fmt::format("{{{}}} is nothing at step {} of the walk", slot.formula, position));
    text += in_words(*value, slot.decimals, played.steps[index].walk->document.scene, language);
    at = close + 1;
  }
  return with_quotes(text, language);
}

LessonCheck check_lesson(const Lesson& lesson, const LessonCheckSettings& settings) {
  const PlayedLesson played = play_lesson(lesson, settings.scenes_folder);
  LessonCheck found{detail::check_claims(played), {}};
  found.errors.insert(found.errors.end(), played.errors.begin(), played.errors.end());
  if (found.errors.empty()) found = detail::check_seeds(played, settings);
  const std::vector<Error> of_words = detail::check_words(played, settings);
  found.errors.insert(found.errors.end(), of_words.begin(), of_words.end());
  return found;
}

std::vector<Error> detail::check_words(const PlayedLesson& played, const LessonCheckSettings& settings) {
  const auto lists = read_claim_words(settings.words_folder);
  return lists ? WordsChecker(played, *lists).check() : std::vector<Error>{lists.error()};
}

}  // namespace raywalk
