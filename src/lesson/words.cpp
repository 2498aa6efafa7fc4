#include "lesson/words.h"

#include "text/spelling.h"

#include <algorithm>
#include <array>
#include <optional>

namespace raywalk {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Adds a line of the file: lines of a paragraph are joined, a list's items are not.
void add_line(Passage& passage, std::string_view line, int number, bool after_empty) {
  if (line.empty()) return;
  if (passage.line == 0) passage.line = number;
  const bool is_item = line.starts_with("- ");
  if (!passage.text.empty()) passage.text += after_empty ? "\n\n" : is_item ? "\n" : " ";
  passage.text += line;
}

class WordsReader {
 public:
  explicit WordsReader(const std::string& file_name) { words_.file = file_name; }

  Result<LessonWords> read(std::string_view text) {
    bool after_empty = false;
    for (std::size_t at = 0; at <= text.size() && !error_;) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string_view line = trimmed(text.substr(at, end - at));
      ++line_;
      if (line.starts_with('#')) {
        heading(line);
      } else if (into_choices_ && line.starts_with("- ")) {
        words_.steps.back().choices.push_back({std::string(trimmed(line.substr(2))), line_});
      } else if (into_choices_ && !words_.steps.back().choices.empty() && !line.empty()) {
        words_.steps.back().choices.back().text += " " + std::string(line);
      } else if (Passage* const to = target()) {
        add_line(*to, line, line_, after_empty);
      } else if (!line.empty()) {
        fail_before_title();
      }
      after_empty = line.empty();
      at = end + 1;
    }
    if (!error_ && words_.title.empty()) fail("the title is missing (expected a line such as \"# Shadows\")", "");
    if (error_) return tl::unexpected(*error_);
    return words_;
  }

 private:
  void fail(std::string message, std::string hint) {
    if (!error_) error_ = Error{words_.file, line_, 0, std::move(message), std::move(hint)};
  }

  void fail_before_title() {
    fail("words stand before the title (expected a first line such as \"# Shadows\")",
         "begin the file with # and the lesson's title");
  }

  /// Where the next words go; null before the title.
  Passage* target() {
    if (words_.title.empty()) return nullptr;
    switch (section_) {
      case Section::whole:
        return &words_.summary;
      case Section::teacher:
        return &words_.teacher;
      case Section::sources:
        return &words_.sources;
      case Section::step:
        return &(words_.steps.back().*part_);
    }
    return nullptr;
  }

  void heading(std::string_view line) {
    const std::size_t order = line.find_first_not_of('#');
    const std::string_view text = order == std::string_view::npos ? "" : trimmed(line.substr(order));
    into_choices_ = false;
    if (text.empty()) return fail("a heading without words (expected some after the #)", "");
    if (words_.title.empty()) {
      if (order != 1) return fail_before_title();
      words_.title = text;
    } else if (order == 2) {
      section(text);
    } else if (order == 3) {
      part(text);
    } else {
      fail("a heading of this order (expected one title with #, steps with ## and their parts with ###)",
           "use bold words instead of further headings");
    }
  }

  void section(std::string_view text) {
    if (text == "teacher" || text == "sources") {
      section_ = text == "teacher" ? Section::teacher : Section::sources;
      if (!target()->empty()) fail("## " + std::string(text) + " stands here a second time", "");
      return;
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos)
      return fail(
          "\"" + std::string(text) + "\" (expected the step's id, a colon and a heading, or teacher or sources)",
          "write it as \"## id: Heading\", with the id as in lesson.toml");
    StepWords step;
    step.id = trimmed(text.substr(0, colon));
    step.heading = trimmed(text.substr(colon + 1));
    step.line = line_;
    if (words_.find(step.id) != nullptr) fail("the step \"" + step.id + "\" has words already", "");
    words_.steps.push_back(std::move(step));
    section_ = Section::step;
    part_ = &StepWords::text;
  }

  void part(std::string_view text) {
    struct Part {
      std::string_view name;
      Passage StepWords::* passage;
    };
    constexpr std::array parts{Part{"predict", &StepWords::question}, Part{"reveal", &StepWords::reveal},
                               Part{"change", &StepWords::change}, Part{"presenter", &StepWords::presenter},
                               Part{"teacher", &StepWords::teacher}};
    if (section_ != Section::step)
      return fail("### stands outside a step (expected it below a ## of a step)", "use ## for a section");
    std::vector<std::string_view> names;
    for (const Part& each : parts) {
      names.push_back(each.name);
      if (each.name != text) continue;
      part_ = each.passage;
      into_choices_ = text == "predict";
      if (!target()->empty()) fail("### " + std::string(text) + " stands in this step a second time", "");
      return;
    }
    const std::string meant = nearest_word(text, names);
    fail("\"### " + std::string(text) + "\" is not known (expected " + one_of(names) + ")",
         meant.empty() ? "these words are the same in every language" : "did you mean " + meant + "?");
  }

  enum class Section { whole, step, teacher, sources };
  LessonWords words_;
  int line_ = 0;
  Section section_ = Section::whole;
  Passage StepWords::* part_ = &StepWords::text;
  bool into_choices_ = false;
  std::optional<Error> error_;
};

}  // namespace

const StepWords* LessonWords::find(std::string_view id) const {
  const auto at = std::find_if(steps.begin(), steps.end(), [&](const StepWords& step) { return step.id == id; });
  return at == steps.end() ? nullptr : &*at;
}

Result<LessonWords> parse_words(std::string_view text, const std::string& file_name) {
  return WordsReader(file_name).read(text);
}

}  // namespace raywalk
