#pragma once
// The words of a lesson in one language: plain Markdown. A heading of the first order is the title; one of the second
// opens a step, "## id: Heading", or one of the sections of the whole lesson, "## teacher" and "## sources"; one of the
// third opens a part of a step. Numbers are formulas in braces, {t:2}, filled in from the trace.

#include "text/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Words, and the line of the file where they begin. Paragraphs are one line each, separated by an empty line; list
/// items begin with "- ".
struct Passage {
  std::string text;
  int line = 0;
  [[nodiscard]] bool empty() const { return text.empty(); }
};

struct StepWords {
  std::string id;
  std::string heading;
  Passage text;                  ///< what the student reads first
  Passage question;              ///< "### predict", without the choices
  std::vector<Passage> choices;  ///< the items of the list under "### predict"
  Passage reveal;                ///< "### reveal": what to see once the answer is shown
  Passage change;                ///< "### change": what to change and watch next
  Passage presenter;             ///< "### presenter": what the presenter says and does
  Passage teacher;               ///< "### teacher": what students answer, and why
  int line = 0;
};

struct LessonWords {
  std::string file;
  std::string title;
  Passage summary;  ///< what one has learnt
  std::vector<StepWords> steps;
  Passage teacher, sources;
  [[nodiscard]] const StepWords* find(std::string_view id) const;
};

[[nodiscard]] Result<LessonWords> parse_words(std::string_view text, const std::string& file_name);

}  // namespace raywalk
